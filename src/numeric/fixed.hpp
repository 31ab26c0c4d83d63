// Fixed-point numbers with error bounds: for events that differ by a displacement only.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "numeric/ball.hpp"
#include "numeric/real.hpp"
#include "numeric/two_words.hpp"

namespace taut::internal {

/// An integer times 2^-320, between -2^63 and 2^63, in two's complement. All quantities of a pair of bodies are scaled
/// to about 1, and ties are decided by quantities of about 2^-200. So the binary point need not move, and a product
/// costs a fraction of that of floating-point numbers of the same length. Only FixedBall detects an overflow of the
/// range.
class Fixed {
 public:
  static constexpr int limbs = 6, fraction_bits = 320;
  /// A unit in the last place, and an error bound of a product.
  static constexpr double unit = 0x1p-320, lost_in_product = 0x1p-316;
  /// Doubles below this are within the range.
  static constexpr double limit = 0x1p62;

  Fixed() : limb_{} {}
  /// Rounds x towards zero, with an error of less than a unit; requires |x| < limit.
  explicit Fixed(double x) : limb_{} {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    const int exponent = static_cast<int>(bits >> 52 & 0x7ff);
    std::uint64_t digits = (bits & 0xfffffffffffff) | (exponent > 0 ? std::uint64_t{1} << 52 : 0);
    int place = std::max(exponent, 1) - 1075 + fraction_bits;
    if (place < 0) {
      digits = place > -64 ? digits >> -place : 0;
      place = 0;
    }
    put(digits, place);
    if (x < 0) negate();
  }
  /// Rounds a binary number towards zero; requires that it is within the range.
  template <unsigned Bits>
  explicit Fixed(const WideFloat<Bits>& x) : limb_{} {
    if (x.is_zero()) return;
    int place = x.exponent() - static_cast<int>(Bits) + 1 + fraction_bits;
    for (const std::uint64_t digits : x.mantissa()) {
      if (place >= 0) {
        put(digits, place);
      } else if (place > -64) {
        put(digits >> -place, 0);
      }
      place += 64;
    }
    if (x.is_negative()) negate();
  }

  bool is_negative() const { return static_cast<std::int64_t>(limb_[limbs - 1]) < 0; }
  void negate() {
    std::uint64_t carry = 1;
    for (std::uint64_t& limb : limb_) {
      limb = ~limb + carry;
      carry = carry != 0 && limb == 0 ? 1 : 0;
    }
  }
  /// The number times 2^by, less than a unit too small. Bits that leave the range at the upper end are lost.
  Fixed scaled(int by) const {
    const bool up = by >= 0;
    const auto words = static_cast<std::size_t>(std::abs(by) / 64);
    const int bits = std::abs(by) % 64;
    const std::uint64_t beyond = is_negative() ? ~std::uint64_t{0} : 0;
    // The limbs of this number, with zeros before the first one and sign bits after the last.
    const auto limb = [&](std::size_t i) { return i < limbs ? limb_[i] : beyond; };
    Fixed result;
    for (std::size_t i = 0; i < limbs; ++i) {
      if (!up) {
        const std::uint64_t here = limb(i + words), above = limb(i + words + 1);
        result.limb_[i] = bits == 0 ? here : here >> bits | above << (64 - bits);
      } else if (i >= words) {
        const std::uint64_t here = limb_[i - words], below = i > words ? limb_[i - words - 1] : 0;
        result.limb_[i] = bits == 0 ? here : here << bits | below >> (64 - bits);
      }
    }
    return result;
  }
  friend Fixed operator-(Fixed a) {
    a.negate();
    return a;
  }
  friend Fixed operator+(Fixed a, const Fixed& b) {
    std::uint64_t carry = 0;
#pragma GCC unroll 6
    for (std::size_t i = 0; i < limbs; ++i) {
      const TwoWords sum = TwoWords{a.limb_[i]} + b.limb_[i] + carry;
      a.limb_[i] = low_word(sum);
      carry = high_word(sum);
    }
    return a;
  }
  friend Fixed operator-(Fixed a, const Fixed& b) {
    std::uint64_t borrow = 0;
#pragma GCC unroll 6
    for (std::size_t i = 0; i < limbs; ++i) {
      const TwoWords difference = TwoWords{a.limb_[i]} - b.limb_[i] - borrow;
      a.limb_[i] = low_word(difference);
      borrow = high_word(difference) & 1;
    }
    return a;
  }
  /// The product, with an error of less than lost_in_product.
  friend Fixed operator*(const Fixed& a, const Fixed& b) {
    // Computes row by row the columns of the full product from the one below the last place on. The columns below that
    // contribute less than four units there. Most numbers have rows of zeros. To keep them zero, the first factor is
    // taken without its sign. The words of the second factor are those of b, or of b + 2^384.
    constexpr std::size_t first = fraction_bits / 64 - 1;
    const Fixed x = a.is_negative() ? -a : a;
    std::array<std::uint64_t, 2 * limbs> sum{};
#pragma GCC unroll 6
    for (std::size_t i = 0; i < limbs; ++i) {
      const std::uint64_t row = x.limb_[i];
      if (row == 0) continue;
      std::uint64_t carry = 0;
#pragma GCC unroll 6
      for (std::size_t k = i < first ? first - i : 0; k < limbs; ++k) {
        const TwoWords column = TwoWords{row} * b.limb_[k] + sum[i + k] + carry;
        sum[i + k] = low_word(column);
        carry = high_word(column);
      }
      sum[i + limbs] = carry;
    }
    Fixed result;
    std::memcpy(result.limb_.data(), sum.data() + first + 1, sizeof result.limb_);
    if (b.is_negative()) result = result - x.moved_up();
    if (a.is_negative()) result.negate();
    return result;
  }

