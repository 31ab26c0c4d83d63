// Pictures of the bodies of a scene, at rest and in motion.
#pragma once

#include <optional>
#include <string>

#include "taut/check.hpp"
#include "taut/io.hpp"

namespace taut::internal {

/// Are the tilings of near pairs drawn, and of bodies displaced which way?
struct DrawnTilings {
  bool wanted = true;
  Touch touch = Touch::open;
};

/// The bodies at `at`, or where the answer ends; not after that. Contacts and overlaps at that instant are marked.
std::string world_picture(const Scene& scene, const Answer& answer, std::optional<double> at, const DrawnTilings& how,
                          DrawOptions options);

/// From the start to where the answer ends; where the file would get large, with fewer frames, or without tilings.
std::string world_animation(const Scene& scene, const Answer& answer, const DrawnTilings& how, AnimateOptions options);

/// The same with the answer of check(), for that touch mode.
std::string world_animation(const Scene& scene, const DrawnTilings& how, AnimateOptions options = {});

/// What the picture does not show of the time that was asked for, for standard error; empty if it shows all.
std::string world_note(const Scene& scene, const Answer& answer, std::optional<double> at);

}  // namespace taut::internal
