// One body against many that rest: a map, prepared once and asked often.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "taut/check.hpp"

namespace taut {

struct OccupancyGrid;

/// Bodies at rest, prepared for questions about bodies that move among them: a floor plan, a city, the obstacles of a
/// planner. Copies share everything; maps and what is prepared for them are safe to share between threads.
///
/// A question answers as check() does about the scene of the map's bodies, in their order, and the moving body after
/// them: first contact, witness, enclosures, `free` as a proof, all of it the same, without testing what is far
/// away.
///
///     const StaticMap map(obstacles);
///     const StaticMap::Mover robot = map.prepare(body);
///     const Answer answer = map.check(robot, from_keyframes(path), 0, 10);
class StaticMap {
 public:
  /// At least one body, so that there is something to test. Bodies must rest in the world's frame: no motion, no
  /// parent. `reach`: shapes of movers may have coordinates of their own up to this magnitude; those of the map may
  /// always. Each body is validated as in a scene, and prepared when first needed: O(n log n) in its vertices. Throws
  /// InputError.
  explicit StaticMap(std::vector<Body> bodies, double reach = 0);

  /// The occupied cells of a grid, as grid_bodies() of taut/grid.hpp makes bodies of them; read_grid() there reads the
  /// maps of ROS's map_server. Throws InputError.
  static StaticMap from_grid(const OccupancyGrid& grid, double reach = 0);
  /// The same of a map's YAML file, read by read_grid(): what is not known to be free is an obstacle.
  static StaticMap from_grid(const std::string& yaml_file, double reach = 0);

  /// How many bodies there are.
  std::size_t size() const;
  /// One of them.
  const Body& body(BodyId id) const;

  class Mover;
  /// The body's shape, as validate() takes it; its motion and its parent are ignored. O(n log n), once. Throws
  /// InputError, also where its coordinates are beyond the map's reach.
  Mover prepare(const Body& body) const;

  /// Does the mover, on this motion, first meet anything on [start, end], what, and when? In the answer, bodies are
  /// those of the map by their indices, and size() is the mover; `coverage` counts pairs of the mover and a body of the
  /// map. CheckOptions::engine does not matter: it is always the spacetime engine. Throws InputError if the motion is
  /// not valid on [start, end].
  Answer check(const Mover& mover, const Motion& motion, double start, double end,
               const CheckOptions& options = {}) const;

  /// A body of the map that the mover overlaps, or with `closed` touching touches, where its motion has it at time t;
  /// of several, the first. Decided exactly. Throws InputError if the motion is not valid there, and UndecidedError
  /// where the highest precision does not decide.
  std::optional<BodyId> overlapped(const Mover& mover, const Motion& motion, double t, Touch touch = Touch::open) const;

  struct Impl;

 private:
  friend class MapQuery;
  std::shared_ptr<const Impl> impl_;
};

/// A shape that moves among the bodies of a map: what StaticMap::prepare() returns.
class StaticMap::Mover {
 public:
  /// That of the body that it was made of.
  const std::string& name() const;

  struct Impl;

 private:
  friend class StaticMap;
  friend class MapQuery;
  explicit Mover(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
  std::shared_ptr<const Impl> impl_;
};

}  // namespace taut
