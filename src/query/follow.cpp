#include "taut/follow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "motion/degrees.hpp"
#include "numeric/budget.hpp"
#include "query/contact_sequence.hpp"
#include "scene/curved_world.hpp"
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

void check_follower(const Scene& scene, BodyId follower, double reach, const FollowOptions& options) {
  const auto count = static_cast<BodyId>(scene.bodies.size());
  if (follower < 0 || follower >= count)
    throw InputError("follower", "there is no body " + std::to_string(follower),
                     "bodies are 0 to " + std::to_string(count - 1));
  const Body& body = scene.bodies[static_cast<std::size_t>(follower)];
  if (!body.motion.pieces.empty())
    throw InputError("follower", "\"" + body.name + "\" has a motion of its own",
                     "leave it out: the cam moves it; draw it where its lift is 0");
  if (options.instants < 1 || options.instants > 1000000)
    throw InputError("instants", "they are not 1 to 1000000", "360, for instance");
  if (!(reach > 0 && std::isfinite(reach)))
    throw InputError("reach", "it is not a positive number", "give a lift at which the follower is free");
  if (!(options.tolerance >= 1e-13 && options.tolerance <= 1))
    throw InputError("tolerance", "it is not between 1e-13 and 1", "1e-9 of the scene's time is usual");
  if (options.contacts && has_curves(scene))
    throw InputError("contacts", "they are those of polygons, and there are curves",
                     "make polygons of them: taut flatten, with a tolerance");
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

/// The largest coordinate of polygons and places, about.
double extent_of(const Scene& scene, const std::vector<BodyPose>& poses) {
  double largest = 0;
  const auto include = [&largest](const Point& p) { largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)}); };
  for (const BodyPose& pose : poses) include(pose.origin);
  for (const Body& body : scene.bodies) {
    std::for_each(body.polygon.begin(), body.polygon.end(), include);
    for (const Part& part : body.parts) std::for_each(part.outline.begin(), part.outline.end(), include);
  }
  return largest;
}

class FollowerSearch {
 public:
  FollowerSearch(const Scene& scene, BodyId follower, const Point& direction, double reach, const FollowOptions& given)
      : scene_(scene),
        drop_(coming_down(scene, follower)),
        follower_(static_cast<std::size_t>(follower)),
        direction_(direction),
        reach_(reach),
        given_(given) {}

  FollowAnswer run() {
    answer_.coverage.pairs = answer_.coverage.not_reached = scene_.bodies.size() - 1;
    for (std::size_t k = 0; k < given_.instants; ++k) {
      report_parts("instants", k, given_.instants);
      try {
        search(boundary(k), boundary(k + 1));
      } catch (const UndecidedError& error) {
        const bool last = is_stopped();
        note_undecided({boundary(k), last ? scene_.end : boundary(k + 1)}, error.what());
        if (last) break;
      }
    }
    return std::move(answer_);
  }

 private:
  bool is_stopped() const {
    return (given_.limits.stop && *given_.limits.stop) || time_left(given_.limits.max_seconds, began_) <= 0;
  }
  void note_undecided(const TimeInterval& stretch, const char* reason) {
    std::vector<TimeInterval>& all = answer_.undecided;
    if (all.empty()) answer_.reason = reason;
    if (!all.empty() && all.back().hi == stretch.lo) {
      all.back().hi = stretch.hi;
    } else {
      all.push_back(stretch);
    }
  }

  double boundary(std::size_t k) const {
    const double share = static_cast<double>(k) / static_cast<double>(given_.instants);
    return k == given_.instants ? scene_.end : scene_.start + (scene_.end - scene_.start) * share;
  }

  Answer asked(const Scene& scene) const {
    CheckOptions options;
    options.touch = given_.touch;
    options.limits = given_.limits;
    options.limits.max_seconds = time_left(given_.limits.max_seconds, began_);
    options.tell_touching = false;
    Answer answer = check(scene, options);
    if (answer.outcome == Outcome::undecided) throw UndecidedError(answer.reason);
    return answer;
  }

  /// Comes down between the two instants. What passes over the follower meanwhile is met by one that comes down later,
  /// and faster.
  void search(double start, double end) {
    constexpr int most_tries = 8;
    constexpr double shorter = 0x1p-4;
    double share = 1;
    for (int tries = 0; tries < most_tries; ++tries, share *= shorter) {
      if (come_down(tries == 0 ? start : end - (end - start) * share, end)) return;
    }
    throw UndecidedError(fmt::format("near t = {}, something is above the follower wherever it comes down", end));
  }

  /// False if something is above it when it has come down.
  bool come_down(double start, double end) {
    drop_.start = start;
    drop_.end = end;
    const double speed = reach_ / (end - start);
    // In place of the last one, which is still there if that was not decided.
    drop_.bodies[follower_].motion.pieces.resize(1);
    MotionPiece& piece = drop_.bodies[follower_].motion.pieces.front();
    piece.origin = start;
    piece.x = {reach_ * direction_.x, -speed * direction_.x};
    piece.y = {reach_ * direction_.y, -speed * direction_.y};
    const Answer down = asked(drop_);
    if (down.outcome == Outcome::untested)
      throw InputError("follower", "nothing was tested: no pair of bodies with it is asked about",
                       "see \"ignore\", and the bodies' layers");
    if (down.outcome == Outcome::overlap_at_start)
      throw InputError("reach", fmt::format("at t = {}, the follower overlaps another body there", start),
                       "give a lift at which it is free at all times");
    if (!down.contact) {
      if (!is_clear_above({0, 0}, end)) return false;
    } else {
      const TimeInterval& time = down.contact->time;
      // With room for rounding, here and in the way itself.
      const double room = 0x1p-50 * reach_;
      const std::array<double, 2> lift{reach_ - speed * (time.hi - start) - room,
                                       reach_ - speed * (time.lo - start) + room};
      if (!rests_on(*down.contact) || !is_clear_above(lift, time.lo)) return false;
      answer_.lifts.push_back({time, lift, down.contact->vertex, down.contact->edge});
    }
    note(down);
    return true;
  }

