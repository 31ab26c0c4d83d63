// A planar map as half-edges: the edges of bodies, and those of a tiling of the space between them.
#pragma once

#include <vector>

#include "comparison/moving_bodies.hpp"

namespace taut::paper {

/// Half-edges 2k and 2k + 1 are the two directions of one edge. Those of bodies come first: half-edge 2v goes from
/// vertex v to the next one of its body, with the body on its left.
class HalfEdges {
 public:
  /// The map whose edges at each vertex are given by their other ends, counterclockwise, from the previous vertex of
  /// the body through the free space to the next one.
  HalfEdges(const MovingBodies& bodies, const std::vector<std::vector<int>>& around);

  int size() const { return static_cast<int>(origin_.size()); }
  static int twin(int h) { return h ^ 1; }
  int origin(int h) const { return origin_[static_cast<std::size_t>(h)]; }
  int target(int h) const { return origin(twin(h)); }
  int next(int h) const { return next_[static_cast<std::size_t>(h)]; }
  int previous(int h) const { return previous_[static_cast<std::size_t>(h)]; }
  /// An edge of a body.
  bool is_side(int h) const { return h < sides_; }
  /// On its left is the inside of a body.
  bool is_inside(int h) const { return h < sides_ && h % 2 == 0; }
  int free_edges() const { return (size() - sides_) / 2; }
  /// The memory of the arrays.
  std::size_t bytes() const;

  /// With h from v to w and the half-edge before it from u to v: the edge uv becomes uw, so that the face on the left
  /// of h loses v, and the face beyond uv gains w. uv is a free edge.
  void slide_previous(int h);
  /// The edge vw becomes uw, so that the face on the left of h loses v, and the face beyond vw gains u. vw is a free
  /// edge.
  void slide_this(int h);

 private:
  void join(int h, int after) {
    next_[static_cast<std::size_t>(h)] = after;
    previous_[static_cast<std::size_t>(after)] = h;
  }

  int sides_ = 0;
  std::vector<int> origin_, next_, previous_;
};

/// What is wrong with the map as a tiling of the free space by pseudo-triangles at these positions; empty if nothing
/// is. Orientations are exact, for the positions as doubles. Looked at: each face's corners, of which three are convex,
/// or none of the infinite face; the order of edges around each vertex; Euler's formula; and, if `crossings`, every two
/// edges.
std::string find_fault(const HalfEdges& map, const MovingBodies& bodies, const std::vector<Point>& positions,
                       bool crossings);

}  // namespace taut::paper
