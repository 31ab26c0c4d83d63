// The number types of the stages of certified evaluation: double, then 320 and 960 bit binary floats.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <tuple>
#include <utility>

#include "numeric/wide_float.hpp"

namespace taut::internal {

/// The precisions of the multi-precision stages, in order. To add one, add it here, and its length where WideFloat is
/// compiled. Beyond the last one the answer is `undecided`. One more between the two would decide nothing that the last
/// one does not decide, and would add a sixth to the engines' code. Few queries get that far, so their cost is not
/// noticeable.
#define TAUT_FOR_EACH_PRECISION(DO) DO(Real320) DO(Real960)
using Real320 = WideFloat<320>;
using Real960 = WideFloat<960>;
using Precisions = std::tuple<Real320, Real960>;

namespace detail {
template <template <class> class Of, class... Reals, class... Before>
std::tuple<Of<Before>..., Of<Reals>...> of_each(const std::tuple<Reals...>&, const std::tuple<Before...>&);
}  // namespace detail
/// A tuple of Of<Real> for each precision, preceded by those for other numbers.
template <template <class> class Of, class... Before>
using OfEachPrecision = decltype(detail::of_each<Of>(std::declval<Precisions>(), std::tuple<Before...>()));
inline constexpr int precise_stages = static_cast<int>(std::tuple_size_v<Precisions>);
/// The widest type: every number of a narrower stage converts to it exactly.
using RealMax = std::tuple_element_t<precise_stages - 1, Precisions>;

/// Absolute error added by every operation on balls, so that underflow (of a double, or of a radius) is harmless.
/// Coordinates are scaled to about 1, and the smallest quantity that ever decides is the square of the displacement,
/// about 2^-400.
inline constexpr double underflow_slack = 0x1p-1000;

/// 2^e for the exponents of normal doubles, without the special cases of std::ldexp.
inline double power_of_two(int e) {
  const std::uint64_t bits = static_cast<std::uint64_t>(e + 1023) << 52;
  double x;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

template <class Real>
struct RealTraits;

template <>
struct RealTraits<double> {
  static constexpr int bits = 53;
  static constexpr double unit_roundoff = 0x1p-53;
  static double magnitude(double x) { return std::fabs(x); }
  static double from_double(double x) { return x; }
  static double to_double(double x) { return x; }
  static double square_root(double x) { return std::sqrt(x); }
  static double near(double x, double) { return x; }
};

template <unsigned Bits>
struct RealTraits<WideFloat<Bits>> {
  using Real = WideFloat<Bits>;
  static constexpr int bits = static_cast<int>(Bits);
  /// Operations have an error of less than a unit in the last place, most of them of at most half of it.
  static double unit() { return power_of_two(1 - bits); }
  /// An upper bound of |x|. From 2^-990 on, it is computed from the first 32 bits, so that products of wide balls do
  /// not grow. From 2^-1020 on, it is at most twice too large. For smaller numbers it is 2^-1018.
  static double magnitude(const Real& x) {
    if (x.is_zero()) return 0;
    const auto e = x.exponent();
    if (e > 1000) return std::numeric_limits<double>::infinity();
    if (e < -1020) return 0x1p-1018;
    if (e < -990) return power_of_two(e + 1);
    const auto first_bits = static_cast<std::uint32_t>(x.mantissa().back() >> 32);
    return (static_cast<double>(first_bits) + 1) * power_of_two(e - 31);
  }
  static Real from_double(double x) { return x; }
  static double to_double(const Real& x) { return x.to_double(); }
  static Real square_root(const Real& x) { return sqrt(x); }
  /// A number within a thousandth of `within` of x, with as few words as this needs.
  static Real near(const Real& x, double within) {
    if (x.is_zero() || !(within > 0) || !std::isfinite(within)) return x;
    return x.first_bits(x.exponent() - std::ilogb(within) + 12);
  }
};

template <class Real>
inline double unit_roundoff() {
  if constexpr (std::is_same_v<Real, double>) {
    return RealTraits<double>::unit_roundoff;
  } else {
    return RealTraits<Real>::unit();
  }
}

/// The largest double certainly below x, and the smallest certainly above (one or two ulps away).
template <class Real>
double double_below(const Real& x) {
  const double d = RealTraits<Real>::to_double(x);
  return std::nextafter(d, -std::numeric_limits<double>::infinity());
}
/// The largest double not above x.
template <class Real>
double double_floor(const Real& x) {
  const double d = RealTraits<Real>::to_double(x);
  return Real(d) > x ? std::nextafter(d, -std::numeric_limits<double>::infinity()) : d;
}
template <class Real>
double double_above(const Real& x) {
  const double d = RealTraits<Real>::to_double(x);
  return std::nextafter(d, std::numeric_limits<double>::infinity());
}

}  // namespace taut::internal
