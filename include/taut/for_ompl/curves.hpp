// The curves of Dubins' and of Reeds' and Shepp's cars as exact motions: lines, and turns about centres.
#pragma once

#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "taut/for_ompl/states.hpp"
#include "taut/map_query.hpp"

namespace taut::for_ompl {

/// One leg: to the left (1), straight (0) or to the right (-1), for so many turning radii, backwards if negative.
struct CurveLeg {
  int turn = 0;
  double length = 0;
};

/// A curve of up to five legs, as both spaces have.
struct Curve {
  std::array<CurveLeg, 5> legs{};
  std::size_t size = 0;
  double radius = 1;

  /// One more leg, unless it has no length.
  void add(int turn, double length) {
    if (length != 0) legs[size++] = {turn, length};
  }
  /// In turning radii.
  double length() const {
    double sum = 0;
    for (const CurveLeg& leg : legs) sum += std::fabs(leg.length);
    return sum;
  }
};

namespace detail {

/// What the space does not show.
struct DubinsRadius : ob::DubinsStateSpace {
  /// The turning radius.
  static double of(const ob::DubinsStateSpace& space) { return space.*(&DubinsRadius::rho_); }
  /// Does it take the shorter one of the two ways between states?
  static bool symmetric(const ob::DubinsStateSpace& space) { return space.*(&DubinsRadius::isSymmetric_); }
};
/// What the space does not show.
struct ReedsSheppRadius : ob::ReedsSheppStateSpace {
  /// The turning radius.
  static double of(const ob::ReedsSheppStateSpace& space) { return space.*(&ReedsSheppRadius::rho_); }
};

}  // namespace detail

/// The curve that the space interpolates along.
inline Curve curve_between(const ob::DubinsStateSpace& space, const ob::State* from, const ob::State* to) {
  using Space = ob::DubinsStateSpace;
  Space::DubinsPath path = space.dubins(from, to);
  bool reverse = false;
  if (detail::DubinsRadius::symmetric(space)) {
    const Space::DubinsPath back = space.dubins(to, from);
    reverse = back.length() < path.length();
    if (reverse) path = back;
  }
  Curve curve;
  curve.radius = detail::DubinsRadius::of(space);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = reverse ? 2 - i : i;
    const int turn = path.type_[k] == Space::DUBINS_LEFT ? 1 : path.type_[k] == Space::DUBINS_RIGHT ? -1 : 0;
    curve.add(turn, reverse ? -path.length_[k] : path.length_[k]);
  }
  return curve;
}

inline Curve curve_between(const ob::ReedsSheppStateSpace& space, const ob::State* from, const ob::State* to) {
  using Space = ob::ReedsSheppStateSpace;
  const Space::ReedsSheppPath path = space.reedsShepp(from, to);
  Curve curve;
  curve.radius = detail::ReedsSheppRadius::of(space);
  for (std::size_t k = 0; k < 5; ++k) {
    if (path.type_[k] == Space::RS_NOP) continue;
    curve.add(path.type_[k] == Space::RS_LEFT ? 1 : path.type_[k] == Space::RS_RIGHT ? -1 : 0, path.length_[k]);
  }
  return curve;
}

/// Writes pieces of a motion one after the other, into the memory of those that were there.
class PieceWriter {
 public:
  /// After the first `keep` pieces of the motion; `motion` must stay where it is.
  explicit PieceWriter(Motion& motion, std::size_t keep = 0) : motion_(motion), size_(keep) {}
  ~PieceWriter() {
    motion_.pieces.resize(size_);
    if (size_ > 0) motion_.pieces.back().until = std::numeric_limits<double>::infinity();
  }
  PieceWriter(const PieceWriter&) = delete;
  PieceWriter& operator=(const PieceWriter&) = delete;

