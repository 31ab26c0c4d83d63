// Functions of the segment's parameter that are positive where a vertex is closer than a margin to an edge's line, or
// to another vertex.
//
// Neither needs a solver of its own. The distance of a vertex from an edge's line less a margin m is the orientation
// and m times the edge's length, which is constant in its body: a certificate function and a constant. The distance of
// two vertices is computed from the two coordinates of one in the frame of the other, which are certificate functions.
#pragma once

#include <algorithm>

#include "certificate/precise_function.hpp"
#include "numeric/first_decisive.hpp"

namespace taut::internal {

/// m |b - a| + (b - a) x (c - a): positive where the vertex is behind the edge's line, or less than the margin in front
/// of it, that is to its right.
template <class Real>
class LineMargin : public PreciseFunction<Real> {
 public:
  LineMargin(const MotionSegment& segment, const PairGeometry& g, const CertificateFunction& line, double margin,
             TaylorFrames* models = nullptr)
      : LineMargin(segment, g, line, length(g, line) * margin, models) {}

  /// Is it certain that the vertex is not more than the margin behind the line?
  bool not_behind(const Ball<Real>& t) const { return (room_ * 2 - this->value(t)).sign() > 0; }

 private:
  LineMargin(const MotionSegment& segment, const PairGeometry& g, const CertificateFunction& line,
             const Ball<Real>& room, TaylorFrames* models)
      : PreciseFunction<Real>(segment, g, line, room, models), room_(room) {}

  static Ball<Real> length(const PairGeometry& g, const CertificateFunction& line) {
    using B = Ball<Real>;
    const DisplacedPoint &a = g.point(line.a), &b = g.point(line.b);
    const B x = B::exact(b.x) - B::exact(a.x) + (B::exact(b.dx) - B::exact(a.dx));
    const B y = B::exact(b.y) - B::exact(a.y) + (B::exact(b.dy) - B::exact(a.dy));
    return sqrt(x * x + y * y);
  }

  Ball<Real> room_;
};

/// m^2 - |c - a|^2.
template <class Real>
class VertexMargin {
 public:
  /// The vertices a and c must belong to different bodies.
  VertexMargin(const MotionSegment& segment, const PairGeometry& g, VertexId a, VertexId c, double margin,
               TaylorFrames* models = nullptr)
      : x_(segment, g, {a, a, c, g.in_p(a), Measure::offset_x}, models),
        y_(segment, g, {a, a, c, g.in_p(a), Measure::offset_y}, models),
        square_(Ball<Real>::exact(margin) * Ball<Real>::exact(margin)) {}

  Jet<Real> operator()(const Ball<Real>& t) const { return combined(x_(t), y_(t)); }
  Jet<Real> operator()(const TimeFromEnd<Real>& t) const { return combined(x_(t), y_(t)); }
  Ball<Real> value(const Ball<Real>& t) const { return combined(x_.value(t), y_.value(t)); }
  Jet<Real> decisive_range(const Ball<Real>& t) const { return (*this)(t); }

  /// As in PreciseFunction: the terms of a polynomial in the square root of the distance from a singular end,
  BallPolynomial<Real> terms_from_end(double end, double direction) const {
    const BallPolynomial<Real> x = x_.terms_from_end(end, direction), y = y_.terms_from_end(end, direction);
    BallPolynomial<Real> sum;
    for (std::size_t k = 0; k < last_from_end; ++k) sum.push_back(-(coefficient(x, x, k) + coefficient(y, y, k)));
    sum[0] = sum[0] + square_;
    return sum;
  }
  /// and its last term, which is a range over all s up to `farthest`. It is that of a product, computed from the
  /// factors' derivatives there.
  Ball<Real> last_term_from_end(double end, double direction, double farthest) const {
    const auto up_to_there = Ball<Real>::between(Real(std::min(farthest, 0.0)), Real(std::max(farthest, 0.0)));
    Ball<Real> sum = Ball<Real>::exact(0);
    for (const PreciseFunction<Real>* const offset : {&x_, &y_}) {
      BallPolynomial<Real> p = offset->terms_from_end(end, direction);
      p.push_back(offset->last_term_from_end(end, direction, farthest));
      const BallPolynomial<Real> ranges = expanded(p, up_to_there);
      sum = sum - coefficient(ranges, ranges, last_from_end);
    }
    return sum;
  }
  Jet<Real> decisive_range(const BallPolynomial<Real>& from_end, const Ball<Real>& s) const {
    return x_.decisive_range(from_end, s);
  }

 private:
  template <class Values>
  Values combined(const Values& x, const Values& y) const {
    const Values sum = x * x + y * y;
    if constexpr (std::is_same_v<Values, Jet<Real>>) {
      return Jet<Real>::constant(square_) - sum;
    } else {
      return square_ - sum;
    }
  }
  /// The coefficient of power k of a product.
  static Ball<Real> coefficient(const BallPolynomial<Real>& p, const BallPolynomial<Real>& q, std::size_t k) {
    Ball<Real> sum = Ball<Real>::exact(0);
    for (std::size_t i = 0; i <= k; ++i) sum = sum + p[i] * q[k - i];
    return sum;
  }

  PreciseFunction<Real> x_, y_;
  Ball<Real> square_;
};

}  // namespace taut::internal
