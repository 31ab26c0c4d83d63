// A contest as libraries for rigid bodies are asked about it: shapes of some metres, and sampled relative poses.
#pragma once

#include <vector>

#include "compare/cases.hpp"
#include "peers/peer.hpp"

namespace taut::bench {

/// The larger side of the larger body's bounding box, in metres: Box2D's manual asks for moving bodies of 0.1 to 10 m.
inline constexpr double peer_size = 10;
/// Box2D's limit on the vertices of a convex polygon.
inline constexpr std::size_t peer_vertices = 8;

/// The two bodies of a contest, in metres about the middles of their bounding boxes, and the way back to its poses. The
/// one with more vertices, which libraries keep in their trees, is seen as fixed.
class PeerPair {
 public:
  explicit PeerPair(const Contest& contest);

  const PeerShape& fixed() const { return fixed_; }
  const PeerShape& moving() const { return moving_; }
  /// Which body of the contest is the fixed one.
  std::size_t fixed_body() const { return fixed_body_; }
  /// The moving body seen from the fixed one at an instant of the contest, plans followed.
  RelativePose pose(double t) const;

 private:
  const Contest& contest_;
  std::size_t fixed_body_;
  Point middle_[2];  ///< of the fixed one, of the moving one
  double scale_;
  PeerShape fixed_, moving_;
};

/// steps + 1 instants, evenly spread from the contest's start to its end.
std::vector<double> sample_times(const Contest& contest, int steps);

/// Whether neither body turns, and each rests or moves along one straight line at one speed.
bool is_straight(const Contest& contest);

}  // namespace taut::bench