  /// An approximation with a relative error of at most 2^-50.
  double approximate() const {
    const Fixed size = is_negative() ? -*this : *this;
    std::size_t top = limbs - 1;
    while (top > 0 && size.limb_[top] == 0) --top;
    double value = static_cast<double>(size.limb_[top]);
    if (top > 0) value += static_cast<double>(size.limb_[top - 1]) * 0x1p-64;
    value *= power_of_two(static_cast<int>(64 * top) - fraction_bits);
    return is_negative() ? -value : value;
  }
  /// Passes the number as nonoverlapping doubles, the largest first.
  template <class Take>
  void each_part(const Take& take) const {
    const double sign = is_negative() ? -1 : 1;
    Fixed size = is_negative() ? -*this : *this;
    for (std::size_t k = limbs; k-- > 0;) {
      while (size.limb_[k] != 0) {
        // The 53 bits from the highest one on, if there are that many.
        const int top = static_cast<int>(64 * k + std::bit_width(size.limb_[k])), place = std::max(top - 53, 0);
        const std::uint64_t digits = size.take_from(place);
        take(sign * static_cast<double>(digits) * power_of_two(place - fraction_bits));
      }
    }
  }
  static constexpr std::size_t most_parts = 8;

 private:
  /// The number times 2^64, ignoring the overflow of its first word.
  Fixed moved_up() const {
    Fixed up;
    for (std::size_t i = 1; i < limbs; ++i) up.limb_[i] = limb_[i - 1];
    return up;
  }

  /// Sets bits that are not set yet.
  void put(std::uint64_t digits, int place) {
    const auto k = static_cast<std::size_t>(place / 64);
    const int shift = place % 64;
    if (k >= limbs) return;
    limb_[k] |= digits << shift;
    if (shift > 0 && k + 1 < limbs) limb_[k + 1] |= digits >> (64 - shift);
  }

  /// Removes and returns all bits from a place on, at most 53.
  std::uint64_t take_from(int place) {
    const auto k = static_cast<std::size_t>(place / 64);
    const int shift = place % 64;
    std::uint64_t digits = limb_[k] >> shift;
    limb_[k] &= (std::uint64_t{1} << shift) - 1;
    if (k + 1 < limbs && limb_[k + 1] != 0) {
      digits |= limb_[k + 1] << (64 - shift);
      limb_[k + 1] = 0;
    }
    return digits;
  }

