// Polygons for curves.
#include <pybind11/pybind11.h>

#include <atomic>
#include <cmath>
#include <vector>

#include "attended.hpp"
#include "bindings.hpp"
#include "numeric/budget.hpp"
#include "rings.hpp"
#include "scene_text.hpp"
#include "taut/outline.hpp"

namespace taut_python {
namespace {

namespace py = pybind11;
using PartsOfBodies = std::vector<std::vector<taut::Part>>;

std::vector<taut::Part> flat_parts(const taut::Body& body, double tolerance, taut::CurveSide side) {
  if (!body.curves.empty()) return taut::flatten(body.curves, side, tolerance, body.name);
  if (!body.parts.empty()) return body.parts;
  return {{body.polygon, {}, std::nullopt}};
}

/// (lo, hi), or None, as Part.z has it.
py::object layers_of(const taut::Part& part) {
  if (!part.z) return py::none();
  const auto end = [](double height) { return std::isfinite(height) ? py::object(py::float_(height)) : py::none(); };
  return py::make_tuple(end(part.z->lo), end(part.z->hi));
}

/// For each body its parts, each with its rings and its own layers, where curves are replaced by polygons.
py::list flatten(const SceneText& text, double tolerance, bool outer) {
  const taut::CurveSide side = outer ? taut::CurveSide::outer : taut::CurveSide::inner;
  const auto flat = attended<PartsOfBodies>([&](const std::atomic<bool>& stop) {
    const taut::internal::Budget scope(taut::Limits{.stop = &stop});
    PartsOfBodies bodies;
    const taut::Scene scene = text.read();
    for (const taut::Body& body : scene.bodies) bodies.push_back(flat_parts(body, tolerance, side));
    return bodies;
  });
  py::list found;
  for (const std::vector<taut::Part>& parts : flat) {
    py::list layers;
    for (const taut::Part& part : parts) layers.append(layers_of(part));
    found.append(py::make_tuple(rings_of(parts), layers));
  }
  return found;
}

}  // namespace

void bind_flatten(py::module_& module) { module.def("flatten", &flatten); }

}  // namespace taut_python
