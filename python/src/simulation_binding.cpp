// Simulation: the kinetic data structure, online.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "attended.hpp"
#include "bindings.hpp"
#include "io/answer_json.hpp"
#include "scene_text.hpp"
#include "taut/simulation.hpp"

namespace py = pybind11;

namespace taut_python {
namespace {

const char* kind_word(taut::FaceKind kind) {
  switch (kind) {
    case taut::FaceKind::node:
      return "node";
    case taut::FaceKind::root:
      return "root";
    case taut::FaceKind::infinite:
      return "infinite";
    case taut::FaceKind::polygon_interior:
      return "polygon_interior";
  }
  return "";
}

/// Vertices (body, index, x, y), edges (from, to, of a body, between bodies), faces (kind, body, depth, boundary).
py::tuple tuple_of(const taut::Tiling& tiling) {
  py::list vertices, edges, faces;
  for (const taut::TilingVertex& v : tiling.vertices)
    vertices.append(py::make_tuple(v.vertex.body, v.vertex.index, v.position.x, v.position.y));
  for (const taut::TilingEdge& e : tiling.edges) edges.append(py::make_tuple(e.from, e.to, e.polygon, e.pq));
  for (const taut::TilingFace& f : tiling.faces)
    faces.append(py::make_tuple(kind_word(f.kind), f.body, f.depth, py::cast(f.boundary)));
  return py::make_tuple(tiling.time, vertices, edges, faces);
}

/// What is known of a simulation between two calls.
struct Standing {
  std::string state, reason;
  double time = 0;
  std::uint64_t events = 0, certificates = 0, certificates_max = 0;
  std::string contact;  ///< JSON members as in an answer, each with a comma before it; or empty
  std::optional<std::pair<double, double>> overlap;
  std::optional<std::pair<int, int>> pair;
  std::vector<std::string> also;          ///< each a JSON object as in an answer
  std::array<std::uint64_t, 8> coverage;  ///< in the order of taut::Coverage
};

/// A simulation that several threads of Python may hold: they take turns. After Ctrl-C it is undecided.
class LiveSimulation {
 public:
  LiveSimulation(const SceneText& text, const RunOptions& options) {
    change<bool>([&] {
      const taut::CheckOptions how = check_options(options, stop_);
      taut::SimulationOptions limits;
      limits.touch = how.touch;
      limits.max_events = how.max_events;
      limits.limits.max_seconds = how.limits.max_seconds;
      limits.limits.stop = &stop_;
      scene_ = text.read();
      simulation_.emplace(scene_, limits);
      return true;
    });
  }

  Standing standing() {
    const py::gil_scoped_release released;
    const std::lock_guard turn(mutex_);
    const taut::Simulation& s = *simulation_;
    Standing found{to_string(s.state()),
                   s.reason(),
                   s.time(),
                   s.events(),
                   s.certificates(),
                   s.certificates_max(),
                   {},
                   {},
                   {},
                   {},
                   {}};
    const taut::Coverage c = s.coverage();
    found.coverage = {c.pairs, c.tested, c.apart, c.ignored, c.moving_alike, c.at_rest, c.layers, c.not_reached};
    if (s.contact()) found.contact = taut::internal::io::contact_json(scene_, *s.contact());
    if (s.overlap_point()) found.overlap.emplace(s.overlap_point()->x, s.overlap_point()->y);
    if (const auto pair = s.pair()) found.pair.emplace((*pair)[0], (*pair)[1]);
    for (const taut::PairAnswer& other : s.also())
      found.also.push_back(taut::internal::io::pair_answer_json(scene_, other));
    return found;
  }

  std::optional<std::pair<double, double>> next_event() {
    using Found = std::optional<std::pair<double, double>>;
    return change<Found>([&]() -> Found {
      const std::optional<taut::TimeInterval> next = simulation_->next_event();
      if (!next) return std::nullopt;
      return std::pair(next->lo, next->hi);
    });
  }

  bool step() {
    return change<bool>([&] { return simulation_->step(); });
  }

  std::string advance_to(double t) {
    return change<std::string>([&] { return to_string(simulation_->advance_to(t)); });
  }

  py::tuple tiling() {
    return tuple_of(change<taut::Tiling>([&] { return simulation_->tiling(); }));
  }

  /// `text` is a scene of one body, which has the motion.
  void set_motion(int body, const SceneText& text) {
    change<bool>([&] {
      taut::Motion motion = text.read().bodies.at(0).motion;
      simulation_->set_motion(body, motion);
      scene_.bodies.at(static_cast<std::size_t>(body)).motion = std::move(motion);
      return true;
    });
  }

 private:
  template <class Result>
  Result change(const std::function<Result()>& work) {
    return attended<Result>(stop_, [&] {
      const std::lock_guard turn(mutex_);
      return work();
    });
  }

  std::atomic<bool> stop_{false};
  std::mutex mutex_;
  taut::Scene scene_;  ///< with the motions of now
  std::optional<taut::Simulation> simulation_;
};

}  // namespace

void bind_simulations(py::module_& module) {
  py::class_<Standing>(module, "Standing")
      .def_readonly("state", &Standing::state)
      .def_readonly("reason", &Standing::reason)
      .def_readonly("time", &Standing::time)
      .def_readonly("events", &Standing::events)
      .def_readonly("certificates", &Standing::certificates)
      .def_readonly("certificates_max", &Standing::certificates_max)
      .def_readonly("contact", &Standing::contact)
      .def_readonly("overlap", &Standing::overlap)
      .def_readonly("pair", &Standing::pair)
      .def_readonly("also", &Standing::also)
      .def_readonly("coverage", &Standing::coverage);
  py::class_<LiveSimulation>(module, "Simulation")
      .def(py::init<const SceneText&, const RunOptions&>())
      .def("standing", &LiveSimulation::standing)
      .def("next_event", &LiveSimulation::next_event)
      .def("step", &LiveSimulation::step)
      .def("advance_to", &LiveSimulation::advance_to)
      .def("tiling", &LiveSimulation::tiling)
      .def("set_motion", &LiveSimulation::set_motion);
}

}  // namespace taut_python
