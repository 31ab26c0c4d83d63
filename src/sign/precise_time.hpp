// Instants beyond the resolution of doubles.
#pragma once

#include "numeric/fine_number.hpp"
#include "numeric/real.hpp"

namespace taut {

/// An instant, enclosed. Both ends are sums of a few doubles where that is enough, else high-precision numbers.
class PreciseTime {
 public:
  /// The index into precision_ladder of the precision at which it was found, -1 for doubles.
  int stage = -1;

  PreciseTime() : PreciseTime(FineNumber(), FineNumber(), -1) {}
  PreciseTime(const FineNumber& lo, const FineNumber& hi, int found) : stage(found), fine_(true), from_(lo), to_(hi) {}
  PreciseTime(const RealMax& lo, const RealMax& hi, int found) : stage(found), fine_(false), lo_(lo), hi_(hi) {}
  static PreciseTime between(double lo, double hi) { return {FineNumber(lo), FineNumber(hi), -1}; }
  /// The end of the enclosure alone.
  PreciseTime last() const { return fine_ ? PreciseTime(to_, to_, stage) : PreciseTime(hi_, hi_, stage); }

  /// Are the ends sums of doubles? Then these are they.
  bool fine() const { return fine_; }
  const FineNumber& fine_lo() const { return from_; }
  const FineNumber& fine_hi() const { return to_; }

  /// A bound of the distance between them.
  double fine_width() const {
    ExactSum<2 * FineNumber::capacity> width;
    for (std::size_t i = 0; i < to_.size(); ++i) width.add(to_.part(i));
    for (std::size_t i = 0; i < from_.size(); ++i) width.add(-from_.part(i));
    return width.approximate() * (1 + 0x1p-50);
  }

  RealMax lo() const { return fine_ ? from_.real() : lo_; }
  RealMax hi() const { return fine_ ? to_.real() : hi_; }
  /// The largest double not above, and one not below.
  double floor() const { return fine_ ? from_.floor() : double_floor(lo_); }
  double ceiling() const { return fine_ ? to_.ceiling() : double_above(hi_); }

  /// Is this instant certainly before `o`?
  bool certainly_before(const PreciseTime& o) const {
    return fine_ && o.fine_ ? to_.compare(o.from_) < 0 : hi() < o.lo();
  }
  /// The same, or they may be one.
  bool not_after(const PreciseTime& o) const { return fine_ && o.fine_ ? to_.compare(o.from_) <= 0 : hi() <= o.lo(); }
  /// Does its enclosure begin earlier?
  bool begins_before(const PreciseTime& o) const {
    return fine_ && o.fine_ ? from_.compare(o.from_) < 0 : lo() < o.lo();
  }

 private:
  bool fine_;
  FineNumber from_, to_;
  RealMax lo_, hi_;
};

}  // namespace taut
