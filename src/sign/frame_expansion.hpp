// A segment's frame functions about instants at which much happens at once, to 2^-315 or so.
//
// Parts drawn on a grid, and mechanisms with equal teeth, have many events that only the displacement, or the rounding
// of their coordinates, tells apart. All of them fall within a few units in the last place of one double. So the
// frame's Taylor polynomials about that double are made once, in numbers of a fixed length, and serve them all: a form
// there is a linear combination of these, its root a few steps of Newton's (FixedPointExpansion), at a small part of
// what a search in floating numbers as long costs.
#pragma once

#include <array>
#include <vector>

#include "base/thread_local_pool.hpp"
#include "numeric/fixed.hpp"
#include "relative/frame_sample.hpp"
#include "relative/motion_segment.hpp"

namespace taut::internal {

/// The functions' Taylor polynomials in the time since `about`, for times no farther from it than `reach`, which is the
/// unit: so slow motions and fast ones have coefficients of the same sizes, and those of high powers are short.
struct FrameExpansion {
  static constexpr std::size_t terms = model_degree;

  double about = 0, reach = 0;
  int exponent = 0;  ///< reach is 2^exponent, or 0
  std::array<std::array<FixedBall, terms>, 5> pp, qq;
  /// Bounds of the next coefficient: nothing else is left out.
  std::array<double, 5> pp_rest{}, qq_rest{};
  /// Values and slopes in doubles, with bounds that hold all over the reach.
  FrameSample pp_over, qq_over;

  const std::array<std::array<FixedBall, terms>, 5>& functions(bool of_pp) const { return of_pp ? pp : qq; }
  const std::array<double, 5>& rest(bool of_pp) const { return of_pp ? pp_rest : qq_rest; }
  const FrameSample& over(bool of_pp) const { return of_pp ? pp_over : qq_over; }
};

/// Those of one segment that were asked for last.
class FrameExpansionCache {
 public:
  /// Makes room, so that nothing is allocated when it is asked for.
  void reserve() {
    if (kept_) return;
    kept_ = ThreadLocalPool<std::vector<FrameExpansion>>::take();
    kept_->clear();
    kept_->reserve(most_kept);
  }
  /// Prepares a segment; the reference must stay valid.
  void reset(const MotionSegment& segment) {
    segment_ = &segment;
    if (kept_) kept_->clear();
    next_ = 0;
  }
  /// One that reaches over [lo, hi], valid until the next call; none where that is too long for it to be of use, on
  /// straight segments and bridges, which have better ways, and where the motion is singular.
  const FrameExpansion* around(double lo, double hi);
  /// The same, if it was asked for before.
  const FrameExpansion* known(double lo, double hi) const;

 private:
  static constexpr std::size_t most_kept = 16;

  FrameExpansion& slot();

  const MotionSegment* segment_ = nullptr;
  ThreadLocalPool<std::vector<FrameExpansion>>::Pointer kept_;
  std::size_t next_ = 0;  ///< which was replaced last
};

}  // namespace taut::internal
