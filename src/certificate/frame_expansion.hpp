// A segment's frame functions about instants of many simultaneous events, to about 2^-315.
//
// Parts drawn on a grid, and mechanisms with equal teeth, have many events that only the displacement, or the rounding
// of their coordinates, distinguishes. All of them fall within a few units in the last place of one double. So the
// frame's Taylor polynomials about that double are computed once, in numbers of a fixed length, and serve all of them.
// A certificate function there is a linear combination of these polynomials, and its root takes a few Newton steps
// (FixedPointExpansion). This costs a small part of a search in floating-point numbers of the same length.
#pragma once

#include <array>
#include <vector>

#include "motion/frame_sample.hpp"
#include "motion/motion_segment.hpp"
#include "numeric/fixed.hpp"
#include "numeric/thread_local_pool.hpp"

namespace taut::internal {

/// The functions' Taylor polynomials in the time since `about`, for times within `reach` of it. The reach is the unit
/// of time, so slow and fast motions have coefficients of the same sizes, and those of high powers are short.
struct FrameExpansion {
  static constexpr std::size_t terms = model_degree;

  double about = 0, reach = 0;
  int exponent = 0;  ///< reach is 2^exponent, or 0
  std::array<std::array<FixedBall, terms>, 5> pp, qq;
  /// Bounds of the next coefficient. Nothing else is omitted.
  std::array<double, 5> pp_rest{}, qq_rest{};
  /// Values and slopes in doubles, with bounds that hold over the whole reach.
  FrameSample pp_over, qq_over;

  const std::array<std::array<FixedBall, terms>, 5>& functions(bool of_pp) const { return of_pp ? pp : qq; }
  const std::array<double, 5>& rest(bool of_pp) const { return of_pp ? pp_rest : qq_rest; }
  const FrameSample& over(bool of_pp) const { return of_pp ? pp_over : qq_over; }
};

/// The most recently used frame expansions of one segment.
class FrameExpansionCache {
 public:
  /// Makes room, so that later queries allocate nothing.
  /// Gives the room back, for others in this thread to use.
  void release() { kept_.reset(); }
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
  /// An expansion that reaches over [lo, hi], valid until the next call. None where [lo, hi] is too long for one to be
  /// useful, on straight segments and bridges, which have better methods, and where the motion is singular.
  const FrameExpansion* around(double lo, double hi);
  /// Like around(), but only an expansion that exists already.
  const FrameExpansion* known(double lo, double hi) const;

 private:
  static constexpr std::size_t most_kept = 16;

  FrameExpansion& slot();

  const MotionSegment* segment_ = nullptr;
  ThreadLocalPool<std::vector<FrameExpansion>>::Pointer kept_;
  std::size_t next_ = 0;  ///< the expansion that was replaced last
};

}  // namespace taut::internal
