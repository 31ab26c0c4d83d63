// Where the bodies are along a way, as a scene with time.
#include <algorithm>
#include <limits>

#include "joints/linked_pairs.hpp"
#include "path/way.hpp"
#include "scene/linkage.hpp"
#include "taut/motions.hpp"
#include "taut/path.hpp"

namespace taut {
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
