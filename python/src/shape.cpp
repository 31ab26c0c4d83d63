#include "shape.hpp"

#include <utility>

namespace taut_python {

void Shape::put_into(taut::Body& body) const {
  body.polygon.clear();
  body.prepared = prepared;
  if (prepared) {
    body.parts.clear();
  } else {
    body.parts = parts;
  }
}

Shape make_shape(std::vector<taut::Part> parts, const std::string& name) {
  Shape shape{std::move(parts), nullptr};
  if (shape.parts.size() == 1 && shape.parts[0].holes.empty()) {
    shape.prepared = taut::prepare(shape.parts[0].outline, name);
    return shape;
  }
  // The rings and how they lie: what a scene of this body alone would be asked.
  taut::Scene alone;
  alone.bodies.push_back({name, {}, {}});
  alone.bodies[0].parts = shape.parts;
  taut::validate(alone);
  return shape;
}

void prepare_bodies(taut::Scene& scene) {
  for (taut::Body& body : scene.bodies) {
    if (!body.parts.empty() || body.prepared) continue;
    body.prepared = taut::prepare(body.polygon, body.name);
    body.polygon.clear();
  }
}

}  // namespace taut_python
