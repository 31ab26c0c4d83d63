// Values with first and second derivatives in time, over balls.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>

#include "numeric/ball.hpp"
#include "numeric/exact_sum.hpp"
#include "numeric/trig.hpp"

namespace taut::internal {

namespace detail {

template <class Real>
Ball<Real> time_since_other(const Ball<Real>& t, double origin) {
  if constexpr (std::is_same_v<Real, double>) {
    const TwoDoubles difference = two_sum(t.mid, -origin);
    if (difference.lo == 0) return Ball<double>(difference.hi, t.rad);
  }
  return t - Ball<Real>::exact(origin);
}

}  // namespace detail

/// t - origin, without a rounding where the difference is a double.
template <class Real>
inline Ball<Real> time_since(const Ball<Real>& t, double origin) {
  return origin == 0 ? t : detail::time_since_other(t, origin);
}

/// A time given by its distance from an end at which the motion is singular: t = end + direction s^2, where direction
/// is 1 and s >= 0 after it, -1 and s <= 0 before it. Functions like the square root of the distance are smooth in s.
template <class Real>
struct TimeFromEnd {
  double end;
  double direction;
  Ball<Real> s;
  double origin = 0;  ///< polynomials are in powers of t - origin
};

/// f, f' and f'' over a ball of times: if t is a ball, each member encloses the range over it.
template <class Real>
struct Jet {
  using Number = Real;
  Ball<Real> v, d, dd;

  static Jet constant(const Ball<Real>& c) { return {c, Ball<Real>::exact(0), Ball<Real>::exact(0)}; }
  static Jet constant(double c) { return constant(Ball<Real>::exact(c)); }
  /// The independent variable.
  static Jet variable(const Ball<Real>& t) { return {t, Ball<Real>::exact(1), Ball<Real>::exact(0)}; }
  /// A polynomial with the given coefficients (ascending) at the ball t, by Horner's rule.
  template <class Coefficients>
  static Jet polynomial(const Coefficients& c, const Ball<Real>& t) {
    using B = Ball<Real>;
    if (c.empty()) return constant(0.0);
    B v = as_ball<Real>(c[c.size() - 1]), d = B::exact(0), dd = B::exact(0);
    for (std::size_t i = c.size() - 1; i-- > 0;) {
      dd = dd * t + d;
      d = d * t + v;
      v = v * t + as_ball<Real>(c[i]);
    }
    return {v, d, dd * 2.0};
  }
  /// The polynomial at a time that may have its expansion about an instant nearby.
  template <class Coefficients, class Time>
  requires requires(const Time& t, const Coefficients& c) { t.local(c); }
  static Jet polynomial(const Coefficients& c, const Time& t) {
    return t.polynomials ? polynomial(t.local(c), t.since) : polynomial(c, t.t);
  }
  /// The polynomial as a function of s.
  template <class Coefficients>
  static Jet polynomial(const Coefficients& c, const TimeFromEnd<Real>& at) {
    using B = Ball<Real>;
    const B twice = at.s * (2 * at.direction);
    const Jet t{time_since(B::exact(at.end), at.origin) + at.s * at.s * at.direction, twice,
                B::exact(2 * at.direction)};
    Jet sum = constant(0.0);
    for (std::size_t i = c.size(); i-- > 0;) sum = sum * t + constant(c[i]);
    return sum;
  }
};

template <class Real>
Jet<Real> operator-(const Jet<Real>& a) {
  return {-a.v, -a.d, -a.dd};
}
template <class Real>
Jet<Real> operator+(const Jet<Real>& a, const Jet<Real>& b) {
  return {a.v + b.v, a.d + b.d, a.dd + b.dd};
}
template <class Real>
Jet<Real> operator-(const Jet<Real>& a, const Jet<Real>& b) {
  return {a.v - b.v, a.d - b.d, a.dd - b.dd};
}
template <class Real>
Jet<Real> operator*(const Jet<Real>& a, const Jet<Real>& b) {
  return {a.v * b.v, a.d * b.v + a.v * b.d, a.dd * b.v + (a.d * b.d) * 2.0 + a.v * b.dd};
}
template <class Real>
Jet<Real> operator*(const Jet<Real>& a, const Ball<Real>& b) {
  return {a.v * b, a.d * b, a.dd * b};
}
template <class Real>
Jet<Real> operator/(const Jet<Real>& a, const Jet<Real>& b) {
  // q b = a, differentiated twice.
  const Ball<Real> q = a.v / b.v;
  const Ball<Real> qd = (a.d - q * b.d) / b.v;
  const Ball<Real> qdd = (a.dd - (qd * b.d) * 2.0 - q * b.dd) / b.v;
  return {q, qd, qdd};
}
template <class Real>
Jet<Real> sqrt(const Jet<Real>& a) {
  const Ball<Real> r = sqrt(a.v);
  const Ball<Real> rd = a.d / (r * 2.0);
  const Ball<Real> rdd = (a.dd - (rd * rd) * 2.0) / (r * 2.0);
  return {r, rd, rdd};
}

/// cos and sin of a moving angle.
template <class Real>
void sin_cos(const Jet<Real>& a, Jet<Real>& sine, Jet<Real>& cosine) {
  const SinCos<Real> sc = sin_cos(a.v);
  const Ball<Real> square = a.d * a.d;
  sine = {sc.sin, sc.cos * a.d, sc.cos * a.dd - sc.sin * square};
  cosine = {sc.cos, -(sc.sin * a.d), -(sc.sin * a.dd) - sc.cos * square};
}

/// Coefficients of a polynomial (ascending) in a fixed array, without dynamic allocation.
template <class Real>
struct BallPolynomial {
  static constexpr std::size_t capacity = 17;  // taut::max_degree + 1
  std::array<Ball<Real>, capacity> c;
  std::size_t size = 0;

