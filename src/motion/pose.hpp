// Where a body is: its moving frame as functions of time (section 3 of the paper).
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "motion/local_time.hpp"
#include "motion/rotation_forms.hpp"
#include "numeric/jet.hpp"
#include "taut/motion.hpp"

namespace taut::internal {

/// The body's point (u, v) is at o + u x + v y, y = x turned by +90 degrees.
template <class J>
struct PoseOf {
  J ox, oy;
  J xx, xy;
};
template <class Real>
using Pose = PoseOf<Jet<Real>>;

/// A polynomial's k-th coefficient; 0 beyond the last.
inline double coefficient(const Coefficients& c, std::size_t k) { return k < c.size() ? c[k] : 0.0; }

/// The same bits on every platform, which std::hypot does not promise.
inline double length(double x, double y) { return std::sqrt(x * x + y * y); }

/// A cosine about an end of a segment at which it is 1 or -1, or nearly: it is `extreme` + h^order rest(h), where h is
/// the time from that end, and the rest is not zero there. The order is 0 where the cosine is not quite so far. Of odd
/// order, the angle starts, or ends, with infinite speed.
struct SingularCosine {
  double end = 0, extreme = 1;
  std::size_t order = 1;
  std::vector<Ball<RealMax>> rest;
};
/// Nothing if the cosine is not about 1 or -1 there, or always is.
std::optional<SingularCosine> singular_at(const CosineRotation& rotation, double origin, double end);

/// Its rest, rounded to a precision.
template <class Real>
BallCoefficients<Real> rest_of(const SingularCosine& cosine) {
  BallCoefficients<Real> rest;
  for (const Ball<RealMax>& c : cosine.rest) {
    const double rounding = RealTraits<RealMax>::magnitude(c.mid) * unit_roundoff<Real>();
    rest.p.push_back(Ball<Real>(static_cast<Real>(c.mid), detail::inflate(c.rad + rounding)));
  }
  return rest;
}

template <class J>
J power(const J& base, std::size_t exponent) {
  J product = J::constant(1.0);
  for (std::size_t k = 0; k < exponent; ++k) product = product * base;
  return product;
}

/// x near such an end. With c = e + h^m r the sine is sqrt(1 - c^2) = sqrt(-e h^m r (2 + e h^m r)): as good as h is
/// known, however close that is to zero. `change` is h^m r, `side` the sign of h^m, and |h|^m the square of `outside`
/// times `inside`, which is left in the root (null for 1).
template <class J, class Real>
void cosine_about_end(double e, const J& change, const J& rest, double side, const J& outside, const J* inside, J& xx,
                      J& xy) {
  const auto times = [](const J& a, double b) { return a * Ball<Real>::exact(b); };
  xx = J::constant(e) + change;
  const J positive = times(rest * (J::constant(2.0) + times(change, e)), -e * side);
  xy = outside * sqrt(inside ? *inside * positive : positive);
}

/// x as a function of time, after such an end (`direction` 1) or before it (-1): smooth if m is even.
template <class J, class Real>
void cosine_near_end(const SingularCosine& cosine, const Ball<Real>& t, double direction, J& xx, J& xy) {
  const std::size_t m = cosine.order;
  const J h = J::variable(t) - J::constant(cosine.end), distance = h * Ball<Real>::exact(direction);
  const J rest = about_middle<J>(rest_of<Real>(cosine), t - Ball<Real>::exact(cosine.end));
  const bool odd = m % 2 == 1;
  cosine_about_end<J, Real>(cosine.extreme, power(h, m) * rest, rest, odd ? direction : 1, power(distance, m / 2),
                            odd ? &distance : nullptr, xx, xy);
}

/// The same as a function of s, where h is direction * s^2: smooth, whatever the order.
template <class J, class Real>
void cosine_from_end(const SingularCosine& cosine, const TimeFromEnd<Real>& t, J& xx, J& xy) {
  const std::size_t m = cosine.order;
  const J rest = J::polynomial(rest_of<Real>(cosine), TimeFromEnd<Real>{0, t.direction, t.s});
  const J outside = power(J::variable(t.s) * Ball<Real>::exact(t.direction), m);  // |s|^m
  const double side = m % 2 == 1 ? t.direction : 1;
  const J change = outside * outside * rest * Ball<Real>::exact(side);
  cosine_about_end<J, Real>(cosine.extreme, change, rest, side, outside, nullptr, xx, xy);
}

/// Adds the way of a body that slides with a joint to its origin.
template <class J, class Time>
void slide_with_joint(const MotionPiece& piece, const Time& t, J& x, J& y) {
  const JointFollower* const follower = followed_joint(piece);
  if (!follower || !follower->slides) return;
  J way = value_of_joint<J>(*follower, t);
  if constexpr (!std::is_same_v<J, Symbolic>) {
    using B = Ball<typename J::Number>;
    const B length = length_of_direction<typename J::Number>(follower->direction);
    way = way * (B::exact(std::ldexp(1.0, follower->exponent)) / length);
  }
  x = x + way * J::constant(follower->direction.x);
  y = y + way * J::constant(follower->direction.y);
}

/// x(t) of a piece.
template <class J, class Time>
void rotation_jet(const MotionPiece& piece, const Time& t, J& xx, J& xy) {
  rotation_jet(piece.rotation, since_origin(t, piece.origin), xx, xy);
}

inline bool turns(const MotionPiece& piece) {
  const JointFollower* const follower = followed_joint(piece);
  return follower ? !follower->slides : !std::holds_alternative<NoRotation>(piece.rotation);
}
inline bool orbits(const MotionPiece& piece) { return !piece.orbit.angle.empty(); }

/// What the body turns about, or what of it orbits; (0, 0) if it does neither.
inline Point pivot_of(const MotionPiece& piece) { return turns(piece) || orbits(piece) ? piece.pivot : Point{}; }

/// Turns the place (x, y) of the pivot c about the orbit's centre: what is added to the body's origin for it. The time
/// is that since the piece's origin.
template <class J, class Time>
void add_orbit(const MotionPiece& piece, const Time& t, J& x, J& y) {
  J e, s;
  sin_cos(angle_at<J>(piece.orbit.angle, t), s, e);
  const Point c = pivot_of(piece), &m = piece.orbit.centre;
  const J rx = x + (J::constant(c.x) - J::constant(m.x)), ry = y + (J::constant(c.y) - J::constant(m.y));
  x = (e * rx - s * ry) + (J::constant(m.x) - J::constant(c.x));
  y = (s * rx + e * ry) + (J::constant(m.y) - J::constant(c.y));
}

/// The pose of a piece of which x is known. J is a Jet, a Series or a Symbolic, and the time what goes with it.
template <class J, class Time>
PoseOf<J> pose_about_axis(const MotionPiece& piece, const Time& time, const J& xx, const J& xy) {
  const Time t = since_origin(time, piece.origin);
  PoseOf<J> p{J::polynomial(piece.x, t), J::polynomial(piece.y, t), xx, xy};
  slide_with_joint(piece, t, p.ox, p.oy);
  if (orbits(piece)) add_orbit(piece, t, p.ox, p.oy);
  const Point c = turns(piece) ? piece.pivot : Point{};
  if (c == Point{}) return p;
  // c - R c, exactly zero where the body is not turned.
  const J x = J::constant(c.x), y = J::constant(c.y), versine = J::constant(1.0) - p.xx;
  p.ox = p.ox + (x * versine + y * p.xy);
  p.oy = p.oy + (y * versine - x * p.xy);
  return p;
}

template <class J, class Time>
PoseOf<J> pose_of(const MotionPiece& piece, const Time& t) {
  J xx, xy;
  rotation_jet(piece, t, xx, xy);
  return pose_about_axis<J>(piece, t, xx, xy);
}

template <class Real>
Pose<Real> pose(const MotionPiece& piece, const Ball<Real>& t) {
  return pose_of<Jet<Real>>(piece, LocalTime<Real>(t));
}

/// The pose at an instant, with precise numbers where doubles show nothing of it: near 1, a cosine that is a sum of
/// large terms leaves the sine but a few digits.
Pose<double> sharp_pose(const MotionPiece& piece, double t);

/// A frame that is seen from another one: the poses as complex numbers are multiplied.
template <class J>
PoseOf<J> compose(const PoseOf<J>& parent, const PoseOf<J>& child) {
  return {parent.ox + (parent.xx * child.ox - parent.xy * child.oy),
          parent.oy + (parent.xx * child.oy + parent.xy * child.ox), parent.xx * child.xx - parent.xy * child.xy,
          parent.xx * child.xy + parent.xy * child.xx};
}

/// What a body follows: its parents' pieces, the outermost first, and its own last. Never empty.
using PieceChain = std::vector<MotionPiece>;

inline bool turns(const PieceChain& chain) {
  return std::any_of(chain.begin(), chain.end(), [](const MotionPiece& p) { return turns(p); });
}

/// axis(link, xx, xy) returns x of the rotation of one of the pieces.
template <class J, class Time, class Axis>
PoseOf<J> pose_of(const PieceChain& chain, const Time& t, const Axis& axis) {
  const auto pose_of_link = [&](std::size_t link) {
    J xx, xy;
    axis(link, xx, xy);
    return pose_about_axis<J>(chain[link], t, xx, xy);
  };
  PoseOf<J> p = pose_of_link(chain.size() - 1);
  for (std::size_t i = chain.size() - 1; i-- > 0;) p = compose(pose_of_link(i), p);
  return p;
}
template <class J, class Time>
PoseOf<J> pose_of(const PieceChain& chain, const Time& t) {
  return pose_of<J>(chain, t, [&](std::size_t link, J& xx, J& xy) { rotation_jet(chain[link], t, xx, xy); });
}
template <class J, class Real>
PoseOf<J> pose_of(const PieceChain& chain, const Ball<Real>& t) {
  return pose_of<J>(chain, LocalTime<Real>(t));
}

/// The same with a point m of the body in place of its origin. The point is taken relative to the pivot before anything
/// is multiplied: far from the origin the two parts of a turn about a pivot nearly cancel, and ranges of them do not.
template <class Real>
Pose<Real> pose_about(const PieceChain& chain, const Point& m, const LocalTime<Real>& t) {
  using J = Jet<Real>;
  const MotionPiece& last = chain.back();
  const LocalTime<Real> since = since_origin(t, last.origin);
  Pose<Real> p;
  p.ox = J::polynomial(last.x, since);
  p.oy = J::polynomial(last.y, since);
  rotation_jet(last, t, p.xx, p.xy);
  slide_with_joint(last, since, p.ox, p.oy);
  if (orbits(last)) add_orbit(last, since, p.ox, p.oy);
  const Point c = turns(last) ? last.pivot : m;
  const J x = J::constant(m.x) - J::constant(c.x), y = J::constant(m.y) - J::constant(c.y);
  p.ox = p.ox + J::constant(c.x) + (p.xx * x - p.xy * y);
  p.oy = p.oy + J::constant(c.y) + (p.xy * x + p.xx * y);
  for (std::size_t i = chain.size() - 1; i-- > 0;) p = compose(pose_of<J>(chain[i], t), p);
  return p;
}

/// The same at the middle of a window of time and over all of it.
struct PosesOver {
  Pose<double> middle, over;
  double half;  ///< no instant of the window is farther from its middle
};
inline PosesOver poses_over(const PieceChain& chain, const Point& m, double from, double to) {
  const double centre = from + (to - from) / 2, half = std::max(to - centre, centre - from) * (1 + 0x1p-50);
  const Ball<double> middle = Ball<double>::exact(centre), over = Ball<double>::between(from, to);
  const bool far = std::any_of(chain.begin(), chain.end(), [&](const MotionPiece& piece) {
    return is_far(from - piece.origin, to - piece.origin, far_window);
  });
  if (!far)
    return {pose_about(chain, m, LocalTime<double>(middle)), pose_about(chain, m, LocalTime<double>(over)), half};
  const LocalPolynomials local(centre);
  const LocalTime<double> at(local, middle), all(local, over);
  return {pose_about(chain, m, at), pose_about(chain, m, all), half};
}

}  // namespace taut::internal
