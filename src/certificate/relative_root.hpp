// Roots determined from nearby roots: certificate functions that are nearly proportional.
//
// Equal teeth, parallel edges and collinear points give certificate functions that are equal except for a factor, the
// rounding of rotated coordinates, and the displacement. Their roots coincide in doubles, and the differences between
// them are far below the last digit. But of these differences a few digits suffice. So once one root is known to full
// precision, by the numbers of FixedPointExpansion, the others are determined from it in doubles.
//
// The coefficients of a function are linear in its edge e, and in its points v: they are C(e, v). If m is the larger
// coordinate of the other function's edge, the two differ by
//   e'_m C(e, v) - e_m C(e', v') = e'_m C(e, v - v') + C(d, v'),  d = e'_m e - e_m e',
// and the second coordinate of d is the cross product of the edges. At the root of the other function, this combination
// of frame functions is e'_m f alone. Divided by the slope, it is the distance to the root of f. Edges and points are
// differences of coordinates, which are nearly always exact in doubles. So where edges are parallel and points
// collinear, only the terms of the displacement remain.
#pragma once

#include <optional>

#include "certificate/certificate_function.hpp"
#include "certificate/frame_expansion.hpp"
#include "certificate/precise_time.hpp"
#include "numeric/exact_sum.hpp"

namespace taut::internal {

struct KnownRoot;

/// A certificate function within reach of a frame's instant.
class RelativeRoot {
 public:
  RelativeRoot() = default;
  RelativeRoot(const FrameExpansion& frame, const MotionSegment& segment, const PairGeometry& g,
               const CertificateFunction& function);

  /// Does `o` belong to the same segment, and to the same instant?
  bool has_same_reference(const RelativeRoot& o) const { return about_ == o.about_ && pp_ == o.pp_; }
  /// The sign of the slope over the whole reach; 0 if it may change there.
  int slope_sign() const { return slope_.sign(); }
  /// The distance of the function's only root within reach from another root nearby, whose enclosure counts as a point.
  /// Nothing unless the two functions are so nearly proportional that this is known far more precisely than doubles
  /// represent instants. Requires that the slope has a sign.
  std::optional<Bounded> distance_from(const FrameExpansion& frame, const MotionSegment& segment,
                                       const KnownRoot& known) const;

 private:
  bool may_be_proportional_to(const MotionSegment& segment, const RelativeRoot& o) const;
  Bounded scaled_value(const FrameSample& over, const MotionSegment& segment, const RelativeRoot& other,
                       bool turned) const;

  double about_ = 0;
  bool pp_ = false;
  FunctionPoints<DoubleDouble> given_;  ///< before the displacement
  FunctionPoints<double> rough_{};
  Bounded displaced_{};  ///< the value that the displacement adds, in its unit, over the whole reach
  Bounded slope_{};      ///< over the whole reach
};

/// The root of a certificate function, enclosed from an instant on.
struct KnownRoot {
  RelativeRoot function;
  ShortSum from;
  double width = 0;
  double farthest = 0;  ///< distance from the frame's instant

  KnownRoot() = default;
  /// Requires a root given by sums.
  KnownRoot(const RelativeRoot& of, const FrameExpansion& frame, const PreciseTime& root);
  /// The root of a nearby function.
  PreciseTime at_distance(const Bounded& h) const;
};

}  // namespace taut::internal
