// Answers of check() as JSON, with the parts that taut/check.hpp leaves out.
#pragma once

#include <optional>
#include <string>

#include "taut/check.hpp"
#include "taut/scene.hpp"

namespace taut::internal {

/// Wall time in seconds. Left out unless asked for: without it, the same scene always gives the same bytes.
struct AnswerTiming {
  double read = 0, build = 0, run = 0;
};

/// As answer_json() in taut/check.hpp, with a member "timing" if given.
std::string answer_json(const Scene& scene, const Answer& answer, Touch touch,
                        const std::optional<AnswerTiming>& timing);

namespace io {

/// An object of the members "t" and "contact" of an answer.
std::string contact_json(const Scene& scene, const Contact& contact);
std::string pair_answer_json(const Scene& scene, const PairAnswer& pair);

}  // namespace io

}  // namespace taut::internal
