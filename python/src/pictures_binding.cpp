// What pictures need: rings, and where bodies are.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <atomic>
#include <map>
#include <string>
#include <vector>

#include "attended.hpp"
#include "bindings.hpp"
#include "rings.hpp"
#include "scene_text.hpp"

namespace py = pybind11;

namespace taut_python {
namespace {

/// The child's pose as seen from the world: as complex numbers, o + x o' and x x'.
taut::BodyPose composed(const taut::BodyPose& parent, const taut::BodyPose& child) {
  const auto& [o, x] = parent;
  const auto& [p, y] = child;
  return {{o.x + x.x * p.x - x.y * p.y, o.y + x.y * p.x + x.x * p.y}, {x.x * y.x - x.y * y.y, x.y * y.x + x.x * y.y}};
}

/// Chains are known to end: the scene is valid.
taut::BodyPose pose_in_world(const std::map<std::string, const taut::Body*>& bodies, const taut::Body& body, double t) {
  taut::BodyPose pose = taut::pose_at(body.motion, t);
  for (const taut::Body* link = &body; !link->relative_to.empty();) {
    link = bodies.at(link->relative_to);
    pose = composed(taut::pose_at(link->motion, t), pose);
  }
  return pose;
}

/// For each instant and each body, four doubles: the origin, and the x axis.
std::string poses(const taut::Scene& scene, const std::vector<double>& times) {
  std::map<std::string, const taut::Body*> bodies;
  for (const taut::Body& body : scene.bodies) bodies.emplace(body.name, &body);
  std::string bytes;
  for (const double t : times) {
    for (const taut::Body& body : scene.bodies) {
      const taut::BodyPose pose = pose_in_world(bodies, body, t);
      const double numbers[] = {pose.origin.x, pose.origin.y, pose.axis.x, pose.axis.y};
      bytes.append(reinterpret_cast<const char*>(numbers), sizeof(numbers));
    }
  }
  return bytes;
}

taut::Scene valid_scene(const SceneText& text) {
  return attended<taut::Scene>([&](const std::atomic<bool>&) {
    taut::Scene scene = text.read();
    taut::validate(scene);
    return scene;
  });
}

/// Each body's parts, and their rings.
py::list rings_of_bodies(const SceneText& text) {
  py::list bodies;
  for (const taut::Body& body : valid_scene(text).bodies)
    bodies.append(rings_of(body.parts.empty() ? std::vector<taut::Part>{{taut::polygon_of(body), {}}} : body.parts));
  return bodies;
}

}  // namespace

void bind_pictures(py::module_& module) {
  module.def("poses", [](const SceneText& text, const std::vector<double>& times) {
    return py::bytes(poses(valid_scene(text), times));
  });
  module.def("rings", &rings_of_bodies);
}

}  // namespace taut_python
