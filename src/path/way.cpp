#include "path/way.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "joints/linked_pairs.hpp"
#include "scene/linkage.hpp"
#include "taut/clearance.hpp"
#include "taut/motions.hpp"
#include "taut/path.hpp"

namespace taut::internal::path {

WayChecker::WayChecker(const PathProblem& problem, const JointSpace& space, const PathOptions& options)
    : problem_(problem), space_(space), options_(options) {}

/// Pairs that no joint moves against each other are no part of the question, but for those that were tested; all others
/// are tested, also if nothing moves them on this way.
Scene WayChecker::scene_of(const std::vector<JointValues>& way) const {
  Scene scene = scene_along(problem_, way);
  ignore_pairs(scene, space_.pairs().fixed());
  scene.at_rest = AtRest::test;
  return scene;
}

CheckOptions WayChecker::check_options() const {
  CheckOptions options;
  options.touch = options_.clearance > 0 ? Touch::open : options_.touch;
  options.tell_touching = false;
  options.limits = options_.limits;
  return options;
}

std::optional<StillCollision> WayChecker::collision_at(const JointValues& values) const {
  const Scene scene = scene_of({values});
  const CheckOptions options = check_options();
  if (options_.clearance > 0) {
    const MarginAnswer answer = check_clearance(scene, options_.clearance, options);
    if (answer.outcome == Outcome::free) return std::nullopt;
    StillCollision found{{}, answer.outcome == Outcome::undecided, answer.reason};
    if (answer.first) found.pair = answer.first->bodies;
    return found;
  }
  const Answer answer = check(scene, options);
  if (answer.outcome == Outcome::free) return std::nullopt;
  return StillCollision{answer.pair, answer.outcome == Outcome::undecided, answer.reason};
}

bool WayChecker::proves(const std::vector<JointValues>& way) const {
  const Scene scene = scene_of(way);
  const CheckOptions options = check_options();
  if (options_.clearance > 0) {
    return check_clearance(scene, options_.clearance, options).outcome == Outcome::free;
  }
  return check(scene, options).outcome == Outcome::free;
}

bool WayChecker::passes(const JointValues& a, const JointValues& b, bool exactly) const {
  return space_.is_free(a, b) || (exactly && proves({a, b}));
}

std::vector<JointValues> WayChecker::shortened(const std::vector<JointValues>& way) const {
  std::vector<JointValues> kept = {way.front()};
  for (std::size_t i = 0; i + 1 < way.size();) {
    // By bisection, as if what passes farther passed nearer as well.
    std::size_t next = i + 1;
    for (std::size_t step = way.size(); step > 0; step /= 2) {
      const std::size_t tried = std::min(next + step, way.size() - 1);
      if (tried > next && passes(way[i], way[tried], false)) next = tried;
    }
    kept.push_back(way[next]);
    i = next;
  }
  return kept;
}

JointMetric::JointMetric(const PathProblem& problem, const JointSpace& space) : dimension_(space.dimension()) {
  const LinkedPairs& pairs = space.pairs();
  JointCell around{problem.start, {}};
  for (std::size_t k = 0; k < dimension_; ++k) {
    const Joint& joint = problem.linkage.joints[k];
    // The rates of a small cell are the derivatives at its middle, times this.
    around.half[k] = (joint.hi - joint.lo) * 0x1p-20;
    // Values are rounded where cells are halved, and where a period is added.
    rounding_[k] = 0x1p-46 * (std::fabs(joint.lo) + std::fabs(joint.hi));
  }
  const int n = static_cast<int>(problem.linkage.scene.bodies.size());
  for (int body = 0; body < n; ++body) {
    if (!pairs.moves(body)) continue;
    const PoseModel pose = pairs.pose(body, around);
    for (const int section : pairs.world().sections(body)) {
      const RingSet& rings = *pairs.world().bodies()[static_cast<std::size_t>(section)].rings;
      for (std::size_t ring = 0; ring < rings.rings().size(); ++ring) {
        for (const Point& p : rings.points(ring)) {
          const JointModel place = pose.place({p.x, p.y});
          for (std::size_t k = 0; k < dimension_; ++k) {
            if (!(around.half[k] > 0)) continue;
            const Vector& r = place.rate[k];
            weights_[k] = std::max(weights_[k], std::sqrt(dot(r, r)) / around.half[k] / pairs.scale());
          }
        }
      }
    }
  }
}

double JointMetric::length(const JointValues& a, const JointValues& b) const {
  double sum = 0;
  for (std::size_t k = 0; k < dimension_; ++k) {
    const double d = weights_[k] * (b[k] - a[k]);
    sum += d * d;
  }
  return std::sqrt(sum) * (1 + 0x1p-40);
}

double JointMetric::length(const std::vector<JointValues>& way) const {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < way.size(); ++i) sum += length(way[i], way[i + 1]);
  return sum * (1 + 0x1p-40);
}

