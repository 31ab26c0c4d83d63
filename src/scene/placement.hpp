// The two bodies at one instant: certified predicates for building the tiling from scratch.
#pragma once

#include <array>
#include <optional>
#include <tuple>
#include <vector>

#include "motion/motion_segment.hpp"
#include "numeric/errors.hpp"
#include "numeric/fixed.hpp"
#include "numeric/stages.hpp"
#include "scene/body_pair.hpp"
#include "scene/pair_geometry.hpp"

namespace taut::internal {

/// From a body's own coordinates to P's frame, rounded: a turn by (c, s), then a shift.
struct RoundedPose {
  double c = 1, s = 0, x = 0, y = 0;
};

/// Are the positions of all vertices computed at once, or each whenever it is asked for?
enum class Positions : unsigned char { tabulated, on_demand };

/// Positions in P's frame at parameter t of a segment (not a bridge), and the predicates that the static construction
/// needs. Four corners of a large box around both bodies are vertices size() .. size()+3, counterclockwise.
/// Predicates never return 0; they throw Undecidable at the limit of precision.
class Placement {
 public:
  Placement(const PairGeometry& geometry, const MotionSegment& segment, double t,
            Positions positions = Positions::tabulated);

  /// The same instant for other shapes.
  Placement with_geometry(const PairGeometry& geometry) const { return {geometry, *segment_, t_}; }
  /// From now on, positions are looked up: worth it where most are asked for several times.
  void tabulate();

  const PairGeometry& geometry() const { return *geometry_; }
  std::uint32_t size() const { return geometry_->size(); }
  VertexId box_corner(unsigned i) const { return VertexId(size() + i); }
  /// +1 if a, b, c turn left.
  int orientation(VertexId a, VertexId b, VertexId c) const;
  /// The order of the plane sweep: along a direction that no design is aligned with.
  bool before(VertexId a, VertexId b) const;
  /// before(a, b) by the difference of their keys, where that is more than key_error().
  double key(VertexId v) const { return keys_.empty() ? key_at(compute(v)) : keys_[v.value]; }
  double key_error() const { return key_error_; }
  /// The key of a point, and the most that it can differ by from that of a point at distance 1.
  static double key_at(const Point& p);
  static constexpr double steepest_key = 1.1;
  /// Rounded positions, for sorting and drawing.
  Point approximate(VertexId v) const { return positions_.empty() ? compute(v) : positions_[v.value]; }
  /// The bound of the error of each coordinate of approximate().
  double position_error() const { return error_; }
  /// How the positions of P (of Q) come about, up to position_error().
  const RoundedPose& pose_p() const { return pose_p_; }
  const RoundedPose& pose_q() const { return pose_q_; }
  /// The stage that decided where doubles did not.
  const StageCounts& stages() const { return stages_; }

 private:
  void set_poses(const Frame<double>& f);
  void set_bounds(const Frame<double>& f);
  Point compute(VertexId v) const {
    if (v.value >= size()) return corners_[v.value - size()];
    const DisplacedPoint& p = geometry_->point(v);
    if (geometry_->in_p(v)) return {p.x + pose_p_.x, p.y + pose_p_.y};
    const double x = p.x + before_turn_.x, y = p.y + before_turn_.y, c = pose_q_.c, s = pose_q_.s;
    return {after_turn_.x + (c * x - s * y), after_turn_.y + (s * x + c * y)};
  }
  /// From Q's coordinates to P's frame, in numbers that bound their errors.
  template <class N>
  struct PoseIn {
    N x, y, c, s;
  };
  template <class N>
  const PoseIn<N>& pose_in() const;
  template <class N>
  void position(VertexId v, N& x, N& y) const;
  template <class N>
  void find_position(VertexId v, N& x, N& y) const;
  double orientation_bound(double products, double differences, double coordinate) const;
  int close_orientation(VertexId a, VertexId b, VertexId c) const;
  int precise_orientation(VertexId a, VertexId b, VertexId c) const;
  /// The sign of what `quantity` makes of a zero of a number's type, where doubles do not decide it.
  template <class Quantity>
  int precise_sign(const char* what, const Quantity& quantity) const;

  const PairGeometry* geometry_;
  const MotionSegment* segment_;
  double t_;
  std::vector<Point> positions_;  ///< empty: on demand
  std::vector<double> keys_;
  std::array<Point, 4> corners_{};  ///< of the box
  RoundedPose pose_p_, pose_q_;
  Point before_turn_, after_turn_;  ///< added to Q's own coordinates
  double error_ = 0;                ///< of each coordinate of a position
  double coarse_bound_ = 0;         ///< of any three vertices' determinant
  double key_error_ = 0;            ///< of each difference of keys_
  template <class... Reals>
  static std::tuple<std::optional<PoseIn<FixedBall>>, std::optional<PoseIn<Ball<Reals>>>...> one_each(
      const std::tuple<Reals...>&);
  mutable decltype(one_each(Precisions())) poses_;  ///< made when first asked for
  /// Positions in numbers of a fixed length, each in the one place that the vertex determines: vertices that lie in one
  /// line are asked about in many threes.
  struct Held {
    VertexId vertex;
    FixedBall x, y;
  };
  static constexpr std::size_t places_to_hold = 64;
  mutable std::vector<Held> held_;  ///< made when first asked for
  /// Their orientations in the same way: of the same three vertices one part of the construction asks after the other.
  struct HeldSign {
    VertexId a, b, c;
    int sign = 0;
  };
  static constexpr std::size_t signs_to_hold = 256;
  mutable std::vector<HeldSign> held_signs_;
  mutable StageCounts stages_;
};

}  // namespace taut::internal
