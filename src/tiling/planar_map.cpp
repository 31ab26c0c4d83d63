#include "tiling/planar_map.hpp"

namespace taut::internal {

PlanarMap PlanarMap::compact(std::vector<HalfedgeId>& handles) const {
  std::vector<HalfedgeId> number(count_);
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < count_; ++i) {
    if (alive(HalfedgeId(i))) number[i] = HalfedgeId(count++);
  }
  const auto renumbered = [&number](HalfedgeId h) { return h.valid() ? number[h.value] : h; };
  PlanarMap result;
  result.vertices_ = vertices_;
  result.count_ = count;
  result.reserve(count);
  for (std::uint32_t i = 0; i < count_; ++i) {
    if (!number[i].valid()) continue;
    const Halfedge h = record(HalfedgeId(i));
    result.own(number[i]) = {h.origin, renumbered(h.next), renumbered(h.previous), h.node};
    result.set_pinch(number[i], is_pinch(HalfedgeId(i)));
  }
  for (HalfedgeId& h : handles) h = renumbered(h);
  return result;
}

PlanarMap PlanarMap::joined(const PlanarMap& first, const PlanarMap& second) {
  const Renumbering p = first_in_joined(first, second), q = second_in_joined(first, second);
  PlanarMap result;
  result.vertices_ = first.vertices_ + second.vertices_;
  result.count_ = first.count_ + second.count_;
  result.reserve(4 * static_cast<std::size_t>(result.vertices_) + 16);
  result.parts_ = {{{p.polygon_end, p.polygon_shift, &first, p, 0},
                    {2 * result.vertices_, q.polygon_shift, &second, q, first.vertices_},
                    {first.count_ + p.shift, p.shift, &first, p, 0},
                    {result.count_, q.shift, &second, q, first.vertices_}}};
  return result;
}

/// What the half-edges of a block were in the parts.
void PlanarMap::read_parts(std::uint32_t first, Halfedge* out) const {
  const std::uint32_t end = std::min(first + block, parts_[3].end);
  for (std::uint32_t i = first; i < end;) {
    const Part& part = part_of(i);
    for (const std::uint32_t stop = std::min(end, part.end); i < stop; ++i) out[i - first] = part.record(i);
  }
}

}  // namespace taut::internal
