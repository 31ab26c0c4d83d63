#include "path/convex_overlap.hpp"

namespace taut::internal::path {
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