  /// On a line from `from`, which is where it is at `start`, with these speeds.
  void line(const PoseSE2& from, const PoseSE2& speed, double start, double end) {
    MotionPiece& piece = next(end);
    piece.x.assign({from.x - speed.x * start, speed.x});
    piece.y.assign({from.y - speed.y * start, speed.y});
    angle(piece, from.angle - speed.angle * start, speed.angle);
    piece.pivot = {};
  }
  /// About a point that is at `pivot` in the body's own coordinates and stays at `centre`.
  void turn(const Point& centre, const Point& pivot, double at_zero, double speed, double end) {
    MotionPiece& piece = next(end);
    piece.x.assign({centre.x - pivot.x});
    piece.y.assign({centre.y - pivot.y});
    angle(piece, at_zero, speed);
    piece.pivot = pivot;
  }

 private:
  MotionPiece& next(double until) {
    if (size_ == motion_.pieces.size()) motion_.pieces.emplace_back();
    motion_.pieces[size_].until = until;
    motion_.pieces[size_].origin = 0;
    return motion_.pieces[size_++];
  }
  static void angle(MotionPiece& piece, double at_zero, double speed) {
    if (!std::holds_alternative<AngleRotation>(piece.rotation)) piece.rotation = AngleRotation{};
    std::get<AngleRotation>(piece.rotation).angle.assign({at_zero, speed});
  }

  Motion& motion_;
  std::size_t size_;
};

/// A box around the way of a body's origin.
struct WayBox {
  double lo_x = INFINITY, lo_y = INFINITY, hi_x = -INFINITY, hi_y = -INFINITY;
  /// A point.
  void add(double x, double y) {
    lo_x = std::min(lo_x, x);
    lo_y = std::min(lo_y, y);
    hi_x = std::max(hi_x, x);
    hi_y = std::max(hi_y, y);
  }
  /// The part of a circle from one angle to another.
  void add_arc(const Point& centre, double radius, double from, double to) {
    if (from > to) std::swap(from, to);
    add(centre.x + radius * std::cos(from), centre.y + radius * std::sin(from));
    add(centre.x + radius * std::cos(to), centre.y + radius * std::sin(to));
    for (double q = std::ceil(from / (pi / 2)); q * (pi / 2) < to; ++q)
      add(centre.x + radius * std::cos(q * (pi / 2)), centre.y + radius * std::sin(q * (pi / 2)));
  }
};

inline constexpr double closing_time = 1.0 / 64;

/// Writes the curve from `from` as pieces of a motion, beginning at time `start`, a turning radius in one unit of time.
/// The curve that OMPL computes misses the state it leads to, by rounding, or by more where OMPL takes what is nearly a
/// line for one: the pieces end with the straight way from where the curve ends to `to`, which takes closing_time, so
/// that what is asked about has no gaps. Returns the time at which the curve ends and that way begins.
inline double write_curve(const Curve& curve, const PoseSE2& from, const PoseSE2& to, double start, PieceWriter& out,
                          WayBox* box = nullptr) {
  PoseSE2 at = from;
  double t = start;
  const double r = curve.radius;
  for (std::size_t i = 0; i < curve.size; ++i) {
    const CurveLeg& leg = curve.legs[i];
    const double end = t + std::fabs(leg.length), way = leg.length < 0 ? -1 : 1;
    if (!(end > t)) continue;
    const double c = std::cos(at.angle), s = std::sin(at.angle);
    if (leg.turn == 0) {
      out.line(at, {way * r * c, way * r * s, 0}, t, end);
      at.x += r * leg.length * c;
      at.y += r * leg.length * s;
    } else {
      // To the left the centre is at (0, r) in the car's own coordinates, to the right at (0, -r).
      const double side = leg.turn, speed = side * way;
      const Point centre{at.x - side * r * s, at.y + side * r * c};
      out.turn(centre, {0, side * r}, at.angle - speed * t, speed, end);
      const double turned = at.angle + side * leg.length;
      if (box) box->add_arc(centre, r, at.angle - side * pi / 2, turned - side * pi / 2);
      at = {centre.x + side * r * std::sin(turned), centre.y - side * r * std::cos(turned), turned};
    }
    if (box) box->add(at.x, at.y);
    t = end;
  }
  const double turn = std::remainder(to.angle - at.angle, 2 * pi);
  constexpr double speed = 1 / closing_time;
  out.line(at, {speed * (to.x - at.x), speed * (to.y - at.y), speed * turn}, t, t + closing_time);
  return t;
}

}  // namespace taut::for_ompl
