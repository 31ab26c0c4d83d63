// How one body moves as seen from the other, over a window of a segment's parameter.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "certificate/instant.hpp"
#include "geometry/vector.hpp"
#include "motion/frame_model.hpp"
#include "motion/motion_segment.hpp"
#include "numeric/exact_sum.hpp"

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

// Instants of a segment that lie between two doubles.

/// The exact sum of these three, where a single double may be too coarse: displaced bodies can come to each other, or
/// closer than a clearance, for a time that has no double in it.
using FineInstant = std::array<double, 3>;

/// The first number is at least as large as the others, and all of it lies in [start, end].
inline bool is_within(const FineInstant& at, double start, double end) {
  const double rest = std::fabs(at[1]) + std::fabs(at[2]);
  if (!std::isfinite(at[0]) || !(rest <= 0x1p-40 * (std::fabs(at[0]) + 1))) return false;
  ExactSum<4> after, before;
  for (const double x : at) {
    after.add(x);
    before.add(x);
  }
  after.add(-start);
  before.add(-end);
  return after.sign() >= 0 && before.sign() <= 0;
}

inline Instant instant_at(const FineInstant& at) {
  ExactSum<3> sum;
  for (const double x : at) sum.add(x);
  const ShortSum exactly = ShortSum::of(sum);
  return Instant::exactly(PreciseTime(exactly, exactly, Stage::doubles));
}

/// A double that is not before it.
inline double rounded_up(const FineInstant& at) {
  return at[1] == 0 && at[2] == 0 ? at[0] : at[0] + 2 * (std::fabs(at[1]) + std::fabs(at[2])) + 0x1p-1060;
}

/// About as near to a number as three doubles come.
inline FineInstant nearest_instant(RealMax rest) {
  FineInstant at{};
  for (double& part : at) {
    part = static_cast<double>(rest);
    rest -= part;
  }
  return at;
}

}  // namespace taut::internal::proof
