// A tree of oriented boxes over the edges of one body, in its own frame.
#pragma once

#include <span>
#include <vector>

#include "scene/body_pair.hpp"
#include "scene/pair_geometry.hpp"
#include "spacetime/nested_discs.hpp"
#include "spacetime/stretch.hpp"

namespace taut::internal::spacetime {

/// A rectangle: all centre + s along + t turned(along) with |s| <= half_length and |t| <= half_width.
struct Box {
  Vector centre, along;  ///< along is a unit vector up to rounding
  double half_length = 0, half_width = 0;
  double radius = 0;  ///< of a disc around the centre that contains the box
};

/// A run of consecutive edges, or several rings. The box certainly contains all of them, as displaced.
struct BoxNode {
  Box box;
  std::uint32_t first = 0, count = 0;  ///< edges by their first vertices; several rings have no first one
  std::uint32_t left = 0, right = 0;   ///< children; unused where count is 1
};

/// Of two nodes that are not both single edges: is it the first one that is divided? The larger one is.
inline bool divides_first(const BoxNode& a, const BoxNode& b) {
  return b.count == 1 || (a.count > 1 && a.box.radius >= b.box.radius);
}

/// A balanced tree; the root is node 0.
class Hierarchy {
 public:
  /// Builds the tree over the edges of a polygon of displaced points.
  explicit Hierarchy(std::span<const DisplacedPoint> polygon);
  /// Builds the tree over all rings of a body.
  explicit Hierarchy(const DisplacedPolygon& body);
  const BoxNode& node(std::uint32_t i) const { return nodes_[i]; }
  std::size_t size() const { return nodes_.size(); }
  /// A disc that contains the body.
  const Disc& around() const { return around_; }
  /// The disc within the hole to whose ring the node's edges belong, if they do.
  const Disc* hollow(const BoxNode& node) const { return hollows_.empty() ? nullptr : hollow_with(node.first); }

 private:
  struct Hollow {
    std::uint32_t first, count;  ///< vertices of the hole's ring
    Disc disc;
  };
  static constexpr std::uint32_t no_first = 0xffffffff;
  const Disc* hollow_with(std::uint32_t edge) const;
  std::uint32_t build(std::span<const DisplacedPoint> ring, std::uint32_t offset, std::uint32_t first,
                      std::uint32_t count);
  std::uint32_t build(const DisplacedPolygon& body, std::span<RingSpan> rings);

  std::vector<BoxNode> nodes_;
  std::vector<Hollow> hollows_;
  Disc around_;
};

/// A bound of the distance of the body's points from its origin.
inline double reach_of(const Hierarchy& tree) {
  const Box& all = tree.node(0).box;
  return (l1_norm(all.centre) + all.radius) * (1 + 0x1p-40);
}

Hierarchy hierarchy_of_p(const PairGeometry& geometry);
Hierarchy hierarchy_of_q(const PairGeometry& geometry);

/// The trees of both bodies of a pair.
struct TreePair {
  const Hierarchy &p, &q;
};

/// Does one of the nodes belong to a hole that is wide enough for the other body?
inline bool may_be_nested(const TreePair& trees, const BoxNode& p, const BoxNode& q) {
  const Disc *of_p = trees.p.hollow(p), *of_q = trees.q.hollow(q);
  return (of_p && of_p->radius > trees.q.around().radius) || (of_q && of_q->radius > trees.p.around().radius);
}

/// The box of the edges first, ..., first + count - 1, aligned with the chord of the run.
Box box_of_run(std::span<const DisplacedPoint> polygon, std::uint32_t first, std::uint32_t count);

}  // namespace taut::internal::spacetime
