// On a straight translation, a certificate function is a line in time whose coefficients are sums of products of input
// numbers. Its sign at any instant and the instant of its root can therefore be found without rounding. Parts and
// mechanisms drawn on a grid have many events at one instant, which only the displacements distinguish. With exact
// lines, such events cost little more than events far from each other.
#pragma once

#include <optional>

#include "certificate/certificate_function.hpp"
#include "certificate/precise_time.hpp"
#include "numeric/exact_number.hpp"

namespace taut::internal {

class ExactLine {
 public:
  /// Are the certificate functions lines on this segment?
  static bool fits(const MotionSegment& segment) { return segment.translation && segment.degree <= 1; }
  /// The displacement is included. Requires fits(segment).
  ExactLine(const MotionSegment& segment, const PairGeometry& g, const CertificateFunction& function);
  /// Was every product exact? Products of numbers of extremely different sizes may underflow; then no other member may
  /// be used.
  bool exact() const { return exact_; }

  /// The sign of the rate of change in time.
  int slope_sign() const { return slope_.sign(); }
  /// The sign at every instant of the enclosure, whose ends are sums of doubles; 0 if it may change there, or is not
  /// known.
  int sign_over(const PreciseTime& t) const;
  /// The instant of the zero, to about 2^-265 of its size, or to `enough`; nothing if that is not known. Requires a
  /// nonzero slope.
  std::optional<PreciseTime> root(Stage stage, double enough = 0) const;

 private:
  static constexpr std::size_t slope_terms = 32, start_terms = ExactNumber::capacity;

  /// A sum of products that is exact except for negligible ones.
  template <std::size_t Terms>
  struct NearlyExact {
    ExactSum<Terms> sum;
    double negligible = 0, error = 0;
  };
  template <std::size_t Terms>
  void begin(NearlyExact<Terms>& value, double sign) const;
  template <std::size_t Terms>
  bool add_change(NearlyExact<Terms>& value, double time) const;

  bool exact_ = true;
  ExactSum<start_terms> start_;  ///< the value at time 0
  ExactSum<slope_terms> slope_;
  double farthest_ = 0;  ///< the largest distance from time 0 on the segment
};

}  // namespace taut::internal
