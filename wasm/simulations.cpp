// Simulation for the npm package. Each call answers {"value": ..., "standing": ...}, or an error.
#include <emscripten.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "ask/question.hpp"
#include "io/answer_writer.hpp"
#include "replies.hpp"
#include "taut/contact_motions.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/simulation.hpp"

namespace taut::web {
using namespace internal;
namespace {

std::map<int, std::unique_ptr<Simulation>> simulations;
int last_simulation = 0;

Simulation& simulation_of(int id) {
  const auto found = simulations.find(id);
  if (found == simulations.end()) throw InputError("", "the simulation was freed", "make another one");
  return *found->second;
}

/// The options of simulations, read and checked as those of questions are.
const QuestionEntry& simulation_entry() {
  static const QuestionEntry entry{
      "simulation",
      "",
      "",
      {touch_option(), max_seconds_option(), max_events_option(),
       whole_option("max_contacts_per_time", 0, UINT32_MAX, SimulationOptions{}.max_contacts_per_time, ""),
       number_option("contact_time", 0, ""), flag_option("record", "")}};
  return entry;
}

SimulationOptions simulation_options(const char* text) {
  const Question asked{"simulation", text};
  const GivenOptions given(asked, simulation_entry());
  SimulationOptions options;
  options.touch = given.touch();
  options.limits.max_seconds = given.number("max_seconds");
  options.max_events = given.whole_number("max_events");
  options.max_contacts_per_time = given.whole_number("max_contacts_per_time");
  options.contact_time = given.number("contact_time");
  options.record = given.flag("record");
  return options;
}

/// What is known between two calls.
std::string standing(const Simulation& s) {
  io::AnswerWriter json(s.scene());
  json.object([&] {
    json.member("state", to_string(s.state()));
    json.reason(s.reason());
    json.member("time", s.time());
    json.member("events", s.events());
    json.member("certificates", s.certificates());
    json.member("certificates_max", s.certificates_max());
    json.member("contacts", s.contacts());
    json.member("contact_again", s.contact_again());
    if (s.pair()) json.pair("pair", *s.pair());
    if (s.contact()) json.key("contact").raw(io::contact_json(s.scene(), *s.contact()));
    json.key("also").array(s.also(), [&](const PairAnswer& other) { json.pair_answer(other); });
    if (s.overlap_point()) json.member("overlap_point", *s.overlap_point());
    json.coverage(s.coverage());
  });
  return json.text();
}

std::string with_standing(const Simulation& s, const std::string& value) {
  return "{\"value\":" + value + ",\"standing\":" + standing(s) + "}";
}

/// `work(simulation)` gives its value as JSON.
template <class Work>
const char* on_simulation(int id, const Work& work) {
  return replied([&] {
    Simulation& s = simulation_of(id);
    return with_standing(s, work(s));
  });
}

/// Of a call without a value.
template <class Work>
const char* changed(int id, const Work& work) {
  return on_simulation(id, [&](Simulation& s) {
    work(s);
    return std::string("null");
  });
}

/// The motion of the only body of a scene.
Motion motion_in(const char* scene) { return parse_scene(scene, "motion").bodies.at(0).motion; }

void write_enclosure(io::JsonWriter& json, const Enclosure& e) { json.numbers({e.lo, e.hi}); }

std::string velocity_json(const ContactMotion& m) {
  return io::json_text([&](io::JsonWriter& json) {
    json.object([&] {
      json.key("normal").array(m.normal, [&](const Enclosure& e) { write_enclosure(json, e); });
      json.key("velocity").array(m.velocity, [&](const Enclosure& e) { write_enclosure(json, e); });
      write_enclosure(json.key("along_normal"), m.along_normal);
    });
  });
}

const char* face_word(FaceKind kind) {
  switch (kind) {
    case FaceKind::node:
      return "node";
    case FaceKind::root:
      return "root";
    case FaceKind::infinite:
      return "infinite";
    case FaceKind::polygon_interior:
      break;
  }
  return "polygon_interior";
}

std::string tiling_json(const Scene& scene, const Tiling& tiling) {
  io::AnswerWriter json(scene);
  json.object([&] {
    json.member("time", tiling.time);
    json.key("vertices").array(tiling.vertices, [&](const TilingVertex& v) { json.vertex(v.vertex); });
    json.key("points").array(tiling.vertices, [&](const TilingVertex& v) { json.point(v.position); });
    json.key("edges").array(tiling.edges, [&](const TilingEdge& e) {
      json.object([&] {
        json.member("start", e.from);
        json.member("end", e.to);
        json.member("polygon", e.polygon);
        json.member("joins", e.pq);
      });
    });
    json.key("faces").array(tiling.faces, [&](const TilingFace& f) {
      json.object([&] {
        json.member("kind", face_word(f.kind));
        if (f.kind == FaceKind::node || f.kind == FaceKind::polygon_interior)
          json.member("body", json.body(f.body).name);
        json.member("depth", f.depth);
        json.key("boundary").array(f.boundary, [&](int vertex) { json.integer(vertex); });
      });
    });
  });
  return json.text();
}

}  // namespace
}  // namespace taut::web

