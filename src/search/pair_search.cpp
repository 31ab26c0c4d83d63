#include "search/pair_search.hpp"

namespace taut {
namespace {

using spacetime::Hierarchy;

/// Made once, and kept with the body.
const Hierarchy& tree_of(const RingSet& rings, bool inwards) {
  const SharedPolygon& displaced = rings.displaced(inwards);
  return rings.kept<Hierarchy>(inwards, [&] { return std::make_shared<const Hierarchy>(*displaced); });
}

}  // namespace

PairSearch::PairSearch(const WorldPlan& world, int a, int b, bool inwards)
    : plan(world.pair(a, b)),
      geometry(displaced_pair(plan, inwards)),
      legs(world.legs(plan)),
      tree_p(tree_of(*plan.rings[0], inwards)),
      tree_q(tree_of(*plan.rings[1], inwards)) {}

}  // namespace taut
