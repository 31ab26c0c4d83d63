// A scene as stretches of time on which both motions are analytic, and bridges between them.
#pragma once

#include <vector>

#include "support/exact_leg.hpp"

namespace taut::testing::exact {

/// In order of time. Throws Beyond if a cosine exceeds 1.
std::vector<Leg> stretches(const Scene& scene);

}  // namespace taut::testing::exact
