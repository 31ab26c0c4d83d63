// Where a body may be during a window of time: a box along the axes that certainly holds it.
#pragma once

#include "geometry/axis_box.hpp"
#include "scene/instance.hpp"

namespace taut::internal {

/// The box with room for a margin around it, which is more than the margin by more than is rounded anywhere; the same
/// box for 0.
inline AxisBox grown(const AxisBox& box, double margin) {
  const double more = margin * (1 + 0x1p-40) + (margin > 0 ? 0x1p-48 : 0);
  return {box.lo_x - more, box.lo_y - more, box.hi_x + more, box.hi_y + more};
}

/// Do the boxes of two bodies over a window show less than those over its halves would? `sizes` is the sum of the two
/// bodies' own. A window is short enough for bodies whose boxes it makes at most half as large again.
inline bool is_long(const AxisBox& a, const AxisBox& b, double sizes) {
  return a.longest() + b.longest() > 1.5 * sizes;
}

/// No window is halved more often.
inline constexpr int most_window_halvings = 30;

/// The box of the body, displaced either way, all over [from, to], in the world's frame and in internal coordinates.
/// Infinite where the motion is singular.
AxisBox swept_box(const InstanceBody& body, double from, double to);

/// Into so many windows is a world's time divided to see which bodies may come near each other at all.
inline constexpr int coarse_windows = 16;
/// Where window k of these begins, and the one before ends.
double coarse_boundary(const Instance& instance, int k);

}  // namespace taut::internal
