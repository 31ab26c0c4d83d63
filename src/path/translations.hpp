// Where one body, or several fixed to each other, only translates: the answer by exact signs.
#pragma once

#include <functional>

#include "path/barrier.hpp"
#include "path/joint_space.hpp"
#include "path/way.hpp"

namespace taut::internal::path {

/// Called with why there is no way. True if that is accepted as a proof.
using OnBarrier = std::function<bool(const JointSpace& space, const Barrier& barrier)>;

/// Sets the answer if the problem is of this kind, and can be decided here: one joint, or two in directions that are
/// not parallel, slide all that moves in the same way, and no clearance is asked for. Goals may be of any kind. False
/// if it is left to the search by cells: also where there is no way, but `on_barrier` is given and nothing is found
/// that it accepts. Then the answer is `exact` already, and what cells say is a proof, or none.
///
/// Each pair of convex pieces of what moves and what does not forbids an open convex polygon of displacements, their
/// Minkowski sum. A shortest way among such polygons turns at their vertices only, and ends at a vertex of the goal, at
/// a place where its boundary crosses that of an obstacle, or straight across. So there is a way if and only if one
/// leads along segments between these. With open touching, the polygons are as they are; with closed touching, they are
/// a little larger, by 2^-200 of their size, as bodies are elsewhere. What crosses what is decided exactly.
bool decide_translation(const PathProblem& problem, const PathOptions& options, const JointSpace& space,
                        const WayChecker& checker, const OnBarrier& on_barrier, PathAnswer& answer);

}  // namespace taut::internal::path
