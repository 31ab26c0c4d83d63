// The questions of the library, by the names that they have in C++: JSON text in and out.
#pragma once

#include <string>

#include "taut/scene.hpp"

namespace taut::web {

/// A question as JavaScript asks it.
struct Question {
  std::string name;     ///< "check", "check_clearance", "clearance", "distance_profile", "intervals", ...
  std::string options;  ///< an object in JSON; see read_options() in questions.cpp
  std::string log;      ///< of a proof, for "verify"
};

/// The answer, as the commands print it with `--json`. The log of "prove" goes to `proof`. Throws InputError.
std::string answer_to(const Question& question, const Scene& scene, std::string& proof);

}  // namespace taut::web
