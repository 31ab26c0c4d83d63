// A scene with curves, and polygons that stand for them.
#pragma once

#include "proof/ring_side.hpp"
#include "taut/feature.hpp"
#include "taut/scene.hpp"

namespace taut::internal::proof {

/// Is any body bounded by curves?
bool any_curves(const Scene& scene);

/// Of each body, its parts as polygons; none of bodies that are polygons already.
using PolygonsOfBodies = std::vector<std::vector<Part>>;

/// The scene in which these take the place of the curves.
Scene with_polygons(const Scene& scene, const PolygonsOfBodies& polygons);

/// What the polygons of a scene are to the bodies: in them, or around them.
enum class Bodies { around, within };

/// The curves of a scene, in pieces, and what is proved about polygons that stand for them.
class CurvedBodies {
 public:
  /// Throws InputError unless all but the curves' not meeting themselves is as a scene must be: no proof needs that.
  explicit CurvedBodies(const Scene& scene);

  /// Throws ProofError unless every polygon has as many rings as the body, and lies as it must: around outlines and
  /// within holes if the polygons are to be around the bodies, else the reverse.
  void require(const PolygonsOfBodies& polygons, Bodies side);

  /// Names a vertex, or an edge, of polygons that were required last: by the segment of the curve that is nearest.
  void name(VertexRef& vertex) const;
  void name(EdgeRef& edge) const;

 private:
  struct Ring {
    std::string name;
    std::vector<CurvePiece> pieces;
    std::vector<NamedChord> chords;
    Polygon polygon;
  };
  using Rings = std::vector<Ring>;  ///< of a part, its outline first

  void require_part(Rings& rings, const Part& part, Bodies side) const;
  template <class Feature>
  void name(Feature& feature, double share) const;
  void validate(const Scene& scene) const;

  std::vector<std::vector<Rings>> bodies_;
};

}  // namespace taut::internal::proof
