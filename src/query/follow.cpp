#include "taut/follow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "motion/degrees.hpp"
#include "numeric/progress.hpp"
#include "solver/run.hpp"
#include "taut/error.hpp"

namespace taut {
using namespace internal;
namespace {

/// All other bodies are the cam: they are not tested against each other.
Scene coming_down(const Scene& scene, BodyId follower) {
  Scene drop = scene;
  const std::string& name = scene.bodies[static_cast<std::size_t>(follower)].name;
  for (std::size_t a = 0; a < scene.bodies.size(); ++a) {
    for (std::size_t b = a + 1; b < scene.bodies.size(); ++b) {
      const std::string &first = scene.bodies[a].name, &second = scene.bodies[b].name;
      if (first != name && second != name) drop.ignore.push_back({first, second});
    }
  }
  return drop;
}

void check_follower(const Scene& scene, BodyId follower, double reach, std::size_t instants) {
  const auto count = static_cast<BodyId>(scene.bodies.size());
  if (follower < 0 || follower >= count)
    throw InputError("follower", "there is no body " + std::to_string(follower),
                     "bodies are 0 to " + std::to_string(count - 1));
  const Body& body = scene.bodies[static_cast<std::size_t>(follower)];
  if (!body.motion.pieces.empty())
    throw InputError("follower", "\"" + body.name + "\" has a motion of its own",
                     "leave it out: the cam moves it; draw it where its lift is 0");
  if (instants < 1 || instants > 1000000)
    throw InputError("instants", "they are not 1 to 1000000", "360, for instance");
  if (!(reach > 0 && std::isfinite(reach)))
    throw InputError("reach", "it is not a positive number", "give a lift at which the follower is free");
}

/// The other pairs, all of which are ignored, are no part of the question.
Coverage of_follower(const Coverage& all, std::size_t bodies) {
  Coverage own = all;
  own.pairs = bodies - 1;
  own.ignored -= all.pairs - own.pairs;
  return own;
}

/// Of length 1 to a rounding or two, for which heights have room.
Point unit_vector(const Point& d) {
  const double length = std::sqrt(d.x * d.x + d.y * d.y);
  if (!(length > 0) || !std::isfinite(length))
    throw InputError("direction", "it is no direction", "give a vector that is not (0, 0)");
  return {d.x / length, d.y / length};
}

/// The lift at an instant of the way down, with room for rounding, here and in the way itself.
std::array<double, 2> lift_at(double reach, double from, double speed, const TimeInterval& time) {
  const double room = 0x1p-50 * reach;
  return {reach - speed * (time.hi - from) - room, reach - speed * (time.lo - from) + room};
}

}  // namespace

FollowAnswer follow(const Scene& scene, BodyId follower, Point along, double reach, const FollowOptions& given) {
  check_follower(scene, follower, reach, given.instants);
  const Point direction = unit_vector(along);
  const auto began = std::chrono::steady_clock::now();
  Scene drop = coming_down(scene, follower);
  CheckOptions options;
  options.touch = given.touch;
  options.limits = given.limits;
  options.tell_touching = false;
  FollowAnswer answer;
  const auto boundary = [&](std::size_t k) {
    const double share = static_cast<double>(k) / static_cast<double>(given.instants);
    return k == given.instants ? scene.end : scene.start + (scene.end - scene.start) * share;
  };
  for (std::size_t k = 0; k < given.instants; ++k) {
    drop.start = boundary(k);
    drop.end = boundary(k + 1);
    const double speed = reach / (drop.end - drop.start);
    MotionPiece piece;
    piece.origin = drop.start;
    piece.x = {reach * direction.x, -speed * direction.x};
    piece.y = {reach * direction.y, -speed * direction.y};
    drop.bodies[static_cast<std::size_t>(follower)].motion = {{piece}};
    report_parts("instants", k, given.instants);
    options.limits.max_seconds = time_left(given.limits.max_seconds, began);
    const Answer down = check(drop, options);
    if (down.outcome == Outcome::untested)
      throw InputError("follower", "nothing was tested: no pair of bodies with it is asked about",
                       "see \"ignore\", and the bodies' layers");
    if (down.outcome == Outcome::undecided) throw UndecidedError(down.reason);
    if (down.outcome == Outcome::overlap_at_start)
      throw InputError("reach", fmt::format("at t = {}, the follower overlaps another body there", drop.start),
                       "give a lift at which it is free at all times");
    const Coverage own = of_follower(down.coverage, scene.bodies.size());
    if (own.tested >= answer.coverage.tested) answer.coverage = own;
    if (down.geometry && (!answer.geometry || down.geometry->tolerance > answer.geometry->tolerance))
      answer.geometry = down.geometry;
    if (!down.contact) continue;
    answer.lifts.push_back({down.contact->time, lift_at(reach, drop.start, speed, down.contact->time),
                            down.contact->vertex, down.contact->edge});
  }
  return answer;
}

Point direction_of(double degrees) {
  Series<double, 0> sine, cosine;
  sin_cos_degrees(Series<double, 0>::constant(degrees), sine, cosine);
  return {cosine.c[0].mid, sine.c[0].mid};
}

}  // namespace taut
