// Curves that separate the two bodies at one instant (sections 1 and 2.2 of the paper).
#pragma once

#include <array>
#include <vector>

#include "taut/feature.hpp"
#include "taut/scene.hpp"

namespace taut {

/// The separator that the tiling maintains: the boundary between the two relative convex hulls.
struct MovingSeparator {
  /// The relative convex hull of either body (by position in Scene::bodies), counterclockwise: the shortest loop around
  /// it that does not cross the other body. A vertex may come twice, where the loop touches itself.
  std::array<std::vector<VertexRef>, 2> hulls;
  /// The path that the two hulls share, in the order of the larger body's; empty if they are apart. It may be one
  /// vertex.
  std::vector<VertexRef> contact;
  /// Edges between the bodies (PQ edges) on either hull, and on the path that they share. By Lemma 2.4 of the paper the
  /// first two are at most twice the number of edges of any separator.
  std::array<int, 2> bichromatic_edges{};
  int bichromatic_contact_edges = 0;
};

/// A polygonal curve that separates the bodies, with about as few edges (links) as there can be.
struct MinimumLinkSeparator {
  /// No separator has fewer than `lower` edges; the curve below has `upper`. Both are certain.
  int lower = 0, upper = 0;
  /// A closed curve around one of the bodies; else its first and last edges go on to infinity, beyond the first and the
  /// last vertex.
  bool closed = false;
  /// World coordinates. Checked in exact arithmetic: no edge meets the inside of a body, and every path from one body
  /// to the other crosses the curve.
  std::vector<Point> vertices;
};

/// The separators of two polygons at rest.
struct Separator {
  /// The polygons overlap: there is no separator, and all else is empty.
  bool overlap = false;
  MovingSeparator moving;
  MinimumLinkSeparator minimum_link;
};

/// Separators of two simple polygons (either orientation) that may touch. The bounds satisfy upper <= lower + 1 if some
/// curve with the fewest edges has room on both its sides, about 2^-40 of the polygons' size. Where there is none (the
/// polygons touch, or corners of both lie on one line that only just passes between them), `lower` and the curve are as
/// certain, but the curve may have more edges; in the worst case it is one of the relative convex hulls. Throws
/// InputError if a polygon is not simple.
Separator separator(const Polygon& p, const Polygon& q);

/// Separators of a scene's bodies at time t (within the scene's interval). The bodies are taken where they are at t
/// with their vertices rounded to doubles, which is exact for a body at rest that has no motion; what is certain is
/// certain of these polygons. Throws InputError if the scene is not valid.
Separator separator(const Scene& scene, double t);

/// The two polygons that the other function speaks of. The scene must be valid, and t within its interval.
std::array<Polygon, 2> placed(const Scene& scene, double t);

}  // namespace taut
