#include "path/convex_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/predicates.hpp"
#include "numeric/dyadic.hpp"

namespace taut::internal::path {
namespace {

/// Above, it would take long.
constexpr std::size_t most_vertices = 1000;

bool same(const Point& a, const Point& b) { return a.x == b.x && a.y == b.y; }

/// Twice the area, positive if counterclockwise.
Dyadic doubled_area(const Polygon& ring) {
  Dyadic sum;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    sum = sum + Dyadic::exact(a.x) * Dyadic::exact(b.y) - Dyadic::exact(a.y) * Dyadic::exact(b.x);
  }
  return sum;
}

Polygon oriented(Polygon ring, int sign) {
  if (doubled_area(ring).sign() != sign) std::reverse(ring.begin(), ring.end());
  return ring;
}

/// Do two segments have a point in common besides a common end?
bool meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  const int abc = orientation(a, b, c), abd = orientation(a, b, d), cda = orientation(c, d, a),
            cdb = orientation(c, d, b);
  if (abc * abd < 0 && cda * cdb < 0) return true;
  const auto between = [](const Point& p, const Point& u, const Point& v) {
    return std::min(u.x, v.x) <= p.x && p.x <= std::max(u.x, v.x) && std::min(u.y, v.y) <= p.y &&
           p.y <= std::max(u.y, v.y) && !same(p, u) && !same(p, v);
  };
  return (abc == 0 && between(c, a, b)) || (abd == 0 && between(d, a, b)) || (cda == 0 && between(a, c, d)) ||
         (cdb == 0 && between(b, c, d));
}

/// Cuts a hole open to the outline by a double edge, the shortest one that meets nothing. False if there is none.
bool open_hole(Polygon& outline, const Polygon& hole, const std::vector<Polygon>& all_holes) {
  double best = INFINITY;
  std::size_t from = 0, to = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    for (std::size_t k = 0; k < hole.size(); ++k) {
      const double length = std::hypot(outline[i].x - hole[k].x, outline[i].y - hole[k].y);
      if (length >= best) continue;
      const auto blocks = [&](const Polygon& ring) {
        for (std::size_t e = 0; e < ring.size(); ++e) {
          if (meet(outline[i], hole[k], ring[e], ring[(e + 1) % ring.size()])) return true;
        }
        return false;
      };
      if (blocks(outline) || std::any_of(all_holes.begin(), all_holes.end(), blocks)) continue;
      best = length;
      from = i;
      to = k;
    }
  }
  if (!(best < INFINITY)) return false;
  Polygon bridge(hole.begin() + static_cast<std::ptrdiff_t>(to), hole.end());
  bridge.insert(bridge.end(), hole.begin(), hole.begin() + static_cast<std::ptrdiff_t>(to) + 1);
  bridge.push_back(outline[from]);
  outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(from) + 1, bridge.begin(), bridge.end());
  return true;
}

bool is_ear(const Polygon& ring, std::size_t k) {
  const std::size_t n = ring.size();
  const Point &a = ring[(k + n - 1) % n], &b = ring[k], &c = ring[(k + 1) % n];
  if (orientation(a, b, c) <= 0) return false;
  return std::none_of(ring.begin(), ring.end(), [&](const Point& v) {
    if (same(v, a) || same(v, b) || same(v, c)) return false;
    return orientation(a, b, v) >= 0 && orientation(b, c, v) >= 0 && orientation(c, a, v) >= 0;
  });
}

std::optional<std::vector<Polygon>> triangles(Polygon ring) {
  std::vector<Polygon> found;
  while (ring.size() > 3) {
    const std::size_t n = ring.size();
    std::size_t ear = n;
    for (std::size_t k = 0; k < n && ear == n; ++k) {
      if (is_ear(ring, k)) ear = k;
    }
    if (ear == n) return std::nullopt;
    found.push_back({ring[(ear + n - 1) % n], ring[ear], ring[(ear + 1) % n]});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  if (orientation(ring[0], ring[1], ring[2]) > 0) found.push_back(ring);
  return found;
}

bool is_convex(const Polygon& ring) {
  const std::size_t n = ring.size();
  for (std::size_t k = 0; k < n; ++k) {
    if (orientation(ring[k], ring[(k + 1) % n], ring[(k + 2) % n]) < 0) return false;
  }
  return true;
}

/// Two pieces joined along an edge that both have, if that is convex.
std::optional<Polygon> joined(const Polygon& a, const Polygon& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) {
      if (!same(a[i], b[(k + 1) % b.size()]) || !same(a[(i + 1) % a.size()], b[k])) continue;
      Polygon both(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      for (std::size_t m = 2; m < b.size(); ++m) both.push_back(b[(k + m) % b.size()]);
      both.insert(both.end(), a.begin() + static_cast<std::ptrdiff_t>(i) + 1, a.end());
      if (is_convex(both)) return both;
    }
  }
  return std::nullopt;
}

void join_convex(std::vector<Polygon>& pieces) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t k = i + 1; k < pieces.size();) {
      const std::optional<Polygon> both = joined(pieces[i], pieces[k]);
      if (!both) {
        ++k;
        continue;
      }
      pieces[i] = *both;
      pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(k));
      k = i + 1;
    }
  }
}

}  // namespace

