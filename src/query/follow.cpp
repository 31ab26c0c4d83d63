#include "taut/follow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "motion/degrees.hpp"
#include "numeric/progress.hpp"
#include "solver/run.hpp"
#include "taut/error.hpp"
#include "taut/pose.hpp"

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
  if (instants < 1 || instants > 1000000)
    throw InputError("instants", "they are not 1 to 1000000", "360, for instance");
  if (!(reach > 0)) throw InputError("reach", "it is not positive", "give a height at which the follower is free");
}

/// Of length 1 to a rounding or two, for which heights have room.
Point unit_vector(const Point& d) {
  const double length = std::hypot(d.x, d.y);
  if (!(length > 0) || !std::isfinite(length))
    throw InputError("direction", "it is no direction", "give a vector that is not (0, 0)");
  return {d.x / length, d.y / length};
}

/// The height at an instant of the way down, with room for rounding, here and in the way itself.
std::array<double, 2> height(double reach, double from, double speed, const TimeInterval& time, const Point& place) {
  const double room = 0x1p-50 * (reach + std::fabs(place.x) + std::fabs(place.y));
  return {reach - speed * (time.hi - from) - room, reach - speed * (time.lo - from) + room};
}

}  // namespace

std::vector<Lift> follow(const Scene& scene, BodyId follower, Point along, double reach, const FollowOptions& given) {
  check_follower(scene, follower, reach, given.instants);
  const Point direction = unit_vector(along);
  const std::size_t instants = given.instants;
  const auto began = std::chrono::steady_clock::now();
  Scene drop = coming_down(scene, follower);
  Body& body = drop.bodies[static_cast<std::size_t>(follower)];
  const BodyPose at = pose_at(body.motion, scene.start);
  CheckOptions options;
  options.touch = given.touch;
  options.limits = given.limits;
  options.tell_touching = false;
  std::vector<Lift> lifts;
  const auto boundary = [&](std::size_t k) {
    return k == instants
               ? scene.end
               : scene.start + (scene.end - scene.start) * static_cast<double>(k) / static_cast<double>(instants);
  };
  for (std::size_t k = 0; k < instants; ++k) {
    drop.start = boundary(k);
    drop.end = boundary(k + 1);
    const double speed = reach / (drop.end - drop.start);
    MotionPiece piece;
    piece.origin = drop.start;
    piece.x = {at.origin.x + reach * direction.x, -speed * direction.x};
    piece.y = {at.origin.y + reach * direction.y, -speed * direction.y};
    if (at.axis.x != 1 || at.axis.y != 0) piece.rotation = AngleRotation{{std::atan2(at.axis.y, at.axis.x)}};
    body.motion = {{piece}};
    report_parts("instants", k, instants);
    options.limits.max_seconds = time_left(given.limits.max_seconds, began);
    const Answer answer = check(drop, options);
    if (answer.outcome == Outcome::undecided) throw UndecidedError(answer.reason);
    if (answer.outcome == Outcome::overlap_at_start)
      throw InputError("reach", fmt::format("at t = {}, the follower overlaps another body there", drop.start),
                       "give a height at which it is free at all times");
    if (!answer.contact) continue;
    lifts.push_back({answer.contact->time, height(reach, drop.start, speed, answer.contact->time, at.origin),
                     answer.contact->vertex, answer.contact->edge});
  }
  return lifts;
}

Point direction_of(double degrees) {
  Series<double, 0> sine, cosine;
  sin_cos_degrees(Series<double, 0>::constant(degrees), sine, cosine);
  return {cosine.c[0].mid, sine.c[0].mid};
}

}  // namespace taut