double JointMetric::least(const ValueBox& a, const ValueBox& b) const {
  double sum = 0;
  for (std::size_t k = 0; k < dimension_; ++k) {
    const double gap = std::max(b.lo[k] - a.hi[k], a.lo[k] - b.hi[k]) - rounding_[k];
    if (!(gap > 0)) continue;
    const double d = weights_[k] * gap;
    sum += d * d;
  }
  return std::sqrt(sum) * (1 - 0x1p-40);
}

}  // namespace taut::internal::path

namespace taut {

// Where the bodies are along a way, as a scene with time.

using namespace internal;
namespace {

/// The driven joints of a mechanism move from waypoint to waypoint. Its links have neither motions nor parents yet.
void drive_along(const PathProblem& problem, const std::vector<JointValues>& waypoints, Scene& scene) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const auto& motion = problem.linkage.motions[i];
    if (motion && std::holds_alternative<LinkMotion>(motion->kind)) scene.bodies[i].relative_to.clear();
  }
  for (std::size_t k = 0; k < problem.linkage.joints.size(); ++k) {
    const std::string& name = problem.linkage.joints[k].name;
    if (!is_joint_of(*scene.mechanism, name)) continue;
    Drive drive{name, {}};
    for (std::size_t n = 1; n < waypoints.size(); ++n) {
      const auto t = static_cast<double>(n);
      drive.pieces.push_back({t, std::array<double, 4>{t - 1, waypoints[n - 1][k], t, waypoints[n][k]}, {}});
    }
    if (drive.pieces.empty()) {
      drive.pieces.emplace_back();
      drive.pieces.back().polynomial = {waypoints[0][k]};
    }
    drive.pieces.back().until = std::numeric_limits<double>::infinity();
    scene.mechanism->drives.push_back(std::move(drive));
  }
}

}  // namespace

Scene internal::path::scene_along(const PathProblem& problem, const std::vector<JointValues>& waypoints) {
  Scene scene = problem.linkage.scene;
  scene.start = 0;
  scene.end = static_cast<double>(waypoints.size()) - 1;
  if (scene.mechanism) drive_along(problem, waypoints, scene);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    scene.bodies[i].motion = {};
    if (i >= problem.linkage.motions.size() || !problem.linkage.motions[i]) continue;
    if (std::holds_alternative<LinkMotion>(problem.linkage.motions[i]->kind)) continue;
    std::vector<Keyframe> frames(waypoints.size());
    Point pivot;
    for (const JointMotion& motion : single_motions(*problem.linkage.motions[i])) {
      if (const auto* revolute = std::get_if<Revolute>(&motion.kind)) pivot = revolute->pivot;
      for (std::size_t n = 0; n < waypoints.size(); ++n) {
        const double value = motion.times * waypoints[n][static_cast<std::size_t>(motion.joint)] + motion.plus;
        frames[n].t = static_cast<double>(n);
        if (const auto* slide = std::get_if<Slide>(&motion.kind)) {
          frames[n].x += value * slide->direction.x;
          frames[n].y += value * slide->direction.y;
        } else {
          frames[n].angle_deg = value;
        }
      }
    }
    scene.bodies[i].motion = from_keyframes(frames, pivot);
  }
  return assembled(std::move(scene));
}

void internal::path::ignore_pairs(Scene& scene, const std::vector<std::array<BodyId, 2>>& pairs) {
  for (const auto& [a, b] : pairs)
    scene.ignore.push_back(
        {scene.bodies[static_cast<std::size_t>(a)].name, scene.bodies[static_cast<std::size_t>(b)].name});
}

/// Where nothing moves, check() tests all pairs. What no joint moves is not asked about here either.
Scene path_scene(const PathProblem& problem, const std::vector<JointValues>& waypoints) {
  Scene scene = internal::path::scene_along(problem, waypoints);
  const bool moves = std::any_of(waypoints.begin(), waypoints.end(),
                                 [&](const JointValues& values) { return values != waypoints.front(); });
  if (moves || scene.at_rest != AtRest::skip) return scene;
  const LinkedPairs pairs(problem.linkage);
  if (pairs.coverage().at_rest > 0) internal::path::ignore_pairs(scene, pairs.fixed());
  return scene;
}

}  // namespace taut
