#include "search/pair_instance.hpp"

#include <utility>

namespace taut::internal {

using spacetime::Hierarchy;

const Hierarchy& tree_of(const RingSet& rings, bool inwards) {
  const SharedPolygon& displaced = rings.displaced(inwards);
  return rings.kept<Hierarchy>(inwards, [&] { return std::make_shared<const Hierarchy>(*displaced); });
}

PairInstance::PairInstance(PairPlan pair, SharedSegments all_segments, bool inwards)
    : plan(std::move(pair)),
      geometry(displaced_pair(plan, inwards)),
      shared_segments(std::move(all_segments)),
      tree_p(tree_of(*plan.rings[0], inwards)),
      tree_q(tree_of(*plan.rings[1], inwards)) {}

PairInstance::PairInstance(const WorldPlan& world, int a, int b, bool inwards)
    : plan(world.pair(a, b)),
      geometry(displaced_pair(plan, inwards)),
      shared_segments(std::make_shared<const MotionSegments>(world.segments(plan))),
      tree_p(tree_of(*plan.rings[0], inwards)),
      tree_q(tree_of(*plan.rings[1], inwards)) {}

}  // namespace taut::internal
