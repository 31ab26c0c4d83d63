// Taylor models of a segment's frame: polynomials that are cheap to evaluate, with certified bounds of what they leave
// out.
#pragma once

#include "numeric/lanes.hpp"
#include "relative/motion_segment.hpp"

namespace taut::internal {

/// The six functions of the frame that vary on a motion segment, about the middle of an interval [start, end] of its
/// parameter: conj(x_P) D (two parts), conj(x_Q) D (two parts), c and s (see FrameOf; not for bridges).
///
/// For every t in [start, end] and h = t - middle in doubles:
///   |sum_k c[k][i] h^k - f_i(t)| <= error[i], and the same for the first two derivatives with error_d[i] and
///   error_dd[i], by Horner's rule in doubles;
///   |bend[i] - f_i''(t)| <= second_rad[i] and |f_i'''(t)| <= third[i].
/// Bounds may be infinite where the motion is singular; they are never NaN.
struct FrameModel {
  static constexpr int functions = 6;
  static FrameModel over(const MotionSegment& segment, double start, double end);

  /// f and f' at t of all functions, in pairs side by side: chains of dependent operations take little longer than one.
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
  /// f, f' and f'' of the pairs that begin with numbers `first` and 4 only.
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
  /// All bounds are finite.
  bool finite() const;
  /// What the polynomials leave out is no more than rounding: shorter intervals would not have better bounds of values.
  bool sharp() const;
  /// An interval twice as long would hardly be sharp: what is left out grows with the power that comes next.
  bool barely_sharp() const;
  /// About the longest interval there that is sharp and straight, as a multiple of this one's length; 1/2 where nothing
  /// tells. A guess, no more.
  double fitting_share(double slack = 1) const;
  /// Not even the middle of the interval has finite bounds: shorter intervals would not help.
  bool hopeless() const;
  /// The second order is off by little, measured by what the first order covers: steps by bend are nearly the longest.
  /// With `slack` it may be off by so many times as much.
  bool straight(double slack = 1) const;

  double start, end, middle, radius;
  int terms;                          ///< coefficients in use, the same for all functions
  double c[model_degree][functions];  ///< by power, then function
  double error[functions], error_d[functions], error_dd[functions];
  double second[functions], second_rad[functions], third[functions];
  double vague_second[functions], vague_third[functions];  ///< what of these bounds is not the coefficients'
  double remainder[functions];                             ///< the part of the error that shrinks with the interval
  double noise[functions];                                 ///< the part that does not: the middle's own uncertainty
  double size[functions];                                  ///< bounds of |f_i|

  /// Of function i, how far its second derivative goes from the middle's, and how large the third one is, by the
  /// coefficients as they are, if that is less than what is known.
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
  /// And half their second derivatives.
  struct Horner2 : Horner {
    Lanes half = {};
    explicit Horner2(const double* leading) : Horner(leading) {}
    void step(const double* next, Lanes h) {
      half = half * h + d;
      Horner::step(next, h);
    }
  };
  /// What an error of function i is measured by.
  double scale(int i) const { return i < 4 ? size[i] + size[i ^ 1] : 1; }
  /// So much of it may be left out, and its bend may take it so far from straight.
  double leave(int i) const;
  double straightness(int i, double slack) const;
};

/// Function i of a model by Taylor's formula, from its series about the middle and, as far as that takes more, over all
/// of the interval; the radius is set.
void take_series(FrameModel& model, int i, const ModelSeries<double>& at_middle, const ModelSeries<double>& over);

}  // namespace taut::internal
