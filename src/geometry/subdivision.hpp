// The faces into which segments divide the plane.
#pragma once

#include <cstddef>
#include <vector>

#include "taut/geometry.hpp"

namespace taut::internal {

class SegmentStrips;

/// A segment between two nodes.
struct SubdivisionEdge {
  int from = 0, to = 0;
};

/// A plane straight-line graph as half-edges: edge e has the half-edges 2e, from `from` to `to`, and 2e + 1, its twin.
/// Edges must meet at common nodes only, and no two may join the same nodes: the caller has split and merged them. All
/// decisions are exact.
class Subdivision {
 public:
  Subdivision(std::vector<Point> nodes, std::vector<SubdivisionEdge> edges);

  int half_edges() const { return static_cast<int>(next_.size()); }
  const Point& point(int node) const { return nodes_[static_cast<std::size_t>(node)]; }
  int origin(int h) const { return h % 2 == 0 ? edge(h).from : edge(h).to; }
  int target(int h) const { return origin(h ^ 1); }
  /// The half-edge that follows along the boundary of the face on the left.
  int next(int h) const { return next_[static_cast<std::size_t>(h)]; }
  /// The face on the left. Face 0 is the unbounded one.
  int face(int h) const { return faces_[static_cast<std::size_t>(h)]; }
  int faces() const { return face_count_; }

 private:
  const SubdivisionEdge& edge(int h) const { return edges_[static_cast<std::size_t>(h / 2)]; }
  void link_around_nodes();
  std::vector<int> outer_walks() const;
  int left_of_component(const Point& p, const SegmentStrips& strips) const;
  void find_faces();

  std::vector<Point> nodes_;
  std::vector<SubdivisionEdge> edges_;
  std::vector<int> next_, faces_;
  int face_count_ = 1;
};

}  // namespace taut::internal
