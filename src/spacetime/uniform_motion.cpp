#include "spacetime/uniform_motion.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/displacement.hpp"
#include "numeric/trig.hpp"

namespace taut::internal::spacetime {
namespace {

/// A moving vector: a parabola about the stretch's middle, and bounds of the remainder for all |h| <= r. `rest` is for
/// the higher powers of time, `error` for everything.
struct MovingVector {
  Path path;
  double rest = 0, error = 0;
};

/// The rounding of a line or a product of parabolas, as a share of the terms' magnitudes: at most 8 operations each.
constexpr double uniform_rounding = 0x1p-49;

double reach_of(const MovingVector& v, double r) { return v.path.x.reach(r) + v.path.y.reach(r); }

MovingVector operator+(const MovingVector& a, const MovingVector& b) {
  return {a.path + b.path, a.rest + b.rest, a.error + b.error};
}
MovingVector operator-(const MovingVector& a, const MovingVector& b) {
  return {{a.path.x - b.path.x, a.path.y - b.path.y}, a.rest + b.rest, a.error + b.error};
}
MovingVector operator-(const MovingVector& a) { return {{-a.path.x, -a.path.y}, a.rest, a.error}; }
MovingVector conj(const MovingVector& a) { return {conj(a.path), a.rest, a.error}; }

/// An exact number, as a vector that rests.
MovingVector resting(Vector v) { return {{{v.x, 0, 0}, {v.y, 0, 0}}, 0, 0}; }

/// The product of complex numbers. Lengths of vectors are bounded by the sums of their coordinates.
MovingVector product(const MovingVector& a, const MovingVector& b, double r) {
  const Vector a0{a.path.x.a, a.path.y.a}, a1{a.path.x.b, a.path.y.b}, a2{a.path.x.c, a.path.y.c};
  const Vector b0{b.path.x.a, b.path.y.a}, b1{b.path.x.b, b.path.y.b}, b2{b.path.x.c, b.path.y.c};
  const Vector c0 = a0 * b0, c1 = a0 * b1 + a1 * b0, c2 = a0 * b2 + a1 * b1 + a2 * b0;
  const double third = l1_norm(a1) * l1_norm(b2) + l1_norm(a2) * l1_norm(b1), fourth = l1_norm(a2) * l1_norm(b2);
  const double left_out = r * r * r * (third + r * fourth), ra = reach_of(a, r), rb = reach_of(b, r);
  MovingVector m;
  m.path = {{c0.x, c1.x, c2.x}, {c0.y, c1.y, c2.y}};
  m.rest = left_out + a.rest * rb + b.rest * ra;
  m.error = left_out + (a.error * rb + b.error * ra) + a.error * b.error + uniform_rounding * ra * rb;
  return m;
}

struct MovingPose {
  MovingVector origin, rotation;
  bool turns = false;
};

MovingPose unmoved() { return {resting({}), resting({1, 0}), false}; }

/// The line x0 + x1 t, expanded about the middle, which is given since the piece's origin.
MovingVector line(const MotionPiece& piece, const Ball<double>& since, double r) {
  const double x0 = coefficient(piece.x, 0), x1 = coefficient(piece.x, 1);
  const double y0 = coefficient(piece.y, 0), y1 = coefficient(piece.y, 1);
  const double middle = since.mid, far = std::fabs(middle) + r;
  MovingVector v;
  v.path = {{x0 + x1 * middle, x1, 0}, {y0 + y1 * middle, y1, 0}};
  v.error = uniform_rounding * (std::fabs(x0) + std::fabs(y0) + far * (std::fabs(x1) + std::fabs(y1))) +
            since.rad * (std::fabs(x1) + std::fabs(y1));
  return v;
}

/// The unit vector of a uniformly changing angle: its Taylor series up to h^2, with a remainder of at most |w h|^3 / 6.
MovingVector uniform_rotation(const Coefficients& angle, const Ball<double>& since, double r) {
  const double speed = coefficient(angle, 1), w = std::fabs(speed) * r;
  const Ball<double> at = Ball<double>::exact(coefficient(angle, 0)) + Ball<double>::exact(speed) * since;
  const SinCos<double> e = sin_cos(at);
  const double c = e.cos.mid, s = e.sin.mid, half = speed * speed / 2;
  MovingVector v;
  v.path = {{c, -speed * s, -half * c}, {s, speed * c, -half * s}};
  v.rest = w * w * w * (1.0 / 6 + 0x1p-20);
  v.error = v.rest + (e.cos.rad + e.sin.rad + 4 * uniform_rounding) * (1 + w + w * w);
  return v;
}

MovingPose uniform_pose(const MotionPiece& piece, double middle, double r) {
  const Ball<double> since = time_since(Ball<double>::exact(middle), piece.origin);
  MovingPose pose{line(piece, since, r), resting({1, 0}), false};
  const auto* rotation = std::get_if<AngleRotation>(&piece.rotation);
  if (!rotation) return pose;
  pose.rotation = uniform_rotation(rotation->angle, since, r);
  pose.turns = true;
  if (piece.pivot == Point{}) return pose;
  const MovingVector pivot = resting({piece.pivot.x, piece.pivot.y});
  pose.origin = pose.origin + (pivot - product(pose.rotation, pivot, r));
  return pose;
}

MovingPose uniform_pose(std::span<const MotionPiece> chain, double middle, double r) {
  if (chain.empty()) return unmoved();
  MovingPose pose = uniform_pose(chain.front(), middle, r);
  for (const MotionPiece& piece : chain.subspan(1)) {
    const MovingPose child = uniform_pose(piece, middle, r);
    const MovingVector relative = pose.turns ? product(pose.rotation, child.origin, r) : child.origin;
    pose.origin = pose.origin + relative;
    if (pose.turns && child.turns) pose.rotation = product(pose.rotation, child.rotation, r);
    if (child.turns && !pose.turns) pose.rotation = child.rotation;
    pose.turns = pose.turns || child.turns;
  }
  return pose;
}

/// `longest` bounds the distance from the origin of the points for which the pose is used. The error of the rotation is
/// not included.
RelativePose relative_pose_of(const MovingVector& shift, const MovingVector& rotation, double longest, double r) {
  RelativePose out;
  out.shift = shift.path;
  out.rotation = rotation.path;
  out.swing = (rotation.path.x.swing(r) + rotation.path.y.swing(r) + rotation.error) * (1 + 0x1p-40);
  out.reach = (reach_of(shift, r) + longest * (1 + reach_of(rotation, r))) * (1 + 0x1p-40);
  // As for the stretches of windows: 2^-44 suffices for the 40 operations that may follow, and for the sums above.
  out.error = (shift.error + 0x1p-44 * out.reach) * (1 + 0x1p-40) + underflow_slack;
  return out;
}

/// Q in P's frame.
MovingPose relative_motion(std::span<const MotionPiece> of_p, std::span<const MotionPiece> of_q, double middle,
                           double r) {
  MovingPose q = uniform_pose(of_q, middle, r);
  if (of_p.empty()) return q;
  const MovingPose p = uniform_pose(of_p, middle, r);
  const MovingVector back = conj(p.rotation);
  q.origin = product(back, q.origin - p.origin, r);
  q.rotation = product(back, q.rotation, r);
  return q;
}

RelativePose pose_in_p(const MovingPose& q, double reach, double r) {
  RelativePose in_p = relative_pose_of(q.origin, q.rotation, reach, r);
  in_p.error = (in_p.error + reach * q.rotation.error) * (1 + 0x1p-40);
  return in_p;
}

}  // namespace

bool UniformMotion::is_even(const MotionPiece& piece) {
  if (piece.x.size() > 2 || piece.y.size() > 2 || orbits(piece)) return false;
  if (std::holds_alternative<NoRotation>(piece.rotation)) return true;
  const auto* rotation = std::get_if<AngleRotation>(&piece.rotation);
  return rotation && rotation->angle.size() <= 2;
}

Stretch UniformMotion::instant(double t) const {
  Stretch out;
  out.middle = t;
  out.in_p = pose_in_p(relative_motion(p_, q_, t, 0), reach_, 0);
  out.in_q.error = INFINITY;
  return out;
}

UniformStretch UniformMotion::stretch(double start, double end) const {
  UniformStretch even;
  Stretch& out = even.stretch_;
  out.middle = start + (end - start) / 2;
  out.r = std::max(end - out.middle, out.middle - start) * (1 + 0x1p-50);
  const MovingPose q = relative_motion(p_, q_, out.middle, out.r);
  out.in_p = pose_in_p(q, reach_, out.r);
  // A point a of P is at back (a - origin) in Q's frame. The error of the parabola of `back` is multiplied by that
  // distance.
  constexpr double longest_of_p = 4;
  MovingVector back = conj(q.rotation);
  even.turn_error_ = back.error;
  back.error = back.rest = 0;
  const MovingVector shift = -product(back, q.origin, out.r);
  back.error = q.rotation.error;
  out.in_q = relative_pose_of(shift, back, longest_of_p, out.r);
  even.base_ = out.in_q.error + q.origin.error * q.rotation.error;
  even.origin_ = {q.origin.path.x.a, q.origin.path.y.a};
  even.way_ = q.origin.path.x.swing(out.r) + q.origin.path.y.swing(out.r) + q.origin.error;
  out.rest = q.origin.rest + reach_ * q.rotation.rest;
  even.everywhere();
  return even;
}

}  // namespace taut::internal::spacetime
