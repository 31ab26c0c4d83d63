// The tiling as half-edges in flat arrays.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/ids.hpp"
#include "tiling/block_array.hpp"
#include "tiling/chain_tree.hpp"

namespace taut::internal {

/// Half-edges 2k and 2k+1 are twins. Edge i < number of vertices is the polygon edge from vertex i to the next one of
/// its polygon: half-edge 2i runs counterclockwise with the polygon's inside on its left, 2i+1 has free space on its
/// left. A half-edge bears the label of the face on its left: the face's node, or for a polygon's inside the leaf of
/// the edge.
///
/// The joined map of two bodies is not copied from theirs: it reads them, and has a record of its own where something
/// has been changed.
class PlanarMap {
 public:
  struct Halfedge {
    VertexId origin;
    HalfedgeId next, previous;
    ChainNode node;
  };

  static HalfedgeId twin(HalfedgeId h) { return HalfedgeId(h.value ^ 1u); }

  /// Room for all edges that a tiling of this many vertices can ever have: E = 2V + 2 - r, r >= 0 (count convex
  /// corners, three for each pseudo-triangle and one for the infinite face; then Euler), and one more during a repair.
  void reset(std::uint32_t vertices) {
    *this = PlanarMap();
    vertices_ = vertices;
    reserve(4 * static_cast<std::size_t>(vertices) + 16);
    count_ = 2 * vertices;
    for (std::uint32_t i = 0; i < count_; i += block) own(HalfedgeId(i));
  }

  std::uint32_t vertices() const { return vertices_; }
  std::uint32_t halfedge_count() const { return count_; }
  bool alive(HalfedgeId h) const { return origin(h).valid(); }

  VertexId origin(HalfedgeId h) const {
    return halfedges_.has(h.value) ? halfedges_[h.value].origin : part_origin(h.value);
  }
  VertexId target(HalfedgeId h) const { return origin(twin(h)); }
  HalfedgeId next(HalfedgeId h) const { return record(h).next; }
  HalfedgeId previous(HalfedgeId h) const { return record(h).previous; }
  ChainNode node(HalfedgeId h) const { return record(h).node; }
  /// All of them at once.
  Halfedge record(HalfedgeId h) const { return halfedges_.has(h.value) ? halfedges_[h.value] : part_record(h.value); }
  bool is_polygon_edge(HalfedgeId h) const { return h.value < 2 * vertices_; }
  bool is_interior(HalfedgeId h) const { return is_polygon_edge(h) && (h.value & 1u) == 0; }
  bool is_pinch(HalfedgeId h) const { return pinch_[h.value >> 1]; }

  void set_origin(HalfedgeId h, VertexId v) { own(h).origin = v; }
  void set_node(HalfedgeId h, ChainNode n) { own(h).node = n; }
  void set_pinch(HalfedgeId h, bool on) { pinch_[h.value >> 1] = on; }
  void link(HalfedgeId a, HalfedgeId b) {
    own(a).next = b;
    own(b).previous = a;
  }

  /// A new edge; the half-edge returned runs from `from` to `to`, its twin back.
  HalfedgeId add_edge(VertexId from, VertexId to) {
    HalfedgeId h;
    if (!free_.empty()) {
      h = free_.back();
      free_.pop_back();
    } else {
      h = HalfedgeId(count_);
      count_ += 2;
      if (count_ > halfedges_.capacity()) reserve(count_);
    }
    own(h) = {from, {}, {}, node::none};
    own(twin(h)) = {to, {}, {}, node::none};
    set_pinch(h, false);
    return h;
  }
  void remove_edge(HalfedgeId h) {
    const HalfedgeId even(h.value & ~1u);
    own(even) = {};
    own(twin(even)) = {};
    set_pinch(h, false);
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
  /// The maps of two bodies in one, with the vertices, and the polygons' edges, of the first before those of
  /// the second. Both must be compact, must not change, and must live as long as the joined map and its copies.
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

  /// Calls visit(h, from, to) for the half-edges 2k of some edges, in order: all that were added since the map was
  /// reset or joined, and others.
  template <class Visit>
  void for_each_changed_edge(const Visit& visit) const {
    halfedges_.for_each_block([&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < std::min<std::size_t>(end, count_); i += 2) {
        const VertexId from = halfedges_[i].origin;
        if (from.valid()) visit(HalfedgeId(i), from, halfedges_[i + 1].origin);
      }
    });
  }

