#include "numeric/wide_float.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace taut {
namespace {

__extension__ using TwoWords = unsigned __int128;

std::uint64_t high_word(TwoWords x) { return static_cast<std::uint64_t>(x >> 64); }
std::uint64_t low_word(TwoWords x) { return static_cast<std::uint64_t>(x); }

/// Moves all to the left until the first bit is set, and says by how many bits; requires that it is not zero.
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

/// A mantissa with a word more at its end, moved to the right by so many bits: at most all but one.
template <std::size_t N>
class Moved {
 public:
  Moved(const std::array<std::uint64_t, N>& mantissa, std::size_t by) : skipped_(by / 64), bits_(by % 64) {
    std::memcpy(word_.data() + 1, mantissa.data(), sizeof mantissa);
  }
  /// The first one is that at the end.
  std::uint64_t word(std::size_t i) const {
    return word_[i + skipped_] >> bits_ | word_[i + skipped_ + 1] << 1 << (63 - bits_);
  }
  /// Has anything but zeros been moved out?
  bool lost() const {
    std::uint64_t left = word_[skipped_] & ((std::uint64_t{1} << bits_) - 1);
    for (std::size_t i = 1; i < skipped_; ++i) left |= word_[i];
    return left != 0;
  }

 private:
  std::array<std::uint64_t, 2 * N + 3> word_{};  ///< with zeros at both ends
  std::size_t skipped_, bits_;
};

/// One word of a quotient: how often the divisor, whose first bit is set, goes into as many words of the rest and one
/// more, which it leaves smaller than itself.
std::uint64_t divide_once(std::uint64_t* rest, const std::uint64_t* divisor, std::size_t length) {
  const std::uint64_t top = divisor[length - 1];
  const TwoWords head = TwoWords{rest[length]} << 64 | rest[length - 1];
  // By the first words it is at most two too large.
  std::uint64_t digit = rest[length] >= top ? ~std::uint64_t{0} : low_word(head / top);
  if (digit == 0) return 0;
  std::uint64_t carry = 0;
  bool borrow = false;
  for (std::size_t k = 0; k <= length; ++k) {
    const TwoWords multiple = TwoWords{digit} * (k < length ? divisor[k] : 0) + carry;
    carry = high_word(multiple);
    const TwoWords difference = TwoWords{rest[k]} - low_word(multiple) - (borrow ? 1 : 0);
    rest[k] = low_word(difference);
    borrow = high_word(difference) != 0;
  }
  while (borrow) {
    --digit;
    TwoWords sum = 0;
    for (std::size_t k = 0; k <= length; ++k) {
      sum += TwoWords{rest[k]} + (k < length ? divisor[k] : 0);
      rest[k] = low_word(sum);
      sum = high_word(sum);
    }
    borrow = sum == 0;
  }
  return digit;
}

/// The same mantissa with another exponent: so that a double tells its reciprocal.
template <unsigned Bits>
WideFloat<Bits> with_exponent(const WideFloat<Bits>& x, int exponent) {
  return ldexp(x, exponent - x.exponent());
}

}  // namespace

template <unsigned Bits>
WideFloat<Bits> WideFloat<Bits>::undefined() {
  WideFloat x;
  x.limb_[limbs - 1] = 1;
  x.exponent_ = undefined_exponent;
  return x;
}

template <unsigned Bits>
WideFloat<Bits> WideFloat<Bits>::rounded(const std::uint64_t* mantissa, std::uint64_t below, bool lost,
                                         std::int64_t exponent, bool negative) {
  constexpr std::uint64_t half = std::uint64_t{1} << 63;
  WideFloat x;
  std::memcpy(x.limb_.data(), mantissa, sizeof x.limb_);
  if (below > half || (below == half && (lost || (x.limb_[0] & 1) != 0))) {
    std::size_t i = 0;
    while (i < limbs && ++x.limb_[i] == 0) ++i;
    if (i == limbs) {
      x.limb_[limbs - 1] = half;
      ++exponent;
    }
  }
  if (exponent > largest_exponent) return undefined();
  if (exponent < -largest_exponent) return {};
  x.exponent_ = static_cast<std::int32_t>(exponent);
  x.negative_ = negative;
  return x;
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
  WideFloat result;
  result.limb_[limbs - 1] = digits << shift;
  result.exponent_ = std::max(biased, 1) - 1075 + 63 - shift;
  result.negative_ = x < 0;
  return result;
}

