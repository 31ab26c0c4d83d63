// Two bodies at one instant, in doubles with a bound: do their edges cross?
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "spacetime/hierarchy.hpp"

namespace taut::internal::spacetime {

/// The pose of Q in P's frame: its point v is at origin + rotation v, up to `error`, which also covers the rounding of
/// a few subsequent operations. The error is at least 2^-44 times the length of any point of Q.
struct QAtPose {
  Vector origin, rotation{1, 0};
  double error = 0;

  /// The pose for a stretch of zero length.
  static QAtPose of(const Stretch& instant) {
    const RelativePose& c = instant.in_p;
    return {{c.shift.x.a, c.shift.y.a}, {c.rotation.x.a, c.rotation.y.a}, c.error};
  }
  Vector at(Vector v) const { return origin + rotation * v; }
};

enum class EdgesCross : std::uint8_t {
  no,       ///< certainly
  yes,      ///< certainly
  unknown,  ///< doubles do not decide
};

/// Keeps its memory between queries.
class PoseSearch {
 public:
  /// Do edges of the displaced bodies cross? `no` does not exclude that one body lies inside the other.
  EdgesCross edges_cross(const QAtPose& at_pose, const PairGeometry& geometry, const Hierarchy& p, const Hierarchy& q);

 private:
  std::vector<std::pair<std::uint32_t, std::uint32_t>> todo_;
};

/// Tests two edges, given by their first vertices: one of P, one of Q.
EdgesCross edges_cross(const QAtPose& at_pose, const PairGeometry& geometry, VertexId of_p, VertexId of_q);

}  // namespace taut::internal::spacetime
