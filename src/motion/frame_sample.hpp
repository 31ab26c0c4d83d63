// The frame functions in doubles with error bounds: at an instant, and their derivatives over a segment.
#pragma once

#include <array>

#include "motion/frame_model.hpp"
#include "motion/motion_segment.hpp"

namespace taut::internal {

/// The five functions of MotionSegment::Frame for one kind of triple, at one instant.
struct FrameSample {
  double f[5], d[5];
  /// Bounds of the errors of f0, of f1 and f2 together, and of f3 and f4, including the rounding of a sum of products
  /// with them.
  double error_0, error_a, error_b;
  double error_0d, error_ad, error_bd;  ///< the corresponding bounds for d
  /// Second derivatives if a model provides them (ModelPlace::sharp), with bounds of the same kind; that of f0 is zero.
  double dd[4];
  double error_add, error_bdd;
};

/// Second derivatives over a segment: middles, and bounds as in FrameSample.
struct FrameCurvature {
  double mid[5];
  double error_0, error_a, error_b;
};

/// Bounds of the third derivatives' magnitudes over a segment; that of f0 is zero.
struct FrameThird {
  double most[4];
};

/// A value with a bound of its error.
struct Bounded {
  double value, error;
  double lower() const { return value - error; }
  double upper() const { return value + error; }
  int sign() const { return value > error ? 1 : (-value > error ? -1 : 0); }
};

/// The sample and the second derivatives of a frame over a ball of times. Unknown values have an infinite bound.
FrameSample sample_of(const std::array<Jet<double>, 5>& f);
FrameCurvature curvature_of(const std::array<Jet<double>, 5>& f);

/// The side whose first two functions are the model's functions `first` and `first` + 1: at an instant, with second
/// derivatives,
void evaluate(const FrameModel& model, double t, int first, FrameSample& sample);
/// and over the model's whole interval. The values and slopes of the functions must be set in `values`.
void add_errors(const FrameModel& model, int first, FrameSample& values);
FrameCurvature curvature_of(const FrameModel& model, int first);
FrameThird third_of(const FrameModel& model, int first);

// The frame functions at two instants: most combinations of them differ from zero there already.

/// An evaluation at these two instants costs very little compared to the frame's identities (FrameIdentities), which
/// few certificate functions need.
class FrameEvaluator {
 public:
  explicit FrameEvaluator(const MotionSegment& segment);
  /// Is the sum of these coefficients times the frame functions for `pp` certainly not identically zero on the segment?
  bool differs_from_zero(bool pp, const std::array<Ball<double>, 5>& coefficients) const;

 private:
  std::array<FrameValues<double>, 2> looks_;
};

}  // namespace taut::internal
