// Cells of a grid that a moving body touches.
#include <pybind11/pybind11.h>

#include <atomic>
#include <string>

#include "attended.hpp"
#include "bindings.hpp"
#include "scene_text.hpp"
#include "taut/cells.hpp"
#include "taut/error.hpp"

namespace taut_python {
namespace {

taut::BodyId body_called(const taut::Scene& scene, const std::string& name) {
  std::string names;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    if (scene.bodies[k].name == name) return static_cast<taut::BodyId>(k);
    names += (k > 0 ? ", " : "") + scene.bodies[k].name;
  }
  throw taut::InputError("cells", "there is no body \"" + name + "\"", "the scene has " + names);
}

std::string cells(const SceneText& text, const std::string& body, double resolution, double x, double y) {
  return attended<std::string>([&](const std::atomic<bool>& stop) {
    const taut::Scene scene = text.read();
    const taut::BodyId id = body_called(scene, body);
    taut::CellOptions how;
    how.resolution = resolution;
    how.origin = {x, y};
    how.limits.stop = &stop;
    return taut::cells_json(scene, id, taut::cells(scene, id, how));
  });
}

}  // namespace

void bind_cells(pybind11::module_& module) { module.def("cells", &cells); }

}  // namespace taut_python
