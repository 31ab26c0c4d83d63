// Pictures of scenes that are more than two polygons.
#pragma once

#include <optional>
#include <string>

#include "taut/check.hpp"
#include "taut/io.hpp"

namespace taut::cli {

/// The bodies at `at`, or where the answer ends; not after that. Contacts and overlaps at that instant are marked.
std::string world_picture(const Scene& scene, const Answer& answer, std::optional<double> at, WorldDrawOptions options);

/// From the start to where the answer ends; with fewer frames where the file would get large.
std::string world_animation(const Scene& scene, const Answer& answer, WorldAnimateOptions options);

/// What the picture does not show of the time that was asked for, for standard error; empty if it shows all.
std::string world_note(const Scene& scene, const Answer& answer, std::optional<double> at);

}  // namespace taut::cli
