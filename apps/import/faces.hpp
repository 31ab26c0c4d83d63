// Which faces of a graph of lines are material.
#pragma once

#include <vector>

#include "geometry/subdivision.hpp"
#include "import/contours.hpp"
#include "import/drawing.hpp"
#include "import/line_graph.hpp"

namespace taut::drawing {
using namespace internal;

/// The faces of those edges of a graph that are alive.
struct FaceMap {
  FaceMap(const LineGraph& graph, const std::vector<bool>& alive);
  /// The edge of the graph that a half-edge of the map lies on.
  int edge(int h) const { return edges[static_cast<std::size_t>(h / 2)]; }

  std::vector<int> edges;
  Subdivision map;
};

/// Of each face 0, if it is empty, or the number of what it belongs to. Faces with one number are one piece where they
/// have an edge in common.
using FaceKeys = std::vector<int>;

/// Half-edges by the face on their left.
std::vector<std::vector<int>> boundaries_of(const Subdivision& map);

/// How contours go around a face.
struct Turns {
  int winding = 0;  ///< counterclockwise ones, less clockwise ones
  int times = 0;    ///< lines to cross on the way out
};

/// Of each face.
std::vector<Turns> turns_around(const LineGraph& graph, const FaceMap& faces);

/// Of each face, less the faces within it; rounded. That of the unbounded one, which is face 0, has no meaning.
std::vector<double> areas_of_faces(const FaceMap& faces);

/// A connected piece of material.
struct Region {
  Part part;                 ///< its rings are simple, and touch each other at vertices at most
  std::vector<int> outline;  ///< edges of the graph
  std::vector<int> holes;    ///< an edge of each hole
};

/// In the order of their outlines' least points.
std::vector<Region> regions_of(const FaceMap& faces, const FaceKeys& keys);

/// Twice the area of a ring, positive if it runs counterclockwise; rounded.
double doubled_area(const Polygon& ring);
/// Of the part, less its holes; rounded.
double area_of(const Part& part);

}  // namespace taut::drawing
