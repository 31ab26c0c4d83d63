// The frame functions in doubles with error bounds: at an instant, and their derivatives over a segment.
#pragma once

namespace taut {

/// The five functions of Leg::Frame for one kind of triple, at one instant.
struct FastSide {
  double f[5], d[5];
  /// Bounds of the errors of f0, of f1 and f2 together, and of f3 and f4, with what a sum of products of them rounds.
  double error_0, error_a, error_b;
  double error_0d, error_ad, error_bd;  ///< the same for d
  /// Second derivatives where a model has them (ClockPlace::sharp), with bounds of the same kind; that of f0 is zero.
  double dd[4];
  double error_add, error_bdd;
};

/// Second derivatives over a segment: middles, and bounds as in FastSide.
struct FastCurvature {
  double mid[5];
  double error_0, error_a, error_b;
};

/// Bounds of the third derivatives' magnitudes over a segment; that of f0 is zero.
struct FastThird {
  double most[4];
};

/// A value with a bound of its error.
struct Bounded {
  double value, error;
};

}  // namespace taut
