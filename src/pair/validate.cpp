#include "taut/validate.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/predicates.hpp"
#include "geometry/prepared_shape.hpp"
#include "motion/pieces.hpp"
#include "pair/curved_world.hpp"
#include "pair/pair_plan.hpp"
#include "pair/validate_time.hpp"
#include "pair/validate_world.hpp"
#include "taut/error.hpp"

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
                     "coordinates that small beside the others can only be rounding noise: make them 0");
}

namespace {

void require_two_polygons(const Scene& scene) {
  validate_time(scene);
  for (const Body& body : scene.bodies) refuse_curves(body);
  if (is_world(scene)) {
    validate_world(scene);
    throw InputError("bodies", "this takes scenes of two bodies, each one polygon in the world's frame, now",
                     "`check` takes worlds: any number of bodies, parts, holes, parents and ignored pairs");
  }
}

/// What `work` does for both bodies; an error is said to be about its body.
template <class Work>
void for_both_bodies(const Work& work) {
  for (BodyId k = 0; k < 2; ++k) {
    try {
      work(static_cast<std::size_t>(k));
    } catch (const InputError& error) {
      throw error.about(k);
    }
  }
}

}  // namespace

Scene with_prepared_shapes(const Scene& scene) {
  require_two_polygons(scene);
  Scene out = scene;
  for_both_bodies([&](std::size_t k) {
    Body& body = out.bodies[k];
    if (body.prepared) {
      validate_polygon_of(body);
    } else {
      body.prepared = prepare(body.polygon, body.name);
    }
    body.polygon.clear();
  });
  return out;
}

std::array<ShapeFacts, 2> validated_facts(const Scene& scene) {
  require_two_polygons(scene);
  for_both_bodies([&](std::size_t k) { validate_polygon_of(scene.bodies[k]); });
  const std::array<ShapeFacts, 2> facts{facts_of(scene.bodies[0]), facts_of(scene.bodies[1])};
  validate_range(facts[0], facts[1]);
  const double extent = std::max(diagonal(facts[0].bounds), diagonal(facts[1].bounds));
  for (std::size_t i = 0; i < 2; ++i) {
    const Body& body = scene.bodies[i];
    validate_motion(body.motion, body.name, facts[i].bounds, scene.start, scene.end, extent);
  }
  return facts;
}

}  // namespace taut::internal

namespace taut {
using namespace internal;

void validate(const Scene& scene) {
  if (has_curves(scene)) {
    validate_world(CurvedWorld(scene).polygons(CurveSide::outer));
    return;
  }
  if (is_world(scene)) return validate_world(scene);
  validated_facts(scene);
}

}  // namespace taut
