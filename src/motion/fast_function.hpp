// A mixed triple's function in doubles with error bounds: the first stage of every evaluation.
#pragma once

#include "motion/mixed_function.hpp"

namespace taut {

/// The five functions of Leg::Frame for one kind of triple, at one instant.
struct FastSide {
  double f[5], d[5];
  double size_a, size_b, size_0;        ///< bounds of |f1|+|f2|, |f3|+|f4|, |f0|
  double size_ad, size_bd, size_0d;     ///< of the derivatives
  double error_a, error_b, error_0;     ///< bounds of the errors of f
  double error_ad, error_bd, error_0d;  ///< and of d
};

/// Second derivatives over a segment: middle and radius of each.
struct FastCurvature {
  double mid[5], rad[5];
};

/// A value with a bound of its error.
struct Bounded {
  double value, error;
};

/// A mixed triple's function as coefficients of the frame functions, in doubles.
/// Level 0 is the function of the input's points. Where that vanishes identically, level 1 is the part that is linear
/// in the displacement, scaled by 2^200.
struct FastFunction {
  double a[5];
  double m0, m34, w;  ///< magnitudes that bound rounding: of a[0]; of a[3], a[4]; of a[1], a[2]
  bool pp = false;
  bool level1 = false;

  static FastFunction level_zero(const Leg& leg, const PairGeometry& g, const MixedTriple& triple,
                                 Measure measure = Measure::orientation);
  /// The next level if level 0 is exactly zero at all times of a translation leg; false otherwise.
  static bool level_one(const Leg& leg, const PairGeometry& g, const MixedTriple& triple, FastFunction& result);

  Bounded value(const FastSide& s) const {
    const double v = a[0] * s.f[0] + a[1] * s.f[1] + a[2] * s.f[2] + a[3] * s.f[3] + a[4] * s.f[4];
    const double e =
        0x1p-49 * (m0 * s.size_0 + w * s.size_a + m34 * s.size_b) + m0 * s.error_0 + w * s.error_a + m34 * s.error_b;
    return {v, e * (1 + 0x1p-40) + floor_error};
  }
  Bounded slope(const FastSide& s) const {
    const double v = a[0] * s.d[0] + a[1] * s.d[1] + a[2] * s.d[2] + a[3] * s.d[3] + a[4] * s.d[4];
    const double e = 0x1p-49 * (m0 * s.size_0d + w * s.size_ad + m34 * s.size_bd) + m0 * s.error_0d + w * s.error_ad +
                     m34 * s.error_bd;
    return {v, e * (1 + 0x1p-40) + floor_error};
  }
  Bounded curvature(const FastCurvature& c) const {
    double v = 0, e = 0;
    for (int i = 0; i < 5; ++i) {
      const double m = i == 0 ? m0 : (i < 3 ? w : m34);
      v += a[i] * c.mid[i];
      e += m * (c.rad[i] + 0x1p-49 * (c.mid[i] < 0 ? -c.mid[i] : c.mid[i]));
    }
    return {v, e * (1 + 0x1p-40) + floor_error};
  }
  /// Covers the displacement at level 0, its square at level 1, and underflow.
  double floor_error = 0;
};

}  // namespace taut
