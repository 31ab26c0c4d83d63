// Does a closed polygon of displacements keep a start from its goal? The argument: docs/path-logs.md.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "proof/barrier.hpp"
#include "proof/path_bodies.hpp"

namespace taut::internal::proof {

/// How joints displace one body seen from another one: by `offset`, and by each joint's value times its vector.
struct RelativeSlide {
  ExactPlace offset;
  std::array<ExactPlace, max_joints> joint;
};

class BarrierChecker {
 public:
  /// The problem must be valid, and outlive this.
  explicit BarrierChecker(const PathProblem& problem) : problem_(problem), bodies_(problem) {}

  /// Throws ProofError unless no way leads from the start to the goal.
  void require(const Barrier& barrier) const;

 private:
  struct Frame;

  std::optional<RelativeSlide> slide_of(std::uint32_t body) const;
  RelativeSlide relative_slide(std::uint32_t body, std::uint32_t other) const;
  Frame frame_of(const Barrier& barrier) const;
  void require_collision(const Frame& frame, const Barrier& barrier, std::size_t edge) const;
  void require_outside(const Frame& frame, const Barrier& barrier, std::size_t edge) const;
  bool starts_in_goal(const Frame& frame) const;
  std::vector<ExactPlace> goal_region(const Frame& frame) const;
  void require_boxes_overlap(const Frame& frame, const Barrier& barrier) const;

  const PathProblem& problem_;
  PathBodies bodies_;
};

}  // namespace taut::internal::proof
