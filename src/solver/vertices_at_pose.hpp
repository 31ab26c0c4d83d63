// The vertices of displaced bodies at one instant, in the world.
#pragma once

#include <array>
#include <optional>
#include <tuple>
#include <vector>

#include "geometry/vector.hpp"
#include "scene/instance.hpp"

namespace taut::internal {

/// The vertices of one body. Positions are rounded, with a bound of the error, and recomputed with more bits on demand.
/// The pose is computed once for each precision, so an object must be used by one thread only.
class VerticesAtPose {
 public:
  VerticesAtPose(const InstanceBody& body, double t, Offset offset);

  const DisplacedPolygon& polygon() const { return *polygon_; }
  /// Rounded; each coordinate has an error of at most error().
  Vector at(std::uint32_t k) const { return positions_[k]; }
  double error() const { return error_; }
  /// The position of a point of the body, also rounded.
  Vector place(Vector v) const;
  template <class Real>
  std::array<Ball<Real>, 2> enclosed(std::uint32_t k) const;

 private:
  SharedPolygon polygon_;
  PieceChain chain_;  ///< the pieces valid at that instant
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
