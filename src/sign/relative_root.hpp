// Roots beside roots: of forms that are nearly proportional.
//
// Equal teeth, parallel edges and points on one line give forms that are one function but for a factor, the rounding of
// turned coordinates, and the displacement. Their roots fall on one instant, and what tells them apart is far below its
// last digit; but of that little, a few digits are enough. So once one of them is known to all its digits, by the
// numbers of FixedPointExpansion, others are found from it in doubles.
//
// A form's coefficients are linear in its edge e, and in its points v: they are C(e, v). Where m is the larger
// coordinate of the other form's edge, the two differ by
//   e'_m C(e, v) - e_m C(e', v') = e'_m C(e, v - v') + C(d, v'),  d = e'_m e - e_m e',
// and the second coordinate of d is the cross product of the edges. At the other form's root this combination of frame
// functions is e'_m f alone, and divided by the slope it is how far off the root of f is. Edges and points are
// differences of coordinates, which doubles nearly always have exactly; so where edges are parallel and points in line,
// nothing is left of it but what comes from the displacement.
#pragma once

#include <optional>

#include "numeric/double_double.hpp"
#include "sign/certificate_function.hpp"
#include "sign/frame_expansion.hpp"
#include "sign/precise_time.hpp"

namespace taut::internal {

struct KnownRoot;

/// A form within reach of a frame's instant, as that takes it.
class RelativeRoot {
 public:
  RelativeRoot() = default;
  RelativeRoot(const FrameExpansion& frame, const MotionSegment& segment, const PairGeometry& g,
               const CertificateFunction& function);

  /// Of the same segment, and about the same instant?
  bool is_beside(const RelativeRoot& o) const { return about_ == o.about_ && pp_ == o.pp_; }
  /// All over the reach; 0 if the slope may change its sign there.
  int slope_sign() const { return slope_.sign(); }
  /// Where the form has its only root within reach, seen from that of another one beside it, whose enclosure counts as
  /// a point. Nothing if the two are not so nearly proportional that this is known far better than a double holds
  /// instants. The slope has a sign.
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
  Bounded displaced_{};  ///< the value that the displacement adds, in its unit, all over the reach
  Bounded slope_{};      ///< all over the reach
};

/// The root of a form, enclosed from an instant on.
struct KnownRoot {
  RelativeRoot function;
  ShortSum from;
  double width = 0;
  double farthest = 0;  ///< from the frame's instant

  KnownRoot() = default;
  /// Given by sums.
  KnownRoot(const RelativeRoot& of, const FrameExpansion& frame, const PreciseTime& root);
  /// Of a form beside it.
  PreciseTime at_distance(const Bounded& h) const;
};

}  // namespace taut::internal
