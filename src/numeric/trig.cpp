#include "numeric/trig.hpp"

#include <cmath>

namespace taut::internal {
namespace {

/// Sine and cosine of |r| <= 0.79 by their Taylor polynomials of degree 17 and 18. Truncation is below 0.79^19/19! <
/// 2^-62. Horner's rule in r^2 has all |terms| < 1. The rounding of each step is damped by r^2/6 < 0.11 before the
/// next, so the total stays below 3 * 2^-53. The bound used is 2^-51.
struct SmallAngle {
  double sin, cos;
};
constexpr double small_angle_error = 0x1p-51;

SmallAngle small_angle(double r) {
  const double z = r * r;
  double s = 1.0 / 355687428096000.0;
  s = s * z - 1.0 / 1307674368000.0;
  s = s * z + 1.0 / 6227020800.0;
  s = s * z - 1.0 / 39916800.0;
  s = s * z + 1.0 / 362880.0;
  s = s * z - 1.0 / 5040.0;
  s = s * z + 1.0 / 120.0;
  s = s * z - 1.0 / 6.0;
  double c = -1.0 / 6402373705728000.0;
  c = c * z + 1.0 / 20922789888000.0;
  c = c * z - 1.0 / 87178291200.0;
  c = c * z + 1.0 / 479001600.0;
  c = c * z - 1.0 / 3628800.0;
  c = c * z + 1.0 / 40320.0;
  c = c * z - 1.0 / 720.0;
  c = c * z + 1.0 / 24.0;
  c = c * z - 0.5;
  return {r + r * (z * s), 1.0 + z * c};
}

}  // namespace

SinCos<double> sin_cos(const Ball<double>& x) {
  using B = Ball<double>;
  if (!(std::fabs(x.mid) < 0x1p19) || !(x.rad < 4)) {
    if (std::fabs(x.mid) < 0x1p60 && x.rad < 4) {
      const SinCos<Real320> w = sin_cos(Ball<Real320>(Real320(x.mid), x.rad));
      const auto narrow = [](const Ball<Real320>& b) {
        return B(RealTraits<Real320>::to_double(b.mid), detail::inflate(b.rad + 0x1p-53));
      };
      return {narrow(w.sin), narrow(w.cos)};
    }
    return {B(0.0, 1.0), B(0.0, 1.0)};
  }
  // Cody-Waite: pi/2 = p1 + p2 + p3 + (< 2^-115). p1 and p2 have 33 bits, so that k * p1 and k * p2 are exact for |k| <
  // 2^20. x - k p1 is exact, and the next two steps round once each: |error of r| < 2^-53 + 2^-95.
  constexpr double p1 = 0x1.921fb544p+0, p2 = 0x1.0b4611a6p-34, p3 = 0x1.3198a2e037073p-69;
  const double k = std::nearbyint(x.mid * 0.63661977236758134308);
  const double r = ((x.mid - k * p1) - k * p2) - k * p3;
  const SmallAngle a = small_angle(r);
  const double error = x.rad + (small_angle_error + 0x1p-52);
  const int quadrant = static_cast<int>(k - 4.0 * std::floor(k / 4.0));
  return quarter_turns(B(a.sin, error * (1 + 0x1p-50)), B(a.cos, error * (1 + 0x1p-50)), quadrant);
}

SinCos<double> sin_cos_of_sum(double hi, double lo) {
  using B = Ball<double>;
  // pi/2 = p1 + p2 + p3 + (< 2^-163), where each is the double nearest to the remainder. The quotient has an error of
  // less than 2^-12, so that |r| < 0.79. hi - k p1 is exact except for its last step, and the rest is below 2^-9. Two
  // roundings of results below 1, and a few of the rest's, make less than 2^-52. The slopes are at most 1.
  constexpr double p1 = 0x1.921fb54442d18p+0, p2 = 0x1.1a62633145c07p-54, p3 = -0x1.f1976b7ed8fbcp-110;
  const double k = std::nearbyint(hi * 0.63661977236758134308);
  const TwoDoubles first = two_product(k, p1), second = two_product(k, p2);
  const double rest = (lo - first.lo) - (second.hi + (second.lo + k * p3));
  const double r = (hi - first.hi) + rest;
  const SmallAngle a = small_angle(r);
  constexpr double error = small_angle_error + 0x1p-52;
  return quarter_turns(B(a.sin, error), B(a.cos, error), static_cast<int>(k - 4.0 * std::floor(k / 4.0)));
}

}  // namespace taut::internal