  void push_back(const Ball<Real>& x) { c[size++] = x; }
  Ball<Real>& operator[](std::size_t k) { return c[k]; }
  const Ball<Real>& operator[](std::size_t k) const { return c[k]; }
};

namespace detail {

/// Rounds to doubles.
template <class Real>
Ball<double> in_doubles(const Ball<Real>& x) {
  const double mid = RealTraits<Real>::to_double(x.mid);
  if (!std::isfinite(mid)) return Ball<double>(0, std::numeric_limits<double>::infinity());
  return Ball<double>(mid, inflate(x.rad + std::fabs(mid) * 0x1p-52));
}

template <class Real>
BallPolynomial<double> in_doubles(const BallPolynomial<Real>& c) {
  BallPolynomial<double> rounded;
  for (std::size_t k = 0; k < c.size; ++k) rounded.push_back(in_doubles(c[k]));
  return rounded;
}

/// The range of a derivative of sum c_k h^k over |h| <= r. Even powers lie on one side only. The varying part is a
/// range, for which a few digits suffice.
template <class Real>
Ball<Real> range_about_zero(const BallPolynomial<Real>& c, std::size_t derivative, double r) {
  using B = Ball<double>;
  if (!(derivative < c.size)) return Ball<Real>::exact(0);
  double factorial = 1;
  for (std::size_t i = 2; i <= derivative; ++i) factorial *= static_cast<double>(i);
  B sum = B::exact(0);
  double power = 1;  // r^(k - derivative)
  for (std::size_t k = derivative + 1; k < c.size; ++k) {
    power = inflate(power * r);
    double factor = 1;
    for (std::size_t i = 0; i < derivative; ++i) factor *= static_cast<double>(k - i);
    // The range of h^(k - derivative).
    const bool odd = (k - derivative) % 2 == 1;
    const B step = odd ? B(0, power) : B(power / 2, power / 2 * (1 + 0x1p-40));
    sum = sum + in_doubles(c[k]) * step * factor;
  }
  return c[derivative] * factorial + Ball<Real>(Real(sum.mid), sum.rad);
}

}  // namespace detail

/// The coefficients of the expansion about a place.
template <class Real>
BallPolynomial<Real> expanded(BallPolynomial<Real> c, const Ball<Real>& place) {
  for (std::size_t k = 0; k + 1 < c.size; ++k) {
    for (std::size_t i = c.size - 1; i-- > k;) c[i] = c[i] + c[i + 1] * place;
  }
  return c;
}
template <class Real>
BallPolynomial<Real> expanded(const BallPolynomial<Real>& c, const Real& place) {
  return expanded(c, Ball<Real>(place, 0.0));
}

/// The range over the ball t of a polynomial given by balls (ascending). The polynomial is expanded about the middle
/// first, so that the range is tight near roots of any multiplicity: |f(t) - f(m)| <= sum |c_k| r^k.
template <class Real>
Jet<Real> polynomial_range(const BallPolynomial<Real>& c, const Ball<Real>& t) {
  const BallPolynomial<Real> about_middle = expanded(c, t.mid);
  return {detail::range_about_zero(about_middle, 0, t.rad), detail::range_about_zero(about_middle, 1, t.rad),
          detail::range_about_zero(about_middle, 2, t.rad)};
}

/// Does the range decide the sign of the value or, over an interval, that of the slope?
template <class Real>
bool is_decisive(const Jet<Real>& range, const Ball<Real>& t) {
  return range.v.sign() != 0 || (t.rad != 0 && range.d.sign() != 0);
}

/// Is the uncertainty of the last coefficient, which in a Taylor polynomial is a range, a large part of that which
/// hides the sign? The result is true for an unbounded range.
template <class Real>
bool is_hidden_by_last(const BallPolynomial<Real>& c, const Ball<Real>& range, const Ball<Real>& t) {
  const std::size_t last = c.size - 1;
  return !std::isfinite(range.rad) || c[last].rad * std::pow(t.magnitude(), static_cast<double>(last)) > range.rad / 8;
}

/// A wider range that decides these signs, or nothing. Coefficients of long numbers have their own scales, and
/// cancellation has taken place in them already. Rounded to doubles, they decide over most balls, at a tenth of the
/// cost.
template <class Real>
std::optional<Jet<Real>> decisive_range_in_doubles(const BallPolynomial<Real>& c, const Ball<Real>& t) {
  const Jet<double> rough = polynomial_range(detail::in_doubles(c), detail::in_doubles(t));
  const auto same = [](const Ball<double>& x) { return Ball<Real>(Real(x.mid), x.rad); };
  const Jet<Real> range{same(rough.v), same(rough.d), same(rough.dd)};
  return is_decisive(range, t) ? std::optional(range) : std::nullopt;
}

/// The value alone.
template <class Real>
Ball<Real> polynomial_value(const BallPolynomial<Real>& c, const Ball<Real>& t) {
  if (t.rad == 0) {
    Ball<Real> v = c[c.size - 1];
    for (std::size_t k = c.size - 1; k-- > 0;) v = v * t + c[k];
    return v;
  }
  return detail::range_about_zero(expanded(c, t.mid), 0, t.rad);
}

}  // namespace taut::internal
