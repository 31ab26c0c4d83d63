// Where a body is: its moving frame as functions of time (section 3 of the paper).
#pragma once

#include <cmath>

#include "numeric/jet.hpp"
#include "taut/motion.hpp"

namespace taut {

/// The body's point (u, v) is at o + u x + v y, y = x turned by +90 degrees.
template <class Real>
struct Pose {
  Jet<Real> ox, oy;
  Jet<Real> xx, xy;
};

/// A polynomial's k-th coefficient; 0 beyond the last.
inline double coefficient(const Coefficients& c, std::size_t k) { return k < c.size() ? c[k] : 0.0; }

/// The same bits on every platform, which std::hypot does not promise.
inline double length(double x, double y) { return std::sqrt(x * x + y * y); }

/// A polynomial's coefficients with 0 for the constant.
struct VaryingPart {
  const Coefficients& whole;
  std::size_t size() const { return whole.size(); }
  bool empty() const { return whole.empty(); }
  double operator[](std::size_t k) const { return k == 0 ? 0.0 : whole[k]; }
};

/// A polynomial divided by t^order, the lower powers dropped.
struct Quotient {
  const Coefficients& whole;
  std::size_t order;
  std::size_t size() const { return whole.size() - order; }
  double operator[](std::size_t k) const { return whole[k + order]; }
};

/// Is the cosine exactly 1 or -1 at `end`, and can it be divided by the distance from there without rounding? Then the
/// angle starts, or ends, with infinite speed.
bool singular_at(const CosineRotation& rotation, double end);

/// The lowest power of t in the polynomial, apart from its constant; 0 if there is none.
inline std::size_t first_power(const Coefficients& a) {
  for (std::size_t k = 1; k < a.size(); ++k) {
    if (a[k] != 0) return k;
  }
  return 0;
}

/// sqrt(1 - c^2) for a cosine c that is singular at that end: with c = e + h^m r, where e is 1 or -1, h = t - end and r
/// is not zero there, it is sqrt(-e h^m r (2 + e h^m r)), and h is direction * s^2.
template <class J, class Real>
void cosine_from_end(const CosineRotation& rotation, const TimeFromEnd<Real>& t, J& xx, J& xy) {
  const double e = rotation.a[0] + t.end * (rotation.a.size() > 1 ? rotation.a[1] : 0) > 0 ? 1 : -1;
  const std::size_t m = first_power(rotation.a);
  xx = J::constant(e);
  xy = J::constant(0.0);
  if (m == 0) return;
  const J s = J::variable(t.s);
  // By singular_at(), either the end is 0 or c is linear: r is the same polynomial about both.
  const J r = J::polynomial(Quotient{rotation.a, m}, t);
  J distance = J::constant(1.0);  // |s|^m
  for (std::size_t k = 0; k < m; ++k) distance = distance * s * Ball<Real>::exact(t.direction);
  const double side = m % 2 == 1 ? t.direction : 1;
  const J change = distance * distance * r * Ball<Real>::exact(side);
  xx = xx + change;
  const J two = J::constant(2.0);
  xy = distance * sqrt(r * (two + change * Ball<Real>::exact(e)) * Ball<Real>::exact(-e * side));
}

/// x(t) of a rotation; J is Jet<Real> or Series<Real, N>, and the time a ball or, for jets, TimeFromEnd.
template <class J, class Time>
void rotation_jet(const Rotation& rotation, const Time& t, J& xx, J& xy) {
  if constexpr (requires { t.direction; }) {
    const auto* c = std::get_if<CosineRotation>(&rotation);
    if (c && singular_at(*c, t.end)) return cosine_from_end(*c, t, xx, xy);
  }
  if (const auto* r = std::get_if<AngleRotation>(&rotation)) {
    sin_cos(J::polynomial(r->angle, t), xy, xx);
  } else if (const auto* d = std::get_if<DirectionRotation>(&rotation)) {
    const J a = J::polynomial(d->a, t), b = J::polynomial(d->b, t);
    const J length = sqrt(a * a + b * b);
    xx = a / length;
    xy = b / length;
  } else if (const auto* h = std::get_if<HalfAngleRotation>(&rotation)) {
    const J s = J::polynomial(h->s, t), square = s * s, one = J::constant(1.0);
    const J below = one + square;
    xx = (one - square) / below;
    xy = (s + s) / below;
  } else if (const auto* c = std::get_if<CosineRotation>(&rotation)) {
    // 1 - c^2 as (1 - c)(1 + c), with the constant parts added first: exact where c starts or ends at 1 or -1.
    const J change = J::polynomial(VaryingPart{c->a}, t);
    const J one = J::constant(1.0), start = J::constant(c->a.empty() ? 0.0 : c->a[0]);
    xx = start + change;
    xy = sqrt(((one - start) - change) * ((one + start) + change));
  } else {
    xx = J::constant(1.0);
    xy = J::constant(0.0);
  }
}

inline bool turns(const MotionPiece& piece) { return !std::holds_alternative<NoRotation>(piece.rotation); }

/// What the body turns about; (0, 0) if it does not turn.
inline Point pivot_of(const MotionPiece& piece) { return turns(piece) ? piece.pivot : Point{}; }

template <class Real>
Pose<Real> pose(const MotionPiece& piece, const Ball<Real>& t) {
  using J = Jet<Real>;
  Pose<Real> p;
  p.ox = J::polynomial(piece.x, t);
  p.oy = J::polynomial(piece.y, t);
  rotation_jet(piece.rotation, t, p.xx, p.xy);
  const Point c = pivot_of(piece);
  if (c == Point{}) return p;
  // c - R c, exactly zero where the body is not turned.
  const J x = J::constant(c.x), y = J::constant(c.y), versine = J::constant(1.0) - p.xx;
  p.ox = p.ox + (x * versine + y * p.xy);
  p.oy = p.oy + (y * versine - x * p.xy);
  return p;
}

/// Are the two given by the very same coefficients?
bool same_rotation(const Rotation& a, const Rotation& b);

}  // namespace taut
