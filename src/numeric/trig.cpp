#include "numeric/trig.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "numeric/two_words.hpp"

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

// Sine and cosine of numbers with several words: in fixed-point numbers, at a tenth of the cost of floating-point ones.

namespace {

/// The words of pi; the last one is rounded.
constexpr RealMax::Limbs pi_words = {0xc2007cb8a163bf06, 0x49286651ece45b3d, 0xae9f24117c4b1fe6, 0xee386bfb5a899fa5,
                                     0x0bff5cb6f406b7ed, 0xf44c42e9a637ed6b, 0xe485b576625e7ec6, 0x4fe1356d6d51c245,
                                     0x302b0a6df25f1437, 0xef9519b3cd3a431b, 0x514a08798e3404dd, 0x020bbea63b139b22,
                                     0x29024e088a67cc74, 0xc4c6628b80dc1cd1, 0xc90fdaa22168c234};

/// A number in [0, 1), in units of 2^(-64 Words); the least significant word first.
template <std::size_t Words>
using Fraction = std::array<std::uint64_t, Words>;

/// The product of the first `Count` words of both alone, less than 17 units of the last of these too small.
template <std::size_t Count, std::size_t Words>
Fraction<Words> product(const Fraction<Words>& a, const Fraction<Words>& b) {
  static_assert(Count <= 16);
  constexpr std::size_t last = Words - Count;
  // Columns start from the one below the unit. The omitted ones contribute less than `Count` units.
  std::array<std::uint64_t, 2 * Count> sum{};
#pragma GCC unroll 6
  for (std::size_t i = 0; i < Count; ++i) {
    std::uint64_t carry = 0;
#pragma GCC unroll 6
    for (std::size_t k = Count - 1 - i; k < Count; ++k) {
      const TwoWords column = TwoWords{a[last + i]} * b[last + k] + sum[i + k] + carry;
      sum[i + k] = low_word(column);
      carry = high_word(column);
    }
    sum[i + Count] = carry;
  }
  Fraction<Words> result{};
#pragma GCC unroll 6
  for (std::size_t i = 0; i < Count; ++i) result[last + i] = sum[Count + i];
  return result;
}
template <std::size_t Words>
Fraction<Words> operator*(const Fraction<Words>& a, const Fraction<Words>& b) {
  return product<Words>(a, b);
}
/// Modulo 1, like all of these operations.
template <std::size_t Words>
Fraction<Words> operator-(Fraction<Words> a, const Fraction<Words>& b) {
  std::uint64_t borrow = 0;
#pragma GCC unroll 6
  for (std::size_t i = 0; i < Words; ++i) {
    const TwoWords difference = TwoWords{a[i]} - b[i] - borrow;
    a[i] = low_word(difference);
    borrow = high_word(difference) & 1;
  }
  return a;
}
template <std::size_t Words>
Fraction<Words> operator+(Fraction<Words> a, const Fraction<Words>& b) {
  std::uint64_t carry = 0;
#pragma GCC unroll 6
  for (std::size_t i = 0; i < Words; ++i) {
    const TwoWords sum = TwoWords{a[i]} + b[i] + carry;
    a[i] = low_word(sum);
    carry = high_word(sum);
  }
  return a;
}
/// Two or four times the number.
template <std::size_t Words>
Fraction<Words> doubled(Fraction<Words> a, int times) {
  for (std::size_t i = Words; i-- > 1;) a[i] = a[i] << times | a[i - 1] >> (64 - times);
  a[0] <<= times;
  return a;
}
/// A quotient by a small number, less than a unit too small.
template <std::size_t Words>
Fraction<Words> quotient(Fraction<Words> a, std::uint64_t by) {
  std::uint64_t rest = 0;
  for (std::size_t i = Words; i-- > 0;) {
    const TwoWords here = TwoWords{rest} << 64 | a[i];
    a[i] = low_word(here / by);
    rest = low_word(here % by);
  }
  return a;
}

/// 1 - cos r and 1 - sin r / r for an angle r up to 0.8. Both are small, and so are the losses when they are doubled,
/// whereas differences of the functions themselves would cancel.
///
/// They are computed from the Taylor polynomials at r / 2^10, whose squares w are below 2^-20: a term takes a third of
/// a word less than the preceding one. Ten doublings follow, each of which multiplies the error of the first one by
/// four.
template <std::size_t Words>
class FromOne {
 public:
  /// A bound of both errors. The errors of the sums are below 64 units: the loss in a term's product is multiplied by
  /// w^n, in units of its last word, and is at most one unit. Doubling changes errors e and d into at most 4 e + 34 and
  /// d + e + 17.
  static constexpr double error() { return power_of_two(27 - static_cast<int>(64 * Words)); }

  /// The argument is r / 2^10.
  explicit FromOne(const Fraction<Words>& r) {
    const Fraction<Words> w = r * r;
    cosine = w * series(w, 2);
    sine = w * series(w, 3);
    for (int i = 0; i < halvings; ++i) {
      // 1 - cos 2a = 4 v - 2 v^2, and sin 2a / 2a = (1 - m) (1 - v).
      const Fraction<Words> both = sine * cosine;
      sine = sine + cosine - both;
      cosine = doubled(cosine, 2) - doubled(cosine * cosine, 1);
    }
  }
  static constexpr int halvings = 10;

  Fraction<Words> cosine, sine;

