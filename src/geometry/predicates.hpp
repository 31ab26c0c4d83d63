// The exact orientation of three points given by doubles.
//
// Contract. For coordinates that are zero or of magnitude between 2^-400 and 2^400 (validate_polygon sees to it),
// `orientation` is the exact sign of (a - c) x (b - c). So, for all such points a, b, c:
//
//   O1  orientation(a, b, c) == -orientation(b, a, c) == -orientation(a, c, b) == -orientation(c, b, a);
//   O2  orientation(a, b, c) == orientation(b, c, a) == orientation(c, a, b);
//   O3  orientation(a, b, c) == 0 if and only if the three points are exactly collinear (two equal points are);
//   O4  orientation(a + v, b + v, c + v) == orientation(a, b, c) if none of the six sums rounds;
//   O5  orientation(s a, s b, s c) == orientation(a, b, c) for every power of two s that stays in the range;
//   O6  orientation is +1 for (0,0), (1,0), (0,1): positive means that a, b, c turn counterclockwise.
//
// Outside that range nothing is promised, except that the functions return.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "numeric/stages.hpp"
#include "taut/geometry.hpp"

namespace taut::internal {

/// Magnitudes between which the coordinates of the contract lie.
inline constexpr double min_coordinate = 0x1p-400;
inline constexpr double max_coordinate = 0x1p+400;
/// False of what is not a number.
inline bool in_range(double x) { return x == 0 || (std::fabs(x) >= min_coordinate && std::fabs(x) <= max_coordinate); }

/// For coordinates that are computed: those as good as zero become zero, and so stay within the contract.
inline double tidy(double x) { return std::fabs(x) < 0x1p-300 ? 0 : x; }

/// The second stage alone: the sign of the six products, summed exactly.
int orientation_exact(const Point& a, const Point& b, const Point& c);
/// The exact sign of (b - a) x (d - c), for the same range; 0 if and only if the two vectors are parallel or null.
int cross_sign_exact(const Point& a, const Point& b, const Point& c, const Point& d);
/// Is a point inside of a simple ring (1), outside (-1), or on it (0)? Exact, for the same range.
int side_of_ring(const Polygon& ring, const Point& p);

namespace detail {

/// Bounds the error of fl(L - R), L = fl(fl(p1 - p2) fl(p3 - p4)), R likewise, against the exact value L* - R*.
///
/// Proof sketch, u = 2^-53. Each difference has a relative error of at most u and is 0 or at least 2^-452, so no
/// product underflows, and L = L*(1 + d1)(1 + d2)(1 + d3) with |di| <= u: L* differs from L by at most
/// ((1 - u)^-3 - 1)|L| < (3u + 7u^2 - 48u^3)|L|; the same for R. So the sign of L - R is that of L* - R* if
///     |L - R| >= (3u + 7u^2 - 48u^3)(|L| + |R|)                                                              (*)
/// Three roundings lie between (*) and what is computed, each of relative size at most u: |fl(L - R)| (1 - u) <=
/// |L - R|, S = fl(|L| + |R|) >= (1 - u)(|L| + |R|), and fl(c S) >= (1 - u) c S. Hence |fl(L - R)| >= fl(c S)
/// implies (*) if c (1 - u)^3 >= 3u + 7u^2 - 48u^3, and c = (3 + 16u)u does: c (1 - 3u) = 3u + 7u^2 - 48u^3.
/// (Shewchuk 1997, section 4.3, has the same constant.) The bound on L* being strict, the comparison may be >=: if
/// both products are zero, they are so exactly, and 0 >= 0 gives the sign 0.
inline constexpr double cross_error = (3.0 + 16.0 * 0x1p-53) * 0x1p-53;

/// True if `sign` was set to the proved sign of left - right, two products as above.
inline bool filtered_sign(double left, double right, int& sign) {
  const double det = left - right;
  if (!(std::fabs(det) >= cross_error * (std::fabs(left) + std::fabs(right)))) return false;
  sign = det > 0 ? 1 : (det < 0 ? -1 : 0);
  return true;
}

}  // namespace detail

/// The sign of (a - c) x (b - c) and which stage decided it.
inline StagedSign orientation_staged(const Point& a, const Point& b, const Point& c) {
  int sign = 0;
  if (detail::filtered_sign((a.x - c.x) * (b.y - c.y), (a.y - c.y) * (b.x - c.x), sign)) return {sign, Stage::doubles};
  return {orientation_exact(a, b, c), Stage::exact};
}

/// +1 if a, b, c turn counterclockwise, -1 if clockwise, 0 if and only if they are collinear.
inline int orientation(const Point& a, const Point& b, const Point& c) { return orientation_staged(a, b, c).sign; }

/// The sign of (b - a) x (d - c): +1 if turning the first vector into the second goes counterclockwise.
inline int cross_sign(const Point& a, const Point& b, const Point& c, const Point& d) {
  int sign = 0;
  if (detail::filtered_sign((b.x - a.x) * (d.y - c.y), (b.y - a.y) * (d.x - c.x), sign)) return sign;
  return cross_sign_exact(a, b, c, d);
}

/// The exact lexicographic order by (x, y): the order of a plane sweep.
inline bool lexicographically_less(const Point& a, const Point& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

// Convex hulls, the orientation of a polygon, its diameter.
//
// All points must satisfy the range of predicates.hpp.

/// The vertices of the convex hull, as indices into `points`: counterclockwise, strictly convex, beginning with the
/// lexicographically smallest point. Exact, O(n log n). Of equal points the lowest index is named. Points on a line
/// give its two ends, equal points one index, no points none.
std::vector<int> convex_hull(const std::vector<Point>& points);

/// The sign of the area of a simple polygon, exact: +1 if its vertices run counterclockwise, -1 if clockwise. O(n).
int polygon_orientation(const Polygon& polygon);

/// The square of the largest distance between two of the points, by rotating calipers: the pairs compared are chosen
/// exactly, their distances are rounded (relative error below 2^-50). 0 for fewer than two points.
double diameter_squared(const std::vector<Point>& points);

}  // namespace taut::internal
