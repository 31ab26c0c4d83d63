// Where doubles do not tell how close two bodies come, roots of any precision do.
#pragma once

#include <string>

#include "spacetime/clearance.hpp"
#include "taut/check.hpp"

namespace taut::internal::spacetime {

/// Closes the gap that find_nearest() may have left: whether the bodies keep a margin is decided at any precision, so
/// asking it for margins between what is certain from below and the least distance found brings the two together.
/// Within a window, at whose start the bodies must not overlap. Afterwards best.unresolved is infinite, or the search
/// for a margin was not decided: why is returned.
std::string resolve_nearest(const PairGeometry& geometry, const TreePair& trees, const MotionSegments& segments,
                            const TimeInterval& window, const ClearanceTolerance& tolerance, Nearest& best);

}  // namespace taut::internal::spacetime
