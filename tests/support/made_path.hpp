// Problems about ways, made up, and what is expected of ways.
#pragma once

#include <cstdint>
#include <optional>

#include "support/rng.hpp"
#include "taut/path.hpp"

namespace taut::testing {

/// A body that follows these joints freely.
JointMotion freely(std::optional<int> x, std::optional<int> y, std::optional<int> deg, Point pivot = {});

/// A star among stars, in a square from -2 to 2; with three dimensions it turns.
PathProblem random_problem(Rng& rng, int dimension);

/// Arms, carriages and free bodies of several parts with holes, some in holes of others. Not every one is valid.
PathProblem random_linkage(std::uint64_t seed);

/// That it is a way, from the start to the goal, by both engines, in the mode and at the clearance in question.
void expect_proved(const PathProblem& problem, const PathAnswer& answer, const PathOptions& options = {});

}  // namespace taut::testing
