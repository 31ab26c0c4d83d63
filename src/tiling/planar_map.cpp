#include "tiling/planar_map.hpp"

namespace taut {

PlanarMap PlanarMap::compact(std::vector<HalfedgeId>& handles) const {
  std::vector<HalfedgeId> number(halfedges_.size());
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < halfedge_count(); ++i) {
    if (alive(HalfedgeId(i))) number[i] = HalfedgeId(count++);
  }
  const auto renumbered = [&number](HalfedgeId h) { return h.valid() ? number[h.value] : h; };
  PlanarMap result;
  result.vertices_ = vertices_;
  result.halfedges_.reserve(count);
  result.pinch_.reserve(count / 2);
  for (std::uint32_t i = 0; i < halfedge_count(); ++i) {
    if (!number[i].valid()) continue;
    const Halfedge& h = halfedges_[i];
    result.halfedges_.push_back({h.origin, renumbered(h.next), renumbered(h.previous), h.node});
    if (i % 2 == 0) result.pinch_.push_back(pinch_[i / 2]);
  }
  for (HalfedgeId& h : handles) h = renumbered(h);
  return result;
}

void PlanarMap::append_part(const PlanarMap& part, std::uint32_t begin, std::uint32_t end, const Renumbering& number,
                            std::uint32_t vertex_shift) {
  for (std::uint32_t i = begin; i < end; ++i) {
    const Halfedge& h = part.halfedges_[i];
    halfedges_.push_back({VertexId(h.origin.value + vertex_shift), number(h.next), number(h.previous), h.node});
  }
}

PlanarMap PlanarMap::joined(const PlanarMap& first, const PlanarMap& second) {
  PlanarMap result;
  result.vertices_ = first.vertices_ + second.vertices_;
  result.reserve();
  const Renumbering number_first = first_in_joined(first, second), number_second = second_in_joined(first, second);
  result.append_part(first, 0, 2 * first.vertices_, number_first, 0);
  result.append_part(second, 0, 2 * second.vertices_, number_second, first.vertices_);
  result.append_part(first, 2 * first.vertices_, first.halfedge_count(), number_first, 0);
  result.append_part(second, 2 * second.vertices_, second.halfedge_count(), number_second, first.vertices_);
  result.pinch_.resize(result.halfedges_.size() / 2, 0);
  return result;
}

}  // namespace taut