template <unsigned Bits>
template <unsigned Other>
requires(Other != Bits) WideFloat<Bits>::WideFloat(const WideFloat<Other>& x) {
  if constexpr (Other < Bits) {
    std::memcpy(limb_.data() + (limbs - x.limbs), x.limb_.data(), sizeof x.limb_);
    exponent_ = x.exponent_;
    negative_ = x.negative_;
  } else {
    if (x.is_zero()) return;
    if (!x.is_defined()) {
      *this = undefined();
      return;
    }
    constexpr std::size_t dropped = WideFloat<Other>::limbs - limbs;
    bool lost = false;
    for (std::size_t i = 0; i + 1 < dropped; ++i) lost = lost || x.limb_[i] != 0;
    *this = rounded(x.limb_.data() + dropped, x.limb_[dropped - 1], lost, x.exponent_, x.negative_);
  }
}

template <unsigned Bits>
WideFloat<Bits> WideFloat<Bits>::of_limbs(const Limbs& integer, int exponent, bool negative) {
  if (std::all_of(integer.begin(), integer.end(), [](std::uint64_t limb) { return limb == 0; })) return {};
  Limbs mantissa = integer;
  const int shift = normalise(mantissa);
  return rounded(mantissa.data(), 0, false, std::int64_t{exponent} + static_cast<int>(Bits) - 1 - shift, negative);
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
  // As many bits of the first word as the double has, fewer below the normal ones, rounded to the nearest.
  const int place = std::clamp(exponent_, -5000, 5000), dropped = 11 + std::clamp(-1022 - place, 0, 53);
  const std::uint64_t first = limb_[limbs - 1], half = std::uint64_t{1} << (dropped - 1), rest = first & (2 * half - 1);
  const bool behind = std::any_of(limb_.begin(), limb_.end() - 1, [](std::uint64_t limb) { return limb != 0; });
  std::uint64_t digits = first >> (dropped - 1) >> 1;
  if (rest > half || (rest == half && (behind || (digits & 1) != 0))) ++digits;
  const double size = std::ldexp(static_cast<double>(digits), place - 63 + dropped);
  return negative_ ? -size : size;
}

template <unsigned Bits>
std::int64_t WideFloat<Bits>::nearest_integer() const {
  if (is_zero() || exponent_ < -1) return 0;
  const std::uint64_t first = limb_[limbs - 1];
  // The first bit is that of 2^exponent.
  const std::uint64_t whole = exponent_ < 0 ? 0 : first >> (63 - exponent_);
  const bool up = exponent_ < 0 || (first >> (62 - exponent_) & 1) != 0;
  const auto size = static_cast<std::int64_t>(whole + (up ? 1 : 0));
  return negative_ ? -size : size;
}

template <unsigned Bits>
WideFloat<Bits> WideFloat<Bits>::sum(const WideFloat& a, const WideFloat& b, bool b_negative) {
  if (!a.is_defined() || !b.is_defined()) return undefined();
  if (b.is_zero()) return a;
  WideFloat second = b;
  second.negative_ = b_negative;
  if (a.is_zero()) return second;
  const bool a_larger = a.exponent_ >= second.exponent_;
  const WideFloat &large = a_larger ? a : second, &small = a_larger ? second : a;
  // What is less than a quarter of a unit in the last place changes nothing.
  if (std::int64_t{large.exponent_} - small.exponent_ > static_cast<std::int64_t>(Bits) + 1) return large;
  return a.negative_ == b_negative ? sum_of_magnitudes(large, small) : difference_of_magnitudes(large, small);
}

template <unsigned Bits>
WideFloat<Bits> WideFloat<Bits>::sum_of_magnitudes(const WideFloat& large, const WideFloat& small) {
  const Moved<limbs> moved(small.limb_, static_cast<std::size_t>(large.exponent_ - small.exponent_));
  std::array<std::uint64_t, limbs> words;
  std::uint64_t below = moved.word(0), carry = 0;
  for (std::size_t i = 0; i < limbs; ++i) {
    const TwoWords place = TwoWords{large.limb_[i]} + moved.word(i + 1) + carry;
    words[i] = low_word(place);
    carry = high_word(place);
  }
  bool lost = moved.lost();
  std::int64_t exponent = large.exponent_;
  if (carry != 0) {
    lost = lost || (below & 1) != 0;
    below = below >> 1 | words[0] << 63;
    for (std::size_t i = 0; i + 1 < limbs; ++i) words[i] = words[i] >> 1 | words[i + 1] << 63;
    words[limbs - 1] = words[limbs - 1] >> 1 | std::uint64_t{1} << 63;
    ++exponent;
  }
  return rounded(words.data(), below, lost, exponent, large.negative_);
}

