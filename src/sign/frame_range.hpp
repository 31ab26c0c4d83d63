// Where the relative motion stays over some time, whatever the segments: corners that keep their sign there need no
// look.
#pragma once

#include "sign/certificate_function.hpp"

namespace taut::internal {

/// Ranges of the frame functions of MotionSegment, without the shift. Bounds may be infinite; they are never NaN.
class FrameRange {
 public:
  /// Over the part [from, to] of a segment.
  static FrameRange over(const MotionSegment& segment, double from, double to);

  /// Around some instants of the part: what over() tells is no smaller, and far more work.
  static FrameRange around_instants(const MotionSegment& segment, double from, double to);

  /// Larger by this share of its size on all sides: its own extremes, with rounding, are well inside.
  FrameRange widened(double share = 0x1p-6) const;
  /// Grows to hold both.
  void include(const FrameRange& other);
  bool contains(const FrameRange& other) const;
  /// Until when the motion stays inside from `from` on: a lower bound, not far below; `from` if it is not inside at
  /// once, infinite if it stays until the segment's end.
  double left_at(const MotionSegment& segment, double from) const;
  /// Does the form certainly have this sign wherever the motion stays in the range? The
  /// displacement is covered.
  bool keeps_sign(const PairGeometry& g, const CertificateFunction& function, int sign) const;

 private:
  void cover(const MotionSegment& segment, double from, double to, const FrameRange& fair, int halvings);
  static FrameRange over_part(const MotionSegment& segment, double from, double to);
  struct Side {
    double lo[5], hi[5];
  };
  Side pp_, qq_;
};

}  // namespace taut::internal
