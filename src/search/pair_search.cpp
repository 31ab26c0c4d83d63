#include "search/pair_search.hpp"

#include <utility>

namespace taut {

using spacetime::Hierarchy;

const Hierarchy& tree_of(const RingSet& rings, bool inwards) {
  const SharedPolygon& displaced = rings.displaced(inwards);
  return rings.kept<Hierarchy>(inwards, [&] { return std::make_shared<const Hierarchy>(*displaced); });
}

PairSearch::PairSearch(PairPlan pair, SharedLegs all_legs, bool inwards)
    : plan(std::move(pair)),
      geometry(displaced_pair(plan, inwards)),
      shared_legs(std::move(all_legs)),
      tree_p(tree_of(*plan.rings[0], inwards)),
      tree_q(tree_of(*plan.rings[1], inwards)) {}

PairSearch::PairSearch(const WorldPlan& world, int a, int b, bool inwards)
    : PairSearch(world.pair(a, b), std::make_shared<const Legs>(world.legs(world.pair(a, b))), inwards) {}

}  // namespace taut
