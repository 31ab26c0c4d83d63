// A segment's frame functions as Taylor polynomials over ranges of its parameter, at high precision.
//
// Near a root of order m the range of a form has to shrink like h^m, but those of its five terms, which cancel there,
// shrink like h. So a search there goes by a polynomial, whose coefficients have cancelled already. To make one costs
// far more than to combine it of the frame's own polynomials; and where bodies graze, or meet at a joint, many forms
// are searched about one instant. So the frame's polynomials are kept, about places on a grid that is as fine as the
// intervals that are asked for: searches that come near an instant meet there. A polynomial is of no use that reaches
// as far as where the motion is singular in the complex plane, which is close by where a cosine comes near 1 and turns.
#pragma once

#include <cstdint>
#include <memory>
#include <tuple>
#include <vector>

#include "relative/motion_segment.hpp"

namespace taut::internal {

/// Good for all of [lo, hi]: the last terms are ranges, the others are exact about the middle but for rounding.
template <class Real>
struct TaylorFrame {
  Real lo, hi, middle;
  double reach;
  std::uint64_t number;  ///< of no other model in the same memory
  FrameOf<ModelSeries<Real>> about_middle;

  /// Would one that reaches less far hardly be better for the ball? One far shorter than the model may see the last
  /// term alone.
  bool suits(const Ball<Real>& t) const { return t.rad >= 0x1p-8 * reach; }
  /// Would one that is made for this ball alone leave out far less?
  bool is_loose_for(const Ball<Real>& t) const { return t.rad > 0 && t.rad < 0x1p-1 * reach; }
};

/// The frame functions by Taylor's formula in s, the root of the distance from an end at which the segment is singular
/// (see TimeFromEnd), where they are smooth.
template <class Real>
class FramesFromEnd {
 public:
  /// The terms but for the last one.
  const FrameOf<SeriesFromEnd<Real>>& terms(const MotionSegment& segment, double end, double direction);
  /// The last one, which makes the formula right for all s from the end to `farthest`.
  const FrameValues<Real>& last(const MotionSegment& segment, double end, double direction, double farthest);

 private:
  struct Last {
    double end, direction, farthest;
    FrameValues<Real> frame;
  };

  double end_ = 0, direction_ = 0;  ///< of the terms; 0 if there are none
  FrameOf<SeriesFromEnd<Real>> terms_;
  std::vector<Last> last_;
  std::size_t next_ = 0;  ///< which is replaced next
};

/// Those of one segment that were asked for last, at each precision.
class TaylorFrames {
 public:
  /// For another segment, which is no bridge.
  void clear();
  /// The one that reaches least far of those that cover the ball, or null; valid until the next call of make().
  template <class Real>
  const TaylorFrame<Real>* known(const Ball<Real>& t) const {
    const TaylorFrame<Real>* best = nullptr;
    const Real lower = t.lower(), upper = t.upper();
    for (const TaylorFrame<Real>& m : kept<Real>().models) {
      if ((!best || m.reach < best->reach) && lower >= m.lo && upper <= m.hi) best = &m;
    }
    return best;
  }
  enum class Reach { several_times, once };
  /// A new one that covers and suits it, t.rad > 0, and reaches several times as far or not; null where the motion is
  /// nearly singular so close by that none so long is of use.
  template <class Real>
  const TaylorFrame<Real>* make(const MotionSegment& segment, const Ball<Real>& t, Reach reach = Reach::several_times);
  template <class Real>
  FramesFromEnd<Real>& from_end() {
    std::unique_ptr<FramesFromEnd<Real>>& frames = std::get<Kept<Real>>(kept_).from_end;
    if (!frames) frames = std::make_unique<FramesFromEnd<Real>>();
    return *frames;
  }

 private:
  /// A place, and about how far from it the motion is singular.
  struct Limit {
    double at, radius;
  };
  bool is_too_long(double middle, double half) const;

  template <class Real>
  struct Kept {
    std::vector<TaylorFrame<Real>> models;
    std::size_t next = 0;                           ///< which is replaced next
    std::unique_ptr<FramesFromEnd<Real>> from_end;  ///< large, and seldom asked for
  };
  template <class Real>
  const Kept<Real>& kept() const {
    return std::get<Kept<Real>>(kept_);
  }

  template <class>
  struct KeptOf;
  template <class... Reals>
  struct KeptOf<std::tuple<Reals...>> {
    using Type = std::tuple<Kept<Reals>...>;
  };

  KeptOf<Precisions>::Type kept_;
  std::uint64_t made_ = 0;
  std::vector<Limit> limits_;  ///< where models were wanted that would have reached beyond
  std::size_t next_limit_ = 0;
};

}  // namespace taut::internal
