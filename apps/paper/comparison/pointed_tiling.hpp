// A pointed pseudo-triangulation of the common exterior of any number of polygons, built from scratch.
#pragma once

#include <vector>

#include "comparison/moving_bodies.hpp"

namespace taut::paper {

/// For each vertex, the other ends of its edges, counterclockwise, from the previous vertex of its body through the
/// free space to the next one: what HalfEdges is made from. The bodies must be disjoint, and no three vertices in line.
///
/// Edges are added one by one, those that cross no other one and leave every vertex an angle of more than 180 degrees:
/// first the convex hull, then edges between vertices of one body, which need no certificates among themselves, then
/// edges between bodies, the shortest first. Where no edge can be added any more, all faces are pseudo-triangles, and
/// there are as few of them as there can be: 3 n - 3 free edges for n bodies, and one more for each reflex vertex.
std::vector<std::vector<int>> pointed_tiling(const MovingBodies& bodies, const std::vector<Point>& positions);

}  // namespace taut::paper
