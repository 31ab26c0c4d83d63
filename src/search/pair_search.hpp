// A pair of a world, with what the spacetime engine needs of it.
#pragma once

#include <vector>

#include "spacetime/first_contact.hpp"
#include "world/world_plan.hpp"

namespace taut {

struct PairSearch {
  /// Throws InputError where a body has features that are finer than the displacement.
  PairSearch(const WorldPlan& world, int a, int b, bool inwards);

  spacetime::TreePair trees() const { return {tree_p, tree_q}; }

  PairPlan plan;
  PairGeometry geometry;
  std::vector<Leg> legs;
  const spacetime::Hierarchy &tree_p, &tree_q;
};

}  // namespace taut
