// Taylor models of a leg's frame: polynomials that are cheap to evaluate, with certified bounds of what they leave out.
#pragma once

#include "motion/leg.hpp"

namespace taut {

/// The six functions of the frame that vary on a motion leg, about the middle of an interval [start, end] of its
/// parameter: conj(x_P) D (two parts), conj(x_Q) D (two parts), c and s (see FrameOf; not for bridges).
///
/// For every t in [start, end] and h = t - middle in doubles:
///   |sum_k c[i][k] h^k - f_i(t)| <= error[i], and the same for slopes with error_d[i], by Horner's rule in doubles;
///   |bend[i] - f_i''(t)| <= bend_rad[i].
/// Bounds may be infinite where the motion is singular; they are never NaN.
struct FrameModel {
  static constexpr int functions = 6;
  static FrameModel over(const Leg& leg, double start, double end);

  /// f and f' of function i at t.
  void evaluate(int i, double t, double& value, double& slope) const {
    const double* a = c[i];
    const double h = t - middle;
    double v = a[terms - 1], d = 0;
    for (int k = terms - 1; k-- > 0;) {
      d = d * h + v;
      v = v * h + a[k];
    }
    value = v;
    slope = d;
  }
  /// All bounds are finite.
  bool finite() const;
  /// What the polynomials leave out is no more than rounding: shorter intervals would not have better bounds of values.
  bool sharp() const;
  /// Not even the middle of the interval has finite bounds: shorter intervals would not help.
  bool hopeless() const;
  /// The second order is off by little, measured by what the first order covers: steps by bend are nearly the longest.
  bool straight() const;

  double start, end, middle, radius;
  int terms;  ///< coefficients in use, the same for all functions
  double c[functions][model_degree];
  double error[functions], error_d[functions];
  double bend[functions], bend_rad[functions];
  double remainder[functions];  ///< the part of the error that shrinks with the interval
  double noise[functions];      ///< the part that does not: the middle's own uncertainty
  double size[functions];       ///< bounds of |f_i|

 private:
  /// What an error of function i is measured by.
  double scale(int i) const { return i < 4 ? size[i] + size[i ^ 1] : 1; }
};

}  // namespace taut
