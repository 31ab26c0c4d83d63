// What JavaScript calls. Texts go in as UTF-8 and come out as JSON, which stays valid until the next call; numbers that
// a picture needs come as arrays. No exception passes: errors are JSON, too.
#include <emscripten.h>

#include <memory>
#include <string>

#include "aftermath.hpp"
#include "import/import.hpp"
#include "io/json_writer.hpp"
#include "numeric/budget.hpp"
#include "problem.hpp"
#include "recording.hpp"
#include "scene/curved_world.hpp"
#include "scene/validate_scene.hpp"
#include "taut/ask.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/validate.hpp"
#include "world.hpp"

namespace taut::web {
using namespace internal;
namespace {

/// What is open: one of the two, or none.
std::unique_ptr<Recording> recording;
std::unique_ptr<World> world;
std::string result;

/// The page stands still while a world is answered.
constexpr double longest_wait = 20;

template <class Ref>
std::string indices_text(const std::vector<Ref>& features) {
  std::string s;
  for (const Ref& f : features) s += (s.empty() ? "" : ",") + std::to_string(f.index);
  return "[" + s + "]";
}

/// Part and ring of each.
template <class Ref>
std::string rings_text(const std::vector<Ref>& features) {
  std::string s;
  for (const Ref& f : features)
    s += (s.empty() ? "[" : ",[") + std::to_string(f.part) + "," + std::to_string(f.ring) + "]";
  return "[" + s + "]";
}

/// Of a world the culprits themselves tell their body.
int body_of(const Culprits& culprits) {
  if (!culprits.edges.empty()) return culprits.edges.front().body;
  return culprits.vertices.empty() ? -1 : culprits.vertices.front().body;
}

/// Which body an error speaks of: the one whose name ends its place.
int body_at_fault(const std::string& place, const Scene* scene) {
  for (std::size_t b = 0; scene && b < scene->bodies.size(); ++b) {
    const std::string& name = scene->bodies[b].name;
    const std::size_t n = place.size(), m = name.size();
    if (n >= m && place.compare(n - m, m, name) == 0) return static_cast<int>(b);
  }
  return -1;
}

std::string error_text(const char* kind, const std::string& place, const std::string& problem, const std::string& hint,
                       int body = -1, const Culprits& culprits = {}) {
  return std::string("{\"error\":{\"kind\":\"") + kind + "\",\"place\":" + io::string_text(place) +
         ",\"problem\":" + io::string_text(problem) + ",\"hint\":" + io::string_text(hint) +
         ",\"body\":" + std::to_string(body) + ",\"vertices\":" + indices_text(culprits.vertices) +
         ",\"edges\":" + indices_text(culprits.edges) + ",\"vertexRings\":" + rings_text(culprits.vertices) +
         ",\"edgeRings\":" + rings_text(culprits.edges) + "}}";
}

/// Runs `work(scene)`, where `scene` may be filled for messages, and keeps its result for JavaScript.
template <class Work>
const char* answered(const Work& work) {
  Scene scene;
  try {
    result = work(scene);
  } catch (const InputError& e) {
    const int named = body_at_fault(e.place(), &scene);
    const int body = named < 0 && !is_ring_pair(scene) ? body_of(e.culprits()) : named;
    result = error_text("input", e.place(), e.problem(), e.hint(), body, e.culprits());
  } catch (const UndecidedError& e) {
    result = error_text("undecided", "", e.what(), "");
  } catch (const Interrupted& e) {
    result = error_text("undecided", "", e.reason, "");
  } catch (const std::exception& e) {
    result = error_text("internal", "", e.what(), "this is a defect of taut: please report it, with the scene");
  }
  return result.c_str();
}

Recording& current() {
  if (!recording) throw InputError("", "no scene is open");
  return *recording;
}

std::string status_text(const Recording& r, bool reached) {
  const Answer answer = r.answer();
  return std::string("{\"state\":\"") + to_string(r.simulation().state()) +
         "\",\"reached\":" + (reached ? "true" : "false") + ",\"time\":" + io::number_text(r.simulation().time()) +
         ",\"freeUntil\":" + io::number_text(answer.free_until) +
         ",\"initial\":" + std::to_string(answer.certificates_initial) +
         ",\"max\":" + std::to_string(answer.certificates_max) +
         ",\"answer\":" + answer_json(r.scene(), answer, r.touch()) + "}";
}

const char* outcome_state(Outcome outcome) {
  switch (outcome) {
    case Outcome::free:
    case Outcome::locked:
      return "finished";
    case Outcome::contact:
      return "contact";
    case Outcome::overlap_at_start:
      return "overlap_at_start";
    case Outcome::closer_at_start:
      return "closer_at_start";
    case Outcome::untested:
      return "untested";
    case Outcome::undecided:
      break;
  }
  return "undecided";
}

/// Of a world, with what its picture needs.
std::string status_text(const World& w) {
  const Answer& answer = w.answer();
  return std::string("{\"state\":\"") + outcome_state(answer.outcome) +
         "\",\"reached\":true,\"time\":" + io::number_text(w.end()) + ",\"freeUntil\":" + io::number_text(w.end()) +
         ",\"initial\":0,\"max\":0,\"answer\":" + answer_json(w.scene(), answer, w.touch()) +
         ",\"world\":" + shapes_text(w.scene(), w.curves()) + "}";
}

std::string ring_text(const Polygon& ring) {
  std::string s;
  for (const Point& p : ring) s += (s.empty() ? "" : ",") + io::point_text(p);
  return "[" + s + "]";
}

std::string part_text(const Part& part) {
  std::string holes;
  for (const Polygon& hole : part.holes) holes += (holes.empty() ? "" : ",") + ring_text(hole);
  return "{\"outline\":" + ring_text(part.outline) + ",\"holes\":[" + holes + "]}";
}

/// The tiling at t, from a simulation of its own.
std::string picture(const Scene& scene, Touch touch, double t) {
  Simulation simulation(scene, touch);
  TilingDrawOptions options;
  if (simulation.state() == SimulationState::overlap_at_start)
    throw InputError("", "the bodies overlap at the start", "there is no free space to tile");
  if (simulation.advance_to(t) == SimulationState::contact) options.contact = &*simulation.contact();
  return draw_svg(scene, simulation.tiling(), options);
}

/// Without the tiling: at the contact, that is marked; nothing after it.
std::string picture_of_bodies(const Recording& r, double t) {
  const Answer answer = r.answer();
  const bool met = answer.contact && t >= answer.contact->time.lo;
  return draw_svg(r.scene(), met ? answer.contact->time.lo : t, met ? marked(answer) : DrawOptions{});
}

}  // namespace
}  // namespace taut::web

