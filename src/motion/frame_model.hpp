// Taylor models of a segment's frame: polynomials that are cheap to evaluate, with certified bounds of their
// remainders.
#pragma once

#include <array>
#include <vector>

#include "motion/motion_segment.hpp"
#include "numeric/dyadic.hpp"
#include "numeric/fixed.hpp"

namespace taut::internal {

/// The six functions of the frame that vary on a motion segment, about the middle of an interval [start, end] of its
/// parameter: conj(x_P) D (two parts), conj(x_Q) D (two parts), c and s (see FrameOf; not for bridges).
///
/// For every t in [start, end] and h = t - middle in doubles:
///   |sum_k c[k][i] h^k - f_i(t)| <= error[i], and the same for the first two derivatives with error_d[i] and
///   error_dd[i], by Horner's rule in doubles;
///   |second[i] - f_i''(t)| <= second_rad[i] and |f_i'''(t)| <= third[i].
/// Bounds may be infinite where the motion is singular; they are never NaN.
struct FrameModel {
  static constexpr int functions = 6;
  static FrameModel over(const MotionSegment& segment, double start, double end);

  /// f and f' at t of all functions, in pairs in parallel: all chains of dependent operations take little longer than
  /// one.
  void evaluate(double t, double (&value)[functions], double (&slope)[functions]) const {
    const Lanes h = both(t - middle);
    const double* at = c[terms - 1];
    Horner p(at), q(at + 2), angle(at + 4);
    for (int k = terms - 1; k-- > 0;) {
      at -= functions;
      p.step(at, h);
      q.step(at + 2, h);
      angle.step(at + 4, h);
    }
    p.store(value, slope);
    q.store(value + 2, slope + 2);
    angle.store(value + 4, slope + 4);
  }
  /// f, f' and f'' at t of the pairs that begin with functions `first` and 4 only.
  void evaluate(double t, int first, double (&value)[4], double (&slope)[4], double (&second_at_t)[4]) const {
    const Lanes h = both(t - middle);
    const double* at = c[terms - 1];
    Horner2 way(at + first), angle(at + 4);
    for (int k = terms - 1; k-- > 0;) {
      at -= functions;
      way.step(at + first, h);
      angle.step(at + 4, h);
    }
    way.store(value, slope);
    angle.store(value + 2, slope + 2);
    store_lanes(second_at_t, way.half + way.half);
    store_lanes(second_at_t + 2, angle.half + angle.half);
  }
  /// Are all bounds finite?
  bool finite() const;
  /// Is the remainder of the polynomials no larger than rounding? Then shorter intervals would not have better bounds
  /// of values.
  bool sharp() const;
  /// Would an interval twice as long hardly be sharp? The remainder grows with the next power.
  bool barely_sharp() const;
  /// The approximate length of the longest interval there that is sharp and straight, as a multiple of this one's
  /// length; 1/2 if it cannot be estimated. It is only an estimate.
  double fitting_share(double slack = 1) const;
  /// Does not even the middle of the interval have finite bounds? Then shorter intervals would not help.
  bool hopeless() const;
  /// Is the error of the second order small relative to the range of the first order? Then steps that use the second
  /// derivative are nearly the longest possible. With `slack`, the error may be that many times as large.
  bool straight(double slack = 1) const;

  double start, end, middle, radius;
  int terms;                          ///< number of coefficients in use, the same for all functions
  double c[model_degree][functions];  ///< by power, then function
  double error[functions], error_d[functions], error_dd[functions];
  double second[functions], second_rad[functions], third[functions];
  double vague_second[functions], vague_third[functions];  ///< the parts of these bounds that are not due to the
                                                           ///< coefficients
  double remainder[functions];                             ///< the part of the error that shrinks with the interval
  double noise[functions];                                 ///< the part that does not shrink: the uncertainty at the
                                                           ///< middle
  double size[functions];                                  ///< bounds of |f_i|

  /// Tightens the bounds of function i, where the current coefficients give smaller ones: the change of its second
  /// derivative from that at the middle, and the magnitude of its third derivative.
  void bound_by_coefficients(int i);

 private:
  /// Horner's rule for a pair of functions and their slopes.
  struct Horner {
    Lanes v, d = {};
    explicit Horner(const double* leading) : v(load_lanes(leading)) {}
    void step(const double* next, Lanes h) {
      d = d * h + v;
      v = v * h + load_lanes(next);
    }
    void store(double* value, double* slope) const {
      store_lanes(value, v);
      store_lanes(slope, d);
    }
  };
  /// Also computes half their second derivatives.
  struct Horner2 : Horner {
    Lanes half = {};
    explicit Horner2(const double* leading) : Horner(leading) {}
    void step(const double* next, Lanes h) {
      half = half * h + d;
      Horner::step(next, h);
    }
  };
  /// The magnitude relative to which an error of function i is measured.
  double scale(int i) const { return i < 4 ? size[i] + size[i ^ 1] : 1; }
  /// The admissible remainder of function i, and the admissible deviation from a straight line due to its second
  /// derivative.
  double leave(int i) const;
  double straightness(int i, double slack) const;
};

/// Sets function i of a model by Taylor's formula, from its series about the middle and, where more is needed, over the
/// whole interval. The radius must be set.
void take_series(FrameModel& model, int i, const ModelSeries<double>& at_middle, const ModelSeries<double>& over);

// The combinations of a segment's frame functions that are zero at all times: exactly, for all rotations.

/// A function of a mixed triple may vanish at all times by an identity. For example, both bodies rotate alike, perhaps
/// in different representations; or a vertex moves along the other body's edge; or collinear features are at rest.
/// Interval arithmetic never shows that, at any precision, and only the displacement decides then.
///
/// The frame functions are written as expressions (Symbolic) over one denominator. A combination of them is zero if and
/// only if it is zero term by term and power by power. These are linear conditions on its coefficients, of which at
/// most five are independent. Their computation is expensive, so they are not used where FrameEvaluator shows that a
/// combination is not zero.
class FrameIdentities {
 public:
  explicit FrameIdentities(const MotionSegment& segment);
  /// Is the sum of these coefficients times the frame functions for `pp` zero at all times of the segment? A positive
  /// result is certain.
  bool vanishes(bool pp, const std::array<Dyadic, 5>& coefficients) const;

 private:
  using Condition = std::array<Dyadic, 5>;
  struct Side {
    bool known = false;
    std::vector<Condition> conditions;
  };
  static Side conditions_of(const std::array<Symbolic, 5>& functions, const SymbolicSegment& segment);

  Side pp_, qq_;
};

}  // namespace taut::internal
