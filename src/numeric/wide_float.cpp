#include "numeric/wide_float.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "numeric/two_words.hpp"

namespace taut::internal {
namespace {

/// GCC's and clang's vector type of two words, stored at once.
using TwoStored = std::uint64_t __attribute__((vector_size(16)));

/// Converts 1 or 0 to a mask of all bits or none.
std::uint64_t mask_of(std::uint64_t bit) { return 0 - bit; }

/// Shifts the words to the left until the first bit is set, and returns the number of bits; requires a nonzero number.
template <std::size_t N>
int normalise(std::array<std::uint64_t, N>& x) {
  std::size_t top = N - 1;
  while (x[top] == 0) --top;
  const std::size_t words = N - 1 - top;
  const int bits = std::countl_zero(x[top]);
  for (std::size_t i = N; i-- > 0;) {
    const std::uint64_t here = i >= words ? x[i - words] : 0, below = i > words ? x[i - words - 1] : 0;
    x[i] = bits == 0 ? here : here << bits | below >> (64 - bits);
  }
  return static_cast<int>(64 * words) + bits;
}

/// A mantissa with one more word at its end, shifted to the right by `by` bits, at most all but one.
template <std::size_t N>
class Moved {
 public:
  Moved(std::span<const std::uint64_t, N> mantissa, std::size_t by) : skipped_(by / 64), bits_(by % 64) {
    std::memcpy(word_.data() + 1, mantissa.data(), mantissa.size_bytes());
  }
  /// Word 0 is the one at the end.
  std::uint64_t word(std::size_t i) const {
    return word_[i + skipped_] >> bits_ | word_[i + skipped_ + 1] << 1 << (63 - bits_);
  }
  /// Have any nonzero bits been shifted out?
  bool lost() const {
    std::uint64_t left = word_[skipped_] & ((std::uint64_t{1} << bits_) - 1);
    for (std::size_t i = 1; i < skipped_; ++i) left |= word_[i];
    return left != 0;
  }

