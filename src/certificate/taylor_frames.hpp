// A segment's frame functions as Taylor polynomials over ranges of its parameter, at high precision.
//
// Near a root of order m, the range of a certificate function has to shrink like h^m, but those of its five terms,
// which cancel there, shrink like h. So a search there uses a polynomial, whose coefficients have cancelled already.
// Computing it from scratch costs far more than combining it from the frame's own polynomials. Where bodies graze, or
// meet at a joint, many functions are searched about one instant. So the frame's polynomials are kept. Their places lie
// on a grid as fine as the requested intervals, so that searches near one instant share them. A polynomial is useless
// if it reaches as far as a singularity of the motion in the complex plane. Such a singularity is close where a cosine
// comes near 1 and turns back.
#pragma once

#include <cstdint>
#include <memory>
#include <tuple>
#include <vector>

#include "motion/motion_segment.hpp"

namespace taut::internal {

/// Valid for all of [lo, hi]. The last terms are ranges, the others are exact about the middle except for rounding.
template <class Real>
struct TaylorFrame {
  Real lo, hi, middle;
  double reach;
  std::uint64_t number;  ///< unique among the models in the same memory
  FrameOf<ModelSeries<Real>> about_middle;

  /// Would a model with a shorter reach hardly be better for the ball? A ball far shorter than the model may see the
  /// last term alone.
  bool suits(const Ball<Real>& t) const { return t.rad >= 0x1p-8 * reach; }
  /// Would a model made for this ball alone have a far smaller remainder?
  bool is_loose_for(const Ball<Real>& t) const { return t.rad > 0 && t.rad < 0x1p-1 * reach; }
};

/// The frame functions as Taylor expansions in s, the square root of the distance from an end at which the segment is
/// singular (see TimeFromEnd). They are smooth in s.
template <class Real>
class FramesFromEnd {
 public:
  /// The terms except for the last one.
  const FrameOf<SeriesFromEnd<Real>>& terms(const MotionSegment& segment, double end, double direction);
  /// The last term, which makes the expansion valid for all s from the end to `farthest`.
  const FrameValues<Real>& last(const MotionSegment& segment, double end, double direction, double farthest);

 private:
  struct Last {
    double end, direction, farthest;
    FrameValues<Real> frame;
  };

  double end_ = 0, direction_ = 0;  ///< of the terms; 0 if there are none
  FrameOf<SeriesFromEnd<Real>> terms_;
  std::vector<Last> last_;
  std::size_t next_ = 0;  ///< the one to be replaced next
};

/// The most recently used models of one segment, at each precision.
class TaylorFrames {
 public:
  /// Prepares for another segment, which must not be a bridge.
  void clear();
  /// The model with the shortest reach that covers the ball, or null; valid until the next call of make().
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
  /// A new model that covers and suits t, where t.rad > 0. It reaches several times as far, or not. Null if the motion
  /// is nearly singular so close by that no model of this length is useful.
  template <class Real>
  const TaylorFrame<Real>* make(const MotionSegment& segment, const Ball<Real>& t, Reach reach = Reach::several_times);
  template <class Real>
  FramesFromEnd<Real>& from_end() {
    std::unique_ptr<FramesFromEnd<Real>>& frames = std::get<Kept<Real>>(kept_).from_end;
    if (!frames) frames = std::make_unique<FramesFromEnd<Real>>();
    return *frames;
  }

 private:
  /// A place, and its approximate distance from the nearest singularity of the motion.
  struct Limit {
    double at, radius;
  };
  bool is_too_long(double middle, double half) const;

  template <class Real>
  struct Kept {
    std::vector<TaylorFrame<Real>> models;
    std::size_t next = 0;                           ///< the one to be replaced next
    std::unique_ptr<FramesFromEnd<Real>> from_end;  ///< large, and seldom needed
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
  std::vector<Limit> limits_;  ///< places where a requested model would have reached beyond the limit
  std::size_t next_limit_ = 0;
};

}  // namespace taut::internal
