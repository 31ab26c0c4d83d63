// The tiling at the start of one question, from that of the last one about the same two shapes.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "kinetic/engine.hpp"
#include "pair/pair_plan.hpp"

namespace taut::internal {

/// Bodies that have moved but a little since the last question have nearly its tiling, and what is left to do is what
/// an engine does: it goes straight from the last placement to the new one, over a bridge, and repairs what changes. As
/// the tiling depends on the placement alone, that is the one that building would have made. Where there is a contact
/// on the way, or more to repair than building is worth, nothing has been gained, and it is built.
class NearStart {
 public:
  /// An engine at the start of these segments, with nothing counted, as if it had been built there; null where it has
  /// to be.
  std::unique_ptr<Engine> engine(const PairGeometry& geometry, const MotionSegments& segments);
  /// Keeps the tiling of an engine that is at the start of its segments. The shapes are those of the plan. If it was
  /// built, that took so much work: more is not spent on the way from here.
  void note(const Engine& engine, const PairPlan& plan, std::optional<std::uint64_t> work_of_building);

 private:
  struct Last {
    PairGeometry geometry;
    std::array<std::shared_ptr<const PreparedShape>, 2> shapes;  ///< the map reads what is kept with them
    PlanarMap map;
    std::shared_ptr<const MotionSegment> segment;  ///< on which it stands,
    double time;                                   ///< and when
  };
  std::unique_ptr<Engine> moved(const PairGeometry& geometry, const MotionSegment& to) const;

  std::optional<Last> last_;
  std::uint64_t work_of_building_ = 0;
  /// Ways that came to nothing, one after the other, and how many questions are built before the next one is tried.
  int failures_ = 0, skip_ = 0;
};

}  // namespace taut::internal
