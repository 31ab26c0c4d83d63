// Polygons for the curves of a scene.
#include <utility>

#include "taut/outline.hpp"
#include "taut/scene.hpp"

namespace taut {
namespace {

void replace_curves(Body& body, CurveSide side, double tolerance) {
  if (body.curves.empty()) return;
  body.parts = flatten(std::exchange(body.curves, {}), side, tolerance, body.name);
  if (body.parts.size() > 1 || !body.parts[0].holes.empty() || body.parts[0].z) return;
  body.polygon = std::move(body.parts[0].outline);
  body.parts.clear();
}

}  // namespace

Scene flatten(const Scene& scene, CurveSide side, double tolerance) {
  Scene flat = scene;
  for (Body& body : flat.bodies) replace_curves(body, side, tolerance);
  return flat;
}

}  // namespace taut
