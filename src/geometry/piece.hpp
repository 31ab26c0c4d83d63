// Pieces of curves, each with a control polygon that bounds it.
//
// The law of a piece: its points are convex combinations of its control points, and its tangents are nonnegative
// combinations of the control polygon's segments. So it lies in the hull of its control points, and if all segments
// have a positive product with one direction, it runs along that direction without ever turning back.
//
//   Bezier curves: both are theirs by definition (Bernstein polynomials are nonnegative and sum up to 1), and de
//     Casteljau's halving keeps them.
//   Arcs of ellipses of a quarter or hardly more: images of c + (cos t, sin t) under an affine map. The arc of the
//   circle between
//     the directions u and v lies in the triangle of its ends and the point (u + v) / (1 + u v) at which the tangents
//     of these meet, and its tangents turn from the one segment's direction to the other's. Halves are between u, v and
//     (u
//     + v) / |u + v|. Affine maps keep combinations.
//   Lines: trivially.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "numeric/ball.hpp"
#include "taut/geometry.hpp"
#include "taut/outline.hpp"

namespace taut::internal::curve {

// Numbers for points on curves: four times as long as doubles, so that what they round is far below what any
// polygon's vertex is moved by.

using Wide = WideFloat<192>;
using WideBall = Ball<Wide>;

/// An index of a container.
inline std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// A point on a curve, or one that controls it, with a bound of its error.
struct WidePoint {
  WideBall x, y;

  static WidePoint of(const Point& p) { return {WideBall::exact(p.x), WideBall::exact(p.y)}; }
  /// Is it known to the last bit? Only points that are given by doubles are.
  bool is_exact() const { return x.rad == 0 && y.rad == 0; }
  Point rounded() const { return {RealTraits<Wide>::to_double(x.mid), RealTraits<Wide>::to_double(y.mid)}; }
};

inline WidePoint operator+(const WidePoint& a, const WidePoint& b) { return {a.x + b.x, a.y + b.y}; }
inline WidePoint operator-(const WidePoint& a, const WidePoint& b) { return {a.x - b.x, a.y - b.y}; }
inline WidePoint operator*(const WidePoint& a, double s) { return {a.x * s, a.y * s}; }
inline WideBall dot(const WidePoint& a, const WidePoint& b) { return a.x * b.x + a.y * b.y; }

/// The sign of (b - a) x (c - a) if doubles show it, else 0. With d a bound of how far rounded coordinates are off,
/// those of differences are off by 2d and a rounding error, which is less than 4d in all.
inline int turn_in_doubles(const WidePoint& a, const WidePoint& b, const WidePoint& c) {
  const Point p = a.rounded(), q = b.rounded(), r = c.rounded();
  double largest = 0, radius = 0;
  for (const double x : {p.x, p.y, q.x, q.y, r.x, r.y}) largest = std::max(largest, std::fabs(x));
  for (const WidePoint* point : {&a, &b, &c}) radius = std::max({radius, point->x.rad, point->y.rad});
  const double d = 0x1p-52 * largest + 2 * radius;
  const double ux = q.x - p.x, uy = q.y - p.y, vx = r.x - p.x, vy = r.y - p.y;
  const double left = ux * vy, right = uy * vx;
  const double error = 4 * d * (std::fabs(ux) + std::fabs(uy) + std::fabs(vx) + std::fabs(vy) + 16 * d) +
                       0x1p-50 * (std::fabs(left) + std::fabs(right)) + 0x1p-1000;
  return left - right > error ? 1 : right - left > error ? -1 : 0;
}

/// The sign of (b - a) x (c - a) if it is certain, else 0.
inline int turn(const WidePoint& a, const WidePoint& b, const WidePoint& c) {
  if (const int sign = turn_in_doubles(a, b, c)) return sign;
  const WidePoint u = b - a, v = c - a;
  return (u.x * v.y - u.y * v.x).sign();
}

/// Centre and half-axes of an ellipse: centre + cos t a + sin t b.
struct ArcFrame {
  WidePoint centre, a, b;
  /// Centre and axes are doubles, the axes along x and y, and the arc's ends exactly on the ellipse.
  bool exact = false;
  WidePoint at(const WidePoint& u) const;
};

/// What is known of the tangent at an end: it is exactly along an axis, where the end is exact. Only such tangents
/// can be followed by edges of doubles without leaving room.
enum class Level : unsigned char { unknown, horizontal, vertical };

struct Piece {
  int segment = 0;
  double from = 0, to = 1;  ///< of the segment's parameter: of arcs, the share of the angle
  std::array<WidePoint, 4> control;
  int size = 2;  ///< of `control`: 2 is a line
  std::array<Level, 2> level{Level::unknown, Level::unknown};
  std::array<bool, 2> still{false, false};  ///< a cubic whose first, or last, segment is exactly null
  std::shared_ptr<const ArcFrame> frame;    ///< of an arc
  std::array<WidePoint, 2> unit;            ///< of an arc: where it begins and ends, on the unit circle

  bool is_line() const { return size == 2; }
  const WidePoint& first() const { return control[0]; }
  const WidePoint& last() const { return control[static_cast<std::size_t>(size - 1)]; }
};

/// The segment in as few pieces as there may be: arcs are cut at the ends of their axes. Curves whose control points
/// are exactly on the line between the ends, in order, are lines. Empty for a segment of no length.
std::vector<Piece> pieces_of(const Point& from, const CurveSegment& segment, int index);

/// Two pieces, cut in the middle; not of lines.
std::array<Piece, 2> halves(const Piece& piece);

struct CentredArc {
  ArcFrame frame;
  std::array<WidePoint, 2> unit;  ///< where it begins and ends, on the unit circle
};

/// Appendix B.2.4 of SVG 2, with a bound of every error; radii are positive, the ends differ.
CentredArc centred(const Point& from, const ArcTo& arc);

}  // namespace taut::internal::curve
