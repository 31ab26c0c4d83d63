#include "taut/validate.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/hull.hpp"
#include "motion/motion_plan.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

void validate_time(const Scene& scene) {
  if (!std::isfinite(scene.start) || !std::isfinite(scene.end))
    throw InputError("time", "the time interval is not finite");
  if (scene.end < scene.start)
    throw InputError("time", "the time interval ends before it starts", "write [start, end] with start <= end");
}

/// Exact predicates multiply coordinates of both bodies: their magnitudes must not be too far apart.
void validate_range(const Scene& scene) {
  double least = INFINITY, largest = 0;
  for (const Body& body : scene.bodies) {
    for (const Point& v : body.polygon) {
      for (const double c : {v.x, v.y}) {
        if (c == 0) continue;
        least = std::min(least, std::fabs(c));
        largest = std::max(largest, std::fabs(c));
      }
    }
  }
  if (largest > 0 && least < largest * 0x1p-400)
    throw InputError("bodies", "the coordinates differ in magnitude by more than 2^400",
                     "coordinates that small beside the others can only be rounding noise: make them 0");
}

}  // namespace

void validate(const Scene& scene) {
  validate_time(scene);
  if (scene.bodies.size() != 2)
    throw InputError("bodies", "the scene has " + std::to_string(scene.bodies.size()) + " bodies",
                     "exactly two are supported now");
  double extent = 0;
  for (const Body& body : scene.bodies) {
    validate_polygon(body.polygon, body.name);
    extent = std::max(extent, bounding_diagonal(body.polygon));
  }
  validate_range(scene);
  for (const Body& body : scene.bodies) {
    validate_motion(body.motion, body.name, body.polygon, scene.start, scene.end, extent);
  }
}

}  // namespace taut