  /// Edges that are not in use, by their even half-edges; the last one is used next.
  const std::vector<HalfedgeId>& unused() const { return free_; }
  /// Bytes held.
  std::size_t bytes() const {
    return halfedges_.bytes() + pinch_.capacity() / 8 + free_.capacity() * sizeof(HalfedgeId);
  }

 private:
  static constexpr std::uint32_t block = BlockArray<Halfedge>::block_size;

  /// Half-edges of a joined map, up to `end`, that are read in the map of one of its parts where this one has no record
  /// of its own: half-edge i there in number i - shift.
  struct Part {
    std::uint32_t end = 0, shift = 0;
    const PlanarMap* map = nullptr;
    Renumbering number{};
    std::uint32_t first_vertex = 0;

    VertexId origin(std::uint32_t i) const { return VertexId(map->halfedges_[i - shift].origin.value + first_vertex); }
    Halfedge record(std::uint32_t i) const {
      const Halfedge& h = map->halfedges_[i - shift];
      return {VertexId(h.origin.value + first_vertex), number(h.next), number(h.previous), h.node};
    }
  };
  /// Where half-edge i of a joined map was.
  const Part& part_of(std::uint32_t i) const {
    return parts_[(i >= parts_[0].end) + (i >= parts_[1].end) + (i >= parts_[2].end)];
  }
  VertexId part_origin(std::uint32_t i) const { return part_of(i).origin(i); }
  Halfedge part_record(std::uint32_t i) const { return part_of(i).record(i); }
  void read_parts(std::uint32_t first, Halfedge* block) const;

  void reserve(std::size_t halfedges) {
    halfedges_.grow(halfedges);
    pinch_.resize(halfedges_.capacity() / 2);
    free_.reserve(std::min<std::size_t>(64, halfedges / 8));
  }
  Halfedge& own(HalfedgeId h) {
    return halfedges_.touch(h.value, [this](std::size_t first, Halfedge* records) {
      read_parts(static_cast<std::uint32_t>(first), records);
    });
  }
  void merge_into(HalfedgeId keep, HalfedgeId drop) {
    const HalfedgeId side = twin(keep);
    const Halfedge moved = record(drop);
    own(side) = moved;
    if (moved.next.valid()) own(moved.next).previous = side;
    if (moved.previous.valid()) own(moved.previous).next = side;
    remove_edge(drop);
  }

  std::uint32_t vertices_ = 0;
  std::uint32_t count_ = 0;  ///< half-edges, in use or not
  BlockArray<Halfedge> halfedges_;
  std::vector<bool> pinch_;  ///< by edge
  std::vector<HalfedgeId> free_;
  std::array<Part, 4> parts_;  ///< of a joined map: the two polygons, and the other edges of the two maps
};

// What must hold of every tiling: used by tests and audits.

class Placement;

/// Checks that links are consistent, every free face is a pseudo-triangle (three convex corners; the infinite face has
/// one), no node has two faces, angles close up around every vertex, and Euler's formula holds. Returns what is wrong,
/// or an empty string.
std::string find_fault(const PlanarMap& map, const Placement& placement);

/// A map in a form that can be compared: one entry per half-edge, sorted.
struct CanonicalHalfedge {
  std::uint32_t from, to, then, node, pinch;
  friend bool operator==(const CanonicalHalfedge& a, const CanonicalHalfedge& b) {
    return a.from == b.from && a.to == b.to && a.then == b.then && a.node == b.node && a.pinch == b.pinch;
  }
  friend bool operator<(const CanonicalHalfedge& a, const CanonicalHalfedge& b) {
    if (a.from != b.from) return a.from < b.from;
    if (a.to != b.to) return a.to < b.to;
    return a.then < b.then;
  }
};
std::vector<CanonicalHalfedge> canonical(const PlanarMap& map);

/// The first differences between two maps, in words; empty if they are equal, labels and pinch edges included.
std::string difference(const PlanarMap& a, const PlanarMap& b);

}  // namespace taut::internal
