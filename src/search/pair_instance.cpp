#include "search/pair_instance.hpp"

#include <utility>

namespace taut::internal {

using spacetime::Hierarchy;

const Hierarchy& tree_of(const RingSet& rings, Offset offset) {
  const SharedPolygon& displaced = rings.displaced(offset);
  return rings.kept<Hierarchy>(offset, [&] { return std::make_shared<const Hierarchy>(*displaced); });
}

PairInstance::PairInstance(PairPlan pair, SharedSegments all_segments, Offset offset)
    : plan(std::move(pair)),
      geometry(displaced_pair(plan, offset)),
      shared_segments(std::move(all_segments)),
      tree_p(tree_of(*plan.rings[0], offset)),
      tree_q(tree_of(*plan.rings[1], offset)) {}

PairInstance::PairInstance(const WorldPlan& world, int a, int b, Offset offset)
    : plan(world.pair(a, b)),
      geometry(displaced_pair(plan, offset)),
      shared_segments(std::make_shared<const MotionSegments>(world.segments(plan))),
      tree_p(tree_of(*plan.rings[0], offset)),
      tree_q(tree_of(*plan.rings[1], offset)) {}

}  // namespace taut::internal
