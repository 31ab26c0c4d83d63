// Bounds of the relative motion over some time, independent of the segments. Corners that keep their sign there need no
// evaluation.
#pragma once

#include "certificate/certificate_function.hpp"

namespace taut::internal {

/// Ranges of the frame functions of MotionSegment, without the shift. Bounds may be infinite; they are never NaN.
class FrameRange {
 public:
  /// The range over the part [from, to] of a segment.
  static FrameRange over(const MotionSegment& segment, double from, double to);

  /// The range around some instants of the part. The range of over() is no smaller, and costs far more work.
  static FrameRange around_instants(const MotionSegment& segment, double from, double to);

  /// The range enlarged by this share of its size on all sides, so that its own extremes, with rounding, are well
  /// inside.
  FrameRange widened(double share = 0x1p-6) const;
  /// Enlarges this range to contain both.
  void include(const FrameRange& other);
  bool contains(const FrameRange& other) const;
  /// A lower bound, not far below, of the time until which the motion stays inside from `from` on. It is `from` if the
  /// motion is not inside at once, infinite if it stays until the segment's end.
  double left_at(const MotionSegment& segment, double from) const;
  /// Does the certificate function certainly have this sign wherever the motion stays in the range? The displacement is
  /// covered.
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
