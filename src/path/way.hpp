// Ways through the space of joint values: how long they are, and proved, with as few waypoints as are easily found.
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

// How long ways between joint values are.

/// A box of joint values.
struct ValueBox {
  JointValues lo{}, hi{};

  static ValueBox of(const JointValues& point) { return {point, point}; }
};

/// The square root of the sum of (weight times difference)^2 over all joints. A joint's weight is the speed of the
/// fastest vertex of any body at the start, if that joint alone moves at speed 1.
class JointMetric {
 public:
  JointMetric(const PathProblem& problem, const JointSpace& space);

  const JointValues& weights() const { return weights_; }
  /// The length of a straight segment, rounded up.
  double length(const JointValues& a, const JointValues& b) const;
  double length(const std::vector<JointValues>& way) const;
  /// Bounds the length of any segment between two boxes from below, though the boxes be rounded to doubles.
  double least(const ValueBox& a, const ValueBox& b) const;

 private:
  JointValues weights_{}, rounding_{};
  std::size_t dimension_;
};

}  // namespace taut::internal::path
