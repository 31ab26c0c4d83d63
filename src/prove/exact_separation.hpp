// How the edges of two bodies are separated throughout a window: lines between ranges of edges.
#pragma once

#include <optional>
#include <vector>

#include "geometry/vector.hpp"
#include "prove/exact_scene.hpp"

namespace taut::internal {

/// A line between two ranges, or that one of them is halved.
struct ExactStep {
  enum class Kind { line, halve_first, halve_second };
  Kind kind = Kind::line;
  Vector normal{};
  double level = 0, slope = 0;  ///< the line is at level + slope * (time since the window's middle)
};

/// Two bodies in a window.
class ExactSeparation {
 public:
  ExactSeparation(const std::vector<ExactEdge>& first, const std::vector<ExactEdge>& second,
                  const LocalPlacement& first_place, const LocalPlacement& second_place, const LocalModels& models);

  /// The steps, in preorder. Nothing if some two edges were not separated: the window is too long, or they meet.
  std::optional<std::vector<ExactStep>> find();

 private:
  struct Side {
    const std::vector<ExactEdge>& edges;
    const LocalPlacement& place;
    std::vector<std::array<Vector, 2>> middle;  ///< the edges' ends in the middle of the window
    double reach = 0;                           ///< the largest magnitude of a coordinate
  };
  struct Range {
    std::size_t from, to;
    std::size_t size() const { return to - from; }
  };

  static Side side(const std::vector<ExactEdge>& edges, const LocalPlacement& place);
  bool separate(const Range& p, const Range& q);
  std::optional<ExactStep> line(const Range& p, const Range& q) const;
  std::optional<Vector> towards(const Range& p, const Range& q) const;
  bool holds(const ExactStep& line, const Range& p, const Range& q) const;
  static Vector farthest(const Side& side, const Range& range, Vector direction);
  static double extent(const Side& side, const Range& range);

  Side first_, second_;
  const LocalModels& models_;
  std::vector<ExactStep> steps_;
};

}  // namespace taut::internal
