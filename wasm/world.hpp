// A scene of more than two polygons, answered once: there is no tiling of it to be recorded.
#pragma once

#include <string>
#include <vector>

#include "taut/check.hpp"
#include "taut/scene.hpp"

namespace taut::web {

class World {
 public:
  /// Asks check(), for so many seconds at most: the page waits. Throws InputError.
  World(const Scene& scene, Touch touch, double max_seconds);

  const Scene& scene() const { return scene_; }
  const Answer& answer() const { return answer_; }
  Touch touch() const { return touch_; }
  /// The last instant of which something is known.
  double end() const;
  /// The picture of an instant, marked if it is the last one.
  std::string picture(double t) const;

 private:
  Scene scene_;
  Touch touch_;
  Answer answer_;
};

/// For pictures on the page: {"order": bodies in the order of painting, "inner": for each body [x, y, room, part] of a
/// point deep inside it, in its own coordinates, "looks": [[fill, line, ink], ...], which come again after the last}.
std::string shapes_text(const Scene& scene);

/// Of every body, origin and axis at time t: four numbers each.
std::vector<double> poses_of(const Scene& scene, double t);

}  // namespace taut::web
