// Numbers given exactly as sums of a few doubles: sufficient for events that differ by a displacement only.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "numeric/exact_sum.hpp"
#include "numeric/fixed.hpp"
#include "numeric/real.hpp"

namespace taut::internal {

/// A nonoverlapping sum of doubles, smallest first, without zeros; zero has no parts.
class ShortSum {
 public:
  static constexpr std::size_t capacity = 8;

  ShortSum() = default;
  explicit ShortSum(double x) {
    if (x != 0) part_[size_++] = x;
  }
  explicit ShortSum(const Fixed& x) {
    static_assert(Fixed::most_parts <= capacity);
    x.each_part([this](double part) { part_[size_++] = part; });
    std::reverse(part_.begin(), part_.begin() + static_cast<std::ptrdiff_t>(size_));
  }
  /// Converts a sum that is known to have few enough terms.
  template <std::size_t Terms>
  static ShortSum of(const ExactSum<Terms>& sum) {
    ShortSum number;
    for (std::size_t i = 0; i < sum.size() && i < capacity; ++i) number.part_[number.size_++] = sum.term(i);
    return number;
  }

  std::size_t size() const { return size_; }
  double part(std::size_t i) const { return part_[i]; }
  /// An approximation within two units in the last place of the number. The largest part may be far from it.
  double approximate() const {
    double sum = 0;
    for (std::size_t i = 0; i < size_; ++i) sum += part_[i];
    return sum;
  }
  /// The exact value: the parts lie within 960 bits.
  RealMax real() const {
    RealMax sum(0);
    for (std::size_t i = size_; i-- > 0;) sum += RealTraits<RealMax>::from_double(part_[i]);
    return sum;
  }

  /// -1, 0 or 1 if the number is less than, equal to, or greater than `o`.
  int compare(const ShortSum& o) const {
    std::size_t i = size_, k = o.size_;
    while (i > 0 && k > 0 && part_[i - 1] == o.part_[k - 1]) --i, --k;
    // The largest part has the sign of the number.
    if (k == 0) return i == 0 ? 0 : (part_[i - 1] > 0 ? 1 : -1);
    if (i == 0) return o.part_[k - 1] > 0 ? -1 : 1;
    const double d = part_[i - 1] - o.part_[k - 1];
    if (std::fabs(d) > up * (most_below(i - 1) + o.most_below(k - 1))) return d > 0 ? 1 : -1;
    ExactSum<2 * capacity> difference;
    while (i-- > 0) difference.add(part_[i]);
    while (k-- > 0) difference.add(-o.part_[k]);
    return difference.sign();
  }
  /// The largest double that is not above the number, and the smallest that is not below it.
  double floor() const {
    if (size_ < 2) return approximate();
    // Usually the rest is far less than the distance of the largest part to the next double.
    const double largest = part_[size_ - 1], next_part = part_[size_ - 2];
    if (most_below(size_ - 1) < 0x1p-54 * std::fabs(largest) && std::fabs(largest) > 0x1p-900) {
      return next_part > 0 ? largest : std::nextafter(largest, -INFINITY);
    }
    double x = approximate();
    while (compare(ShortSum(x)) < 0) x = std::nextafter(x, -INFINITY);
    for (double next; compare(ShortSum(next = std::nextafter(x, INFINITY))) >= 0;) x = next;
    return x;
  }
  double ceiling() const { return -negated().floor(); }

 private:
  static constexpr double up = 1 + 0x1p-50;

  /// A bound of the sum of the first i parts: as they do not overlap, it is less than twice the largest of them. It may
  /// be as much as the part above them.
  double most_below(std::size_t i) const { return i > 0 ? 2 * std::fabs(part_[i - 1]) : 0; }
  ShortSum negated() const {
    ShortSum n = *this;
    for (std::size_t i = 0; i < size_; ++i) n.part_[i] = -part_[i];
    return n;
  }

  std::array<double, capacity> part_;
  std::size_t size_ = 0;
};

}  // namespace taut::internal
