// Functions of the segment's parameter that are positive where a vertex is closer than a margin to an edge's line, or
// to another vertex.
//
// Neither needs a solver of its own. The distance of a vertex from an edge's line less a margin m is the orientation
// and m times the edge's length, which is constant in its body: a certificate function and a constant, or a polynomial
// in the time if the margin is one. The distance of two vertices is computed from the two coordinates of one in the
// frame of the other, which are certificate functions.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>

#include "certificate/precise_function.hpp"
#include "numeric/stages.hpp"
#include "scene/pair_margins.hpp"

namespace taut::internal {

/// A margin on a segment, at one precision: a constant and, if it changes, the other terms of a polynomial.
template <class Real>
struct MarginTerms {
  Ball<Real> constant;
  std::optional<TimePolynomial<Real>> varying = {};  ///< without a constant term

  MarginTerms(double m) : constant(Ball<Real>::exact(m)) {}
  MarginTerms(const Ball<Real>& m, std::optional<TimePolynomial<Real>> terms)
      : constant(m), varying(std::move(terms)) {}

  Ball<Real> value(const Ball<Real>& t) const { return varying ? constant + varying->value(t) : constant; }
  MarginTerms times(const Ball<Real>& factor) const {
    MarginTerms product(constant * factor, varying);
    if (varying) {
      for (std::size_t k = 0; k < varying->c.size; ++k) product.varying->c[k] = varying->c[k] * factor;
    }
    return product;
  }
};

/// m |b - a| + (b - a) x (c - a): positive where the vertex is behind the edge's line, or less than the margin in front
/// of it, that is to its right.
template <class Real>
class LineMargin : public PreciseFunction<Real> {
 public:
  LineMargin(const MotionSegment& segment, const PairGeometry& g, const CertificateFunction& line,
             const MarginTerms<Real>& margin, TaylorFrames* models = nullptr)
      : LineMargin(models, margin.times(length(g, line)), segment, g, line) {}

  /// Is it certain that the vertex is not more than the margin behind the line?
  bool not_behind(const Ball<Real>& t) const { return (room_.value(t) * 2 - this->value(t)).sign() > 0; }

 private:
  LineMargin(TaylorFrames* models, const MarginTerms<Real>& room, const MotionSegment& segment, const PairGeometry& g,
             const CertificateFunction& line)
      : PreciseFunction<Real>(segment, g, line, room.constant, models, room.varying), room_(room) {}

  static Ball<Real> length(const PairGeometry& g, const CertificateFunction& line) {
    using B = Ball<Real>;
    const DisplacedPoint &a = g.point(line.a), &b = g.point(line.b);
    const B x = B::exact(b.x) - B::exact(a.x) + (B::exact(b.dx) - B::exact(a.dx));
    const B y = B::exact(b.y) - B::exact(a.y) + (B::exact(b.dy) - B::exact(a.dy));
    return sqrt(x * x + y * y);
  }

  MarginTerms<Real> room_;  ///< the margin times the edge's length
};

/// m^2 - |c - a|^2, where m must not be negative.
template <class Real>
class VertexMargin {
 public:
  /// The vertices a and c must belong to different bodies.
  VertexMargin(const MotionSegment& segment, const PairGeometry& g, VertexId a, VertexId c,
               const MarginTerms<Real>& margin, TaylorFrames* models = nullptr)
      : x_(segment, g, {a, a, c, g.in_p(a), Measure::offset_x}, models),
        y_(segment, g, {a, a, c, g.in_p(a), Measure::offset_y}, models),
        margin_(margin),
        square_(margin.constant * margin.constant) {}

  Jet<Real> operator()(const Ball<Real>& t) const { return square_at(t) - (squared(x_(t)) + squared(y_(t))); }
  Jet<Real> operator()(const TimeFromEnd<Real>& t) const { return square_at(t) - (squared(x_(t)) + squared(y_(t))); }
  Ball<Real> value(const Ball<Real>& t) const {
    const Ball<Real> square = margin_.varying ? squared(margin_.value(t)) : square_;
    return square - (squared(x_.value(t)) + squared(y_.value(t)));
  }
  Jet<Real> decisive_range(const Ball<Real>& t) const { return (*this)(t); }