 private:
  /// Terms down to w^n / (2 n)! < 2^(-64 Words).
  static constexpr int most_terms = [] {
    int n = 0, bits = 0;  // a lower bound of the bits of (2 n)!
    for (; 2 * halvings * n + bits < static_cast<int>(64 * Words); ++n) {
      bits += static_cast<int>(std::bit_width(static_cast<unsigned>((2 * n + 1) * (2 * n + 2)))) - 1;
    }
    return n;
  }();

  /// 1 / k!, less than two units too small. The entries for k = 0 and 1 are unused.
  static const std::array<Fraction<Words>, 2 * most_terms + 4>& reciprocal_factorials() {
    static const auto all = [] {
      std::array<Fraction<Words>, 2 * most_terms + 4> made{};
      made[2][Words - 1] = std::uint64_t{1} << 63;
      for (std::size_t k = 3; k < made.size(); ++k) made[k] = quotient(made[k - 1], k);
      return made;
    }();
    return all;
  }

  /// 1 / first! - w / (first + 2)! + w^2 / (first + 4)! ..., by Horner's rule.
  static Fraction<Words> series(const Fraction<Words>& w, std::size_t first) {
    Fraction<Words> sum = reciprocal_factorials()[first + 2 * most_terms];
    add_terms<unneeded(most_terms - 1)>(w, first, most_terms, sum);
    return sum;
  }
  /// The sum from term n on will be multiplied by w^n, so this many of its last words do not matter. If there are many,
  /// four at a time are omitted, because each length is compiled separately.
  static constexpr std::size_t unneeded(int n) {
    constexpr int step = Words > 8 ? 4 : 1;
    return static_cast<std::size_t>(2 * halvings * n / (64 * step) * step);
  }
  static constexpr std::size_t fewer(std::size_t unneeded) { return unneeded - (Words > 8 ? 4 : 1); }
  /// Adds the terms before `n`.
  template <std::size_t Unneeded>
  static void add_terms(const Fraction<Words>& w, std::size_t first, int n, Fraction<Words>& sum) {
    const auto& shares = reciprocal_factorials();
    for (; n > 0 && unneeded(n - 1) == Unneeded; --n) {
      sum = shares[first + 2 * static_cast<std::size_t>(n - 1)] - product<Words - Unneeded>(w, sum);
    }
    if constexpr (Unneeded > 0) add_terms<fewer(Unneeded)>(w, first, n, sum);
  }
};

/// |x| / 2^10, less than a unit too small; requires that |x| < 1.
template <std::size_t Words, class Real>
Fraction<Words> shrunk(const Real& x) {
  static_assert(64 * (Words - 1) == RealTraits<Real>::bits);
  Fraction<Words> fraction{};
  if (x.is_zero()) return fraction;
  // The mantissa is a number with one word less, from its highest bit on.
  const int down = -x.exponent() - 1 + FromOne<Words>::halvings;
  const auto words = static_cast<std::size_t>(down / 64);
  const int bits = down % 64;
  const auto mantissa = x.mantissa();
  const auto word = [&](std::size_t i) { return i == 0 || i >= Words ? 0 : mantissa[i - 1]; };
  for (std::size_t i = 0; i + words < Words; ++i) {
    const std::uint64_t here = word(i + words), above = word(i + words + 1);
    fraction[i] = bits == 0 ? here : here >> bits | above << (64 - bits);
  }
  return fraction;
}

/// 1 - x, with the given error of x and that of omitting its last word.
template <class Real, std::size_t Words>
Ball<Real> one_minus(const Fraction<Words>& x, double error) {
  const Fraction<Words> rest = Fraction<Words>{} - x;
  typename Real::Limbs first;
  bool is_one = true;
  for (std::size_t i = 0; i < first.size(); ++i) {
    first[i] = rest[i + 1];
    is_one = is_one && first[i] == 0;
  }
  const int exponent = -static_cast<int>(64 * first.size());
  return {is_one ? Real(1) : Real::of_limbs(first, exponent, false), error + power_of_two(exponent)};
}

}  // namespace

template <class Real>
SinCos<Real> sin_cos(const Ball<Real>& x) {
  using B = Ball<Real>;
  constexpr std::size_t words = Real::limbs + 1;
  const double size = RealTraits<Real>::magnitude(x.mid);
  if (!(size < 0x1p60) || !(x.rad < 4)) {
    // Nothing better is needed: the angle makes more than one full rotation over the ball.
    return {B(Real(0), 1.0), B(Real(0), 1.0)};
  }
  if (x.mid.is_zero()) return {x, B(Real(1), x.rad)};
  // The number of quarter turns. It may be off by one if the angle is nearly halfway between two of them.
  const Real half_pi = ldexp(pi<Real>(), -1);
  const std::int64_t k = size < 0x1p30
                             ? static_cast<std::int64_t>(std::nearbyint(x.mid.to_double() * 0.6366197723675814))
                             : (x.mid / half_pi).nearest_integer();
  // Computed for the middle; the radius of x is added at the end (both functions have slope at most 1).
  B r(x.mid, 0.0);
  if (k != 0) r = r - B(Real::of_integer(k), 0.0) * B(half_pi, 4 * unit_roundoff<Real>());
  const FromOne<words> from_one(shrunk<words>(r.mid));
  const double rad = detail::inflate(r.rad + x.rad);
  B s = B(r.mid, 0.0) * one_minus<Real>(from_one.sine, FromOne<words>::error());
  B c = one_minus<Real>(from_one.cosine, FromOne<words>::error());
  s.rad = detail::inflate(s.rad + rad);
  c.rad = detail::inflate(c.rad + rad);
  return quarter_turns(s, c, static_cast<int>(k & 3));
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

}  // namespace taut::internal
