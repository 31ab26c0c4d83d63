// Scenes with joints, a start and a goal, for the page that looks for ways.
#pragma once

#include <string>

#include "taut/path.hpp"

namespace taut::web {

/// {"joints": [{"name", "range", "periodic"}], "start": a value of each, "goal": [lo, hi] of each, null where any value
/// will do, or "outside", "bodies": see linked_bodies_json(), "scene": the bodies at rest at the start, for a unit of
/// time}.
std::string problem_text(const PathProblem& problem);

/// {"answer": as `taut path --json` prints it, "scene": the bodies on their way, or null}.
std::string way_text(const PathProblem& problem, const PathOptions& options);

}  // namespace taut::web
