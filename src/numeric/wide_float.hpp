// Binary floating-point numbers of several machine words, for the stages after doubles.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>

namespace taut::internal {

/// 0, or +-m 2^e, where m has Bits bits and is in [1, 2); or undefined, which is the result of an overflow, of a
/// division by zero and of the root of a negative number. Sums, differences and quotients are rounded to nearest, with
/// ties to even. So are products and roots, unless the true result lies within 2^-50 units of the last place of the
/// middle between two numbers: their error is less than a unit. A result that is representable at this length is exact.
/// Numbers smaller than 2^-1000000 become 0.
///
/// The length is a compile-time constant, and nothing is allocated: for lengths of a few words, bookkeeping would cost
/// more than the product itself. The functions are compiled once, in wide_float.cpp, for the lengths in use.
template <unsigned Bits>
class WideFloat {
  static_assert(Bits % 64 == 0 && Bits >= 128);

 public:
  static constexpr std::size_t limbs = Bits / 64;
  using Limbs = std::array<std::uint64_t, limbs>;  ///< the least significant first

  WideFloat() : word_{} {}
  /// Exact. Infinities and NaN give an undefined number.
  template <class Number>
  requires(std::is_floating_point_v<Number> || (std::is_integral_v<Number> && sizeof(Number) <= 4)) WideFloat(Number x)
      : WideFloat(of_double(static_cast<double>(x))) {
    static_assert(sizeof(Number) <= 8, "not exact");
  }
  /// The nearest number of this length; the same number if this length is not shorter.
  template <unsigned Other>
  requires(Other != Bits) explicit WideFloat(const WideFloat<Other>& x);
  /// The integer of these limbs times 2^exponent.
  static WideFloat of_limbs(const Limbs& integer, int exponent, bool negative);

  bool is_zero() const { return word_[limbs - 1] == 0; }
  bool is_defined() const { return exponent() != undefined_exponent; }
  bool is_negative() const { return word_[limbs] >> 32 != 0; }
  /// The e of +-m 2^e. Requires a nonzero number. The exponent of undefined numbers is larger than any other.
  std::int32_t exponent() const { return static_cast<std::int32_t>(static_cast<std::uint32_t>(word_[limbs])); }
  /// m 2^(Bits - 1), an integer; zeros for zero.
  std::span<const std::uint64_t, limbs> mantissa() const { return std::span(word_).template first<limbs>(); }

  /// The nearest double, which may be infinite; undefined numbers become NaN.
  double to_double() const;
  explicit operator double() const { return to_double(); }
  /// The nearest integer; requires a magnitude below 2^62.
  std::int64_t nearest_integer() const;
  static WideFloat of_integer(std::int64_t x);
  /// The first bits alone, at least `count` of them: shorter numbers are multiplied faster.
  WideFloat first_bits(int count) const;

  friend WideFloat operator-(const WideFloat& a) { return with_sign(a, !a.is_negative()); }
  friend WideFloat operator+(const WideFloat& a, const WideFloat& b) { return sum(a, b, b.is_negative()); }
  friend WideFloat operator-(const WideFloat& a, const WideFloat& b) { return sum(a, b, !b.is_negative()); }
  friend WideFloat operator*(const WideFloat& a, const WideFloat& b) { return product(a, b); }
  friend WideFloat operator/(const WideFloat& a, const WideFloat& b) { return quotient(a, b); }
  WideFloat& operator+=(const WideFloat& b) { return *this = *this + b; }
  WideFloat& operator-=(const WideFloat& b) { return *this = *this - b; }
  friend WideFloat sqrt(const WideFloat& x) { return square_root(x); }
  friend WideFloat abs(const WideFloat& x) { return with_sign(x, false); }
  friend WideFloat ldexp(const WideFloat& x, int by) { return scaled(x, by); }
  /// The nearest integer; requires a magnitude below 2^(Bits - 3). After the addition of so large a number, the last
  /// place is that of 1.
  friend WideFloat round(const WideFloat& x) {
    const WideFloat large = scaled(1.5, static_cast<int>(Bits) - 1);
    return (x + large) - large;
  }

  friend bool operator==(const WideFloat& a, const WideFloat& b) { return order(a, b) == 0; }
  /// An undefined number is neither less nor equal nor greater.
  friend std::partial_ordering operator<=>(const WideFloat& a, const WideFloat& b) { return order(a, b); }

 private:
  template <unsigned Other>
  friend class WideFloat;
  static constexpr std::int32_t undefined_exponent = std::numeric_limits<std::int32_t>::max();
  static constexpr std::int64_t largest_exponent = 1000000;

  /// Leaves the words uninitialized, for functions that write all of them.
  struct Unset {};
  explicit WideFloat(Unset) {}

  static WideFloat undefined();
  static WideFloat of_double(double x);
  /// The number with these limbs, whose first bit is set, and this exponent, which must be a valid one.
  static WideFloat of_words(const Limbs& mantissa, std::int32_t exponent, bool negative);
  static WideFloat with_sign(const WideFloat& x, bool negative);
  static WideFloat sum(const WideFloat& a, const WideFloat& b, bool b_negative);
  static WideFloat sum_of_magnitudes(const WideFloat& large, const WideFloat& small, bool negative);
  static WideFloat difference_of_magnitudes(const WideFloat& large, const WideFloat& small, bool negative);
  static WideFloat product(const WideFloat& a, const WideFloat& b);
  static WideFloat quotient(const WideFloat& a, const WideFloat& b);
  static WideFloat square_root(const WideFloat& x);
  static WideFloat scaled(const WideFloat& x, int by);
  static std::partial_ordering order(const WideFloat& a, const WideFloat& b);
  static std::strong_ordering order_of_magnitudes(const WideFloat& a, const WideFloat& b);
  /// Rounds a mantissa whose first bit is set: `below` is the word after its last one, and `lost` shows whether any
  /// nonzero bits follow.
  static WideFloat rounded(const Limbs& mantissa, std::uint64_t below, bool lost, std::int64_t exponent, bool negative);
  /// The limbs, followed by the exponent, plus 2^32 if the number is negative.
  std::array<std::uint64_t, limbs + 1> word_;
};

}  // namespace taut::internal
