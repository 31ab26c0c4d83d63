// Instants beyond the resolution of doubles.
#pragma once

#include <optional>

#include "numeric/short_sum.hpp"
#include "numeric/stages.hpp"

namespace taut::internal {

/// An instant, enclosed. Both ends are sums of a few doubles where that suffices, otherwise high-precision numbers.
class PreciseTime {
 public:
  /// The stage at which it was found: doubles, or one at high precision.
  Stage stage = Stage::doubles;

  PreciseTime() : PreciseTime(ShortSum(), ShortSum(), Stage::doubles) {}
  PreciseTime(const ShortSum& lo, const ShortSum& hi, Stage found)
      : stage(found), has_sums_(true), from_(lo), to_(hi) {}
  PreciseTime(const RealMax& lo, const RealMax& hi, Stage found) : stage(found), has_sums_(false), lo_(lo), hi_(hi) {}
  static PreciseTime between(double lo, double hi) { return {ShortSum(lo), ShortSum(hi), Stage::doubles}; }
  /// The upper end of the enclosure alone.
  PreciseTime last() const { return has_sums_ ? PreciseTime(to_, to_, stage) : PreciseTime(hi_, hi_, stage); }

  /// Are the ends sums of doubles? If so, sum_lo() and sum_hi() return them.
  bool has_sums() const { return has_sums_; }
  const ShortSum& sum_lo() const { return from_; }
  const ShortSum& sum_hi() const { return to_; }

  /// A bound of the distance between the two sums.
  double width_of_sums() const {
    ExactSum<2 * ShortSum::capacity> width;
    for (std::size_t i = 0; i < to_.size(); ++i) width.add(to_.part(i));
    for (std::size_t i = 0; i < from_.size(); ++i) width.add(-from_.part(i));
    return width.approximate() * (1 + 0x1p-50);
  }

  RealMax lo() const { return has_sums_ ? from_.real() : lo_; }
  RealMax hi() const { return has_sums_ ? to_.real() : hi_; }
  /// The largest double that is not above the enclosure, and a double that is not below it.
  double floor() const { return has_sums_ ? from_.floor() : double_floor(lo_); }
  double ceiling() const { return has_sums_ ? to_.ceiling() : double_above(hi_); }

  /// Is this instant certainly before `o`?
  bool certainly_before(const PreciseTime& o) const {
    return has_sums_ && o.has_sums_ ? to_.compare(o.from_) < 0 : hi() < o.lo();
  }
  /// Which of the two instants is first, if that is certain: true if it is this one.
  std::optional<bool> is_first(const PreciseTime& o) const {
    if (certainly_before(o)) return true;
    if (o.certainly_before(*this)) return false;
    return std::nullopt;
  }
  /// Is this instant certainly before `o`, or possibly equal to it?
  bool not_after(const PreciseTime& o) const {
    return has_sums_ && o.has_sums_ ? to_.compare(o.from_) <= 0 : hi() <= o.lo();
  }
  /// Does its enclosure begin earlier?
  bool begins_before(const PreciseTime& o) const {
    return has_sums_ && o.has_sums_ ? from_.compare(o.from_) < 0 : lo() < o.lo();
  }

 private:
  bool has_sums_;
  ShortSum from_, to_;
  RealMax lo_, hi_;
};

}  // namespace taut::internal
