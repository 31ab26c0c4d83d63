#include "proof/stated_box.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/pieces.hpp"
#include "motion/pose.hpp"
#include "numeric/budget.hpp"

namespace taut::internal::proof {
namespace {

/// How often a stretch is halved to see that a body stays within a box.
constexpr int most_box_halvings = 8;

/// A coordinate of the body's middle over a stretch: by its slope about the stretch's middle, or the range itself.
Ball<double> over_stretch(const Jet<double>& middle, const Jet<double>& over, double half) {
  const Ball<double> by_slope = middle.v + over.d * Ball<double>(0, half);
  return by_slope.rad <= over.v.rad ? by_slope : over.v;
}

bool contains(const AxisBox& all, const AxisBox& b) {
  return b.lo_x >= all.lo_x && b.lo_y >= all.lo_y && b.hi_x <= all.hi_x && b.hi_y <= all.hi_y;
}

/// A body while every motion of its chain follows one piece.
class BodyReach {
 public:
  explicit BodyReach(const AxisBox& bounds)
      : middle_{(bounds.lo_x + bounds.hi_x) / 2, (bounds.lo_y + bounds.hi_y) / 2},
        half_wide_((bounds.hi_x - bounds.lo_x) / 2),
        half_high_((bounds.hi_y - bounds.lo_y) / 2) {}

  /// A box that it stays in; with numbers that are none where the motion is singular.
  AxisBox over(const PieceChain& chain, double from, double to) const {
    const auto [at, whole, half] = poses_over(chain, middle_, from, to);
    const Ball<double> x = over_stretch(at.ox, whole.ox, half), y = over_stretch(at.oy, whole.oy, half);
    // The rectangle as it is turned lies in a rectangle along the axes, and in a disc.
    const double cosine = whole.xx.v.magnitude(), sine = whole.xy.v.magnitude(), disc = length(half_wide_, half_high_);
    const double wide = std::min(disc, cosine * half_wide_ + sine * half_high_);
    const double high = std::min(disc, sine * half_wide_ + cosine * half_high_);
    const double rounding = 0x1p-45 * (x.magnitude() + y.magnitude() + half_wide_ + half_high_);
    const double to_x = x.rad + wide + rounding, to_y = y.rad + high + rounding;
    return {x.mid - to_x, y.mid - to_y, x.mid + to_x, y.mid + to_y};
  }
  /// Does it stay within the box, as far as some halvings show?
  bool within(const AxisBox& box, const PieceChain& chain, double from, double to, int halvings) const {
    checkpoint();
    if (contains(box, over(chain, from, to))) return true;
    const double m = from + (to - from) / 2;
    return halvings > 0 && from < m && m < to && within(box, chain, from, m, halvings - 1) &&
           within(box, chain, m, to, halvings - 1);
  }

 private:
  Point middle_;
  double half_wide_, half_high_;
};

/// The piece of each motion of the chain that holds at a time, and until when all of them do.
struct PiecesAt {
  PieceChain chain;
  double until = std::numeric_limits<double>::infinity();

  PiecesAt(const MotionChain& motions, double t) {
    for (const PieceList& motion : motions) {
      chain.push_back(motion.at(t));
      until = std::min(until, chain.back().until);
    }
  }
};

/// Calls visit(chain, from, to, halvings) for all stretches of that time without a joint, and for the instants at
/// joints at which some motions of the chain, the inner ones, have passed to the next piece. True if all calls are.
template <class Visit>
bool all_stretches(const MotionChain& motions, const WorldTime& time, const Visit& visit) {
  for (double t = time.from;;) {
    const PiecesAt now(motions, t);
    if (!visit(now.chain, t, std::min(now.until, time.to), most_box_halvings)) return false;
    // A joint at the very end belongs to this stretch.
    if (now.until > time.to) return true;
    t = now.until;
    PieceChain mixed = PiecesAt(motions, t).chain;
    for (std::size_t outer = 0; outer < mixed.size(); ++outer) {
      if (!visit(mixed, t, t, 0)) return false;
      mixed[outer] = now.chain[outer];
    }
    if (t >= time.to) return true;
  }
}

/// Without the room, and what rounding it off may add.
AxisBox shrunk(const StatedBox& b, double room) {
  const auto less = [room](double side, int away) {
    return std::isinf(side) ? side : side + away * (room + 0x1p-50 * (std::fabs(side) + room));
  };
  return {less(b.lo_x, 1), less(b.lo_y, 1), less(b.hi_x, -1), less(b.hi_y, -1)};
}

}  // namespace

StatedBox read_box(ByteReader& in) {
  StatedBox box;
  for (float* side : {&box.lo_x, &box.lo_y, &box.hi_x, &box.hi_y}) *side = in.f32();
  if (!(box.lo_x <= box.hi_x && box.lo_y <= box.hi_y)) throw ProofError("a box that is none");
  return box;
}

bool stays_within(const VerifierBody& body, const WorldTime& time, double room, const StatedBox& box) {
  const BodyReach reach(body.rings->bounds());
  const AxisBox inner = shrunk(box, room);
  return all_stretches(body.motions, time, [&](const PieceChain& chain, double from, double to, int halvings) {
    return reach.within(inner, chain, from, to, halvings);
  });
}

bool has_room(const StatedBox& box, double room, const AxisBox& reach) { return contains(shrunk(box, room), reach); }

std::optional<AxisBox> box_around(const VerifierBody& body, const WorldTime& time) {
  const BodyReach reach(body.rings->bounds());
  AxisBox all{INFINITY, INFINITY, -INFINITY, -INFINITY};
  const bool known = all_stretches(body.motions, time, [&](const PieceChain& chain, double from, double to, int) {
    const AxisBox b = reach.over(chain, from, to);
    all = {std::min(all.lo_x, b.lo_x), std::min(all.lo_y, b.lo_y), std::max(all.hi_x, b.hi_x),
           std::max(all.hi_y, b.hi_y)};
    return std::isfinite(b.lo_x + b.lo_y + b.hi_x + b.hi_y);
  });
  return known ? std::optional(all) : std::nullopt;
}

}  // namespace taut::internal::proof
