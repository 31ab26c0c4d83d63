// Closed polygons of displacements that no way crosses: why there is no way where bodies only translate.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "path/exact_point.hpp"
#include "taut/feature.hpp"

namespace taut::internal::path {

/// The displacements at which convex pieces of two bodies overlap. The ring is open.
struct Obstacle {
  ConvexRing ring;
  std::array<BodyId, 2> bodies;           ///< the one that rests, and the one that moves
  std::array<ConvexRing, 2> pieces = {};  ///< likewise, where joints do not move them
};

/// An edge of a barrier, from `from` to where the next one begins.
struct BarrierEdge {
  ExactPoint from;
  /// These have a point in common, which moves evenly. If there are none, the edge is outside of the joints' ranges.
  std::optional<std::array<BodyId, 2>> bodies = {};
  std::array<ExactPoint, 2> common = {};  ///< at the edge's begin and end, where joints do not move the first body
  int side = 0;                           ///< of the ranges, as a barrier's problem has them
};
struct Barrier {
  std::vector<BarrierEdge> edges;
  /// Where it is to stay within where boxes overlap: those of which bodies, the one that moves first.
  std::array<BodyId, 2> boxes = {};
};

struct BarrierProblem {
  const std::vector<Obstacle>& obstacles;
  /// Convex polygons beyond each of four sides of the ranges, of displacements that no joint values have.
  std::array<ConvexRing, 4> beyond;
  ExactPoint start;
  /// Convex. A barrier leads around it or the start, but not around both, and not through its inside. If touching is
  /// enough, it may run along the goal, or come to it.
  ConvexRing goal;
  /// Instead of a goal: a barrier leads around the start, and stays in this polygon.
  std::optional<ConvexRing> within;
  bool touching = false;  ///< bodies may not even touch
};

/// Nothing if there is none, or none is found: one that leads through the goal, or such that its corners have no exact
/// coordinates. Whether it is one is for a verifier to say.
std::optional<Barrier> find_barrier(const BarrierProblem& problem);

}  // namespace taut::internal::path
