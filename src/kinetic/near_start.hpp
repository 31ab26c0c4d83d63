// The tiling at the start of one query, derived from that of the previous query about the same two shapes.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "kinetic/engine.hpp"
#include "pair/pair_plan.hpp"

namespace taut::internal {

/// If the bodies have moved only a little since the last query, the tiling is nearly the same. The remaining work is
/// that of an engine: it moves straight from the last placement to the new one, over a bridge, and repairs what
/// changes. As the tiling depends on the placement alone, the result is the one that building would give. If there is a
/// contact on the path, or more to repair than building would cost, the attempt is abandoned and the tiling is built.
class NearStart {
 public:
  /// An engine at the start of these segments, with its counters at zero, as if it had been built there. Null if the
  /// tiling must be built.
  std::unique_ptr<Engine> engine(const PairGeometry& geometry, const MotionSegments& segments);
  /// Stores the tiling of an engine that is at the start of its segments. The shapes are those of the plan. If the
  /// tiling was built, `work_of_building` is the work spent on it; later moves from here are limited by that.
  void note(const Engine& engine, const PairPlan& plan, std::optional<std::uint64_t> work_of_building);

 private:
  struct Last {
    PairGeometry geometry;
    std::array<std::shared_ptr<const PreparedShape>, 2> shapes;  ///< the map reads data that is stored with them
    PlanarMap map;
    std::shared_ptr<const MotionSegment> segment;  ///< the segment of the stored placement,
    double time;                                   ///< and its time
  };
  std::unique_ptr<Engine> moved(const PairGeometry& geometry, const MotionSegment& to) const;

  std::optional<Last> last_;
  std::uint64_t work_of_building_ = 0;
  /// The number of consecutive failed moves, and the number of queries to build before the next attempt.
  int failures_ = 0, skip_ = 0;
};

}  // namespace taut::internal
