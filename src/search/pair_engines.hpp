// Who answers for the pairs of a world?
#pragma once

#include <memory>

#include "search/kinetic_pair.hpp"
#include "taut/check.hpp"

namespace taut {

/// The two bodies with that engine, with both, or with both in turn. What is given must outlive it.
std::unique_ptr<WindowedPair> windowed_pair(EngineChoice engine, const WorldPlan& world, int a, int b, bool inwards,
                                            EventBudget& budget);

}  // namespace taut
