// The tiling as half-edges in flat arrays.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/ids.hpp"
#include "tiling/chain_tree.hpp"

namespace taut {

/// Half-edges 2k and 2k+1 are twins. Edge i < number of vertices is the polygon edge from vertex i to the next one of
/// its polygon: half-edge 2i runs counterclockwise with the polygon's inside on its left, 2i+1 has free space on its
/// left. A half-edge bears the label of the face on its left: the face's node, or for a polygon's inside the leaf of
/// the edge.
class PlanarMap {
 public:
  struct Halfedge {
    VertexId origin;
    HalfedgeId next, previous;
    NodeId node;
  };

  static HalfedgeId twin(HalfedgeId h) { return HalfedgeId(h.value ^ 1u); }

  /// Room for all edges that a tiling of this many vertices can ever have: E = 2V + 2 - r, r >= 0 (count convex
  /// corners, three for each pseudo-triangle and one for the infinite face; then Euler), and one more during a repair.
  void reset(std::uint32_t vertices) {
    vertices_ = vertices;
    halfedges_.clear();
    pinch_.clear();
    free_.clear();
    reserve();
    halfedges_.resize(2 * static_cast<std::size_t>(vertices));
    pinch_.resize(vertices, 0);
  }

  std::uint32_t vertices() const { return vertices_; }
  std::uint32_t halfedge_count() const { return static_cast<std::uint32_t>(halfedges_.size()); }
  bool alive(HalfedgeId h) const { return halfedges_[h.value].origin.valid(); }

  VertexId origin(HalfedgeId h) const { return halfedges_[h.value].origin; }
  VertexId target(HalfedgeId h) const { return halfedges_[h.value ^ 1u].origin; }
  HalfedgeId next(HalfedgeId h) const { return halfedges_[h.value].next; }
  HalfedgeId previous(HalfedgeId h) const { return halfedges_[h.value].previous; }
  NodeId node(HalfedgeId h) const { return halfedges_[h.value].node; }
  bool is_polygon_edge(HalfedgeId h) const { return h.value < 2 * vertices_; }
  bool is_interior(HalfedgeId h) const { return is_polygon_edge(h) && (h.value & 1u) == 0; }
  bool is_pinch(HalfedgeId h) const { return pinch_[h.value >> 1] != 0; }

  void set_origin(HalfedgeId h, VertexId v) { halfedges_[h.value].origin = v; }
  void set_node(HalfedgeId h, NodeId n) { halfedges_[h.value].node = n; }
  void set_pinch(HalfedgeId h, bool on) { pinch_[h.value >> 1] = on; }
  void link(HalfedgeId a, HalfedgeId b) {
    halfedges_[a.value].next = b;
    halfedges_[b.value].previous = a;
  }

  /// A new edge; the half-edge returned runs from `from` to `to`, its twin back.
  HalfedgeId add_edge(VertexId from, VertexId to) {
    HalfedgeId h;
    if (!free_.empty()) {
      h = free_.back();
      free_.pop_back();
    } else {
      h = HalfedgeId(halfedges_.size());
      halfedges_.resize(halfedges_.size() + 2);
      pinch_.push_back(0);
    }
    halfedges_[h.value] = {from, {}, {}, node::none};
    halfedges_[h.value ^ 1u] = {to, {}, {}, node::none};
    pinch_[h.value >> 1] = 0;
    return h;
  }
  void remove_edge(HalfedgeId h) {
    const HalfedgeId even(h.value & ~1u);
    halfedges_[even.value] = {};
    halfedges_[even.value ^ 1u] = {};
    pinch_[even.value >> 1] = 0;
    free_.push_back(even);
  }
  /// Two records of one edge, seen from its two sides, become one: `a` keeps its side, and what `b` says of the other
  /// side goes to a's twin. A polygon's own half-edge keeps its number. Returns the half-edge that stands for `a`.
  HalfedgeId merge(HalfedgeId a, HalfedgeId b) {
    if (is_polygon_edge(b)) {
      merge_into(b, a);
      return twin(b);
    }
    merge_into(a, b);
    return a;
  }
  /// A copy without unused edges, which are numbered anew; so are `handles`.
  PlanarMap compact(std::vector<HalfedgeId>& handles) const;
  /// The maps of two bodies beside each other, with the vertices, and the polygons' edges, of the first before those of
  /// the second. Both must be compact.
  static PlanarMap joined(const PlanarMap& first, const PlanarMap& second);
  /// The number that a half-edge of one of them has in the joined map.
  struct Renumbering {
    std::uint32_t polygon_end;           ///< in its own map: the half-edges before are the polygon's
    std::uint32_t polygon_shift, shift;  ///< for the polygon's, and for the others
    HalfedgeId operator()(HalfedgeId h) const {
      return HalfedgeId(h.valid() ? h.value + (h.value < polygon_end ? polygon_shift : shift) : h.value);
    }
  };
  static Renumbering first_in_joined(const PlanarMap& first, const PlanarMap& second) {
    return {2 * first.vertices(), 0, 2 * second.vertices()};
  }
  static Renumbering second_in_joined(const PlanarMap& first, const PlanarMap& second) {
    return {2 * second.vertices(), 2 * first.vertices(), first.halfedge_count()};
  }

  /// Edges that are not in use, by their even half-edges; the last one is used next.
  const std::vector<HalfedgeId>& unused() const { return free_; }
  /// Bytes held.
  std::size_t bytes() const {
    return halfedges_.capacity() * sizeof(Halfedge) + pinch_.capacity() + free_.capacity() * sizeof(HalfedgeId);
  }

 private:
  void reserve() {
    halfedges_.reserve(4 * static_cast<std::size_t>(vertices_) + 16);
    pinch_.reserve(2 * static_cast<std::size_t>(vertices_) + 8);
    free_.reserve(64);
  }
  void append_part(const PlanarMap& part, std::uint32_t begin, std::uint32_t end, const Renumbering& number,
                   std::uint32_t vertex_shift);
  void merge_into(HalfedgeId keep, HalfedgeId drop) {
    const HalfedgeId side = twin(keep);
    Halfedge& record = halfedges_[side.value];
    record = halfedges_[drop.value];
    if (record.next.valid()) halfedges_[record.next.value].previous = side;
    if (record.previous.valid()) halfedges_[record.previous.value].next = side;
    remove_edge(drop);
  }

  std::uint32_t vertices_ = 0;
  std::vector<Halfedge> halfedges_;
  std::vector<std::uint8_t> pinch_;
  std::vector<HalfedgeId> free_;
};

}  // namespace taut