/// large has no smaller exponent; the result has its sign, or the other one if it is the smaller one after all.
template <unsigned Bits>
WideFloat<Bits> WideFloat<Bits>::difference_of_magnitudes(const WideFloat& large, const WideFloat& small) {
  const auto order = order_of_magnitudes(large, small);
  if (order == 0) return {};
  if (order < 0) return difference_of_magnitudes(small, large);
  const Moved<limbs> moved(small.limb_, static_cast<std::size_t>(large.exponent_ - small.exponent_));
  // Where something is lost of what is subtracted, one unit less is a little too little, and the rest is positive. No
  // more than one bit cancels then, so that it lies far behind the half by which is rounded.
  const bool lost = moved.lost();
  std::array<std::uint64_t, limbs + 1> words;
  std::uint64_t borrow = lost ? 1 : 0;
  for (std::size_t i = 0; i <= limbs; ++i) {
    const TwoWords place = TwoWords{i == 0 ? 0 : large.limb_[i - 1]} - moved.word(i) - borrow;
    words[i] = low_word(place);
    borrow = high_word(place) & 1;
  }
  const int shift = words[limbs] >> 63 != 0 ? 0 : normalise(words);
  return rounded(words.data() + 1, words[0], lost, std::int64_t{large.exponent_} - shift, large.negative_);
}

template <unsigned Bits>
WideFloat<Bits> WideFloat<Bits>::product(const WideFloat& a, const WideFloat& b) {
  if (!a.is_defined() || !b.is_defined()) return undefined();
  if (a.is_zero() || b.is_zero()) return {};
  // Doubles have zeros in all words but the first: from the last one on that is not zero.
  const auto first_word = [](const WideFloat& x) {
    std::size_t i = 0;
    while (x.limb_[i] == 0) ++i;
    return i;
  };
  std::size_t first_row = first_word(a), first_column = first_word(b);
  const Limbs *rows = &a.limb_, *columns = &b.limb_;
  if (first_row < first_column) {
    std::swap(rows, columns);
    std::swap(first_row, first_column);
  }
  // Row by row, columns from the one before the word by which is rounded: those below it are less than `limbs` units in
  // its last place. Where the product is one of this length, what they would carry is missing by so little that
  // rounding mends it.
  constexpr std::size_t first = limbs - 2;
  std::array<std::uint64_t, 2 * limbs> full{};
  for (std::size_t i = first_row; i < limbs; ++i) {
    const std::uint64_t row = (*rows)[i];
    std::uint64_t carry = 0;
    for (std::size_t k = std::max(first_column, i < first ? first - i : 0); k < limbs; ++k) {
      const TwoWords column = TwoWords{row} * (*columns)[k] + full[i + k] + carry;
      full[i + k] = low_word(column);
      carry = high_word(column);
    }
    full[i + limbs] = carry;
  }
  std::int64_t exponent = std::int64_t{a.exponent_} + b.exponent_ + 1;
  if (full[2 * limbs - 1] >> 63 == 0) {
    for (std::size_t i = 2 * limbs - 1; i > first; --i) full[i] = full[i] << 1 | full[i - 1] >> 63;
    full[first] <<= 1;
    --exponent;
  }
  return rounded(full.data() + limbs, full[limbs - 1], full[first] != 0, exponent, a.negative_ != b.negative_);
}

template <unsigned Bits>
WideFloat<Bits> WideFloat<Bits>::cut(std::size_t words) const {
  WideFloat x = *this;
  for (std::size_t i = 0; i + words < limbs; ++i) x.limb_[i] = 0;
  return x;
}