  std::array<std::uint64_t, limbs> limb_;
};

/// A fixed-point number with a bound of its error and a bound of its magnitude. A number that leaves the range becomes
/// "anything".
class FixedBall {
 public:
  FixedBall() = default;
  static FixedBall exact(double x) {
    const double size = std::fabs(x);
    if (!(size < Fixed::limit)) return anything();
    // From 2^-267 on, the last of the 53 bits is at least a unit.
    return FixedBall(Fixed(x), size >= 0x1p-267 || size == 0 ? 0 : Fixed::unit, size);
  }
  template <unsigned Bits>
  static FixedBall of(const Ball<WideFloat<Bits>>& x) {
    const double size = RealTraits<WideFloat<Bits>>::magnitude(x.mid);
    if (!(size < Fixed::limit)) return anything();
    return FixedBall(Fixed(x.mid), (x.rad + Fixed::unit) * up, size + x.rad + Fixed::unit);
  }
  FixedBall(const Fixed& mid, double rad, double most) : mid_(mid), rad_(rad), most_(most) {}

  const Fixed& mid() const { return mid_; }
  double rad() const { return rad_; }
  /// A bound of its magnitude.
  double most() const { return most_; }
  bool is_zero() const { return most_ == 0; }
  /// A double nearby, and a bound of its distance from the true number.
  double about() const { return mid_.approximate(); }
  double error_of(double about) const { return (rad_ + std::fabs(about) * 0x1p-49) * up; }
  /// The sign, -1 or 1, if that is certain, else 0.
  int sign() const {
    const double x = about(), error = error_of(x);
    return x > error ? 1 : (-x > error ? -1 : 0);
  }
  /// The same number with a tighter bound of its magnitude, for use after cancellation.
  FixedBall tightened() const {
    const double size = std::fabs(about());
    return {mid_, rad_, std::min(most_, (size * up + rad_) * up)};
  }
  /// The number times 2^by, |by| <= 900.
  FixedBall scaled(int by) const {
    const double factor = power_of_two(by), most = most_ * factor;
    if (!(most < Fixed::limit)) return anything();
    if (is_zero()) return {};
    return FixedBall(mid_.scaled(by), (rad_ * factor + Fixed::unit) * up, (most + Fixed::unit) * up);
  }
  void widen(double by) {
    rad_ = (rad_ + by) * up;
    most_ = (most_ + by) * up;
    check();
  }

  friend FixedBall operator-(FixedBall a) {
    a.mid_.negate();
    return a;
  }
  friend FixedBall operator+(const FixedBall& a, const FixedBall& b) {
    FixedBall sum(a.mid_ + b.mid_, (a.rad_ + b.rad_) * up, (a.most_ + b.most_) * up);
    sum.check();
    return sum;
  }
  friend FixedBall operator-(const FixedBall& a, const FixedBall& b) {
    FixedBall difference(a.mid_ - b.mid_, (a.rad_ + b.rad_) * up, (a.most_ + b.most_) * up);
    difference.check();
    return difference;
  }
  friend FixedBall operator*(const FixedBall& a, const FixedBall& b) {
    if (a.is_zero() || b.is_zero()) return {};
    FixedBall product(a.mid_ * b.mid_, (a.most_ * b.rad_ + b.most_ * a.rad_ + Fixed::lost_in_product) * up,
                      (a.most_ * b.most_ + Fixed::lost_in_product) * up);
    product.check();
    return product;
  }

 private:
  static constexpr double up = 1 + 0x1p-50;

  static FixedBall anything() {
    FixedBall x;
    x.rad_ = x.most_ = std::numeric_limits<double>::infinity();
    return x;
  }
  void check() {
    if (!(most_ < Fixed::limit)) *this = anything();  // also catches a NaN
  }

  Fixed mid_;
  double rad_ = 0, most_ = 0;
};

// Two doubles processed in parallel, each rounded as it would be alone: the common subset of SSE2, NEON and
// WebAssembly.

/// GCC's and clang's vector type: + - * / act on both elements, each rounding as IEEE 754 says.
using Lanes = double __attribute__((vector_size(16)));

inline Lanes load_lanes(const double* from) {
  Lanes x;
  std::memcpy(&x, from, sizeof x);
  return x;
}
inline void store_lanes(double* to, Lanes x) { std::memcpy(to, &x, sizeof x); }
inline Lanes both(double x) { return Lanes{x, x}; }

}  // namespace taut::internal
