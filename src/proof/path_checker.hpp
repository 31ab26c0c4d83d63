// Does a body collide with another one for all values of a cell, as a log about paths says?
#pragma once

#include <optional>
#include <vector>

#include "proof/path_bodies.hpp"
#include "proof/path_cell.hpp"
#include "proof/path_log.hpp"

namespace taut::internal::proof {

class PathChecker {
 public:
  /// The problem must be valid, and outlive this.
  PathChecker(const PathProblem& problem, double clearance);

  /// Is what a claim says of a cell proved? An open cell claims nothing, and is.
  bool holds(const PathClaim& claim, const PathCell& cell) const;
  /// May the goal be in the cell?
  bool may_be_goal(const PathCell& cell) const;
  bool may_be_start(const PathCell& cell) const;

 private:
  using Segment = std::array<Point, 2>;
  struct EdgeOfPart {
    Segment ends;
    Layers z;
  };

  /// The edge, or the one that begins at the vertex.
  std::optional<EdgeOfPart> edge(const PathFeature& feature) const;
  /// The pose of one body seen from another one.
  CellPose seen(const CellValues& values, std::uint32_t from, std::uint32_t body) const;
  CellPose pose(const CellValues& values, const std::vector<int>& chain) const;
  /// Of the four ends, how far each is to the left of the other edge, times that one's length.
  std::optional<std::array<CellFunction, 4>> sides(const CellValues& values, const PathCrossing& crossing) const;
  bool crosses(const CellValues& values, const PathCrossing& crossing) const;
  bool exclude_each_other(const CellValues& values, const std::vector<PathCrossing>& crossings) const;
  static bool holds_point(const PartShape& part, const Point& p, bool strictly);
  static bool is_beyond(const CellValues& values, const CellPoint& at, const Point& middle, const Segment& edge,
                        const Point& n);
  bool stays_inside(const CellValues& values, const PathClaim& claim) const;
  static bool stays_inside(const CellValues& values, const CellPoint& at, const PartShape& part);
  bool stays_near(const CellValues& values, const PathClaim& claim) const;
  bool may_be_outside(const CellValues& values) const;

  const PathProblem& problem_;
  double clearance_;
  PathBodies bodies_;
};

}  // namespace taut::internal::proof
