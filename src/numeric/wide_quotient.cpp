// Quotients of binary floating-point numbers of several machine words.
#include <algorithm>
#include <cstring>

#include "numeric/two_words.hpp"
#include "numeric/wide_float.hpp"

namespace taut::internal {
namespace {

/// Computes one word of a quotient: the quotient of the rest, which has one more word than the divisor, by the divisor,
/// whose first bit is set. Leaves the remainder in `rest`.
std::uint64_t divide_once(std::uint64_t* rest, const std::uint64_t* divisor, std::size_t length) {
  const std::uint64_t top = divisor[length - 1];
  const TwoWords head = TwoWords{rest[length]} << 64 | rest[length - 1];
  // Computed from the first words, the digit is at most two too large.
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

}  // namespace

/// Long division, word by word, with one word more than is kept; D. E. Knuth, The Art of Computer Programming, volume
/// 2, 4.3.1, algorithm D. A divisor that is a double is a single word.
template <unsigned Bits>
WideFloat<Bits> WideFloat<Bits>::quotient(const WideFloat& a, const WideFloat& b) {
  if (!a.is_defined() || !b.is_defined() || b.is_zero()) return undefined();
  if (a.is_zero()) return {};
  std::size_t first = 0;
  while (b.word_[first] == 0) ++first;
  const std::uint64_t* const divisor = b.word_.data() + first;
  const std::size_t length = limbs - first;
  // The dividend is in the upper words, with one more for the carry above it. Multiples of the divisor are subtracted
  // from it.
  std::array<std::uint64_t, 2 * limbs + 2> rest{};
  std::memcpy(rest.data() + limbs + 1, a.word_.data(), sizeof(Limbs));
  // The integer part, 0 or 1, and one word more than the mantissa for the fraction.
  std::array<std::uint64_t, limbs + 2> digits{};
  for (std::size_t i = limbs + 2; i-- > 0;) {
    digits[i] = divide_once(rest.data() + i + limbs - length, divisor, length);
  }
  const bool lost = std::any_of(rest.begin(), rest.end(), [](std::uint64_t word) { return word != 0; });
  const bool whole = digits[limbs + 1] != 0;
  std::int64_t exponent = std::int64_t{a.exponent()} - b.exponent();
  bool below = lost;
  if (whole) {
    below = below || (digits[0] & 1) != 0;
    for (std::size_t i = 0; i <= limbs; ++i) digits[i] = digits[i] >> 1 | digits[i + 1] << 63;
  } else {
    --exponent;  // the first bit of the fraction is set, because both mantissas have their first bit set
  }
  Limbs mantissa;
  std::memcpy(mantissa.data(), digits.data() + 1, sizeof mantissa);
  return rounded(mantissa, digits[0], below, exponent, a.is_negative() != b.is_negative());
}

template WideFloat<192> WideFloat<192>::quotient(const WideFloat&, const WideFloat&);
template WideFloat<320> WideFloat<320>::quotient(const WideFloat&, const WideFloat&);
template WideFloat<960> WideFloat<960>::quotient(const WideFloat&, const WideFloat&);

}  // namespace taut::internal
