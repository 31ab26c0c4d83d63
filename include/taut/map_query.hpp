// What a planner asks, a hundred thousand times a second: may a robot be here, may it go from here to there?
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "taut/static_map.hpp"

namespace taut {

/// Turned counterclockwise by `angle` radians about its origin, then moved by (x, y).
struct PoseSE2 {
  double x = 0, y = 0, angle = 0;
};

/// A robot's link among those of its chain.
struct RobotLink {
  StaticMap::Mover shape;
  /// The link in whose frame this one moves, which comes before it; -1: the world's.
  int parent = -1;
};

/// How to ask.
struct MapQueryOptions {
  Touch touch = Touch::open;
  /// Do links meet each other, too? Links and their parents never do: they share a joint.
  bool links_meet = true;
  Limits limits = {};
};

/// Answers without names and text, for many of them.
struct MapFinding {
  /// `overlap_at_start` also where the robot, with closed touching, touches at the start. `untested` if no link shares
  /// a layer with a body of the map, or with another link that it may meet.
  Outcome outcome = Outcome::free;
  /// Certainly no collision before this time; of MapQuery::passes(), which does not search for the first one, just some
  /// such time.
  double free_until = 0;
  /// Of a contact, which certainly happens by this time; else the end of the time that was asked about.
  double contact_by = 0;
  /// Which link collides, or is undecided; -1 if free.
  int link = -1;
  /// With which body of the map, or with which other link; -1 where it is not that, or not known.
  BodyId body = -1;
  int other_link = -1;

  /// Proved to be free.
  bool free() const { return outcome == Outcome::free; }
};

/// Questions of one robot to one map, with the memory that they take: one for each thread. Answers are as certain as
/// those of StaticMap::check(), and the same up to the last bits of a contact's enclosure. Motions along lines with
/// even turns, about the body's origin or about any pivot, single or in chains, take a short way: where nothing is
/// near, a fraction of a microsecond, and nothing is allocated. All others are answered, too.
///
///     MapQuery query(map, map.prepare(robot));
///     if (query.at({3, 4, 0.5}).free() && query.passes({3, 4, 0.5}, {5, 4, 1.5}).free()) ...
class MapQuery {
 public:
  /// One body. Prepares all bodies of the map that were not yet. Throws InputError where a feature is finer than the
  /// displacement (see StaticMap), or a mover is not this map's.
  MapQuery(const StaticMap& map, const StaticMap::Mover& robot, const MapQueryOptions& options = {});
  /// A chain or a tree of links, each after its parent. Throws InputError also where it is not.
  MapQuery(const StaticMap& map, const std::vector<RobotLink>& links, const MapQueryOptions& options = {});
  ~MapQuery();
  /// Nothing may be asked of the one that was moved from.
  MapQuery(MapQuery&&) noexcept;
  /// Nothing may be asked of the one that was moved from.
  MapQuery& operator=(MapQuery&&) noexcept;

  /// May the robot be here? The pose of a robot of one body; `free_until` is 0. Throws InputError if a number is not
  /// finite, or beyond 2^400.
  MapFinding at(const PoseSE2& pose) { return at(std::span(&pose, 1)); }
  /// Of each link, seen from its parent.
  MapFinding at(std::span<const PoseSE2> poses);

  /// The first collision on the straight way: x = from.x + t (to.x - from.x), the same for y and the angle, t from 0 to
  /// 1. What is decided exactly is the motion with those two coefficients, the difference rounded to a double. It does
  /// not wrap angles: from 3 to -3 is a turn by -6.
  MapFinding along(const PoseSE2& from, const PoseSE2& to) { return along(std::span(&from, 1), std::span(&to, 1)); }
  /// The same for each link, seen from its parent.
  MapFinding along(std::span<const PoseSE2> from, std::span<const PoseSE2> to);
  /// The first collision of links that move as given, each seen from its parent, on [start, end]. Throws
  /// InputError if a motion is not valid there.
  MapFinding along(std::span<const Motion> motions, double start, double end);

  /// Is it free? The same without searching for the first collision, which is cheaper where there is one: a
  /// few places on the path are tested first.
  MapFinding passes(const PoseSE2& from, const PoseSE2& to) { return passes(std::span(&from, 1), std::span(&to, 1)); }
  /// The same for each link, seen from its parent.
  MapFinding passes(std::span<const PoseSE2> from, std::span<const PoseSE2> to);
  /// The same for motions, as along() takes them.
  MapFinding passes(std::span<const Motion> motions, double start, double end);

  /// Why the last answer was `undecided` or `untested`.
  const std::string& reason() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace taut
