// The verifier's own planar map: half-edges with the sign of the corner that each enters.
#pragma once

#include <vector>

#include "proof/bytes.hpp"
#include "proof/format.hpp"
#include "scene/placement.hpp"

namespace taut::internal::proof {

/// Half-edges 2k and 2k+1 are twins; edge i < n is the edge of a body from vertex i to the next, 2i with the body on
/// its left. `sign` is that of the corner from this half-edge to the next one: 1 if it is less than a straight angle.
struct Halfedge {
  VertexId origin;
  HalfedgeId next, previous;
  std::int8_t sign = 0;
};

/// The half-edges around a corner u, v, w of a face at an event: what there is before, and what has changed after.
struct Change {
  std::array<HalfedgeId, 6> corners{};  ///< each enters a corner that ends, or has begun
  int count = 0;
  void add(HalfedgeId h) { corners[static_cast<std::size_t>(count++)] = h; }
};

class ProofMap {
 public:
  /// Reads the tiling at the start and checks it all: links, the bodies' edges, angles around every vertex, three
  /// convex corners in every face (one in the infinite one), and that boundaries turn around once. Throws ProofError.
  ProofMap(ByteReader& in, const Placement& placement);

  static HalfedgeId twin(HalfedgeId h) { return HalfedgeId(h.value ^ 1u); }
  std::uint32_t size() const { return static_cast<std::uint32_t>(halfedges_.size()); }
  bool alive(HalfedgeId h) const { return h.value < size() && halfedges_[h.value].origin.valid(); }
  bool is_body_edge(HalfedgeId h) const { return h.value < 2 * vertices_; }
  bool is_inside(HalfedgeId h) const { return is_body_edge(h) && (h.value & 1u) == 0; }
  VertexId origin(HalfedgeId h) const { return halfedges_[h.value].origin; }
  VertexId target(HalfedgeId h) const { return halfedges_[h.value ^ 1u].origin; }
  HalfedgeId next(HalfedgeId h) const { return halfedges_[h.value].next; }
  HalfedgeId previous(HalfedgeId h) const { return halfedges_[h.value].previous; }
  int sign(HalfedgeId h) const { return halfedges_[h.value].sign; }

  /// The corners that end if the corner entered by h fails and the edge that `kind` says goes.
  Change ending(HalfedgeId h, Record kind) const;
  /// Makes the change: across the corner (u, v, w) entered by h comes an edge u w, unless the face is that triangle.
  /// At that instant u, v, w are on one line. If the corner was reflex, v is between; if not, the edge that goes leads
  /// to the farther of u and w. Throws ProofError where the angles would not add up, or a face would not have its
  /// number of convex corners. Returns the corners that begin.
  Change apply(HalfedgeId h, Record kind);

 private:
  void read(ByteReader& in);
  void check_links() const;
  void measure(const Placement& placement);
  void check_angles(HalfedgeId out, const Placement& placement) const;
  void check_faces(const Placement& placement) const;
  int turns(HalfedgeId h, const Placement& placement, std::vector<bool>& seen, int& convex) const;
  HalfedgeId new_edge(VertexId from, VertexId to);
  void drop_edge(HalfedgeId h);
  void link(HalfedgeId a, HalfedgeId b) {
    halfedges_[a.value].next = b;
    halfedges_[b.value].previous = a;
  }
  std::int8_t& sign_of(HalfedgeId h) { return halfedges_[h.value].sign; }
  Change open_triangle(HalfedgeId uv, HalfedgeId vw);
  Change replace_first(HalfedgeId uv, HalfedgeId vw);
  Change replace_second(HalfedgeId uv, HalfedgeId vw);

  std::uint32_t vertices_;
  std::vector<Halfedge> halfedges_;
  std::vector<HalfedgeId> free_;
};

}  // namespace taut::internal::proof
