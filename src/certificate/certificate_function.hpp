// Certificate functions: the functions whose sign the engines need. Their coefficients are derived here and only here.
//
// A certificate function is a polynomial in the positions of vertices of both bodies, in the frame of one of them. On a
// segment it is a fixed linear combination of the segment's frame functions (FrameOf in motion_segment.hpp). All
// evaluation code (doubles with bounds, exact lines, balls of any precision, identities, roots) uses the coefficients
// alone.
//
// To add another function, add its coefficients here, and the missing functions to the frame. Distances are made of
// certificate functions, too: see margin_function.hpp.
#pragma once

#include <array>
#include <type_traits>

#include "motion/motion_segment.hpp"
#include "scene/body_pair.hpp"
#include "scene/pair_geometry.hpp"

namespace taut::internal {

/// The measured quantity: the cross product (b - a) x (c - a), or the dot product (b - a) . (c - a), or one of the
/// coordinates of c - a in the frame of a's body, for which b does not matter.
enum class Measure : unsigned char { orientation, projection, offset_x, offset_y };

/// Two vertices a, b of one body and a vertex c of the other, and the quantity measured.
struct CertificateFunction {
  VertexId a, b, c;
  bool pp = false;  ///< a and b belong to P
  Measure measure = Measure::orientation;

  friend bool operator==(const CertificateFunction& x, const CertificateFunction& y) {
    return x.a == y.a && x.b == y.b && x.c == y.c && x.measure == y.measure;
  }
  /// The orientation of u, v, w, permuted cyclically so that the two vertices of one body come first. The permutation
  /// does not change the orientation.
  static CertificateFunction of(const PairGeometry& g, VertexId u, VertexId v, VertexId w) {
    if (g.same_body(u, v)) return {u, v, w, g.in_p(u)};
    if (g.same_body(v, w)) return {v, w, u, g.in_p(v)};
    return {w, u, v, g.in_p(w)};
  }
  /// Another measure of the same vertices.
  CertificateFunction measured(Measure what) const { return {a, b, c, pp, what}; }
  /// The position of c along the edge, measured from a (along) or from b in the opposite direction (back): negative
  /// beyond that end.
  CertificateFunction along() const { return {a, b, c, pp, Measure::projection}; }
  CertificateFunction back() const { return {b, a, c, pp, Measure::projection}; }
};

/// Vertices as given, or displaced.
enum class Shape : unsigned char { given, displaced };

/// The products a x b and a . b, for any number type; sums of doubles have their own.
template <class N>
N cross(const N& ax, const N& ay, const N& bx, const N& by) {
  return ax * by - ay * bx;
}
template <class N>
N dot(const N& ax, const N& ay, const N& bx, const N& by) {
  return ax * bx + ay * by;
}

/// The points that determine the coefficients, in the coordinates of the segment: the edge from a to b, and the points
/// a and c. N is any number type.
template <class N>
struct FunctionPoints {
  N ex, ey, ax, ay, cx, cy;

  /// A measure other than the orientation replaces the edge: the projection by the edge rotated by -90 degrees, a
  /// coordinate by a unit vector.
  void measure(Measure what) {
    if (what == Measure::projection) {
      const N turn = ex;
      ex = ey;
      ey = -turn;
    } else if (what != Measure::orientation) {
      ex = small(what == Measure::offset_y ? 1 : 0);
      ey = small(what == Measure::offset_x ? -1 : 0);
    }
  }

 private:
  static N small(double x) {
    if constexpr (std::is_same_v<N, double>) {
      return x;
    } else {
      return N::exact(x);
    }
  }
};

/// The points of a certificate function in the coordinates of the segment, in a number type that represents doubles
/// exactly (N::exact).
template <class N>
FunctionPoints<N> points_of(const MotionSegment& segment, const PairGeometry& g, const CertificateFunction& function,
                            Shape shape) {
  const DisplacedPoint &a = g.point(function.a), &b = g.point(function.b), &c = g.point(function.c);
  const auto whole = [shape](double x, double dx) {
    return shape == Shape::given ? N::exact(x) : N::exact(x) + N::exact(dx);
  };
  const auto difference = [shape](double x, double dx, double y, double dy) {
    const N given = N::exact(x) - N::exact(y);
    return shape == Shape::given ? given : given + (N::exact(dx) - N::exact(dy));
  };
  FunctionPoints<N> p{difference(b.x, b.dx, a.x, a.dx),
                      difference(b.y, b.dy, a.y, a.dy),
                      whole(a.x, a.dx),
                      whole(a.y, a.dy),
                      whole(c.x, c.dx),
                      whole(c.y, c.dy)};
  p.measure(function.measure);
  add_offset(segment, function.pp, p.ax, p.ay);
  add_offset(segment, !function.pp, p.cx, p.cy);
  return p;
}

/// In the frame of a's body, c is at D + (c + i s) (cx + i cy), so that the orientation e x (c - a) is this combination
/// of 1, D and (c, s): see FrameOf in motion_segment.hpp. In Q's frame all terms from D and from the angle change sign.
/// The coefficients are linear in the edge, and in the two points together.
template <class N>
std::array<N, 5> function_coefficients(bool pp, const FunctionPoints<N>& p) {
  const N turned = dot(p.ex, p.ey, p.cx, p.cy);
  return {cross(p.ax, p.ay, p.ex, p.ey), pp ? -p.ey : p.ey, pp ? p.ex : -p.ex, cross(p.ex, p.ey, p.cx, p.cy),
          pp ? turned : -turned};
}

/// The coefficients where neither body rotates, and c is 1. The terms of 1 and c are combined, so that differences
/// cancel.
template <class N>
std::array<N, 5> translation_coefficients(bool pp, const FunctionPoints<N>& p, const N& zero) {
  return {cross(p.ex, p.ey, N(p.cx - p.ax), N(p.cy - p.ay)), pp ? -p.ey : p.ey, pp ? p.ex : -p.ex, zero, zero};
}

/// The coefficients that the segment requires.
template <class N>
std::array<N, 5> coefficients_on(const MotionSegment& segment, bool pp, const FunctionPoints<N>& p, const N& zero) {
  return segment.translation ? translation_coefficients(pp, p, zero) : function_coefficients(pp, p);
}

// Certificate functions that are zero at all times before the displacement.

/// Is the certificate function of three vertices, before their displacement, zero at all times of the segment? If this
/// is not known, the result is false. Not for bridges.
bool vanishes_before_displacement(const MotionSegment& segment, const PairGeometry& g,
                                  const CertificateFunction& function);

/// The part of a certificate function to evaluate: all of it, or, where it is zero at all times before the
/// displacement, only the contribution of the displacement. (On a translation, the polynomial's own coefficients have
/// cancelled already.)
enum class Portion : unsigned char { whole, displacement };
Portion portion_of(const MotionSegment& segment, const PairGeometry& g, const CertificateFunction& function);

}  // namespace taut::internal
