// The vertices of displaced bodies where they stand at one instant, in the world.
#pragma once

#include <array>
#include <optional>
#include <tuple>
#include <vector>

#include "geometry/vector.hpp"
#include "world/world_plan.hpp"

namespace taut::internal {

/// One body. Positions are rounded, with a bound of the error, and computed again with more bits where that is asked:
/// its pose is computed once for each precision, so one object serves one thread.
class VerticesAtPose {
 public:
  VerticesAtPose(const WorldBody& body, double t, bool inwards);

  const DisplacedPolygon& polygon() const { return *polygon_; }
  /// Rounded; each coordinate is wrong by error() at most.
  Vector at(std::uint32_t k) const { return positions_[k]; }
  double error() const { return error_; }
  /// Where a point of the body is, rounded, too.
  Vector place(Vector v) const;
  template <class Real>
  std::array<Ball<Real>, 2> enclosed(std::uint32_t k) const;

 private:
  SharedPolygon polygon_;
  PieceChain chain_;  ///< the pieces that hold at that instant
  double t_;
  Vector origin_, axis_{1, 0};
  std::vector<Vector> positions_;
  double error_ = 0;
  bool turned_ = true;  ///< its axes may not be the world's
  template <class Real>
  using Known = std::optional<Pose<Real>>;
  mutable OfEachPrecision<Known, double> poses_;
};

}  // namespace taut::internal
