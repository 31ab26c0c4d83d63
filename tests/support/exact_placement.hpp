// Do the interiors of two polygons intersect at one instant? From signs alone, contacts of every kind included.
//
// They do if and only if two edges cross in their interiors, or two open angles intersect at a point at which the
// boundaries meet (a straight angle within an edge), or one body lies in the other. For a component of the intersection
// is a polygon. A corner of it lies on both boundaries, which is the first or the second case, unless its boundary is
// all of one body's.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "support/exact_segment.hpp"
#include "taut/geometry.hpp"

namespace taut::testing::exact {

/// The signs of functions at one instant.
using Signs = std::function<int(const Function&)>;

/// Whether the polygons run counterclockwise, and where they bend.
class Shapes {
 public:
  explicit Shapes(const Scene& scene);
  int size(int body) const { return static_cast<int>(seconds_of_[static_cast<std::size_t>(body)].size()); }
  bool counterclockwise(int body) const { return counterclockwise_[static_cast<std::size_t>(body)]; }
  /// The orientation of the vertex and its neighbours, in counterclockwise order: 1 where it is convex.
  int second(int body, int vertex) const {
    return seconds_of_[static_cast<std::size_t>(body)][static_cast<std::size_t>(vertex)];
  }

 private:
  std::array<bool, 2> counterclockwise_{};
  std::array<std::vector<int>, 2> seconds_of_;
};

/// Is the vertex on the closed edge?
bool touching(const VertexEdge& pair, const Signs& signs);
bool interiors_intersect(const Shapes& shapes, const Signs& signs);

}  // namespace taut::testing::exact