using namespace taut;
using namespace taut::web;

extern "C" {

/// Its value is the number by which later calls name it.
EMSCRIPTEN_KEEPALIVE const char* taut_simulation_open(const char* scene, const char* options) {
  return replied([&] {
    auto made = std::make_unique<Simulation>(parse_scene(scene), simulation_options(options));
    const Simulation& s = *(simulations[++last_simulation] = std::move(made));
    return with_standing(s, std::to_string(last_simulation));
  });
}
EMSCRIPTEN_KEEPALIVE const char* taut_simulation_close(int id) {
  simulations.erase(id);
  return "null";
}

EMSCRIPTEN_KEEPALIVE const char* taut_simulation_advance(int id, double t) {
  return changed(id, [&](Simulation& s) { s.advance_to(t); });
}
EMSCRIPTEN_KEEPALIVE const char* taut_simulation_step(int id) {
  return on_simulation(id, [](Simulation& s) { return std::string(s.step() ? "true" : "false"); });
}
EMSCRIPTEN_KEEPALIVE const char* taut_simulation_next_event(int id) {
  return on_simulation(id, [](Simulation& s) {
    const std::optional<TimeInterval> next = s.next_event();
    return next ? io::json_text([&](io::JsonWriter& json) { json.numbers({next->lo, next->hi}); }) : "null";
  });
}
EMSCRIPTEN_KEEPALIVE const char* taut_simulation_resume(int id) {
  return changed(id, [](Simulation& s) { s.resume(); });
}
EMSCRIPTEN_KEEPALIVE const char* taut_simulation_stop(int id, int body, double gap) {
  return changed(id, [&](Simulation& s) { stop(s, body, gap); });
}
/// About the hinge (x, y), or along the direction.
EMSCRIPTEN_KEEPALIVE const char* taut_simulation_push(int id, int body, int hinge, double x, double y, double step,
                                                      double gap) {
  return changed(id, [&](Simulation& s) {
    const Point p{x, y};
    push(s, body, hinge ? Guide{p, {}} : Guide{std::nullopt, p}, step, gap);
  });
}
EMSCRIPTEN_KEEPALIVE const char* taut_simulation_set_motion(const char* motion, int id, int body) {
  return changed(id, [&](Simulation& s) { s.set_motion(body, motion_in(motion)); });
}
/// `scene` has the body alone, without its parent; the value is the body's number.
EMSCRIPTEN_KEEPALIVE const char* taut_simulation_add_body(const char* scene, const char* parent, int id) {
  return on_simulation(id, [&](Simulation& s) {
    Body body = parse_scene(scene, "body").bodies.at(0);
    body.relative_to = parent;
    return std::to_string(s.add_body(body));
  });
}
EMSCRIPTEN_KEEPALIVE const char* taut_simulation_remove_body(int id, int body) {
  return changed(id, [&](Simulation& s) { s.remove_body(body); });
}
EMSCRIPTEN_KEEPALIVE const char* taut_simulation_ignore(int id, int a, int b) {
  return changed(id, [&](Simulation& s) { s.ignore(a, b); });
}
/// Without a parent, that is -1.
EMSCRIPTEN_KEEPALIVE const char* taut_simulation_set_parent(const char* motion, int id, int body, int parent) {
  return changed(id, [&](Simulation& s) {
    s.set_parent(body, parent < 0 ? std::nullopt : std::optional<BodyId>(parent), motion_in(motion));
  });
}
/// Of the contact (0), or of one of those that came with it (from 1 on).
EMSCRIPTEN_KEEPALIVE const char* taut_simulation_relative_velocity(int id, int which) {
  return on_simulation(id, [&](Simulation& s) {
    const bool known = s.contact() && which <= static_cast<int>(s.also().size());
    if (!known) throw InputError("", "there is no contact", "ask while the state is \"contact\"");
    const std::size_t place = static_cast<std::size_t>(which);
    return velocity_json(s.relative_velocity(which == 0 ? *s.contact() : *s.also()[place - 1].contact));
  });
}
EMSCRIPTEN_KEEPALIVE const char* taut_simulation_record(int id) {
  return on_simulation(id, [](Simulation& s) {
    return io::json_text([&](io::JsonWriter& json) {
      json.array(s.record(), [&](const Scene& scene) { json.raw(write_scene(scene)); });
    });
  });
}
EMSCRIPTEN_KEEPALIVE const char* taut_simulation_tiling(int id) {
  return on_simulation(id, [](Simulation& s) { return tiling_json(s.scene(), s.tiling()); });
}

}  // extern "C"
