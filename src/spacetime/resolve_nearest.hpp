// Resolves the minimum distance of two bodies by roots of any precision where doubles do not decide.
#pragma once

#include <string>

#include "spacetime/clearance.hpp"
#include "taut/check.hpp"

namespace taut::internal::spacetime {

/// Closes the gap that find_nearest() may have left. Whether the bodies keep a margin is decided at any precision, so
/// queries with margins between the certain lower bound and the least distance found bring the two together. The search
/// is within a window, at whose start the bodies must not overlap. Afterwards best.unresolved is infinite, or the
/// search for a margin was not decided, and the reason is returned.
std::string resolve_nearest(const PairGeometry& geometry, const TreePair& trees, const MotionSegments& segments,
                            const TimeInterval& window, const ClearanceTolerance& tolerance, Nearest& best);

}  // namespace taut::internal::spacetime
