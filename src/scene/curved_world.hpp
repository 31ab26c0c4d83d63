// A scene with curves, between two scenes of polygons.
#pragma once

#include <string>
#include <vector>

#include "geometry/band.hpp"
#include "taut/check.hpp"
#include "taut/scene.hpp"

namespace taut::internal {

/// Is any body bounded by curves?
bool has_curves(const Scene& scene);

/// As validate_polygons(), of bodies with curves as well.
void validate_curved_world(const Scene& scene);

/// The bands of all curves of a scene, refined where somebody asks for it. Whatever bodies within do, the bodies do,
/// and whatever the bodies do, those around them do.
class CurvedWorld {
 public:
  /// Throws InputError where a body has polygons besides its curves, or a curve is not valid. The polygons are not
  /// validated, nor are motions.
  explicit CurvedWorld(const Scene& scene);

  const Scene& scene() const { return scene_; }
  const std::vector<curve::BandedPart>& parts(BodyId body) const { return parts_[static_cast<std::size_t>(body)]; }
  /// The same scene of the polygons on that side.
  Scene polygons(CurveSide side) const;

  /// Halves to be made: by body, part, ring and cell.
  using Halvings = std::vector<std::vector<std::vector<std::vector<int>>>>;
  Halvings no_halvings() const;
  /// True if anything has become finer.
  bool refine(const Halvings& halvings);
  /// Halves what is thicker until nothing is. Throws InputError where doubles do not allow it.
  void refine_to(double tolerance);

  /// Names a feature of polygons() by its segment; returns how thick the cell is.
  double name_curve(CurveSide side, VertexRef& vertex) const;
  double name_curve(CurveSide side, EdgeRef& edge) const;
  /// Of both features of a contact; the tolerance at the thicker one.
  double name_curves(CurveSide side, Contact& contact) const;

  /// Of a vertex of polygons(): marks its cell and its neighbours.
  std::size_t mark_vertex(CurveSide side, const VertexRef& vertex, Halvings& marks) const;

  double tolerance() const;
  std::uint64_t segments() const;

 private:
  template <class Feature>
  double name(CurveSide side, Feature& feature, double within) const;

  Scene scene_;
  std::vector<std::vector<curve::BandedPart>> parts_;
};

}  // namespace taut::internal
