// How one body moves as seen from the other, over a window of a segment's parameter.
#pragma once

#include "geometry/vector.hpp"
#include "motion/frame_model.hpp"
#include "motion/motion_segment.hpp"

namespace taut::internal::proof {

/// The law: at the window's middle + h, |h| <= half, the moving body's point v is seen at
///   shift + h shift_rate + h^2/2 shift_second + (rotation + h rotation_rate + h^2/2 rotation_second) v + e,
/// where |e| <= shift_error + rotation_error |v|, and the other body's own points at (1 + e') a, where |e'| <=
/// scale_error.
/// |(x, y)| is |x| + |y|. What rounding adds in a few further operations is covered by 2^-44 of `size`, and of the
/// points.
struct WindowModel {
  Vector shift, shift_rate, shift_second, rotation, rotation_rate, rotation_second;
  double shift_error = 0, rotation_error = 0, scale_error = 0;
  double size = 0;  ///< of everything that was added
};

/// The second order of the motion about the middle, with a bound of the rest: a window half as long has an eighth of
/// it. Where the motion is singular, its range over the window takes the place of all of them.
class MotionWindow {
 public:
  MotionWindow(const MotionSegment& segment, double from, double to);
  /// The same from a model over that window, or a longer one, which costs far less. Of a bridge there is none.
  MotionWindow(const MotionSegment& segment, const FrameModel& model, double from, double to);

  double from() const { return from_; }
  double to() const { return to_; }
  double half() const { return half_; }
  /// Q's points in P's frame, and P's points in Q's frame.
  const WindowModel& from_p() const { return from_p_; }
  const WindowModel& from_q() const { return from_q_; }
  /// Is a model over this window so good, at a guess, that shorter ones would be no better?
  bool may_be_sharp() const;

 private:
  MotionWindow(double from, double to);

  double from_, to_, middle_, half_;
  WindowModel from_p_, from_q_;
};

}  // namespace taut::internal::proof