  /// Is what it meets below it, and not beside it, or above it?
  bool rests_on(const Contact& contact) const {
    constexpr double least = 0x1p-20;
    const Point along = turned(poses_at(scene_, contact.time.lo)[follower_]);
    const double up = contact.normal.x * along.x + contact.normal.y * along.y;
    return (static_cast<std::size_t>(contact.edge.body) == follower_ ? -up : up) > least;
  }

  /// The direction, which its parent sees, in the world.
  Point turned(const BodyPose& at) const {
    return {at.axis.x * direction_.x - at.axis.y * direction_.y, at.axis.y * direction_.x + at.axis.x * direction_.y};
  }

  /// Is there room for the follower from `reach` down to shortly above the lift, while all else is held where it is at
  /// that instant, up to rounding?
  bool is_clear_above(const std::array<double, 2>& lift, double t) const {
    const std::vector<BodyPose> poses = poses_at(scene_, t);
    const double above = lift[1] + 4 * (lift[1] - lift[0]) + 0x1p-36 * (reach_ + extent_of(scene_, poses));
    if (!(above < reach_)) return true;
    Scene still = drop_;
    still.mechanism.reset();
    still.assembly.reset();
    still.lock.reset();
    still.start = 0;
    still.end = 1;
    for (std::size_t i = 0; i < still.bodies.size(); ++i) hold(still.bodies[i], poses[i], i == follower_ ? above : 0);
    const Outcome outcome = asked(still).outcome;
    return outcome == Outcome::free || outcome == Outcome::untested;
  }

  /// The body rests where it is, or comes down from `reach` to the lift `above`.
  void hold(Body& body, const BodyPose& at, double above) const {
    body.relative_to.clear();
    body.motion = {};
    if (above == 0 && at.origin == Point{0, 0} && at.axis == Point{1, 0}) return;
    const Point along = turned(at);
    MotionPiece& piece = body.motion.pieces.emplace_back();
    const double from = above > 0 ? reach_ : 0, way = above > 0 ? reach_ - above : 0;
    piece.x = {at.origin.x + from * along.x, -way * along.x};
    piece.y = {at.origin.y + from * along.y, -way * along.y};
    if (!(at.axis == Point{1, 0})) piece.rotation = AngleRotation{{std::atan2(at.axis.y, at.axis.x)}};
  }

  void note(const Answer& down) {
    const Coverage own = of_follower(down.coverage, scene_.bodies.size());
    if (own.tested >= answer_.coverage.tested) answer_.coverage = own;
    if (down.geometry && (!answer_.geometry || down.geometry->tolerance > answer_.geometry->tolerance))
      answer_.geometry = down.geometry;
  }

  const Scene& scene_;
  Scene drop_;
  std::size_t follower_;
  Point direction_;
  double reach_;
  const FollowOptions& given_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  FollowAnswer answer_;
};

/// Is the follower free at `reach` at all times? The reason, if that is not decided.
std::string why_not_free_at_reach(const Scene& scene, BodyId follower, const Point& unit, double reach,
                                  const CheckOptions& options) {
  Scene held = coming_down(scene, follower);
  MotionPiece& piece = held.bodies[static_cast<std::size_t>(follower)].motion.pieces.emplace_back();
  piece.x = {reach * unit.x};
  piece.y = {reach * unit.y};
  held.at_rest = AtRest::test;
  const Answer answer = check(held, options);
  if (answer.contact || answer.outcome == Outcome::overlap_at_start)
    throw InputError("reach",
                     fmt::format("at t = {}, the follower meets another body there",
                                 answer.contact ? answer.contact->time.lo : scene.start),
                     "for contacts, give a lift at which it is free at all times");
  return answer.outcome == Outcome::undecided ? answer.reason : std::string();
}

void find_contacts(const Scene& scene, BodyId follower, const Point& direction, double reach,
                   const FollowOptions& given, std::chrono::steady_clock::time_point began, FollowAnswer& answer) {
  CheckOptions options;
  options.touch = given.touch;
  options.limits = {time_left(given.limits.max_seconds, began), given.limits.stop};
  options.tell_touching = false;
  answer.contacts_reason = why_not_free_at_reach(scene, follower, unit_vector(direction), reach, options);
  if (!answer.contacts_reason.empty()) {
    answer.contacts = {{FollowState::open, {scene.start, scene.end}, {0, reach}, {}}};
    return;
  }
  const Limits left{time_left(given.limits.max_seconds, began), given.limits.stop};
  const Budget scope(left);
  answer.contacts = contact_sequence(
      Instance(scene), {follower, direction, reach, given.tolerance * (scene.end - scene.start), given.touch},
      answer.contacts_reason);
}

}  // namespace

FollowAnswer follow(const Scene& scene, BodyId follower, Point direction, double reach, const FollowOptions& options) {
  check_follower(scene, follower, reach, options);
  const Point unit = unit_vector(direction);
  const auto began = std::chrono::steady_clock::now();
  FollowAnswer answer = FollowerSearch(scene, follower, unit, reach, options).run();
  if (options.contacts) find_contacts(scene, follower, direction, reach, options, began, answer);
  return answer;
}

Point direction_of(double degrees) {
  Series<double, 0> sine, cosine;
  sin_cos_degrees(Series<double, 0>::constant(degrees), sine, cosine);
  return {cosine.c[0].mid, sine.c[0].mid};
}

}  // namespace taut
