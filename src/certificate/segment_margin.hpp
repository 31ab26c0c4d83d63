// A margin over time, in the terms of a motion segment.
#pragma once

#include <optional>

#include "certificate/margin_function.hpp"
#include "scene/margin.hpp"

namespace taut::internal {

/// What a margin is on one segment, which is not a bridge.
class SegmentMargin {
 public:
  /// Bounds over a stretch of time: `most` is certainly not below the margin, which changes by about `change`.
  struct Bounds {
    double most = 0, change = 0;
  };

  SegmentMargin(const Margin& margin, const MotionSegment& segment);

  Bounds over(double from, double to) const { return varying_ ? bounds_of_polynomial(from, to) : Bounds{constant_, 0}; }
  template <class Real>
  MarginTerms<Real> terms() const {
    if (!varying_) return MarginTerms<Real>(constant_);
    return terms_of_polynomial<Real>();
  }

 private:
  /// Of a margin that changes: about the segment's instant for functions, about its middle for bounds.
  struct Varying {
    double about, middle;
    LocalPolynomials::Known in_segment;
    BallPolynomial<double> near_middle;
  };
  Bounds bounds_of_polynomial(double from, double to) const;
  template <class Real>
  MarginTerms<Real> terms_of_polynomial() const;

  double constant_ = 0;
  std::optional<Varying> varying_;
};

}  // namespace taut::internal
