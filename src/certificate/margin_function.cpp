#include "certificate/margin_function.hpp"

namespace taut::internal {

SegmentMargin::SegmentMargin(const Margin& margin, const MotionSegment& segment) {
  if (is_constant(margin)) {
    constant_ = constant_term(margin);
    return;
  }
  const double middle = segment.start + (segment.end - segment.start) / 2;
  varying_.emplace(Varying{segment.about(), middle, expanded_about(margin, segment.about()),
                           expanded_about(margin, middle).rounded<double>().p});
}

SegmentMargin::Bounds SegmentMargin::bounds_of_polynomial(double from, double to) const {
  const Ball<double> stretch = Ball<double>::between(from, to);
  const Ball<double> range = polynomial_value(varying_->near_middle, time_since(stretch, varying_->middle));
  return {range.upper(), 2 * range.rad};
}

template <class Real>
MarginTerms<Real> SegmentMargin::terms_of_polynomial() const {
  BallPolynomial<Real> c = varying_->in_segment.rounded<Real>().p;
  const Ball<Real> constant = c[0];
  c[0] = Ball<Real>::exact(0);
  return {constant, TimePolynomial<Real>{c, varying_->about}};
}
#define TAUT_INSTANTIATE(Real) template MarginTerms<Real> SegmentMargin::terms_of_polynomial<Real>() const;
TAUT_INSTANTIATE(double)
TAUT_FOR_EACH_PRECISION(TAUT_INSTANTIATE)
#undef TAUT_INSTANTIATE

}  // namespace taut::internal
