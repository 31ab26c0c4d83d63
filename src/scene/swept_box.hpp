// Where a body may be during a window of time: a box along the axes that certainly holds it.
#pragma once

#include "scene/instance.hpp"

namespace taut::internal {

/// In internal coordinates. Infinite where the motion is singular.
struct SweptBox {
  double lo_x = 0, lo_y = 0, hi_x = 0, hi_y = 0;

  bool meets(const SweptBox& o) const { return lo_x <= o.hi_x && o.lo_x <= hi_x && lo_y <= o.hi_y && o.lo_y <= hi_y; }
  /// With room for a margin around it; the same for 0.
  SweptBox grown(double margin) const {
    const double more = margin * (1 + 0x1p-40) + (margin > 0 ? 0x1p-48 : 0);
    return {lo_x - more, lo_y - more, hi_x + more, hi_y + more};
  }
  /// The box around both.
  SweptBox with(const SweptBox& o) const {
    return {lo_x < o.lo_x ? lo_x : o.lo_x, lo_y < o.lo_y ? lo_y : o.lo_y, hi_x > o.hi_x ? hi_x : o.hi_x,
            hi_y > o.hi_y ? hi_y : o.hi_y};
  }
  double longest() const { return hi_x - lo_x > hi_y - lo_y ? hi_x - lo_x : hi_y - lo_y; }
};

/// Do the boxes of two bodies over a window show less than those over its halves would? `sizes` is the sum of the two
/// bodies' own. A window is short enough for bodies whose boxes it makes at most half as large again.
inline bool is_long(const SweptBox& a, const SweptBox& b, double sizes) {
  return a.longest() + b.longest() > 1.5 * sizes;
}

/// No window is halved more often.
inline constexpr int most_window_halvings = 30;

/// The box of the body, displaced either way, all over [from, to], in the world's frame.
SweptBox swept_box(const InstanceBody& body, double from, double to);

/// Into so many windows is a world's time divided to see which bodies may come near each other at all.
inline constexpr int coarse_windows = 16;
/// Where window k of these begins, and the one before ends.
double coarse_boundary(const Instance& instance, int k);

}  // namespace taut::internal
