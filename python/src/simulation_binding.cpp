// Simulation: the kinetic data structure, online.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

#include "attended.hpp"
#include "bindings.hpp"
#include "io/answer_writer.hpp"
#include "scene_text.hpp"
#include "taut/contact_motions.hpp"
#include "taut/io.hpp"
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
  std::uint64_t events = 0, certificates = 0, certificates_max = 0, contacts = 0;
  bool again = false;
  std::string contact;  ///< JSON members as in an answer, each with a comma before it; or empty
  std::optional<std::pair<double, double>> overlap;
  std::optional<std::pair<int, int>> pair;
  std::vector<std::string> also;          ///< each a JSON object as in an answer
  std::array<std::uint64_t, 8> coverage;  ///< in the order of taut::Coverage
};

/// A contact as numbers, for callbacks that come often: the bodies of the vertex and of the edge, indices of both, the
/// point, and the normal.
struct LiveContact {
  explicit LiveContact(const taut::Contact& c)
      : bodies(c.vertex.body, c.edge.body),
        indices(c.vertex.index, c.edge.index),
        point(c.point.x, c.point.y),
        normal(c.normal.x, c.normal.y),
        t(c.time.lo, c.time.hi) {}

  std::pair<int, int> bodies, indices;
  std::pair<double, double> point, normal, t;
};

/// One piece of a motion, as numbers.
using Coefficients = std::vector<double>;

taut::Motion polynomial(Coefficients x, Coefficients y, std::optional<Coefficients> angle,
                        const std::pair<double, double>& pivot, double origin) {
  taut::MotionPiece piece;
  piece.x = std::move(x);
  piece.y = std::move(y);
  if (angle) piece.rotation = taut::AngleRotation{std::move(*angle)};
  piece.pivot = {pivot.first, pivot.second};
  piece.origin = origin;
  return taut::Motion{{piece}};
}

using Interval = std::pair<double, double>;

Interval interval(const taut::Enclosure& e) { return {e.lo, e.hi}; }

/// What a simulation takes besides the options of all questions.
struct SimulationChoices {
  std::uint64_t max_contacts;
  double contact_time;
  bool record;
};

/// A simulation that several threads of Python may hold: they take turns. After Ctrl-C it is undecided.
class LiveSimulation {
 public:
  LiveSimulation(const SceneText& text, const RunOptions& options, const SimulationChoices& choices) {
    change<bool>([&] {
      const taut::CheckOptions how = check_options(options, stop_);
      taut::SimulationOptions limits;
      limits.touch = how.touch;
      limits.max_events = how.max_events;
      limits.limits.max_seconds = how.limits.max_seconds;
      limits.limits.stop = &stop_;
      limits.max_contacts_per_time = choices.max_contacts;
      limits.contact_time = choices.contact_time;
      limits.record = choices.record;
      simulation_.emplace(text.read(), limits);
      return true;
    });
  }

  Standing standing() {
    if (works_here()) return standing_now();
    const py::gil_scoped_release released;
    const std::lock_guard turn(mutex_);
    return standing_now();
  }

