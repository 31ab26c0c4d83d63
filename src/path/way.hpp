// Ways through the space of joint values: proved, and with as few waypoints as are easily found.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "path/joint_space.hpp"

namespace taut::internal::path {

/// Who collides, where all joints keep these values.
struct StillCollision {
  std::optional<std::array<BodyId, 2>> pair;
  bool undecided = false;
  std::string reason;
};

/// As path_scene(), but for what is ignored if nothing moves.
Scene scene_along(const PathProblem& problem, const std::vector<JointValues>& waypoints);
void ignore_pairs(Scene& scene, const std::vector<std::array<BodyId, 2>>& pairs);

class WayChecker {
 public:
  WayChecker(const PathProblem& problem, const JointSpace& space, const PathOptions& options);

  /// Nothing if the bodies are free at these values, by the engines of check().
  std::optional<StillCollision> collision_at(const JointValues& values) const;
  /// Proves each instant of the way by the engines of check().
  bool proves(const std::vector<JointValues>& way) const;
  /// Are all instants between two combinations free? Fast, in doubles; near contacts by the engines of check().
  bool passes(const JointValues& a, const JointValues& b, bool exactly) const;
  /// Fewer waypoints, by segments that pass.
  std::vector<JointValues> shortened(const std::vector<JointValues>& way) const;

 private:
  Scene scene_of(const std::vector<JointValues>& way) const;
  CheckOptions check_options() const;

  const PathProblem& problem_;
  const JointSpace& space_;
  const PathOptions& options_;
};

}  // namespace taut::internal::path
