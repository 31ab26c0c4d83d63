// Is a vertex closer than a margin to an edge's line, or to another vertex? As functions of the leg's parameter, which
// are positive where it is.
//
// Neither needs a solver of its own. The distance of a vertex from an edge's line less a margin m is the orientation
// and m times the edge's length, which rests in its body. The distance of two vertices is made of the two coordinates
// of one in the frame of the other, which are forms.
#pragma once

#include "numeric/first_told.hpp"
#include "sign/precise_function.hpp"

namespace taut {

/// m |b - a| + (b - a) x (c - a): positive where the vertex is behind the edge's line, or not as far as the margin in
/// front of it, that is to its right.
template <class Real>
class LineCloseness {
 public:
  LineCloseness(const Leg& leg, const PairGeometry& g, const Form& line, double margin)
      : orientation_(leg, g, line), room_(length(g, line) * margin) {}

  Jet<Real> operator()(const Ball<Real>& t) const {
    Jet<Real> f = orientation_(t);
    f.v = f.v + room_;
    return f;
  }
  Ball<Real> value(const Ball<Real>& t) const { return orientation_.value(t) + room_; }
  /// Is it certain that it is not even behind the line by more than the margin?
  bool not_behind(const Ball<Real>& t) const { return (room_ - orientation_.value(t)).sign() > 0; }

 private:
  static Ball<Real> length(const PairGeometry& g, const Form& line) {
    using B = Ball<Real>;
    const DisplacedPoint &a = g.point(line.a), &b = g.point(line.b);
    const B x = B::exact(b.x) - B::exact(a.x) + (B::exact(b.dx) - B::exact(a.dx));
    const B y = B::exact(b.y) - B::exact(a.y) + (B::exact(b.dy) - B::exact(a.dy));
    return sqrt(x * x + y * y);
  }

  PreciseFunction<Real> orientation_;
  Ball<Real> room_;
};

/// m^2 - |c - a|^2.
template <class Real>
class VertexCloseness {
 public:
  /// a and c are of different bodies.
  VertexCloseness(const Leg& leg, const PairGeometry& g, VertexId a, VertexId c, double margin)
      : x_(leg, g, {a, a, c, g.in_p(a), Measure::offset_x}),
        y_(leg, g, {a, a, c, g.in_p(a), Measure::offset_y}),
        square_(Ball<Real>::exact(margin) * Ball<Real>::exact(margin)) {}

  Jet<Real> operator()(const Ball<Real>& t) const {
    const Jet<Real> x = x_(t), y = y_(t);
    return Jet<Real>::constant(square_) - (x * x + y * y);
  }
  Ball<Real> value(const Ball<Real>& t) const {
    const Ball<Real> x = x_.value(t), y = y_.value(t);
    return square_ - (x * x + y * y);
  }

 private:
  PreciseFunction<Real> x_, y_;
  Ball<Real> square_;
};

}  // namespace taut
