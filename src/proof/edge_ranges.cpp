#include "proof/edge_ranges.hpp"

#include <algorithm>
#include <cmath>

namespace taut::internal::proof {
namespace {

/// What rounding adds to a projection, relative to the coordinates, with what makes the directions unit vectors.
constexpr double projection_rounding = 0x1p-46;

/// Grows around points, along a direction and across it.
class RectangleAround {
 public:
  explicit RectangleAround(Vector along) : along_(along) {}

  void add(Vector p) {
    const double s = dot(along_, p), t = dot(turned(along_), p);
    lo_ = {std::fmin(lo_.x, s), std::fmin(lo_.y, t)};
    hi_ = {std::fmax(hi_.x, s), std::fmax(hi_.y, t)};
    largest_ = std::fmax(largest_, l1_norm(p));
  }
  bool is_wide() const { return hi_.x - lo_.x >= hi_.y - lo_.y; }
  EdgeRange range() const {
    const double room = projection_rounding * largest_ + displacement_room;
    EdgeRange r;
    r.along = along_;
    r.half_length = (hi_.x - lo_.x) / 2 + room;
    r.half_width = (hi_.y - lo_.y) / 2 + room;
    r.centre = along_ * Vector{lo_.x + (hi_.x - lo_.x) / 2, lo_.y + (hi_.y - lo_.y) / 2};
    return r;
  }

 private:
  Vector along_, lo_{INFINITY, INFINITY}, hi_{-INFINITY, -INFINITY};
  double largest_ = 0;
};

Vector at(const DisplacedPoint& p) { return {p.x, p.y}; }

/// From one point to another; along the first axis where they are one.
Vector direction(Vector from, Vector to) {
  const Vector d = to - from;
  const double length = std::sqrt(dot(d, d));
  return length > 0 ? Vector{d.x / length, d.y / length} : Vector{1, 0};
}

/// Twice the middle of the ring's box, along one axis.
double middle(const DisplacedPolygon& body, const RingSpan& ring, bool along_x) {
  double lo = INFINITY, hi = -INFINITY;
  for (std::uint32_t i = ring.first; i < ring.first + ring.count; ++i) {
    const double c = along_x ? body.points[i].x : body.points[i].y;
    lo = std::min(lo, c);
    hi = std::max(hi, c);
  }
  return lo + hi;
}

}  // namespace

EdgeRanges::EdgeRanges(const DisplacedPolygon& body) {
  ranges_.reserve(2 * body.points.size());
  std::vector<RingSpan> rings = body.rings;
  if (rings.empty()) rings.push_back({0, static_cast<std::uint32_t>(body.points.size()), false});
  add_rings(body, rings);
}

std::uint32_t EdgeRanges::add_rings(const DisplacedPolygon& body, std::span<RingSpan> rings) {
  if (rings.size() == 1) return add_run(body, rings[0], 0, rings[0].count);
  RectangleAround box(Vector{1, 0});
  std::uint32_t count = 0;
  for (const RingSpan& ring : rings) {
    for (std::uint32_t i = 0; i < ring.count; ++i) box.add(at(body.points[ring.first + i]));
    count += ring.count;
  }
  const auto index = static_cast<std::uint32_t>(ranges_.size());
  ranges_.push_back(box.range());
  ranges_[index].count = count;
  const bool along_x = box.is_wide();
  std::vector<std::pair<double, RingSpan>> order;
  for (const RingSpan& ring : rings) order.emplace_back(middle(body, ring, along_x), ring);
  std::sort(order.begin(), order.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : a.second.first < b.second.first;
  });
  for (std::size_t i = 0; i < rings.size(); ++i) rings[i] = order[i].second;
  const std::size_t half = rings.size() / 2;
  const std::uint32_t left = add_rings(body, rings.first(half)), right = add_rings(body, rings.subspan(half));
  ranges_[index].halves[0] = left;
  ranges_[index].halves[1] = right;
  return index;
}

std::uint32_t EdgeRanges::add_run(const DisplacedPolygon& body, const RingSpan& ring, std::uint32_t first,
                                  std::uint32_t count) {
  const auto point = [&](std::uint32_t k) { return at(body.points[ring.first + k % ring.count]); };
  RectangleAround box(direction(point(first), point(first + count)));
  for (std::uint32_t k = first; k <= first + count; ++k) box.add(point(k));
  const auto index = static_cast<std::uint32_t>(ranges_.size());
  ranges_.push_back(box.range());
  ranges_[index].first = ring.first + first;
  ranges_[index].count = count;
  if (count > 1) {
    const std::uint32_t half = count / 2, left = add_run(body, ring, first, half),
                        right = add_run(body, ring, first + half, count - half);
    ranges_[index].halves[0] = left;
    ranges_[index].halves[1] = right;
  }
  return index;
}

EdgeSlabs::EdgeSlabs(const Polygon& polygon) : polygon_(polygon) {
  double highest = -INFINITY;
  lowest_ = INFINITY;
  for (const Point& p : polygon_) {
    lowest_ = std::min(lowest_, p.y);
    highest = std::max(highest, p.y);
  }
  // Long edges are in many slabs: fewer of these, then.
  for (count_ = 1 + polygon_.size() / 2;; count_ /= 2) {
    scale_ = highest > lowest_ ? static_cast<double>(count_) / (highest - lowest_) : 0;
    if (!std::isfinite(scale_)) scale_ = 0;
    if (count_ == 1 || listed() <= 8 * polygon_.size()) break;
  }
  slabs_.resize(count_);
  for (std::uint32_t e = 0; e < polygon_.size(); ++e) {
    const std::size_t last = slab_of(std::max(begin(e).y, end(e).y));
    for (std::size_t s = slab_of(std::min(begin(e).y, end(e).y)); s <= last; ++s) slabs_[s].push_back(e);
  }
}

std::size_t EdgeSlabs::listed() const {
  std::size_t sum = 0;
  for (std::size_t e = 0; e < polygon_.size(); ++e)
    sum += slab_of(std::max(begin(e).y, end(e).y)) - slab_of(std::min(begin(e).y, end(e).y)) + 1;
  return sum;
}

std::optional<int> passage(const CurvePoint& a, const CurvePoint& b, const CurvePoint& z) {
  const CertainSign below = order_of(a.y, z.y), above = order_of(b.y, z.y);
  if (!below || !above) return std::nullopt;
  const bool up = *below <= 0 && *above > 0, down = *below > 0 && *above <= 0;
  if (!up && !down) return 0;
  const CertainSign side = side_of(a, b, z);
  if (!side || *side == 0) return std::nullopt;
  return up ? (*side > 0 ? 1 : 0) : (*side < 0 ? -1 : 0);
}

std::optional<bool> EdgeSlabs::contains(const CurvePoint& z) const {
  const Extent y = extent_of(&z, 1, [](const CurvePoint& p) -> const CurveNumber& { return p.y; });
  const std::size_t slab = slab_of(y.lo);
  if (slab != slab_of(y.hi)) return std::nullopt;
  bool odd = false;
  for (const std::uint32_t e : slabs_[slab]) {
    if (std::max(begin(e).y, end(e).y) < y.lo || std::min(begin(e).y, end(e).y) > y.hi) continue;
    const std::optional<int> passed = passage(CurvePoint::of(begin(e)), CurvePoint::of(end(e)), z);
    if (!passed) return std::nullopt;
    if (*passed != 0) odd = !odd;
  }
  return odd;
}

}  // namespace taut::internal::proof
