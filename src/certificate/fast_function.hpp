// A certificate function in doubles with error bounds: the first stage of every evaluation.
#pragma once

#include <array>
#include <cmath>

#include "certificate/certificate_function.hpp"
#include "motion/frame_model.hpp"
#include "motion/frame_sample.hpp"

namespace taut::internal {

/// A certificate function as coefficients of the frame functions, in doubles. Level 0 is the function of the input's
/// points. Where that vanishes identically, level 1 is the part that is linear in the displacement, scaled by 2^200.
struct FastFunction {
  double a[5];
  double m0, m34, w;  ///< bound rounding: of a[0]; of a[3], a[4]; of a[1], a[2]
  bool pp = false;
  bool level1 = false;

  static FastFunction undisplaced(const MotionSegment& segment, const PairGeometry& g,
                                  const CertificateFunction& function);
  /// The part that is linear in the displacement, scaled as at level 1, regardless of level 0.
  static FastFunction displacement_part(const MotionSegment& segment, const PairGeometry& g,
                                        const CertificateFunction& function);
  /// Stores the next level if level 0 is exactly zero at all times of the segment; otherwise returns false.
  static bool displacement_gradient(const MotionSegment& segment, const PairGeometry& g,
                                    const CertificateFunction& function, FastFunction& result);

  Bounded value(const FrameSample& s) const {
    const Bounded v = combine(s.f, s.error_0, s.error_a, s.error_b);
    return {v.value, v.error + floor_error};
  }
  Bounded slope(const FrameSample& s) const { return combine(s.d, s.error_0d, s.error_ad, s.error_bd); }
  Bounded curvature(const FrameCurvature& c) const { return combine(c.mid, c.error_0, c.error_a, c.error_b); }
  /// The second derivative at one instant.
  Bounded second(const FrameSample& s) const {
    const double v = a[1] * s.dd[0] + a[2] * s.dd[1] + a[3] * s.dd[2] + a[4] * s.dd[3];
    return {v, (w * s.error_add + m34 * s.error_bdd) * (1 + 0x1p-40) + underflow_slack};
  }
  /// A bound of the third derivative's magnitude over the segment.
  double third(const FrameThird& c) const {
    // Coefficients are rounded by less than this share of their magnitudes' bounds.
    constexpr double rounding = 0x1p-45;
    const double sum = (std::fabs(a[1]) + rounding * w) * c.most[0] + (std::fabs(a[2]) + rounding * w) * c.most[1] +
                       (std::fabs(a[3]) + rounding * m34) * c.most[2] + (std::fabs(a[4]) + rounding * m34) * c.most[3];
    return sum * (1 + 0x1p-40) + underflow_slack;
  }
  /// An approximate zero of the polynomial of a model, by steps from `t` of higher order than Newton's. It is only a
  /// good estimate.
  double root_of(const FrameModel& model, double t) const;
  /// The error of a value that covers the displacement at level 0, and its square at level 1. The displacement's effect
  /// on a derivative is proportional to the speed of the motion. The magnitudes above have room for it, whatever the
  /// unit of time.
  double floor_error = 0;

 private:
  void take(const std::array<double, 5>& coefficients) {
    for (std::size_t i = 0; i < 5; ++i) a[i] = coefficients[i];
  }
  Bounded combine(const double (&f)[5], double error_0, double error_a, double error_b) const {
    const double v = a[0] * f[0] + a[1] * f[1] + a[2] * f[2] + a[3] * f[3] + a[4] * f[4];
    return {v, (m0 * error_0 + w * error_a + m34 * error_b) * (1 + 0x1p-40) + underflow_slack};
  }
};

}  // namespace taut::internal
