// The tiling of a placement from the tilings of its two bodies.
#pragma once

#include <optional>

#include "tiling/shape_tiling.hpp"
#include "tiling/static_tiling.hpp"

namespace taut::internal {

/// The same as build_tiling(placement), given what is known of each body alone, displaced as in the placement.
/// Where the bodies' regions are apart, faces are taken over; only the nodes to whose regions the other body may come
/// near are done anew, on outlines that leave out what the other body cannot reach. What remains to be done per vertex
/// is copying.
/// Nothing if that would not pay, because much of both bodies is near the other, or if the bodies are not disjoint:
/// then the tiling must be built from scratch. With `in_any_case`, also where it does not pay.
std::optional<StaticTiling> join_tilings(const Placement& placement, const ShapeTiling& p, const ShapeTiling& q,
                                         bool in_any_case = false);

}  // namespace taut::internal
