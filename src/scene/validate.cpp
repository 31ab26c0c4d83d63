#include "taut/validate.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/predicates.hpp"
#include "scene/curved_world.hpp"
#include "scene/validate_scene.hpp"
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