  /// As in PreciseFunction: the terms of a polynomial in the square root of the distance from a singular end,
  BallPolynomial<Real> terms_from_end(double end, double direction) const {
    const BallPolynomial<Real> x = x_.terms_from_end(end, direction), y = y_.terms_from_end(end, direction);
    BallPolynomial<Real> sum;
    for (std::size_t k = 0; k < last_from_end; ++k) sum.push_back(-(coefficient(x, x, k) + coefficient(y, y, k)));
    if (margin_.varying) {
      const BallPolynomial<Real> m = margin_from_end(end, direction);
      for (std::size_t k = 0; k < last_from_end; ++k) sum[k] = sum[k] + coefficient(m, m, k);
    } else {
      sum[0] = sum[0] + square_;
    }
    return sum;
  }
  /// and its last term, which is a range over all s up to `farthest`. It is that of a product, computed from the
  /// factors' derivatives there.
  Ball<Real> last_term_from_end(double end, double direction, double farthest) const {
    const auto up_to_there = Ball<Real>::between(Real(std::min(farthest, 0.0)), Real(std::max(farthest, 0.0)));
    const auto last_of_square = [&](BallPolynomial<Real> p, const Ball<Real>& last) {
      p.push_back(last);
      const BallPolynomial<Real> ranges = expanded(p, up_to_there);
      return coefficient(ranges, ranges, last_from_end);
    };
    Ball<Real> sum = Ball<Real>::exact(0);
    for (const PreciseFunction<Real>* const offset : {&x_, &y_}) {
      sum = sum - last_of_square(offset->terms_from_end(end, direction),
                                 offset->last_term_from_end(end, direction, farthest));
    }
    if (!margin_.varying) return sum;
    return sum + last_of_square(margin_from_end(end, direction),
                                margin_.varying->last_term_from_end(end, direction, farthest));
  }
  Jet<Real> decisive_range(const BallPolynomial<Real>& from_end, const Ball<Real>& s) const {
    return x_.decisive_range(from_end, s);
  }

 private:
  template <class Values>
  static Values squared(const Values& x) {
    return x * x;
  }
  template <class Time>
  Jet<Real> square_at(const Time& t) const {
    if (!margin_.varying) return Jet<Real>::constant(square_);
    return squared(Jet<Real>::constant(margin_.constant) + (*margin_.varying)(t));
  }
  BallPolynomial<Real> margin_from_end(double end, double direction) const {
    BallPolynomial<Real> m = margin_.varying->terms_from_end(end, direction);
    m[0] = m[0] + margin_.constant;
    return m;
  }
  /// The coefficient of power k of a product.
  static Ball<Real> coefficient(const BallPolynomial<Real>& p, const BallPolynomial<Real>& q, std::size_t k) {
    Ball<Real> sum = Ball<Real>::exact(0);
    for (std::size_t i = 0; i <= k; ++i) sum = sum + p[i] * q[k - i];
    return sum;
  }

  PreciseFunction<Real> x_, y_;
  MarginTerms<Real> margin_;
  Ball<Real> square_;  ///< of the constant
};

// A margin over time, in the terms of a motion segment.

/// What a margin is on one segment, which is not a bridge.
class SegmentMargin {
 public:
  /// Bounds over a stretch of time: `most` is certainly not below the margin, which changes by about `change`.
  struct Bounds {
    double most = 0, change = 0;
  };

  SegmentMargin(const Margin& margin, const MotionSegment& segment);

  Bounds over(double from, double to) const { return varying_ ? bounds_of_polynomial(from, to) : Bounds{constant_, 0}; }
  template <class Real>
  MarginTerms<Real> terms() const {
    if (!varying_) return MarginTerms<Real>(constant_);
    return terms_of_polynomial<Real>();
  }

 private:
  /// Of a margin that changes: about the segment's instant for functions, about its middle for bounds.
  struct Varying {
    double about, middle;
    LocalPolynomials::Known in_segment;
    BallPolynomial<double> near_middle;
  };
  Bounds bounds_of_polynomial(double from, double to) const;
  template <class Real>
  MarginTerms<Real> terms_of_polynomial() const;

  double constant_ = 0;
  std::optional<Varying> varying_;
};

}  // namespace taut::internal
