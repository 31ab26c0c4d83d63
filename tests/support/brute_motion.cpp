#include "support/brute_motion.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <variant>

namespace taut::testing {

namespace {

constexpr Real infinity = std::numeric_limits<Real>::infinity();

/// Value and derivatives of a polynomial at the middle of an interval, and bounds on them over the interval.
struct Jet {
  Real value = 0, first = 0, second = 0;
  Real value_way = 0;                      // |p(t) - p(middle)|
  Real first_bound = 0, second_bound = 0;  // |p'(t)|, |p''(t)|
};

Real evaluate(const Coefficients& c, Real t) {
  Real v = 0;
  for (std::size_t k = c.size(); k-- > 0;) v = v * t + c[k];
  return v;
}

/// By the Taylor expansion around the middle, which is finite: the bounds are rigorous up to rounding.
Jet jet(const Coefficients& c, Real middle, Real half) {
  std::vector<Real> taylor(c.begin(), c.end());
  taylor.resize(std::max<std::size_t>(taylor.size(), 3), 0);
  const int n = static_cast<int>(taylor.size());
  for (int i = 0; i < n; ++i)
    for (int k = n - 2; k >= i; --k) taylor[k] += middle * taylor[k + 1];
  Jet j{taylor[0], taylor[1], 2 * taylor[2]};
  Real power = 1;
  for (int k = 1; k < n; ++k, power *= half) {
    j.first_bound += k * std::fabs(taylor[k]) * power;
    j.value_way += std::fabs(taylor[k]) * power * half;
    if (k + 1 < n) j.second_bound += (k + 1) * k * std::fabs(taylor[k + 1]) * power;
  }
  return j;
}

struct RotationBounds {
  Real middle_rate, rate, rate_change, way;
};

RotationBounds bound(const NoRotation&, Real, Real) { return {0, 0, 0, 0}; }

/// Mechanisms have oracles of their own.
RotationBounds bound(const JointFollower&, Real, Real) { throw std::logic_error("no bounds of a mechanism"); }

RotationBounds bound(const AngleRotation& r, Real middle, Real half) {
  const Jet a = jet(r.angle, middle, half);
  return {a.first, a.first_bound, a.second_bound, a.value_way};
}

RotationBounds bound(const DirectionRotation& r, Real middle, Real half) {
  const Jet a = jet(r.a, middle, half), b = jet(r.b, middle, half);
  const Real size = std::hypot(a.value, b.value), speed = std::hypot(a.first_bound, b.first_bound);
  const Real middle_rate = (a.value * b.first - b.value * a.first) / (size * size);
  const Real least = size - std::hypot(a.value_way, b.value_way);
  if (!(least > 0)) return {middle_rate, infinity, infinity, infinity};
  // theta' = (d x d') / |d|^2; theta'' = (d x d'') / |d|^2 - 2 (d x d') (d . d') / |d|^4.
  const Real change = std::hypot(a.second_bound, b.second_bound) / least + 2 * speed * speed / (least * least);
  return {middle_rate, speed / least, change, speed / least * half};
}

RotationBounds bound(const HalfAngleRotation& r, Real middle, Real half) {
  const Jet s = jet(r.s, middle, half);
  const Real nearest = std::max<Real>(0, std::fabs(s.value) - s.value_way), least = 1 + nearest * nearest;
  // theta = 2 atan s; |s| / (1 + s^2) <= 1/2.
  const Real rate = 2 * s.first_bound / least;
  const Real change = 2 * s.second_bound / least + 2 * s.first_bound * s.first_bound / least;
  return {2 * s.first / (1 + s.value * s.value), rate, change, rate * half};
}

RotationBounds bound(const CosineRotation& r, Real middle, Real half) {
  const Jet a = jet(r.a, middle, half);
  const auto clamp = [](Real x) { return std::min<Real>(1, std::max<Real>(-1, x)); };
  const Real here = std::acos(clamp(a.value));
  const Real way =
      std::max(here - std::acos(clamp(a.value + a.value_way)), std::acos(clamp(a.value - a.value_way)) - here);
  const Real q = std::sqrt(std::max<Real>(0, 1 - a.value * a.value));
  const Real largest = std::fabs(a.value) + a.value_way, least_squared = 1 - largest * largest;
  if (!(least_squared > 0)) return {q > 0 ? -a.first / q : infinity, infinity, infinity, way};
  const Real least = std::sqrt(least_squared);
  // theta' = -a' / q, theta'' = -a'' / q - a a'^2 / q^3.
  const Real change = a.second_bound / least + a.first_bound * a.first_bound / (least_squared * least);
  return {-a.first / q, a.first_bound / least, change, way};
}

Vec axis(const NoRotation&, Real) { return {1, 0}; }
Vec axis(const AngleRotation& r, Real t) {
  const Real a = evaluate(r.angle, t);
  return {std::cos(a), std::sin(a)};
}
Vec axis(const DirectionRotation& r, Real t) {
  const Vec d{evaluate(r.a, t), evaluate(r.b, t)};
  return (1 / length(d)) * d;
}
Vec axis(const HalfAngleRotation& r, Real t) {
  const Real s = evaluate(r.s, t), q = 1 + s * s;
  return {(1 - s * s) / q, 2 * s / q};
}
Vec axis(const CosineRotation& r, Real t) {
  const Real a = evaluate(r.a, t);
  return {a, std::sqrt(std::max<Real>(0, 1 - a * a))};
}

Vec axis(const JointFollower&, Real) { throw std::logic_error("no axis of a mechanism"); }

Real magnitude_of(const Coefficients& c, Real t) {
  Real v = 0;
  for (std::size_t k = c.size(); k-- > 0;) v = v * std::fabs(t) + std::fabs(Real(c[k]));
  return v;
}

}  // namespace

Vec BrutePiece::pivot() const {
  if (std::holds_alternative<NoRotation>(piece_.rotation)) return {};
  return {piece_.pivot.x, piece_.pivot.y};
}

Frame BrutePiece::at(Real time) const {
  const Real t = time - piece_.origin;
  const Vec c = pivot(), a = std::visit([&](const auto&r) { return axis(r, t); }, piece_.rotation);
  const Vec turned{a.x * c.x - a.y * c.y, a.y * c.x + a.x * c.y};
  return {Vec{evaluate(piece_.x, t), evaluate(piece_.y, t)} + (c - turned), a};
}

FrameBounds BrutePiece::over(Real time, Real half) const {
  const Real middle = time - piece_.origin;
  const Jet x = jet(piece_.x, middle, half), y = jet(piece_.y, middle, half);
  FrameBounds b;
  b.acceleration = std::hypot(x.second_bound, y.second_bound);
  b.origin_way = std::hypot(x.value_way, y.value_way);
  b.origin_velocity = {x.first, y.first};
  bound_rotation(middle, half, b);
  const Vec c = pivot();
  if (length(c) == 0) return b;  // rates may be infinite
  const Vec a = at(time).axis, turned{a.x * c.x - a.y * c.y, a.y * c.x + a.x * c.y};
  b.acceleration += length(c) * (b.rate * b.rate + b.rate_change);
  b.origin_way += length(c) * b.angle_way;
  b.origin_velocity = b.origin_velocity - b.middle_rate * Vec{-turned.y, turned.x};
  return b;
}

void BrutePiece::bound_rotation(Real middle, Real half, FrameBounds& b) const {
  const RotationBounds r =
      std::visit([&](const auto& function) { return bound(function, middle, half); }, piece_.rotation);
  b.middle_rate = r.middle_rate;
  b.rate = r.rate;
  b.rate_change = r.rate_change;
  b.angle_way = std::min(r.way, r.rate * half);
}

Real BrutePiece::magnitude(Real time, Real radius) const {
  const Real t = std::fabs(time) + std::fabs(Real(piece_.origin));
  Real turned = 1;
  if (const auto* r = std::get_if<AngleRotation>(&piece_.rotation)) turned += magnitude_of(r->angle, t);
  return magnitude_of(piece_.x, t) + magnitude_of(piece_.y, t) + turned * (radius + 2 * length(pivot()));
}

}  // namespace taut::testing
