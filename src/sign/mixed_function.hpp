// Orientation and projection of three vertices of both bodies, as functions of the leg's parameter, at high precision.
#pragma once

#include <optional>

#include "relative/leg.hpp"
#include "sign/form.hpp"
#include "sign/mixed_triple.hpp"
#include "sign/vanishing.hpp"

namespace taut {

/// The function as five coefficients of the leg's frame functions; multi-precision, displacement included.
template <class Real>
class PreciseFunction {
 public:
  PreciseFunction(const Leg& leg, const PairGeometry& g, const MixedTriple& triple,
                  Measure measure = Measure::orientation)
      : leg_(leg), pp_(triple.pp) {
    const DisplacedPoint &a = g.point(triple.a), &b = g.point(triple.b), &c = g.point(triple.c);
    FormPoints<Ball<Real>> p;
    p.ex = difference(b.x, b.dx, a.x, a.dx);
    p.ey = difference(b.y, b.dy, a.y, a.dy);
    p.measure(measure);
    position(a, triple.pp, p.ax, p.ay);
    position(c, !triple.pp, p.cx, p.cy);
    if (leg.translation) {
      // The frames do not turn: the terms of 1 and c are one, in which differences of coordinates cancel.
      coefficients_ = form_coefficients(triple.pp, p);
      coefficients_[0] = p.ex * (p.cy - p.ay) - p.ey * (p.cx - p.ax);
      coefficients_[3] = Ball<Real>::exact(0);
      expand();
    } else if (portion_of(leg, g, triple, measure) == Portion::displacement) {
      coefficients_ = displacement_part(g, triple, measure, p);
    } else {
      coefficients_ = form_coefficients(triple.pp, p);
    }
  }

  /// Value and derivatives over the ball t of the leg's parameter.
  Jet<Real> operator()(const Ball<Real>& t) const {
    if (leg_.translation) return polynomial_range(polynomial_, t);
    const Frame<Real> f = frame(leg_, t);
    const Jet<Real> range = combine(pp_ ? f.for_pp : f.for_qq);
    if (range.v.sign() != 0 || range.d.sign() != 0 || t.rad == 0 || leg_.bridge) return range;
    return range_of_model(t);
  }
  /// The same as a function of the distance's root from a singular end.
  Jet<Real> operator()(const TimeFromEnd<Real>& t) const {
    const Frame<Real> f = frame(leg_, t);
    return combine(pp_ ? f.for_pp : f.for_qq);
  }
  /// As a polynomial in s that is right for all s from the end to `farthest`: Taylor's formula about the end.
  BallPolynomial<Real> from_end(double end, double direction, const Ball<Real>& farthest) const {
    const FrameOf<PreciseSeries<Real>> at_end =
        frame_series(leg_, TimeFromEnd<Real>{end, direction, Ball<Real>::exact(0)});
    const FrameOf<PreciseSeries<Real>> over =
        frame_series(leg_, TimeFromEnd<Real>{end, direction, hull(Ball<Real>::exact(0), farthest)});
    return taylor_polynomial(at_end, over);
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
  /// Taylor's formula, with the last term from all over the range.
  BallPolynomial<Real> taylor_polynomial(const FrameOf<PreciseSeries<Real>>& middle,
                                         const FrameOf<PreciseSeries<Real>>& over) const {
    BallPolynomial<Real> sum;
    for (int k = 0; k <= taylor_degree; ++k) {
      const FrameOf<PreciseSeries<Real>>& from = k < taylor_degree ? middle : over;
      const std::array<PreciseSeries<Real>, 5>& f = pp_ ? from.for_pp : from.for_qq;
      Ball<Real> c = f[0].c[k] * coefficients_[0];
      for (std::size_t i = 1; i < 5; ++i) c = c + f[i].c[k] * coefficients_[i];
      sum.push_back(c);
    }
    return sum;
  }
  /// The range by a polynomial of high degree. Near a root of order m ranges have to shrink like h^m, but those of the
  /// five terms, which cancel there, shrink like h; the coefficients of the polynomial have cancelled already. A search
  /// asks for many intervals close to each other: the polynomial serves them until they are far smaller than what it
  /// was made for.
  Jet<Real> range_of_model(const Ball<Real>& t) const {
    if constexpr (std::is_same_v<Real, double>) {
      return {Ball<Real>(0, INFINITY), Ball<Real>(0, INFINITY), Ball<Real>(0, INFINITY)};
    } else {
      if (!model_ || t.lower() < model_->lo || t.upper() > model_->hi || t.rad < 0x1p-8 * model_->reach) make_model(t);
      return polynomial_range(model_->about_middle, t - Ball<Real>(model_->middle, 0.0));
    }
  }
  void make_model(const Ball<Real>& t) const {
    const Real lo = std::min<Real>(t.lower(), std::max<Real>(t.mid - 4 * t.rad, Real(leg_.start)));
    const Real hi = std::max<Real>(t.upper(), std::min<Real>(t.mid + 4 * t.rad, Real(leg_.end)));
    const Ball<Real> over = Ball<Real>::between(lo, hi), middle(over.mid, 0.0);
    model_ = Model{lo, hi, over.mid, over.rad, taylor_polynomial(frame_series(leg_, middle), frame_series(leg_, over))};
  }

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
  /// Of a function that is zero at all times before the displacement: the rest, with nothing to cancel. What is linear
  /// in the edge e0 + e1 and in the points r0 + r1, without e0 r0, is e0 r1 + e1 (r0 + r1).
  std::array<Ball<Real>, 5> displacement_part(const PairGeometry& g, const MixedTriple& triple, Measure measure,
                                              const FormPoints<Ball<Real>>& whole) const {
    using B = Ball<Real>;
    const DisplacedPoint &a = g.point(triple.a), &b = g.point(triple.b), &c = g.point(triple.c);
    FormPoints<B> edge = whole;
    edge.ex = B::exact(b.dx) - B::exact(a.dx);
    edge.ey = B::exact(b.dy) - B::exact(a.dy);
    edge.measure(measure);
    FormPoints<B> points{B::exact(b.x) - B::exact(a.x),
                         B::exact(b.y) - B::exact(a.y),
                         B::exact(a.dx),
                         B::exact(a.dy),
                         B::exact(c.dx),
                         B::exact(c.dy)};
    points.measure(measure);
    std::array<B, 5> sum = form_coefficients(triple.pp, edge);
    const std::array<B, 5> more = form_coefficients(triple.pp, points);
    // The motion's terms have the edge alone in them: they are in the first sum.
    for (const std::size_t i : {0, 3, 4}) sum[i] = sum[i] + more[i];
    return sum;
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
  struct Model {
    Real lo, hi, middle;
    double reach;
    BallPolynomial<Real> about_middle;
  };
  mutable std::optional<Model> model_;  ///< the last one that was made
};

}  // namespace taut
