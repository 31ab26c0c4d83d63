#include "path/convex_overlap.hpp"

#include <algorithm>

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

}  // namespace

ConvexRing left_of(const ConvexRing& ring, const ExactPoint& a, const ExactPoint& b) {
  ConvexRing kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const ExactPoint &p = ring[i], &q = ring[(i + 1) % ring.size()];
    const int at_p = turn_sign(a, b, p), at_q = turn_sign(a, b, q);
    if (at_p >= 0) kept.push_back(p);
    if (at_p * at_q >= 0) continue;
    if (auto meeting = line_meeting(a, b, p, q)) kept.push_back(std::move(*meeting));
  }
  kept = without_repeated(kept);
  const bool has_area = kept.size() > 2 && is_inside(kept, rounded_middle(kept));
  return has_area ? kept : ConvexRing();
}

std::optional<ExactPoint> common_point(const ConvexRing& a, const ConvexRing& b, bool touching) {
  const std::vector<ExactPoint> corners = common_corners(a, b);
  if (corners.empty()) return std::nullopt;
  ExactPoint middle = rounded_middle(corners);
  if (is_inside(a, middle) && is_inside(b, middle)) return middle;
  if (!touching) return std::nullopt;
  const Dyadic one(1, 0);
  const auto found = std::find_if(corners.begin(), corners.end(), [&](const ExactPoint& p) { return p.w == one; });
  if (found == corners.end()) return std::nullopt;
  return *found;
}

}  // namespace taut::internal::path
