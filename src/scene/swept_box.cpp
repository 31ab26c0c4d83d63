#include "scene/swept_box.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace taut::internal {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr AxisBox everywhere{-unbounded, -unbounded, unbounded, unbounded};

/// A point's coordinate over the window: the mean value theorem about the middle, or the range itself if that is less.
Ball<double> range_of(const Jet<double>& middle, const Jet<double>& over, double half) {
  const Ball<double> by_slope = middle.v + over.d * Ball<double>(0, half);
  return by_slope.rad <= over.v.rad ? by_slope : over.v;
}

/// While every motion of the chain follows one piece.
AxisBox box_of_pieces(const PieceChain& chain, const AxisBox& bounds, double from, double to) {
  const Point c{(bounds.lo_x + bounds.hi_x) / 2, (bounds.lo_y + bounds.hi_y) / 2};
  const auto [at, range, half] = poses_over(chain, c, from, to);
  const Ball<double> x = range_of(at.ox, range.ox, half), y = range_of(at.oy, range.oy, half);
  double wide = (bounds.hi_x - bounds.lo_x) / 2, high = (bounds.hi_y - bounds.lo_y) / 2;
  if (turns(chain)) wide = high = length(wide, high);
  const double slack = 0x1p-45 * (x.magnitude() + y.magnitude() + wide + high) + displacement_room;
  wide += x.rad + slack;
  high += y.rad + slack;
  if (!(std::isfinite(wide) && std::isfinite(high) && std::isfinite(x.mid) && std::isfinite(y.mid))) return everywhere;
  return {x.mid - wide, y.mid - high, x.mid + wide, y.mid + high};
}

}  // namespace

AxisBox swept_box(const InstanceBody& body, double from, double to) {
  const AxisBox& bounds = body.rings->bounds();
  if (body.motions.empty()) return box_of_pieces({MotionPiece{}}, bounds, from, to);
  AxisBox whole;
  // From joint to joint of any of the motions. Bridges lie between the two boxes that they join.
  for (double t = from;;) {
    PieceChain chain;
    double until = unbounded;
    for (const PieceList& motion : body.motions) {
      chain.push_back(motion.at(t));
      until = std::min(until, chain.back().until);
    }
    whole.include(box_of_pieces(chain, bounds, t, std::min(until, to)));
    // A joint at the very end belongs to this window, bridge and all.
    if (until > to || t >= to) break;
    t = until;
  }
  return whole;
}

double coarse_boundary(const Instance& instance, int k) {
  const double length = instance.end() - instance.start();
  return k == coarse_windows ? instance.end()
                             : std::min(instance.end(), instance.start() + length * k / coarse_windows);
}

}  // namespace taut::internal