  Standing standing_now() const {
    const taut::Simulation& s = *simulation_;
    Standing found{to_string(s.state()),
                   s.reason(),
                   s.time(),
                   s.events(),
                   s.certificates(),
                   s.certificates_max(),
                   s.contacts(),
                   s.contact_again(),
                   {},
                   {},
                   {},
                   {},
                   {}};
    const taut::Coverage c = s.coverage();
    found.coverage = {c.pairs, c.tested, c.apart, c.ignored, c.moving_alike, c.at_rest, c.layers, c.not_reached};
    if (s.contact()) found.contact = taut::internal::io::contact_json(s.scene(), *s.contact());
    if (s.overlap_point()) found.overlap.emplace(s.overlap_point()->x, s.overlap_point()->y);
    if (const auto pair = s.pair()) found.pair.emplace((*pair)[0], (*pair)[1]);
    for (const taut::PairAnswer& other : s.also())
      found.also.push_back(taut::internal::io::pair_answer_json(s.scene(), other));
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
      simulation_->set_motion(body, motion_of(text));
      return true;
    });
  }
  void set_polynomial(int body, Coefficients x, Coefficients y, std::optional<Coefficients> angle,
                      const std::pair<double, double>& pivot, double origin) {
    const taut::Motion motion = polynomial(std::move(x), std::move(y), std::move(angle), pivot, origin);
    change<bool>([&] {
      simulation_->set_motion(body, motion);
      return true;
    });
  }

  std::string resume() {
    return change<std::string>([&] { return to_string(simulation_->resume()); });
  }

  /// At the contact: the body's motion from now on, as a scene of that body alone.
  std::string stop(int body, double gap) {
    return change<std::string>([&] {
      taut::stop(*simulation_, body, gap);
      return motion_text(body);
    });
  }
  std::string push(int body, const std::optional<std::pair<double, double>>& hinge,
                   const std::pair<double, double>& direction, double step, double gap) {
    return change<std::string>([&] {
      taut::Guide guide{{}, {direction.first, direction.second}};
      if (hinge) guide.hinge = taut::Point{hinge->first, hinge->second};
      taut::push(*simulation_, body, guide, step, gap);
      return motion_text(body);
    });
  }

  /// `text` is a scene of that body alone, without its parent.
  int add_body(const SceneText& text, const std::string& parent) {
    return change<int>([&] {
      taut::Body body = text.read().bodies.at(0);
      body.relative_to = parent;
      return simulation_->add_body(body);
    });
  }
  void remove_body(int body) {
    change<bool>([&] {
      simulation_->remove_body(body);
      return true;
    });
  }
  void ignore(int a, int b) {
    change<bool>([&] {
      simulation_->ignore(a, b);
      return true;
    });
  }
  void set_parent(int body, std::optional<int> parent, const SceneText& motion) {
    change<bool>([&] {
      simulation_->set_parent(body, parent, motion_of(motion));
      return true;
    });
  }

  /// Of the contact, or of one of the others that came with it.
  py::tuple relative_velocity(std::size_t which) {
    const auto found = change<taut::ContactMotion>([&] {
      if (!simulation_->contact())
        throw taut::InputError("", "there is no contact", "ask while the state is \"contact\"");
      return simulation_->relative_velocity(which == 0 ? *simulation_->contact()
                                                       : *simulation_->also().at(which - 1).contact);
    });
    return py::make_tuple(interval(found.normal[0]), interval(found.normal[1]), interval(found.velocity[0]),
                          interval(found.velocity[1]), interval(found.along_normal));
  }

  /// JSON texts of scenes.
  std::vector<std::string> record() {
    return change<std::vector<std::string>>([&] {
      std::vector<std::string> texts;
      for (const taut::Scene& scene : simulation_->record()) texts.push_back(taut::write_scene(scene));
      return texts;
    });
  }

  /// Calls `visit(contact)` for each contact up to t, and goes on after it, unless it returns False.
  std::string advance_many(double t, const py::function& visit) {
    return change<std::string>([&] {
      // This thread's state of the interpreter is kept from one call to the next.
      const py::gil_scoped_acquire holding;
      const py::gil_scoped_release released;
      while (simulation_->advance_to(t) == taut::SimulationState::contact) {
        std::vector<taut::Contact> contacts{*simulation_->contact()};
        for (const taut::PairAnswer& other : simulation_->also()) contacts.push_back(*other.contact);
        bool goes_on = true;
        for (const taut::Contact& contact : contacts) {
          const py::gil_scoped_acquire acquired;
          goes_on = !visit(LiveContact(contact)).is(py::bool_(false)) && goes_on;
        }
        if (!goes_on || simulation_->state() != taut::SimulationState::contact) break;
        simulation_->resume();
      }
      return std::string(to_string(simulation_->state()));
    });
  }

 private:
  std::string motion_text(int body) const {
    taut::Scene alone;
    alone.start = simulation_->scene().start;
    alone.end = simulation_->scene().end;
    alone.bodies = {simulation_->scene().bodies[static_cast<std::size_t>(body)]};
    alone.bodies[0].relative_to.clear();
    return taut::write_scene(alone);
  }
  static taut::Motion motion_of(const SceneText& text) { return text.read().bodies.at(0).motion; }

  /// Is this a call from a callback?
  bool works_here() const {
    const bool here = working_.load() == std::this_thread::get_id();
    if (here && handles_signals())
      throw taut::InputError("", "a handler of signals asks a simulation in the middle of its work",
                             "ask after the call that works has returned");
    return here;
  }

  template <class Result>
  Result change(const std::function<Result()>& work) {
    if (works_here()) return work();
    return attended<Result>(stop_, [&] {
      std::unique_lock turn(mutex_, std::defer_lock);
      while (!turn.try_lock_for(signal_period)) look_for_signals();
      const Working here(working_);
      return work();
    });
  }

  /// While it lives, calls from this thread are those of callbacks.
  struct Working {
    explicit Working(std::atomic<std::thread::id>& id) : id_(id) { id_ = std::this_thread::get_id(); }
    ~Working() { id_ = std::thread::id(); }
    Working(const Working&) = delete;
    Working& operator=(const Working&) = delete;
    std::atomic<std::thread::id>& id_;
  };

  std::atomic<bool> stop_{false};
  std::timed_mutex mutex_;
  std::atomic<std::thread::id> working_{};
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
      .def_readonly("contacts", &Standing::contacts)
      .def_readonly("again", &Standing::again)
      .def_readonly("contact", &Standing::contact)
      .def_readonly("overlap", &Standing::overlap)
      .def_readonly("pair", &Standing::pair)
      .def_readonly("also", &Standing::also)
      .def_readonly("coverage", &Standing::coverage);
  py::class_<LiveContact>(module, "LiveContact")
      .def_readonly("bodies", &LiveContact::bodies)
      .def_readonly("indices", &LiveContact::indices)
      .def_readonly("point", &LiveContact::point)
      .def_readonly("normal", &LiveContact::normal)
      .def_readonly("t", &LiveContact::t);
  py::class_<LiveSimulation>(module, "Simulation")
      .def(py::init([](const SceneText& text, const RunOptions& options, std::uint64_t max_contacts,
                       double contact_time, bool record) {
        return std::make_unique<LiveSimulation>(text, options, SimulationChoices{max_contacts, contact_time, record});
      }))
      .def("standing", &LiveSimulation::standing)
      .def("next_event", &LiveSimulation::next_event)
      .def("step", &LiveSimulation::step)
      .def("advance_to", &LiveSimulation::advance_to)
      .def("tiling", &LiveSimulation::tiling)
      .def("set_motion", &LiveSimulation::set_motion)
      .def("set_polynomial", &LiveSimulation::set_polynomial)
      .def("resume", &LiveSimulation::resume)
      .def("stop", &LiveSimulation::stop)
      .def("push", &LiveSimulation::push)
      .def("add_body", &LiveSimulation::add_body)
      .def("remove_body", &LiveSimulation::remove_body)
      .def("ignore", &LiveSimulation::ignore)
      .def("set_parent", &LiveSimulation::set_parent)
      .def("relative_velocity", &LiveSimulation::relative_velocity)
      .def("record", &LiveSimulation::record)
      .def("advance_many", &LiveSimulation::advance_many);
}

}  // namespace taut_python
