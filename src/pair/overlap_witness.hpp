// Bodies that overlap already: a point that shows it.
#pragma once

#include <optional>

#include "pair/pair_plan.hpp"

namespace taut::internal {

/// A point that certainly lies inside both bodies at time t (not within a jump between two pieces), in world
/// coordinates and in the input's units. The bodies are those that were written, without the displacement. Nothing if
/// none was found: an overlap can be too thin for two doubles. Linear in the number of vertices, but where the overlap
/// is small beside the bodies.
std::optional<Point> common_point(const PairPlan& plan, double t);
/// The same of two bodies of rings, which follow these pieces at that time: of their parents, the outermost first, and
/// their own. The segment is the pair's, and not a bridge.
std::optional<Point> common_point(const PairPlan& plan, const std::array<PieceChain, 2>& chains,
                                  const MotionSegment& segment, double t);

}  // namespace taut::internal