/// Long division, word by word, with a word more than is kept; D. E. Knuth, The Art of Computer Programming, volume 2,
/// 4.3.1, algorithm D. A divisor that is a double is a single word.
template <unsigned Bits>
WideFloat<Bits> WideFloat<Bits>::quotient(const WideFloat& a, const WideFloat& b) {
  if (!a.is_defined() || !b.is_defined() || b.is_zero()) return undefined();
  if (a.is_zero()) return {};
  std::size_t first = 0;
  while (b.limb_[first] == 0) ++first;
  const std::uint64_t* const divisor = b.limb_.data() + first;
  const std::size_t length = limbs - first;
  // The dividend in the upper words, one for what is carried above it; from it the quotient's multiples are taken.
  std::array<std::uint64_t, 2 * limbs + 2> rest{};
  std::memcpy(rest.data() + limbs + 1, a.limb_.data(), sizeof a.limb_);
  // Whole units, 0 or 1, and a word more than the mantissa of what follows.
  std::array<std::uint64_t, limbs + 2> digits{};
  for (std::size_t i = limbs + 2; i-- > 0;) {
    digits[i] = divide_once(rest.data() + i + limbs - length, divisor, length);
  }
  const bool lost = std::any_of(rest.begin(), rest.end(), [](std::uint64_t word) { return word != 0; });
  const bool whole = digits[limbs + 1] != 0;
  std::int64_t exponent = std::int64_t{a.exponent_} - b.exponent_;
  bool below = lost;
  if (whole) {
    below = below || (digits[0] & 1) != 0;
    for (std::size_t i = 0; i <= limbs; ++i) digits[i] = digits[i] >> 1 | digits[i + 1] << 63;
  } else {
    --exponent;  // the first bit of what follows is set, because both mantissas' are
  }
  return rounded(digits.data() + 1, digits[0], below, exponent, a.negative_ != b.negative_);
}

/// By Newton's steps for the reciprocal of the root, as a quotient: r + r (1 - x r^2) / 2 is wrong by a share of less
/// than 2 e^2.
template <unsigned Bits>
WideFloat<Bits> WideFloat<Bits>::square_root(const WideFloat& x) {
  if (x.is_zero()) return {};
  if (!x.is_defined() || x.negative_) return undefined();
  using Longer = WideFloat<Bits + 64>;
  const int odd = x.exponent_ % 2 == 0 ? 0 : 1;
  const Longer square(with_exponent(x, odd));
  Longer r(1 / std::sqrt(square.to_double()));
  std::size_t words = 1;
  for (unsigned known = 50; known < Bits + 64; known = 2 * known - 1) {
    words *= 2;
    r = (r + r * ldexp(Longer(1) - r * (r * square), -1)).cut(words);
  }
  return scaled(WideFloat(r * square), (x.exponent_ - odd) / 2);
}

template <unsigned Bits>
WideFloat<Bits> WideFloat<Bits>::scaled(const WideFloat& x, int by) {
  if (x.is_zero() || !x.is_defined()) return x;
  return rounded(x.limb_.data(), 0, false, std::int64_t{x.exponent_} + by, x.negative_);
}

template <unsigned Bits>
std::strong_ordering WideFloat<Bits>::order_of_magnitudes(const WideFloat& a, const WideFloat& b) {
  if (a.is_zero() || b.is_zero()) return (a.is_zero() ? 0 : 1) <=> (b.is_zero() ? 0 : 1);
  if (a.exponent_ != b.exponent_) return a.exponent_ <=> b.exponent_;
  for (std::size_t i = limbs; i-- > 0;) {
    if (a.limb_[i] != b.limb_[i]) return a.limb_[i] <=> b.limb_[i];
  }
  return std::strong_ordering::equal;
}

template <unsigned Bits>
std::partial_ordering WideFloat<Bits>::order(const WideFloat& a, const WideFloat& b) {
  if (!a.is_defined() || !b.is_defined()) return std::partial_ordering::unordered;
  if (a.negative_ != b.negative_) return a.negative_ ? std::partial_ordering::less : std::partial_ordering::greater;
  return a.negative_ ? order_of_magnitudes(b, a) : order_of_magnitudes(a, b);
}

// The lengths of the stages and of points on curves, and what is converted into what.
#define TAUT_LENGTH(Bits, A, B, C)                          \
  template class WideFloat<Bits>;                           \
  template WideFloat<Bits>::WideFloat(const WideFloat<A>&); \
  template WideFloat<Bits>::WideFloat(const WideFloat<B>&); \
  template WideFloat<Bits>::WideFloat(const WideFloat<C>&);
TAUT_LENGTH(192, 320, 640, 960)
TAUT_LENGTH(320, 192, 640, 960)
TAUT_LENGTH(640, 192, 320, 960)
TAUT_LENGTH(960, 192, 320, 640)
#undef TAUT_LENGTH

}  // namespace taut