std::optional<std::vector<Polygon>> convex_pieces(const Part& part) {
  Polygon ring = oriented(part.outline, 1);
  Dyadic area = doubled_area(ring);
  std::vector<Polygon> holes;
  std::size_t vertices = ring.size();
  for (const Polygon& hole : part.holes) {
    holes.push_back(oriented(hole, -1));
    area = area + doubled_area(holes.back());
    vertices += hole.size();
  }
  if (vertices > most_vertices) return std::nullopt;
  if (holes.empty() && is_convex(ring)) return std::vector<Polygon>{ring};
  for (const Polygon& hole : holes) {
    if (!open_hole(ring, hole, holes)) return std::nullopt;
  }
  auto pieces = triangles(ring);
  if (!pieces) return std::nullopt;
  join_convex(*pieces);
  Dyadic sum;
  for (const Polygon& piece : *pieces) sum = sum + doubled_area(piece);
  if (!(sum == area)) return std::nullopt;
  return pieces;
}

namespace {

/// All corners of what two polygons have in common.
std::vector<ExactPoint> common_corners(const ConvexRing& a, const ConvexRing& b) {
  std::vector<ExactPoint> found;
  for (const ExactPoint& p : a) {
    if (contains(b, p)) found.push_back(p);
  }
  for (const ExactPoint& p : b) {
    if (contains(a, p)) found.push_back(p);
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    const ExactPoint &from = a[i], &to = a[(i + 1) % a.size()];
    const AxisBox around = bounds_of(from, to);
    for (std::size_t k = 0; k < b.size(); ++k) {
      const ExactPoint &other = b[k], &end = b[(k + 1) % b.size()];
      if (!around.meets(bounds_of(other, end))) continue;
      if (auto meeting = meeting_point(from, to, other, end)) found.push_back(std::move(*meeting));
    }
  }
  return found;
}

/// The two ends of points on a line; nothing if they are on none.
ConvexRing ends_of(const ConvexRing& points) {
  ConvexRing ends = {points[0], points[1]};
  for (const ExactPoint& p : points) {
    if (turn_sign(points[0], points[1], p) != 0) return {};
    if (contains(ends, p)) continue;
    ends = contains({p, ends[1]}, ends[0]) ? ConvexRing{p, ends[1]} : ConvexRing{ends[0], p};
  }
  return ends;
}

/// A quotient by two doubles.
Dyadic fine_quotient(const Dyadic& above, const Dyadic& below) {
  const Dyadic first = Dyadic::exact(nearest_quotient(above, below));
  return first + Dyadic::exact(nearest_quotient(above - first * below, below));
}
/// A sum of corners, each to twice the digits of a double, with weights that are powers of two: inside of what has an
/// area, also if that is only some units of the last place wide.
ExactPoint fine_middle(const ConvexRing& corners) {
  Dyadic x, y;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ExactPoint& p = corners[i];
    x = x + fine_quotient(p.x, p.w);
    y = y + fine_quotient(p.y, p.w);
    if (i == 0) continue;
    x = x.halved();
    y = y.halved();
  }
  return ExactPoint::of(x, y);
}

/// The point by binary numbers, if its coordinates are doubles or have no weight.
std::optional<ExactPoint> without_weight(const ExactPoint& p) {
  if (p.w == Dyadic(1, 0)) return p;
  const Dyadic x = Dyadic::exact(p.near.x), y = Dyadic::exact(p.near.y);
  if (!(x * p.w == p.x) || !(y * p.w == p.y)) return std::nullopt;
  return ExactPoint::of(x, y);
}

}  // namespace

ConvexRing left_of(const ConvexRing& ring, const ExactPoint& a, const ExactPoint& b, bool flat) {
  ConvexRing kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const ExactPoint &p = ring[i], &q = ring[(i + 1) % ring.size()];
    const int at_p = turn_sign(a, b, p), at_q = turn_sign(a, b, q);
    if (at_p >= 0) kept.push_back(p);
    if (at_p * at_q >= 0) continue;
    if (auto meeting = line_meeting(a, b, p, q)) kept.push_back(std::move(*meeting));
  }
  kept = without_repeated(kept);
  ConvexRing ends = kept.size() > 2 ? ends_of(kept) : kept;
  if (ends.empty()) return kept;
  return flat ? ends : ConvexRing();
}

ExactPoint middle_of(const ConvexRing& ring) {
  if (ring.size() < 3) return ring[0];
  ExactPoint rounded = rounded_middle(ring);
  return is_inside(ring, rounded) ? rounded : fine_middle(ring);
}

std::optional<ExactPoint> common_point(const ConvexRing& a, const ConvexRing& b, bool touching) {
  const std::vector<ExactPoint> corners = common_corners(a, b);
  if (corners.empty()) return std::nullopt;
  if (a.size() > 2 && b.size() > 2) {
    for (const auto middle_by : {rounded_middle, fine_middle}) {
      const ExactPoint middle = middle_by(corners);
      if (is_inside(a, middle) && is_inside(b, middle)) return middle;
    }
  }
  if (!touching) return std::nullopt;
  for (const ExactPoint& p : corners) {
    if (auto exact = without_weight(p)) return exact;
  }
  return std::nullopt;
}

}  // namespace taut::internal::path