 private:
  std::array<std::uint64_t, 2 * N + 3> word_{};  ///< with zeros at both ends
  std::size_t skipped_, bits_;
};

/// The same mantissa with another exponent, in the range where a double can approximate its reciprocal.
template <unsigned Bits>
WideFloat<Bits> with_exponent(const WideFloat<Bits>& x, int exponent) {
  return ldexp(x, exponent - x.exponent());
}

}  // namespace

template <unsigned Bits>
WideFloat<Bits> WideFloat<Bits>::undefined() {
  Limbs mantissa{};
  mantissa[limbs - 1] = 1;
  return of_words(mantissa, undefined_exponent, false);
}

/// Stores two words at a time, because copies of the number read them in that way. Data stored by halves cannot be read
/// as a whole until both halves have been written to the cache, which takes as long as a product.
template <unsigned Bits>
WideFloat<Bits> WideFloat<Bits>::of_words(const Limbs& mantissa, std::int32_t exponent, bool negative) {
  WideFloat x{Unset()};
  const std::uint64_t last = static_cast<std::uint32_t>(exponent) | std::uint64_t{negative} << 32;
#pragma GCC unroll 8
  for (std::size_t i = 0; i < limbs; i += 2) {
    const TwoStored two = {mantissa[i], i + 1 < limbs ? mantissa[i + 1] : last};
    std::memcpy(x.word_.data() + i, &two, sizeof two);
  }
  if constexpr (limbs % 2 == 0) x.word_[limbs] = last;
  return x;
}

template <unsigned Bits>
WideFloat<Bits> WideFloat<Bits>::with_sign(const WideFloat& x, bool negative) {
  Limbs mantissa;
  std::memcpy(mantissa.data(), x.word_.data(), sizeof mantissa);
  return of_words(mantissa, x.exponent(), negative && !x.is_zero());
}

/// Rounds without a branch, because the direction is unpredictable.
template <unsigned Bits>
inline WideFloat<Bits> WideFloat<Bits>::rounded(const Limbs& mantissa, std::uint64_t below, bool lost,
                                                std::int64_t exponent, bool negative) {
  const bool beyond_half = (below << 1) != 0 || lost;
  std::uint64_t carry = below >> 63 & ((beyond_half ? 1 : 0) | mantissa[0]);
  Limbs result;
#pragma GCC unroll 16
  for (std::size_t i = 0; i < limbs; ++i) {
    result[i] = mantissa[i] + carry;
    carry = result[i] < carry ? 1 : 0;
  }
  if (carry != 0) {
    result[limbs - 1] = std::uint64_t{1} << 63;
    ++exponent;
  }
  if (exponent > largest_exponent) return undefined();
  if (exponent < -largest_exponent) return {};
  return of_words(result, static_cast<std::int32_t>(exponent), negative);
}

template <unsigned Bits>
WideFloat<Bits> WideFloat<Bits>::of_double(double x) {
  if (x == 0) return {};
  if (!std::isfinite(x)) return undefined();
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  const int biased = static_cast<int>(bits >> 52 & 0x7ff);
  const std::uint64_t digits = (bits & 0xfffffffffffff) | (biased > 0 ? std::uint64_t{1} << 52 : 0);
  const int shift = std::countl_zero(digits);
  Limbs mantissa{};
  mantissa[limbs - 1] = digits << shift;
  return of_words(mantissa, std::max(biased, 1) - 1075 + 63 - shift, x < 0);
}

template <unsigned Bits>
template <unsigned Other>
requires(Other != Bits) WideFloat<Bits>::WideFloat(const WideFloat<Other>& x) {
  Limbs mantissa{};
  if constexpr (Other < Bits) {
    std::memcpy(mantissa.data() + (limbs - x.limbs), x.word_.data(), sizeof(std::uint64_t) * x.limbs);
    *this = of_words(mantissa, x.exponent(), x.is_negative());
  } else if (x.is_zero() || !x.is_defined()) {
    *this = x.is_zero() ? WideFloat() : undefined();
  } else {
    constexpr std::size_t dropped = WideFloat<Other>::limbs - limbs;
    bool lost = false;
    for (std::size_t i = 0; i + 1 < dropped; ++i) lost = lost || x.word_[i] != 0;
    std::memcpy(mantissa.data(), x.word_.data() + dropped, sizeof mantissa);
    *this = rounded(mantissa, x.word_[dropped - 1], lost, x.exponent(), x.is_negative());
  }
}

template <unsigned Bits>
WideFloat<Bits> WideFloat<Bits>::of_limbs(const Limbs& integer, int exponent, bool negative) {
  if (std::all_of(integer.begin(), integer.end(), [](std::uint64_t limb) { return limb == 0; })) return {};
  Limbs mantissa = integer;
  const int shift = normalise(mantissa);
  return rounded(mantissa, 0, false, std::int64_t{exponent} + static_cast<int>(Bits) - 1 - shift, negative);
}

template <unsigned Bits>
WideFloat<Bits> WideFloat<Bits>::of_integer(std::int64_t x) {
  Limbs integer{};
  integer[0] = x < 0 ? -static_cast<std::uint64_t>(x) : static_cast<std::uint64_t>(x);
  return of_limbs(integer, 0, x < 0);
}

template <unsigned Bits>
double WideFloat<Bits>::to_double() const {
  if (is_zero()) return 0;
  if (!is_defined()) return std::numeric_limits<double>::quiet_NaN();
  // As many bits of the first word as the double has, fewer for subnormal results, rounded to the nearest.
  const int place = std::clamp(exponent(), -5000, 5000), dropped = 11 + std::clamp(-1022 - place, 0, 53);
  const std::uint64_t first = word_[limbs - 1], half = std::uint64_t{1} << (dropped - 1), rest = first & (2 * half - 1);
  const bool behind =
      std::any_of(word_.begin(), word_.begin() + (limbs - 1), [](std::uint64_t limb) { return limb != 0; });
  std::uint64_t digits = first >> (dropped - 1) >> 1;
  if (rest > half || (rest == half && (behind || (digits & 1) != 0))) ++digits;
  const double size = std::ldexp(static_cast<double>(digits), place - 63 + dropped);
  return is_negative() ? -size : size;
}

template <unsigned Bits>
std::int64_t WideFloat<Bits>::nearest_integer() const {
  const int place = exponent();
  if (is_zero() || place < -1) return 0;
  const std::uint64_t first = word_[limbs - 1];
  // The first bit is that of 2^exponent.
  const std::uint64_t whole = place < 0 ? 0 : first >> (63 - place);
  const bool up = place < 0 || (first >> (62 - place) & 1) != 0;
  const auto size = static_cast<std::int64_t>(whole + (up ? 1 : 0));
  return is_negative() ? -size : size;
}

template <unsigned Bits>
WideFloat<Bits> WideFloat<Bits>::sum(const WideFloat& a, const WideFloat& b, bool b_negative) {
  if (!a.is_defined() || !b.is_defined()) return undefined();
  if (b.is_zero()) return a;
  if (a.is_zero()) return with_sign(b, b_negative);
  const bool a_larger = a.exponent() >= b.exponent();
  const WideFloat &large = a_larger ? a : b, &small = a_larger ? b : a;
  const bool negative = a_larger ? a.is_negative() : b_negative;
  // A number below a quarter of a unit in the last place changes nothing.
  if (std::int64_t{large.exponent()} - small.exponent() > static_cast<std::int64_t>(Bits) + 1) {
    return with_sign(large, negative);
  }
  return a.is_negative() == b_negative ? sum_of_magnitudes(large, small, negative)
                                       : difference_of_magnitudes(large, small, negative);
}

template <unsigned Bits>
WideFloat<Bits> WideFloat<Bits>::sum_of_magnitudes(const WideFloat& large, const WideFloat& small, bool negative) {
  const Moved<limbs> moved(small.mantissa(), static_cast<std::size_t>(large.exponent() - small.exponent()));
  Limbs words;
  std::uint64_t below = moved.word(0), carry = 0;
#pragma GCC unroll 16
  for (std::size_t i = 0; i < limbs; ++i) {
    const TwoWords place = TwoWords{large.word_[i]} + moved.word(i + 1) + carry;
    words[i] = low_word(place);
    carry = high_word(place);
  }
  // After a carry, all words are shifted by a bit.
  const bool lost = moved.lost() || (below & carry) != 0;
  const int by = static_cast<int>(carry);
  const std::uint64_t mask = mask_of(carry);
  below = below >> by | (words[0] << 63 & mask);
#pragma GCC unroll 16
  for (std::size_t i = 0; i + 1 < limbs; ++i) words[i] = words[i] >> by | (words[i + 1] << 63 & mask);
  words[limbs - 1] = words[limbs - 1] >> by | carry << 63;
  return rounded(words, below, lost, std::int64_t{large.exponent()} + by, negative);
}

/// The exponent of `large` must not be smaller. The result has the sign `negative`, or the opposite sign if `large` is
/// the smaller number after all.
template <unsigned Bits>
WideFloat<Bits> WideFloat<Bits>::difference_of_magnitudes(const WideFloat& large, const WideFloat& small,
                                                          bool negative) {
  const auto order = order_of_magnitudes(large, small);
  if (order == 0) return {};
  if (order < 0) return difference_of_magnitudes(small, large, !negative);
  const Moved<limbs> moved(small.mantissa(), static_cast<std::size_t>(large.exponent() - small.exponent()));
  // If bits of the subtrahend are lost, subtracting one more unit makes the result slightly too small, and the
  // remainder is positive. In that case at most one bit cancels, so that the remainder lies far behind the half unit
  // that decides the rounding.
  const bool lost = moved.lost();
  std::array<std::uint64_t, limbs + 1> words;
  std::uint64_t borrow = lost ? 1 : 0;
#pragma GCC unroll 16
  for (std::size_t i = 0; i <= limbs; ++i) {
    const TwoWords place = TwoWords{i == 0 ? 0 : large.word_[i - 1]} - moved.word(i) - borrow;
    words[i] = low_word(place);
    borrow = high_word(place) & 1;
  }
  const int shift = words[limbs] >> 63 != 0 ? 0 : normalise(words);
  Limbs mantissa;
#pragma GCC unroll 16
  for (std::size_t i = 0; i < limbs; ++i) mantissa[i] = words[i + 1];
  return rounded(mantissa, words[0], lost, std::int64_t{large.exponent()} - shift, negative);
}

template <unsigned Bits>
WideFloat<Bits> WideFloat<Bits>::product(const WideFloat& a, const WideFloat& b) {
  if (!a.is_defined() || !b.is_defined()) return undefined();
  if (a.is_zero() || b.is_zero()) return {};
  // Doubles have zeros in all words but the first. Rows start from the last nonzero word.
  const auto first_word = [](const WideFloat& x) {
    std::size_t i = 0;
    while (x.word_[i] == 0) ++i;
    return i;
  };
  const std::size_t a_first = first_word(a), b_first = first_word(b), first_row = std::max(a_first, b_first);
  const WideFloat &rows = a_first < b_first ? b : a, &columns = a_first < b_first ? a : b;
  // Columns start from the one before the word that decides the rounding. Those below it contribute less than `limbs`
  // units in its last place. If the product is representable at this length, the missing carry is so small that
  // rounding corrects it.
  constexpr std::size_t first = limbs - 2;
  std::array<std::uint64_t, 2 * limbs> full{};
#pragma GCC unroll 16
  for (std::size_t i = 0; i < limbs; ++i) {
    if (i < first_row) continue;
    const std::uint64_t row = rows.word_[i];
    std::uint64_t carry = 0;
#pragma GCC unroll 16
    for (std::size_t k = i < first ? first - i : 0; k < limbs; ++k) {
      const TwoWords column = TwoWords{row} * columns.word_[k] + full[i + k] + carry;
      full[i + k] = low_word(column);
      carry = high_word(column);
    }
    full[i + limbs] = carry;
  }
  // Two mantissas are in [1, 2). If the product is less than 2, all words are shifted by a bit.
  const std::uint64_t by = full[2 * limbs - 1] >> 63 ^ 1, mask = mask_of(by);
  const auto moved = [&full, by, mask](std::size_t i) { return full[i] << by | (full[i - 1] >> 63 & mask); };
  Limbs words;
#pragma GCC unroll 16
  for (std::size_t i = 0; i < limbs; ++i) words[i] = moved(limbs + i);
  const bool lost = full[first] << by != 0;
  return rounded(words, moved(limbs - 1), lost, std::int64_t{a.exponent()} + b.exponent() + 1 - static_cast<int>(by),
                 a.is_negative() != b.is_negative());
}

template <unsigned Bits>
WideFloat<Bits> WideFloat<Bits>::first_bits(int count) const {
  const auto words = static_cast<std::size_t>(std::max(count + 63, 64) / 64);
  if (words >= limbs) return *this;
  Limbs mantissa{};
  for (std::size_t i = limbs - words; i < limbs; ++i) mantissa[i] = word_[i];
  return of_words(mantissa, exponent(), is_negative());
}

/// Uses Newton steps for the reciprocal of the root, which need no division: the relative error of r + r (1 - x r^2) /
/// 2 is less than 2 e^2. One more product gives the root.
template <unsigned Bits>
WideFloat<Bits> WideFloat<Bits>::square_root(const WideFloat& x) {
  if (x.is_zero()) return {};
  if (!x.is_defined() || x.is_negative()) return undefined();
  using Longer = WideFloat<Bits + 64>;
  const int odd = x.exponent() % 2 == 0 ? 0 : 1;
  const Longer square(with_exponent(x, odd));
  Longer r(1 / std::sqrt(square.to_double()));
  int bits = 64;
  for (unsigned known = 50; known < Bits + 64; known = 2 * known - 1) {
    bits *= 2;
    r = (r + r * ldexp(Longer(1) - r * (r * square), -1)).first_bits(bits);
  }
  return scaled(WideFloat(r * square), (x.exponent() - odd) / 2);
}

template <unsigned Bits>
WideFloat<Bits> WideFloat<Bits>::scaled(const WideFloat& x, int by) {
  if (x.is_zero() || !x.is_defined()) return x;
  Limbs mantissa;
  std::memcpy(mantissa.data(), x.word_.data(), sizeof mantissa);
  return rounded(mantissa, 0, false, std::int64_t{x.exponent()} + by, x.is_negative());
}

template <unsigned Bits>
std::strong_ordering WideFloat<Bits>::order_of_magnitudes(const WideFloat& a, const WideFloat& b) {
  if (a.is_zero() || b.is_zero()) return (a.is_zero() ? 0 : 1) <=> (b.is_zero() ? 0 : 1);
  if (a.exponent() != b.exponent()) return a.exponent() <=> b.exponent();
  for (std::size_t i = limbs; i-- > 0;) {
    if (a.word_[i] != b.word_[i]) return a.word_[i] <=> b.word_[i];
  }
  return std::strong_ordering::equal;
}

template <unsigned Bits>
std::partial_ordering WideFloat<Bits>::order(const WideFloat& a, const WideFloat& b) {
  if (!a.is_defined() || !b.is_defined()) return std::partial_ordering::unordered;
  if (a.is_negative() != b.is_negative()) {
    return a.is_negative() ? std::partial_ordering::less : std::partial_ordering::greater;
  }
  return a.is_negative() ? order_of_magnitudes(b, a) : order_of_magnitudes(a, b);
}

// Instantiates the lengths of the stages and of points on curves, and the conversions between them.
#define TAUT_LENGTH(Bits, A, B)                             \
  template class WideFloat<Bits>;                           \
  template WideFloat<Bits>::WideFloat(const WideFloat<A>&); \
  template WideFloat<Bits>::WideFloat(const WideFloat<B>&);
TAUT_LENGTH(192, 320, 960)
TAUT_LENGTH(320, 192, 960)
TAUT_LENGTH(960, 192, 320)
#undef TAUT_LENGTH

}  // namespace taut::internal