using namespace taut;
using namespace taut::web;

extern "C" {

/// {"scene": the scene as write_scene() has it}, after validation.
EMSCRIPTEN_KEEPALIVE const char* taut_read_scene(const char* text, const char* name) {
  return answered([&](Scene& scene) {
    scene = parse_scene(text, name);
    if (!is_ring_pair(scene))
      validate_curved_world(scene);
    else
      validate(scene);
    return "{\"scene\":" + write_scene(scene) + "}";
  });
}

/// {"parts": [{"outline": [[x, y], ...], "holes": [[[x, y], ...], ...]}, ...]} from WKT or GeoJSON.
EMSCRIPTEN_KEEPALIVE const char* taut_read_outline(const char* text, const char* name) {
  return answered([&](Scene&) {
    const std::string outline = text;
    const std::size_t first = outline.find_first_not_of(" \t\r\n");
    const bool json = first != std::string::npos && outline[first] == '{';
    std::string s;
    for (const Part& part : json ? parse_geojson_parts(outline, name) : parse_wkt_parts(outline, name))
      s += (s.empty() ? "" : ",") + part_text(part);
    return "{\"parts\":[" + s + "]}";
  });
}

/// {"scene": the scene, or null if there are faults, "report": see report_json(), "picture": see report_svg()} of a
/// drawing, whose format its name tells. `open`: see drawing::OpenRings; `crossing`: see drawing::Crossing.
EMSCRIPTEN_KEEPALIVE const char* taut_read_drawing(const char* text, const char* name, int open, int crossing) {
  return answered([&](Scene& scene) {
    drawing::ImportSettings settings;
    settings.open = static_cast<drawing::OpenRings>(open);
    settings.crossing = static_cast<drawing::Crossing>(crossing);
    const drawing::Import import = drawing::examine_drawings({drawing::read_drawing(text, name, settings)}, settings);
    if (import.faults.empty()) {
      scene = import.scene;
      validate_curved_world(scene);
    }
    return "{\"scene\":" + (import.faults.empty() ? write_scene(scene) : std::string("null")) +
           ",\"report\":" + report_json(import, settings) + ",\"picture\":" + io::string_text(report_svg(import)) + "}";
  });
}

/// {"shapes": what pictures need of the bodies, see shapes_text()} of any valid scene.
EMSCRIPTEN_KEEPALIVE const char* taut_shapes(const char* text) {
  return answered([&](Scene& scene) {
    scene = parse_scene(text, "scene");
    validate_curved_world(scene);
    return "{\"shapes\":" + shapes_text(scene, nullptr) + "}";
  });
}

/// Opens a scene in place of the present one: its status. On an error the present one stays. A world is answered at
/// once, and its status has "world" besides.
EMSCRIPTEN_KEEPALIVE const char* taut_open(const char* text, const char* name, int closed) {
  return answered([&](Scene& scene) {
    scene = parse_scene(text, name);
    const Touch touch = closed != 0 ? Touch::closed : Touch::open;
    if (!is_ring_pair(scene)) {
      world = std::make_unique<World>(scene, touch, longest_wait);
      recording.reset();
      return status_text(*world);
    }
    auto fresh = std::make_unique<Recording>(scene, touch);
    recording = std::move(fresh);
    world.reset();
    return status_text(*recording, true);
  });
}

/// {"answer": ...} to a question about any valid scene, as the commands print it with `--json`.
EMSCRIPTEN_KEEPALIVE const char* taut_ask(const char* question, const char* text, const char* options) {
  return answered([&](Scene& scene) {
    scene = parse_scene(text, "scene");
    return "{\"answer\":" + ask({question, options}, scene).json + "}";
  });
}

/// problem_text() of a scene with joints, a start and a goal.
EMSCRIPTEN_KEEPALIVE const char* taut_read_problem(const char* text, const char* name) {
  return answered([&](Scene&) {
    const PathProblem problem = parse_path_problem(text, name);
    validate(problem);
    return problem_text(problem);
  });
}

/// way_text() of such a scene.
EMSCRIPTEN_KEEPALIVE const char* taut_find_way(const char* text, int closed, double clearance, int shortest,
                                               double max_seconds) {
  return answered([&](Scene&) {
    PathOptions options;
    options.touch = closed != 0 ? Touch::closed : Touch::open;
    options.clearance = clearance;
    options.shortest = shortest != 0;
    options.limits.max_seconds = max_seconds;
    return way_text(parse_path_problem(text, "problem"), options);
  });
}

/// aftermath_text() of a scene.
EMSCRIPTEN_KEEPALIVE const char* taut_go_on(const char* text, int closed, int bounce) {
  return answered([&](Scene& scene) {
    scene = parse_scene(text, "scene");
    AftermathOptions options;
    options.touch = closed != 0 ? Touch::closed : Touch::open;
    options.bounce = bounce != 0;
    options.max_seconds = longest_wait;
    return aftermath_text(scene, options);
  });
}

EMSCRIPTEN_KEEPALIVE const char* taut_advance(double until, double milliseconds) {
  return answered([&](Scene&) {
    if (world) return status_text(*world);
    const bool reached = current().advance(until, milliseconds);
    return status_text(current(), reached);
  });
}

/// Body `body` takes up its motion in the scene `text` at the present of the simulation.
EMSCRIPTEN_KEEPALIVE const char* taut_change_plan(const char* text, int body) {
  return answered([&](Scene& scene) {
    scene = parse_scene(text, "scene");
    current().change_plan(scene, body);
    return status_text(current(), true);
  });
}

/// Of every body, origin and axis at time t: four numbers each. Valid until the next call of this function.
EMSCRIPTEN_KEEPALIVE const double* taut_poses(double t) {
  static std::vector<double> poses;
  if (recording || world) poses = poses_of(world ? world->scene() : recording->scene(), t);
  return poses.data();
}

/// Of a world, the tilings of the pairs that are near at t: {"lines": five numbers for each, its ends in the world, and
/// 1 if it joins two bodies}.
EMSCRIPTEN_KEEPALIVE const char* taut_tilings(double t) {
  return answered(
      [&](Scene&) { return "{\"lines\":" + io::array_text(world ? world->tilings(t) : std::vector<double>()) + "}"; });
}

/// A picture of an instant: {"svg": ...}. With the proof, it is the simulation's own view, to compare a replay with.
EMSCRIPTEN_KEEPALIVE const char* taut_svg(double t, int proof) {
  return answered([&](Scene&) {
    const std::string svg = world        ? world->picture(t, proof != 0)
                            : proof != 0 ? picture(current().scene(), current().touch(), t)
                                         : picture_of_bodies(current(), t);
    return "{\"svg\":" + io::string_text(svg) + "}";
  });
}

/// Arrays by number: 0 vertices, 1 half-edges at the start, 2 changes, 3 events (32-bit integers), 4 times (doubles).
/// Valid until the next call that advances or opens.
EMSCRIPTEN_KEEPALIVE const void* taut_array(int which) {
  if (!recording) return nullptr;
  const std::vector<std::int32_t>* arrays[] = {&recording->vertices(), &recording->start(), &recording->changes(),
                                               &recording->events()};
  if (which == 4) return recording->times().data();
  return which >= 0 && which < 4 ? arrays[which]->data() : nullptr;
}

EMSCRIPTEN_KEEPALIVE int taut_array_size(int which) {
  if (!recording) return 0;
  const std::vector<std::int32_t>* arrays[] = {&recording->vertices(), &recording->start(), &recording->changes(),
                                               &recording->events()};
  if (which == 4) return static_cast<int>(recording->times().size());
  return which >= 0 && which < 4 ? static_cast<int>(arrays[which]->size()) : 0;
}

}  // extern "C"
