// A scene as stretches of time on which both motions are analytic, and bridges between them.
#pragma once

#include <vector>

#include "support/exact_segment.hpp"

namespace taut::testing::exact {

/// In order of time. Throws Beyond if a cosine exceeds 1.
std::vector<MotionSegment> stretches(const Scene& scene);

}  // namespace taut::testing::exact
