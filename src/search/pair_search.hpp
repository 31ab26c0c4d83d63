// A pair of a world, with what the spacetime engine needs of it.
#pragma once

#include <memory>
#include <vector>

#include "spacetime/first_contact.hpp"
#include "world/world_plan.hpp"

namespace taut {

using SharedLegs = std::shared_ptr<const Legs>;

/// Made once, and kept with the body.
const spacetime::Hierarchy& tree_of(const RingSet& rings, bool inwards);

struct PairSearch {
  /// Throws InputError where a body has features that are finer than the displacement.
  PairSearch(PairPlan pair, SharedLegs all_legs, bool inwards);
  PairSearch(const WorldPlan& world, int a, int b, bool inwards);

  spacetime::TreePair trees() const { return {tree_p, tree_q}; }
  const Legs& legs() const { return *shared_legs; }

  PairPlan plan;
  PairGeometry geometry;
  SharedLegs shared_legs;
  const spacetime::Hierarchy &tree_p, &tree_q;
};

}  // namespace taut
