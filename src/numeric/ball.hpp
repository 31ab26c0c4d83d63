// Balls: a number with a proved bound of its error. No directed rounding is used (WebAssembly has none): every
// operation rounds to nearest, and the radius absorbs the rounding.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

#include "numeric/exact_sum.hpp"
#include "numeric/real.hpp"

namespace taut::internal {

namespace detail {

/// Rounds a radius up: sums and products of at most a dozen nonnegative doubles stay below the result.
inline double inflate(double r) { return r * (1 + 0x1p-48) + underflow_slack; }

/// A bound of the rounding error of an operation whose result is m.
template <class Real>
inline double rounding(const Real& m) {
  return RealTraits<Real>::magnitude(m) * unit_roundoff<Real>();
}

/// The sum, or a slightly larger number if the sum is not representable.
inline double sum_above(double a, double b) {
  const TwoDoubles sum = two_sum(a, b);
  return sum.lo > 0 ? std::nextafter(sum.hi, std::numeric_limits<double>::infinity()) : sum.hi;
}
template <class Real>
Real sum_above(const Real& a, double b) {
  if (b == 0) return a;
  const Real sum = a + b;
  // Twice the rounding error of the sum, because adding it rounds once more.
  return sum + (2 * rounding(sum) + 0x1p-1060);
}

}  // namespace detail

/// All reals x with |x - mid| <= rad. The laws, for every operation op on balls A, B:
///   1. containment: a in A and b in B imply (a op b) in (A op B);
///   2. an undefined operation (division by a ball that contains zero, overflow) gives an infinite radius or a
///      NaN middle, for which sign() is 0;
///   3. sign() != 0 is a proof of the sign of every member;
///   4. lower() <= a <= upper(): rounded outwards, and equal to the middle where the radius is 0.
template <class Real>
struct Ball {
  Real mid{};
  double rad = 0;

  Ball() = default;
  Ball(const Real& m, double r) : mid(m), rad(r) {}
  /// Takes the middle that `make` returns, constructed in its final place, so that its words need not be moved.
  template <class Make>
  requires std::is_invocable_r_v<Real, Make>
  explicit Ball(Make make) : mid(make()) {}
  static Ball exact(double x) { return Ball(RealTraits<Real>::from_double(x), 0.0); }
  /// The ball spanned by lo <= hi.
  static Ball between(const Real& lo, const Real& hi) { return between(lo, hi, (lo + hi) / 2); }
  /// A ball spanned by lo <= hi, hardly larger than between(lo, hi), whose middle has as few words as its length
  /// allows. Products with such a middle are cheaper.
  static Ball about_short_middle(const Real& lo, const Real& hi) {
    return between(lo, hi, RealTraits<Real>::near((lo + hi) / 2, RealTraits<Real>::magnitude(Real(hi - lo))));
  }
  /// The ball about m that contains both ends.
  static Ball between(const Real& lo, const Real& hi, const Real& m) {
    const double reach = std::max(RealTraits<Real>::magnitude(Real(hi - m)), RealTraits<Real>::magnitude(Real(m - lo)));
    return Ball(m, reach * (1 + 0x1p-50) + RealTraits<Real>::magnitude(m) * (4 * unit_roundoff<Real>()));
  }

