// A scene of more than two polygons, answered once: there is no tiling of it to be recorded.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "draw/world_shapes.hpp"
#include "scene/curved_world.hpp"
#include "taut/check.hpp"
#include "taut/scene.hpp"

namespace taut::web {
using namespace internal;

class World {
 public:
  /// Asks check(), for so many seconds at most: the page waits. Throws InputError.
  World(const Scene& scene, Touch touch, double max_seconds);

  const Scene& scene() const { return scene_; }
  const Answer& answer() const { return answer_; }
  Touch touch() const { return touch_; }
  /// The last instant of which something is known.
  double end() const;
  /// The bands of its curves, which decided; finer where they are far from what happens, so that they do not hide it.
  /// Null if there are none.
  const CurvedWorld* curves() const { return curves_ ? &*curves_ : nullptr; }
  /// The picture of an instant, marked if it is the last one; with the tilings of near pairs, if the proof is wanted.
  std::string picture(double t, bool proof) const;
  /// The tilings of the pairs that are near at t, up to the end: five numbers for each line, its ends in the world, and
  /// 1 if it joins two bodies. None where making them takes too long for a page that is drawn, and of curves.
  std::vector<double> tilings(double t) const;

 private:
  Scene scene_;
  Touch touch_;
  std::optional<CurvedWorld> curves_;
  Answer answer_;
  mutable std::optional<io::WorldShapes> shapes_;  ///< made when they are first asked for
};

/// For pictures on the page: {"order": bodies in the order of painting, "inner": for each body [x, y, room, part] of a
/// point deep inside it, in its own coordinates, "styles": [[fill, line, ink], ...], which come again after the last,
/// "joints": [[body, [x, y], direction of a slide], ...], each in the coordinates of the body that carries it}.
/// With `curves` also "bands": for each body, part and ring [width, [x, y, ...], [x, y, ...]], the walls of a band that
/// the curve is in, none of them farther than the width from the other; for each polygon [].
std::string shapes_text(const Scene& scene, const CurvedWorld* curves);

/// Of every body, origin and axis at time t: four numbers each.
std::vector<double> poses_of(const Scene& scene, double t);

}  // namespace taut::web
