#include "spacetime/box_separation.hpp"

#include <algorithm>
#include <cmath>

namespace taut::spacetime {
namespace {

/// A direction fixed to one box, and how far the other box about is beyond it.
struct Axis {
  Point n{1, 0};
  Point support;  ///< the corner of the fixed box that is farthest along n
  double gap = -INFINITY;
};

using Corners = std::array<Point, 4>;

double dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }

/// The moving box's corners in the fixed box's frame, rounded: only to choose an axis.
Corners place(const Leg& leg, const FrameSample& s, bool pp, const Corners& moving) {
  // n . (c - a) for n = x and y, by the coefficients of DirectedDistance relative to the fixed origin.
  const double side = pp ? 1 : -1;
  const double sx = leg.shift_p || leg.shift_q ? leg.shift.x : 0, sy = leg.shift_p || leg.shift_q ? leg.shift.y : 0;
  const bool fixed_shifts = pp ? leg.shift_p : leg.shift_q, moving_shifts = pp ? leg.shift_q : leg.shift_p;
  Corners out;
  for (std::size_t k = 0; k < 4; ++k) {
    Point m = moving[k];
    if (moving_shifts) m = {m.x + side * sx, m.y + side * sy};
    const double c = s.f[3], t = side * s.f[4];
    out[k] = {side * s.f[1] + c * m.x - t * m.y, side * s.f[2] + t * m.x + c * m.y};
    if (fixed_shifts) out[k] = {out[k].x + side * sx, out[k].y + side * sy};
  }
  return out;
}

/// The side of the fixed box that sees the moving one farthest beyond it.
Axis best_axis(const Box& fixed, const Corners& moving) {
  Axis best;
  const Point normals[4] = {
      {-fixed.across.x, -fixed.across.y}, fixed.along, fixed.across, {-fixed.along.x, -fixed.along.y}};
  for (std::size_t k = 0; k < 4; ++k) {
    const double support = dot(normals[k], fixed.corners[k]);
    double gap = INFINITY;
    for (const Point& m : moving) gap = std::min(gap, dot(normals[k], m) - support);
    if (gap > best.gap) best = {normals[k], fixed.corners[k], gap};
  }
  return best;
}

/// How long all corners of the moving box certainly stay beyond the axis.
double beyond_for(const Leg& leg, FrameWindow& window, const Axis& axis, bool pp, const Corners& moving, double t,
                  double limit) {
  double h = limit - t;
  for (const Point& m : moving) {
    const DirectedDistance f(leg, pp, axis.n, axis.support, m);
    h = std::min(h, Course(f, window, t, 1).positive_until(h));
    if (!(h > 0)) return 0;
  }
  return h;
}

/// Is all of the moving box certainly beyond the axis, wherever the frame is within the sample's errors?
bool beyond(const Leg& leg, const FrameSample& sample, const Axis& axis, bool pp, const Corners& moving) {
  return std::all_of(moving.begin(), moving.end(), [&](const Point& m) {
    return DirectedDistance(leg, pp, axis.n, axis.support, m).value(sample).sign() > 0;
  });
}

}  // namespace

double apart_until(const Leg& leg, FrameWindow& window, const Box& p, const Box& q, double t, double limit) {
  double longest = 0;
  for (const bool pp : {true, false}) {
    const Box &fixed = pp ? p : q, &moving = pp ? q : p;
    const FrameSample& s = window.smooth() ? window.at(t, pp) : window.range(pp);
    const Axis axis = best_axis(fixed, place(leg, s, pp, moving.corners));
    if (!(axis.gap > 0)) continue;
    if (window.smooth()) {
      longest = std::max(longest, beyond_for(leg, window, axis, pp, moving.corners, t, limit));
    } else if (beyond(leg, s, axis, pp, moving.corners)) {
      return limit;
    }
    if (longest >= limit - t) return limit;
  }
  if (!(longest > 0)) return t;
  return std::max(t, std::min(limit, std::nextafter(t + longest, -INFINITY)));
}

bool apart_at(const Leg& leg, FrameWindow& window, const Box& p, const Box& q, double t) {
  for (const bool pp : {true, false}) {
    const Box &fixed = pp ? p : q, &moving = pp ? q : p;
    const FrameSample& s = window.smooth() ? window.at(t, pp) : window.range(pp);
    const Axis axis = best_axis(fixed, place(leg, s, pp, moving.corners));
    if (axis.gap > 0 && beyond(leg, s, axis, pp, moving.corners)) return true;
  }
  return false;
}

}  // namespace taut::spacetime
