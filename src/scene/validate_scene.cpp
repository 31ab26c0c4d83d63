#include "scene/validate_scene.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "geometry/part_rings.hpp"
#include "geometry/predicates.hpp"
#include "geometry/prepared_shape.hpp"
#include "motion/pieces.hpp"
#include "scene/curved_world.hpp"
#include "scene/joined_parts.hpp"
#include "scene/names.hpp"
#include "scene/pair_margins.hpp"
#include "scene/ring_set.hpp"
#include "taut/error.hpp"
#include "taut/validate.hpp"

namespace taut::internal {
namespace {

/// The same error, its culprits on this part of this body; on this ring, unless they name rings themselves.
InputError located(const InputError& error, BodyId body, std::size_t part, std::size_t ring) {
  Culprits culprits = error.culprits();
  const auto locate = [&](auto& feature) {
    feature.body = body;
    feature.part = static_cast<int>(part);
    if (ring > 0) feature.ring = static_cast<int>(ring);
  };
  for (VertexRef& v : culprits.vertices) locate(v);
  for (EdgeRef& e : culprits.edges) locate(e);
  return InputError(error.place(), error.problem(), error.hint(), std::move(culprits));
}

void validate_prepared(const Body& body) {
  if (body.polygon.empty() || body.prepared->polygon() == body.polygon) return;
  throw InputError(body.name, "the prepared shape was made of another polygon",
                   "set Body::prepared to what prepare(polygon) returns for the body's own polygon, "
                   "which may be left out then");
}

/// Its rings, one by one and together; grows the range of magnitudes, and the bounds of the body.
void validate_shape(const Body& body, BodyId id, ShapeFacts& range, AxisBox& box) {
  if (!body.parts.empty() && !body.polygon.empty())
    throw InputError(body.name, "the body has a polygon and parts", "a body is one polygon, or parts");
  const auto take = [&](const ShapeFacts& facts) {
    range.least = std::min(range.least, facts.least);
    range.largest = std::max(range.largest, facts.largest);
    box.include(facts.bounds);
  };
  // What is being validated: a part, and its ring, or 0 for all of its rings together.
  std::size_t part = 0, ring = 0;
  const auto validate = [&](const Polygon& polygon) {
    validate_polygon(polygon, ring_name(body, part, ring));
    take(facts_of(polygon));
  };
  try {
    if (body.parts.empty() && body.prepared) {
      validate_prepared(body);
      take(body.prepared->facts());
    } else if (body.parts.empty()) {
      validate(body.polygon);
    }
    for (part = 0; part < body.parts.size(); ++part) {
      const Part& given = body.parts[part];
      ring = 0;
      validate(given.outline);
      for (ring = 1; ring <= given.holes.size(); ++ring) validate(given.holes[ring - 1]);
      ring = 0;
      validate_holes(given, ring_name(body, part, 0));
    }
  } catch (const InputError& error) {
    throw located(error, id, part, ring);
  }
}

void validate_layers(const Body& body) {
  const bool of_parts = body.parts.size() + body.curves.size() > 1;
  int k = 0;
  for_each_layers(body, [&](const Layers& z) {
    if (!(z.lo < z.hi))
      throw InputError(ring_name(body.name, of_parts, k, 0), fmt::format("its layers z run from {} to {}", z.lo, z.hi),
                       "write the lower height first, and two different ones");
    ++k;
  });
}

void validate_parents(const Scene& scene, const BodyNames& names) {
  for (const Body& body : scene.bodies) {
    const Body* link = &body;
    for (int depth = 1; !link->relative_to.empty(); ++depth) {
      const std::optional<BodyId> parent = names.find(link->relative_to);
      if (!parent) refuse_parent(*link, names_of(scene.bodies));
      link = &scene.bodies[static_cast<std::size_t>(*parent)];
      if (link == &body) refuse_cycle(body.name);
      validate_depth(body.name, depth);
    }
  }
}

void validate_ignored(const Scene& scene, const BodyNames& names) {
  for (std::size_t i = 0; i < scene.ignore.size(); ++i) {
    for (const std::string& name : scene.ignore[i]) {
      if (name != "*" && !names.find(name))
        throw no_such_body(names_of(scene.bodies), name, "ignore[" + std::to_string(i) + "]", "",
                           "write names of bodies of the scene, or \"*\" for every other one");
    }
    if (scene.ignore[i][0] == scene.ignore[i][1] && scene.ignore[i][0] != "*")
      throw InputError("ignore[" + std::to_string(i) + "]", "it pairs \"" + scene.ignore[i][0] + "\" with itself",
                       "write the names of two bodies, or \"*\" for every other one");
  }
}

}  // namespace

BodyNames::BodyNames(const Scene& scene) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) add(scene.bodies[i].name, static_cast<BodyId>(i));
}

BodyNames::BodyNames(const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < names.size(); ++i) add(names[i], static_cast<BodyId>(i));
}

