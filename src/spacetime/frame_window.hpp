// A short window of a segment, with bounds of everything that moves in it.
#pragma once

#include <limits>

#include "motion/frame_sample.hpp"

namespace taut::internal::spacetime {

/// A window of the segment's parameter. The laws:
///   1. smooth(): at(t) encloses values and slopes at any t in [start, end]; second() encloses the second derivatives
///      over the whole window; all bounds are finite.
///   2. not smooth() (the motion is singular near by): only range() may be used; it encloses the values over the
///      window.
class FrameWindow {
 public:
  /// The window from `start`, as long as its bounds are good, and not beyond `limit` (> start). It tries `length`
  /// first.
  FrameWindow(const MotionSegment& segment, double start, double limit, double length);

  double start() const { return start_; }
  double end() const { return end_; }
  double length() const { return end_ - start_; }
  /// The approximate length that an adjacent window can have (not for a bridge).
  double fitting_length() const;
  bool smooth() const { return smooth_; }
  const FrameSample& at(double t, bool pp) {
    if (!(t == cached_)) evaluate(t);
    return pp ? pp_ : qq_;
  }
  const FrameCurvature& second(bool pp) const { return pp ? second_pp_ : second_qq_; }
  /// The model that gives a smooth window's bounds (not for a bridge).
  const FrameModel& model() const { return model_; }
  const FrameSample& range(bool pp) const { return pp ? pp_ : qq_; }

 private:
  bool make_smooth();
  void make_bridge();
  bool make_range();
  double roughness() const;
  bool is_as_good_as_an_instant();
  void evaluate(double t);

  const MotionSegment* segment_;
  double start_, end_;
  bool smooth_ = true;
  double cached_;
  double instant_roughness_ = std::numeric_limits<double>::quiet_NaN();  ///< once it was asked for
  FrameModel model_;
  FrameSample pp_{}, qq_{};
  FrameCurvature second_pp_{}, second_qq_{};
};

}  // namespace taut::internal::spacetime
