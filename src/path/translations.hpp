// Where one body, or several fixed to each other, only translates: the answer by exact signs.
#pragma once

#include "path/joint_space.hpp"
#include "path/way.hpp"

namespace taut::internal::path {

/// Sets the answer if the problem is of this kind, and can be decided here: two joints that move all that moves along
/// the axes, no clearance, and a goal that is a single place; other goals if there is a way. False if it is left to the
/// search by cells.
///
/// Each pair of convex pieces of what moves and what does not forbids an open convex polygon of displacements, their
/// Minkowski sum. A shortest way among such polygons turns at their vertices only, so there is a way if and only if one
/// leads along segments between vertices, the start and the goal. With open touching, the polygons are as they are;
/// with closed touching, they are a little larger, by 2^-200 of their size, as bodies are elsewhere. What crosses what
/// is decided exactly.
bool decide_translation(const PathProblem& problem, const PathOptions& options, const JointSpace& space,
                        const WayChecker& checker, PathAnswer& answer);

}  // namespace taut::internal::path
