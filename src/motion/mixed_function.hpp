// Orientation and projection of three vertices of both bodies, as functions of the leg's parameter, at high precision.
#pragma once

#include "motion/leg.hpp"
#include "motion/mixed_triple.hpp"

namespace taut {

/// The function as five coefficients of the leg's frame functions; multi-precision, displacement included.
template <class Real>
class PreciseFunction {
 public:
  PreciseFunction(const Leg& leg, const PairGeometry& g, const MixedTriple& triple,
                  Measure measure = Measure::orientation)
      : leg_(leg), pp_(triple.pp) {
    using B = Ball<Real>;
    const DisplacedPoint &a = g.point(triple.a), &b = g.point(triple.b), &c = g.point(triple.c);
    B ex = difference(b.x, b.dx, a.x, a.dx), ey = difference(b.y, b.dy, a.y, a.dy);
    if (measure == Measure::projection) {
      const B turn = ex;
      ex = ey;
      ey = -turn;
    }
    B ax, ay, cx, cy;
    position(a, triple.pp, ax, ay);
    position(c, !triple.pp, cx, cy);
    // Coefficient by coefficient as in Leg: see Frame. For two vertices of Q the frame is Q's, and everything that
    // comes from D and from the angle changes sign.
    const B turned = ex * cx + ey * cy;
    coefficients_[1] = triple.pp ? -ey : ey;
    coefficients_[2] = triple.pp ? ex : -ex;
    coefficients_[4] = triple.pp ? turned : -turned;
    if (leg.translation) {
      coefficients_[0] = ex * (cy - ay) - ey * (cx - ax);
      coefficients_[3] = B::exact(0);
      expand();
    } else {
      coefficients_[0] = ey * ax - ex * ay;
      coefficients_[3] = ex * cy - ey * cx;
    }
  }

  /// Value and derivatives over the ball t of the leg's parameter.
  Jet<Real> operator()(const Ball<Real>& t) const {
    if (leg_.translation) return polynomial_range(polynomial_, t);
    const Frame<Real> f = frame(leg_, t);
    return combine(pp_ ? f.for_pp : f.for_qq);
  }
  /// The same as a function of the distance's root from a singular end.
  Jet<Real> operator()(const TimeFromEnd<Real>& t) const {
    const Frame<Real> f = frame(leg_, t);
    return combine(pp_ ? f.for_pp : f.for_qq);
  }
  /// As a polynomial in s that is right for all s from the end to `farthest`: Taylor's formula about the end.
  BallPolynomial<Real> from_end(double end, double direction, const Ball<Real>& farthest) const {
    const FrameOf<EndSeries<Real>> at_end = frame_series(leg_, TimeFromEnd<Real>{end, direction, Ball<Real>::exact(0)});
    const FrameOf<EndSeries<Real>> over =
        frame_series(leg_, TimeFromEnd<Real>{end, direction, hull(Ball<Real>::exact(0), farthest)});
    BallPolynomial<Real> sum;
    for (int k = 0; k <= end_degree; ++k) {
      const FrameOf<EndSeries<Real>>& from = k < end_degree ? at_end : over;
      const std::array<EndSeries<Real>, 5>& f = pp_ ? from.for_pp : from.for_qq;
      Ball<Real> c = f[0].c[k] * coefficients_[0];
      for (std::size_t i = 1; i < 5; ++i) c = c + f[i].c[k] * coefficients_[i];
      sum.push_back(c);
    }
    return sum;
  }
  /// The value alone, at less than half the price.
  Ball<Real> value(const Ball<Real>& t) const {
    if (leg_.translation) return polynomial_value(polynomial_, t);
    const FrameValues<Real> f = frame_values(leg_, t);
    const std::array<Ball<Real>, 5>& v = pp_ ? f.for_pp : f.for_qq;
    Ball<Real> sum = v[0] * coefficients_[0];
    for (std::size_t i = 1; i < 5; ++i) sum = sum + v[i] * coefficients_[i];
    return sum;
  }

 private:
  /// On a translation the function is a polynomial: its own coefficients show roots that those of x and y hide.
  void expand() {
    using B = Ball<Real>;
    polynomial_.size = 0;
    polynomial_.push_back(coefficients_[0]);
    const auto at = [](const Coefficients& c, int k) {
      return B::exact(static_cast<std::size_t>(k) < c.size() ? c[static_cast<std::size_t>(k)] : 0.0);
    };
    for (int k = 1; k <= leg_.degree; ++k) {
      const B dx = at(leg_.q.x, k) - at(leg_.p.x, k), dy = at(leg_.q.y, k) - at(leg_.p.y, k);
      polynomial_.push_back(coefficients_[1] * dx + coefficients_[2] * dy);
    }
  }
  static Ball<Real> difference(double x, double dx, double y, double dy) {
    using B = Ball<Real>;
    return (B::exact(x) - B::exact(y)) + (B::exact(dx) - B::exact(dy));
  }
  void position(const DisplacedPoint& v, bool of_p, Ball<Real>& x, Ball<Real>& y) const {
    using B = Ball<Real>;
    x = B::exact(v.x) + B::exact(v.dx);
    y = B::exact(v.y) + B::exact(v.dy);
    add_offset(leg_, of_p, x, y);
  }
  Jet<Real> combine(const std::array<Jet<Real>, 5>& f) const {
    Jet<Real> sum = f[0] * coefficients_[0];
    for (std::size_t i = 1; i < 5; ++i) sum = sum + f[i] * coefficients_[i];
    return sum;
  }

  const Leg& leg_;
  bool pp_;
  std::array<Ball<Real>, 5> coefficients_;
  BallPolynomial<Real> polynomial_;  ///< of a translation
};

}  // namespace taut
