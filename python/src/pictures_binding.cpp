// What pictures need: rings, and where bodies are.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <atomic>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "attended.hpp"
#include "bindings.hpp"
#include "rings.hpp"
#include "scene_text.hpp"

namespace py = pybind11;

namespace taut_python {
namespace {

/// For each instant and each body, four doubles: the origin, and the x axis.
std::string poses(const taut::Scene& scene, const std::vector<double>& times) {
  std::string bytes;
  for (const double t : times) {
    for (const taut::BodyPose& pose : taut::poses_at(scene, t)) {
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

/// A body, and the part, the ring and the index of a vertex or an edge of it.
using FeatureTuple = std::tuple<int, int, int, int>;

/// What the last frame of a picture that moves shows besides the bodies.
struct Ending {
  std::string words;
  bool free = false;
  /// Vertex, edge, point and normal.
  std::optional<std::tuple<FeatureTuple, FeatureTuple, std::pair<double, double>, std::pair<double, double>>> contact;
  std::optional<std::array<int, 2>> overlap;
};

template <class Ref>
Ref feature_of(const FeatureTuple& given) {
  const auto& [body, part, ring, index] = given;
  return {body, index, part, ring};
}

/// Smaller than notebooks mind: with fewer frames, if need be.
std::string animation(const taut::Scene& scene, double end, const Ending& ending) {
  constexpr std::size_t large = 200000;
  taut::AnimateOptions options;
  options.ending = ending.words;
  options.free = ending.free;
  if (ending.contact) {
    const auto& [vertex, edge, point, normal] = *ending.contact;
    options.draw.contacts.push_back({{end, end},
                                     feature_of<taut::VertexRef>(vertex),
                                     feature_of<taut::EdgeRef>(edge),
                                     {point.first, point.second},
                                     {normal.first, normal.second}});
  }
  if (ending.overlap) options.draw.overlaps.push_back(*ending.overlap);
  std::string svg = taut::animate_svg(scene, end, options);
  while (svg.size() > large && options.frames > 30) {
    options.frames /= 2;
    svg = taut::animate_svg(scene, end, options);
  }
  return svg;
}

}  // namespace

void bind_pictures(py::module_& module) {
  module.def("poses", [](const SceneText& text, const std::vector<double>& times) {
    return py::bytes(poses(valid_scene(text), times));
  });
  module.def("rings", &rings_of_bodies);
  py::class_<Ending>(module, "Ending")
      .def(py::init())
      .def_readwrite("words", &Ending::words)
      .def_readwrite("free", &Ending::free)
      .def_readwrite("contact", &Ending::contact)
      .def_readwrite("overlap", &Ending::overlap);
  module.def("animation", [](const SceneText& text, double end, const Ending& ending) {
    const taut::Scene scene = valid_scene(text);
    return attended<std::string>([&](const std::atomic<bool>&) { return animation(scene, end, ending); });
  });
}

}  // namespace taut_python
