#include "proof/stated_box.hpp"

#include <algorithm>
#include <cmath>

#include "base/interruption.hpp"
#include "motion/pieces.hpp"
#include "motion/pose.hpp"

namespace taut::proof {
namespace {

/// How often a stretch is halved to see that a body stays within a box.
constexpr int most_box_halvings = 8;

/// A coordinate of the body's middle over a stretch: by its slope about the stretch's middle, or the range itself.
Ball<double> over_stretch(const Jet<double>& middle, const Jet<double>& over, double half) {
  const Ball<double> by_slope = middle.v + over.d * Ball<double>(0, half);
  return by_slope.rad <= over.v.rad ? by_slope : over.v;
}

/// A body in its box: where is that while every motion of the chain follows one piece?
class BoxWatch {
 public:
  BoxWatch(const Bounds& bounds, double room, const StatedBox& box)
      : middle_{(bounds.lo.x + bounds.hi.x) / 2, (bounds.lo.y + bounds.hi.y) / 2},
        half_wide_((bounds.hi.x - bounds.lo.x) / 2),
        half_high_((bounds.hi.y - bounds.lo.y) / 2),
        room_(room),
        box_(box) {}

  bool holds(const PieceChain& chain, double from, double to, int halvings) const {
    interruption_point();
    if (holds_at_once(chain, from, to)) return true;
    const double m = from + (to - from) / 2;
    return halvings > 0 && from < m && m < to && holds(chain, from, m, halvings - 1) &&
           holds(chain, m, to, halvings - 1);
  }

 private:
  bool holds_at_once(const PieceChain& chain, double from, double to) const {
    const double half = (to - from) / 2 * (1 + 0x1p-50);
    const Pose<double> own{Jet<double>::constant(middle_.x), Jet<double>::constant(middle_.y),
                           Jet<double>::constant(1.0), Jet<double>::constant(0.0)};
    const Pose<double> over = compose(pose_of<Jet<double>>(chain, Ball<double>::between(from, to)), own);
    const Pose<double> at = compose(pose_of<Jet<double>>(chain, Ball<double>::exact(from + (to - from) / 2)), own);
    const Ball<double> x = over_stretch(at.ox, over.ox, half), y = over_stretch(at.oy, over.oy, half);
    // The rectangle as it is turned lies in a rectangle along the axes, and in a disc.
    const double cosine = over.xx.v.magnitude(), sine = over.xy.v.magnitude(), disc = length(half_wide_, half_high_);
    const double wide = std::min(disc, cosine * half_wide_ + sine * half_high_);
    const double high = std::min(disc, sine * half_wide_ + cosine * half_high_);
    const double rounding = 0x1p-45 * (x.magnitude() + y.magnitude() + half_wide_ + half_high_ + room_);
    const double to_x = x.rad + wide + room_ + rounding, to_y = y.rad + high + room_ + rounding;
    return x.mid - to_x >= box_.lo_x && x.mid + to_x <= box_.hi_x && y.mid - to_y >= box_.lo_y &&
           y.mid + to_y <= box_.hi_y;
  }

  Point middle_;
  double half_wide_, half_high_, room_;
  const StatedBox& box_;
};

/// The piece of each motion of the chain that holds at a time, and until when all of them do.
struct PiecesAt {
  PieceChain chain;
  double until = std::numeric_limits<double>::infinity();

  PiecesAt(const MotionChain& motions, double t) {
    for (const std::vector<MotionPiece>& motion : motions) {
      chain.push_back(piece_at(motion, t));
      until = std::min(until, chain.back().until);
    }
  }
};

}  // namespace

StatedBox read_box(ByteReader& in) {
  StatedBox box;
  for (float* side : {&box.lo_x, &box.lo_y, &box.hi_x, &box.hi_y}) *side = in.f32();
  if (!(box.lo_x <= box.hi_x && box.lo_y <= box.hi_y)) throw ProofError("a box that is none");
  return box;
}

bool stays_within(const ProvedBody& body, const WorldTime& time, double room, const StatedBox& box) {
  const BoxWatch watch(body.rings->bounds(), room, box);
  for (double t = time.from;;) {
    const PiecesAt now(body.motions, t);
    if (!watch.holds(now.chain, t, std::min(now.until, time.to), most_box_halvings)) return false;
    // A joint at the very end belongs to this stretch.
    if (now.until > time.to) return true;
    t = now.until;
    PieceChain mixed = PiecesAt(body.motions, t).chain;
    for (std::size_t outer = 0; outer < mixed.size(); ++outer) {
      if (!watch.holds(mixed, t, t, 0)) return false;
      mixed[outer] = now.chain[outer];
    }
    if (t >= time.to) return true;
  }
}

}  // namespace taut::proof
