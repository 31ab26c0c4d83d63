#include "geometry/cell.hpp"

#include <algorithm>

#include "geometry/predicates.hpp"

namespace taut::internal::curve {
namespace {

/// Is p certainly not to the right of the line from a to b? Where a tangent is level, control points lie on the line
/// itself, which only their coordinates show.
bool not_right_of(const Point& a, const Point& b, const WidePoint& p) {
  if (p.is_exact()) return orientation(a, b, p.rounded()) >= 0;
  if (a.y == b.y) return b.x > a.x ? p.y.lower() >= a.y : p.y.upper() <= a.y;
  if (a.x == b.x) return b.y > a.y ? p.x.upper() <= a.x : p.x.lower() >= a.x;
  return turn(WidePoint::of(a), WidePoint::of(b), p) > 0;
}

bool strictly_convex(const std::vector<Point>& ring) {
  const std::size_t n = ring.size();
  if (n < 3) return false;
  for (std::size_t i = 0; i < n; ++i) {
    if (orientation(ring[i], ring[(i + 1) % n], ring[(i + 2) % n]) <= 0) return false;
  }
  // All turns are to the left; that they are one turn together shows at any vertex.
  for (std::size_t i = 2; i + 1 < n; ++i) {
    if (orientation(ring[0], ring[i], ring[i + 1]) <= 0) return false;
  }
  return true;
}

bool holds_control_points(const Cell& cell, const std::vector<Point>& wall) {
  for (std::size_t i = 0; i + 1 < wall.size(); ++i) {
    for (int k = 0; k < cell.piece.size; ++k) {
      if (!not_right_of(wall[i], wall[i + 1], cell.piece.control[static_cast<std::size_t>(k)])) return false;
    }
  }
  return true;
}

/// Are all of them strictly to the left of the lines from a to p and from p to b?
bool beyond_second(const Point& a, const WidePoint& p, const Point& b, const std::vector<WidePoint>& points) {
  const WidePoint from = WidePoint::of(a), to = WidePoint::of(b);
  return std::all_of(points.begin(), points.end(),
                     [&](const WidePoint& q) { return turn(from, p, q) > 0 && turn(p, to, q) > 0; });
}

/// C3. Gates that are points need none of it: the piece begins in a corner of a convex polygon.
bool beyond_gates(const Cell& cell, const Gate& first, const Gate& last) {
  const Piece& piece = cell.piece;
  const auto begin = piece.control.begin(), end = begin + piece.size;
  if (!first.exact) {
    std::vector<WidePoint> ahead(begin + 1, end);
    ahead.push_back(WidePoint::of(last.left));
    ahead.push_back(WidePoint::of(last.right));
    if (!beyond_second(first.left, piece.first(), first.right, ahead)) return false;
  }
  if (!last.exact) {
    std::vector<WidePoint> behind(begin, end - 1);
    behind.push_back(WidePoint::of(first.left));
    behind.push_back(WidePoint::of(first.right));
    if (!beyond_second(last.right, piece.last(), last.left, behind)) return false;
  }
  return true;
}

/// C4, for the direction of the chord. Segments of Bezier curves shall turn by less than a quarter from each other,
/// which implies it, and which halves inherit: so whatever has a cell can be halved.
bool runs_ahead(const Piece& piece) {
  std::vector<WidePoint> segments;
  for (int k = 0; k + 1 < piece.size; ++k) {
    if ((k == 0 && piece.still[0]) || (k + 2 == piece.size && piece.still[1])) continue;
    segments.push_back(piece.control[static_cast<std::size_t>(k + 1)] - piece.control[static_cast<std::size_t>(k)]);
  }
  const WidePoint chord = piece.last() - piece.first();
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (dot(segments[i], chord).sign() <= 0) return false;
    for (std::size_t j = 0; j < i && !piece.frame; ++j) {
      if (dot(segments[i], segments[j]).sign() <= 0) return false;
    }
  }
  return true;
}

std::vector<Point> wall_of(const Point& from, const std::vector<Point>& corners, const Point& to) {
  std::vector<Point> wall{from};
  wall.insert(wall.end(), corners.begin(), corners.end());
  wall.push_back(to);
  return wall;
}

}  // namespace

bool verified(const Cell& cell, const Gate& first, const Gate& last) {
  if (!runs_ahead(cell.piece) || !strictly_convex(corners_of(cell, first, last))) return false;
  const std::vector<Point> right = wall_of(first.right, cell.right, last.right);
  std::vector<Point> left = wall_of(first.left, cell.left, last.left);
  std::reverse(left.begin(), left.end());
  return holds_control_points(cell, right) && holds_control_points(cell, left) && beyond_gates(cell, first, last);
}

}  // namespace taut::internal::curve
