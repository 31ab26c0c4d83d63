#include "numeric/trig.hpp"

#include <array>
#include <cstddef>

namespace taut {
namespace {

/// The words of pi, the last one rounded.
constexpr RealMax::Limbs pi_words = {0xc2007cb8a163bf06, 0x49286651ece45b3d, 0xae9f24117c4b1fe6, 0xee386bfb5a899fa5,
                                     0x0bff5cb6f406b7ed, 0xf44c42e9a637ed6b, 0xe485b576625e7ec6, 0x4fe1356d6d51c245,
                                     0x302b0a6df25f1437, 0xef9519b3cd3a431b, 0x514a08798e3404dd, 0x020bbea63b139b22,
                                     0x29024e088a67cc74, 0xc4c6628b80dc1cd1, 0xc90fdaa22168c234};

/// Sine and cosine of |r| <= 0.79 by their Taylor polynomials of degree 17 and 18.
/// Truncation is below 0.79^19/19! < 2^-62. Horner in r^2 with all |terms| < 1: the rounding of each step is damped by
/// r^2/6 < 0.11 before the next, so the total stays below 3 * 2^-53; 2^-51 is what we claim.
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

/// Turns the pair by k quarter turns.
template <class Real>
SinCos<Real> quarter_turns(const Ball<Real>& s, const Ball<Real>& c, int k) {
  switch (k & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

constexpr int halvings_of_angle = 10;
constexpr int most_terms = 40;  // 2^(-20 n) / (2 n)! is less than 2^-968 from 34 on

/// 1/k!, to the number's precision.
template <class Real>
const std::array<Ball<Real>, 2 * most_terms>& reciprocal_factorials() {
  static const auto all = [] {
    std::array<Ball<Real>, 2 * most_terms> made;
    made[0] = Ball<Real>::exact(1);
    for (std::size_t k = 1; k < made.size(); ++k) made[k] = made[k - 1] / Ball<Real>::exact(static_cast<double>(k));
    return made;
  }();
  return all;
}

/// The sum of w^(n - first) / (2 n + odd)! from n = first on, |w| <= 2^-20, by Horner's rule over the terms that
/// matter.
template <class Real>
Ball<Real> series_of_squares(const Ball<Real>& w, int first, int odd) {
  const auto& reciprocals = reciprocal_factorials<Real>();
  const auto share = [&](int n) -> const Ball<Real>& { return reciprocals[static_cast<std::size_t>(2 * n + odd)]; };
  const double size = w.magnitude();
  double power = size;  // of the first term that is left out
  int last = first;
  while (last + 2 < most_terms && power * share(last + 1).magnitude() > unit_roundoff<Real>() * 0x1p-8) {
    ++last;
    power *= size;
  }
  Ball<Real> sum = share(last);
  for (int n = last; n-- > first;) sum = sum * w + share(n);
  // What is left out shrinks at least by half from term to term.
  sum.rad = detail::inflate(sum.rad + 2 * power * share(last + 1).magnitude());
  return sum;
}

template <class Real>
SinCos<Real> sin_cos_multi(const Ball<Real>& x) {
  using B = Ball<Real>;
  const double size = RealTraits<Real>::magnitude(x.mid);
  if (!(size < 0x1p60) || !(x.rad < 4)) {
    // Nothing better is needed: such an angle turns more than once over the ball.
    return {B(Real(0), 1.0), B(Real(0), 1.0)};
  }
  const Real half_pi = ldexp(pi<Real>(), -1);
  const std::int64_t k = (x.mid / half_pi).nearest_integer();
  const B turns(Real::of_integer(k), 0.0);
  const B quarter(half_pi, 4 * unit_roundoff<Real>());
  // Work at the middle; the radius of x is added at the end (both functions have slope at most 1).
  const B r = (B(x.mid, 0.0) - turns * quarter) * std::ldexp(1.0, -halvings_of_angle);
  const B w = -(r * r);
  // sin(r)/r and 1 - cos(r), |r| < 2^-10, to below the working precision.
  const B sine = series_of_squares(w, 0, 1), versine = -(w * series_of_squares(w, 1, 0));
  // Doubling: with v = 1 - cos a: 1 - cos 2a = 2 v (2 - v), sin 2a = 2 sin a (1 - v). Stable for small a.
  B s = r * sine, v = versine;
  for (int i = 0; i < halvings_of_angle; ++i) {
    const B one_minus = B::exact(1) - v;
    s = s * one_minus * 2.0;
    v = v * (B::exact(2) - v) * 2.0;
  }
  B c = B::exact(1) - v;
  s.rad = detail::inflate(s.rad + x.rad);
  c.rad = detail::inflate(c.rad + x.rad);
  return quarter_turns(s, c, static_cast<int>(k & 3));
}

}  // namespace

SinCos<double> sin_cos(const Ball<double>& x) {
  using B = Ball<double>;
  if (!(std::fabs(x.mid) < 0x1p19) || !(x.rad < 4)) {
    if (std::fabs(x.mid) < 0x1p60 && x.rad < 4) {
      const SinCos<Real320> w = sin_cos_multi(Ball<Real320>(Real320(x.mid), x.rad));
      const auto narrow = [](const Ball<Real320>& b) {
        return B(RealTraits<Real320>::to_double(b.mid), detail::inflate(b.rad + 0x1p-53));
      };
      return {narrow(w.sin), narrow(w.cos)};
    }
    return {B(0.0, 1.0), B(0.0, 1.0)};
  }
  // Cody-Waite: pi/2 = p1 + p2 + p3 + (< 2^-115). p1 and p2 have 33 bits, so that k * p1 and k * p2 are exact for
  // |k| < 2^20; x - k p1 is exact, the next two steps round once each: |error of r| < 2^-53 + 2^-95.
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
  // pi/2 = p1 + p2 + p3 + (< 2^-163), each the double nearest to what is left. The quotient errs by less than 2^-12, so
  // that |r| < 0.79. hi - k p1 is exact but for its last step, and the rest is below 2^-9: two roundings of results
  // below 1, and a few of the rest's, make less than 2^-52. The slopes are at most 1.
  constexpr double p1 = 0x1.921fb54442d18p+0, p2 = 0x1.1a62633145c07p-54, p3 = -0x1.f1976b7ed8fbcp-110;
  const double k = std::nearbyint(hi * 0.63661977236758134308);
  const TwoDoubles first = two_product(k, p1), second = two_product(k, p2);
  const double rest = (lo - first.lo) - (second.hi + (second.lo + k * p3));
  const double r = (hi - first.hi) + rest;
  const SmallAngle a = small_angle(r);
  constexpr double error = small_angle_error + 0x1p-52;
  return quarter_turns(B(a.sin, error), B(a.cos, error), static_cast<int>(k - 4.0 * std::floor(k / 4.0)));
}

template <class Real>
SinCos<Real> sin_cos(const Ball<Real>& x) {
  return sin_cos_multi(x);
}
template <class Real>
Real pi() {
  return Real(RealMax::of_limbs(pi_words, 2 - RealTraits<RealMax>::bits, false));
}
#define TAUT_INSTANTIATE(Real) \
  template Real pi<Real>();    \
  template SinCos<Real> sin_cos(const Ball<Real>&);
TAUT_FOR_EACH_PRECISION(TAUT_INSTANTIATE)
#undef TAUT_INSTANTIATE

}  // namespace taut