void BodyNames::add(const std::string& name, BodyId body) {
  if (name == "*") throw InputError("bodies", "a body is called \"*\"", "in \"ignore\" that is every other body");
  if (!name.empty() && !numbers_.emplace(name, body).second)
    throw InputError("bodies", "two bodies are called \"" + name + "\"",
                     "give the bodies different names: answers call them by name");
}

std::optional<BodyId> BodyNames::find(const std::string& name) const {
  const auto found = numbers_.find(name);
  return found == numbers_.end() ? std::nullopt : std::optional(found->second);
}

void validate_depth(const std::string& name, int depth) {
  if (depth <= max_depth) return;
  throw InputError(name, "its chain of parents has more than " + std::to_string(max_depth) + " bodies",
                   "shorten it, or look for a cycle among its parents");
}

void refuse_parent(const Body& body, const std::vector<std::string>& known) {
  throw no_such_body(known, body.relative_to, body.name, " for it to be relative to",
                     "`relative_to` is the name of another body of the scene");
}

void refuse_cycle(const std::string& name) {
  throw InputError(name, "it is relative to itself, through its parents", "chains must end");
}

void validate_added(const Body& body, BodyId id, double start, double end, double largest, double& extent) {
  refuse_curves(body);
  validate_layers(body);
  ShapeFacts range;
  range.least = INFINITY;
  range.largest = largest;
  AxisBox box;
  validate_shape(body, id, range, box);
  validate_range(range, range);
  const double wider = std::max(extent, diagonal(box));
  validate_motion(body.motion, body.name, box, start, end, wider);
  extent = wider;
}

void validate_ignored(const Scene& scene) { validate_ignored(scene, BodyNames(scene)); }

bool is_ring_pair(const Scene& scene) {
  const auto polygon = [](const Body& body) {
    return body.parts.empty() && body.curves.empty() && body.relative_to.empty();
  };
  return scene.bodies.size() == 2 && scene.ignore.empty() &&
         std::all_of(scene.bodies.begin(), scene.bodies.end(), polygon) &&
         share_layers(scene.bodies[0], scene.bodies[1]);
}

void require_ring_pair(const Scene& scene, const std::string& use) {
  for (const Body& body : scene.bodies) refuse_curves(body);
  if (is_ring_pair(scene)) return;
  throw InputError(
      "bodies",
      use +
          " needs two bodies, each one polygon in the world's frame, on a common layer, and the scene is another "
          "one",
      "`check` takes any number of bodies, with parts, holes, parents and ignored pairs");
}

void validate_polygons(const Scene& scene) {
  for (const Body& body : scene.bodies) refuse_curves(body);
  if (scene.mechanism && !scene.assembly)
    throw InputError("mechanism", "its bodies have no motions yet", "ask about assembled(scene)");
  validate_time(scene);
  if (scene.bodies.empty()) throw InputError("bodies", "the scene has no bodies", "write at least one");
  const BodyNames names(scene);
  ShapeFacts range;
  range.least = INFINITY;
  std::vector<AxisBox> boxes;
  boxes.reserve(scene.bodies.size());
  double extent = 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    AxisBox box;
    validate_layers(scene.bodies[i]);
    validate_shape(scene.bodies[i], static_cast<BodyId>(i), range, box);
    boxes.push_back(box);
    extent = std::max(extent, diagonal(box));
  }
  validate_range(range, range);
  validate_parents(scene, names);
  validate_ignored(scene, names);
  validate_clearances(scene);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    validate_motion(body.motion, body.name, boxes[i], scene.start, scene.end, extent);
  }
}

}  // namespace taut::internal

namespace taut::internal {

void validate_time(const Scene& scene) {
  if (!std::isfinite(scene.start) || !std::isfinite(scene.end))
    throw InputError("time", "the time interval is not finite");
  // Products of times and coefficients are to stay within doubles; instants may be as near to 0 as they are.
  for (const double t : {scene.start, scene.end}) {
    if (std::fabs(t) > max_coordinate)
      throw InputError("time", "it goes beyond 2^400, the largest magnitude that taut computes with",
                       "choose another unit of time");
  }
  if (scene.end < scene.start)
    throw InputError("time", "the time interval ends before it starts", "write [start, end] with start <= end");
}

void validate_range(const ShapeFacts& a, const ShapeFacts& b) {
  const double least = std::min(a.least, b.least), largest = std::max(a.largest, b.largest);
  if (largest > 0 && least < largest * 0x1p-400)
    throw InputError("bodies", "the coordinates differ in magnitude by more than 2^400",
                     "coordinates that small compared with the others can only be rounding noise: make them 0");
}

}  // namespace taut::internal

namespace taut {
using namespace internal;

void validate(const Scene& scene) {
  if (has_curves(scene)) {
    validate_polygons(CurvedWorld(scene).polygons(CurveSide::outer));
    return;
  }
  validate_polygons(scene);
}

}  // namespace taut