  /// -1 or +1 if all members have this sign, else 0.
  int sign() const {
    if (mid > rad) return 1;
    if (-mid > rad) return -1;
    return 0;
  }
  /// An upper bound of |x| over the ball.
  double magnitude() const { return (RealTraits<Real>::magnitude(mid) + rad) * (1 + 0x1p-50); }
  /// Bounds below and above all members.
  Real lower() const { return -detail::sum_above(Real(-mid), rad); }
  Real upper() const { return detail::sum_above(mid, rad); }
};

/// A coefficient, a double or a ball, as a ball.
template <class Real>
Ball<Real> as_ball(double x) {
  return Ball<Real>::exact(x);
}
template <class Real>
const Ball<Real>& as_ball(const Ball<Real>& x) {
  return x;
}

template <class Real>
inline Ball<Real> operator-(const Ball<Real>& a) {
  Ball<Real> minus([&] { return -a.mid; });
  minus.rad = a.rad;
  return minus;
}
template <class Real>
inline Ball<Real> operator+(const Ball<Real>& a, const Ball<Real>& b) {
  Ball<Real> sum([&] { return a.mid + b.mid; });
  sum.rad = detail::inflate(a.rad + b.rad + detail::rounding(sum.mid));
  return sum;
}
template <class Real>
inline Ball<Real> operator-(const Ball<Real>& a, const Ball<Real>& b) {
  Ball<Real> difference([&] { return a.mid - b.mid; });
  difference.rad = detail::inflate(a.rad + b.rad + detail::rounding(difference.mid));
  return difference;
}
template <class Real>
inline Ball<Real> operator*(const Ball<Real>& a, const Ball<Real>& b) {
  Ball<Real> product([&] { return a.mid * b.mid; });
  const double am = RealTraits<Real>::magnitude(a.mid), bm = RealTraits<Real>::magnitude(b.mid);
  double r = detail::rounding(product.mid);
  // 0 * infinity must stay infinite: an infinite radius means "anything".
  if (b.rad != 0) r += (am + a.rad) * b.rad;
  if (a.rad != 0) r += bm * a.rad;
  product.rad = detail::inflate(r);
  return product;
}
template <class Real>
Ball<Real> operator/(const Ball<Real>& a, const Ball<Real>& b) {
  // b| >= distance > 0. The magnitude of an MP number may be twice too large, so the distance is computed from the
  // number itself.
  const Real away = (b.mid < 0 ? Real(-b.mid) : b.mid) - b.rad;
  const double distance = away > 0 ? std::nextafter(RealTraits<Real>::to_double(away), 0.0) * (1 - 0x1p-50) : 0.0;
  if (!(distance > 0)) return Ball<Real>(Real(0), std::numeric_limits<double>::infinity());
  Real m = a.mid / b.mid;
  // The product may underflow, which the division would magnify.
  const double mm = RealTraits<Real>::magnitude(m);
  return Ball<Real>(m, detail::inflate((mm * b.rad + (a.rad + 0x1p-1060)) / distance + detail::rounding(m)));
}

/// Times 2^by, |by| <= 900.
template <class Real>
Ball<Real> scaled(const Ball<Real>& a, int by) {
  using std::ldexp;
  return {ldexp(a.mid, by), detail::inflate(a.rad * power_of_two(by))};
}

/// Multiplication by an exact double, such as a power of two.
template <class Real>
inline Ball<Real> operator*(const Ball<Real>& a, double b) {
  return a * Ball<Real>::exact(b);
}

/// Square root of the nonnegative members; where the ball reaches below zero the result covers [0, sqrt(upper)].
template <class Real>
Ball<Real> sqrt(const Ball<Real>& a) {
  const Real upper = a.mid + a.rad;
  if (!(upper > 0)) return Ball<Real>(Real(0), a.rad >= 0 ? detail::inflate(a.rad) : a.rad);
  const Real lower = a.mid - a.rad;
  if (!(lower > 0)) {
    const Real half = RealTraits<Real>::square_root(upper) / 2;
    return Ball<Real>(half, detail::inflate(RealTraits<Real>::to_double(half) * (1 + 0x1p-40)));
  }
  const Real m = RealTraits<Real>::square_root(a.mid);
  const double root_mid = RealTraits<Real>::to_double(m) * (1 - 0x1p-50);
  return Ball<Real>(m, detail::inflate((root_mid > 0 ? a.rad / root_mid : a.rad) + detail::rounding(m)));
}

/// The smallest ball that contains both.
template <class Real>
Ball<Real> hull(const Ball<Real>& a, const Ball<Real>& b) {
  const Real lo = std::min<Real>(a.lower(), b.lower()), hi = std::max<Real>(a.upper(), b.upper());
  return Ball<Real>::between(lo, hi);
}

// Reciprocals of small whole numbers, used in series instead of divisions: a product costs a third of a quotient.

/// 1/k for k = 1 .. 32, to the precision of the number type.
template <class Real>
const Ball<Real>& reciprocal(int k) {
  static const auto all = [] {
    std::array<Ball<Real>, 33> made;
    made[0] = Ball<Real>::exact(0);
    for (std::size_t i = 1; i < made.size(); ++i) {
      made[i] = Ball<Real>::exact(1) / Ball<Real>::exact(static_cast<double>(i));
    }
    return made;
  }();
  return all[static_cast<std::size_t>(k)];
}

}  // namespace taut::internal
