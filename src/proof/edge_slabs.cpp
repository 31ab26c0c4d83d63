#include "proof/edge_slabs.hpp"

namespace taut::internal::proof {

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
