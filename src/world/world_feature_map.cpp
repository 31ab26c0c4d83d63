#include "world/world_feature_map.hpp"

#include "pair/overlap_witness.hpp"

namespace taut::internal {

std::optional<Point> common_point(const WorldPlan& world, int a, int b) {
  const PairPlan plan = world.pair(a, b);
  const auto chain = [&](std::size_t side) {
    const auto body = static_cast<std::size_t>(plan.rings[side]->body());
    return pieces_at(world.bodies()[body].motions, world.start());
  };
  return common_point(plan, {chain(0), chain(1)}, world.segments(plan).front(), world.start());
}

}  // namespace taut::internal
