// How close do bodies come?
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "taut/check.hpp"

namespace taut {

/// Where two bodies are nearest to each other, as far as was found.
struct NearestPoints {
  std::array<BodyId, 2> pair{};    ///< in the order of the scene
  double lo = 0, hi = 0;           ///< certainly encloses the least distance of the pair's closures over all time
  TimeInterval time;               ///< in it the distance is at most `hi`
  std::array<Point, 2> points{};   ///< one on each body, in the pair's order; world coordinates, rounded
  std::array<EdgeRef, 2> edges{};  ///< on which the points lie
};

/// The answer of clearance().
struct Clearance {
  /// Of the pair that comes closest. Absent if no pair is asked about, or if nothing could be decided.
  std::optional<NearestPoints> nearest;
  /// With `all_pairs`: of every pair that was asked about, in the order of the scene.
  std::vector<NearestPoints> pairs;
  std::string reason;  ///< why it is not decided; empty otherwise
  Coverage coverage;
};

/// How precise the bracket is to be.
struct ClearanceOptions {
  /// hi - lo <= relative * hi + 1e-12 of the largest coordinate, as far as doubles tell: bodies that come closer than
  /// about 1e-4 of the scene's size may have a bracket some times wider. At least 1e-12.
  double relative = 1e-9;
  bool all_pairs = false;
  double max_seconds = 1e300;
  const std::atomic<bool>* stop = nullptr;
};

/// The least distance of the closures of any two bodies that are asked about, over the scene's time: 0 if they touch or
/// overlap. The bracket is certain, by branch and bound over time and pairs of boxes with certified bounds; instants in
/// between are in it as well. Throws InputError.
Clearance clearance(const Scene& scene, const ClearanceOptions& options = {});

}  // namespace taut
