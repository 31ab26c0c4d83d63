// Is an answer true? In the words of the oracle by definition.
#pragma once

#include <string>

#include "support/exact_oracle.hpp"
#include "taut/check.hpp"

namespace taut::testing::exact {

/// What is wrong with the answer; empty if nothing is. The answer is about bodies displaced by a hair's breadth, and
/// its time may differ from the exact one by what this moves a zero of that multiplicity, no more. What is undecided,
/// or beyond the oracle, is not wrong.
std::string difference(const ExactAnswer& exact, const Answer& answer, const Scene& scene, Touch touch);

}  // namespace taut::testing::exact
