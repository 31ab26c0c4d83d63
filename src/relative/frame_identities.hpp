// Which combinations of a segment's frame functions are zero at all times: exactly, however the bodies turn.
#pragma once

#include <array>
#include <vector>

#include "numeric/dyadic.hpp"
#include "relative/motion_segment.hpp"

namespace taut::internal {

/// A function of a mixed triple may vanish at all times by an identity: both bodies turn alike, if perhaps in different
/// forms; a vertex is carried along the other body's edge; what stays in line rests. Intervals never show that, at any
/// precision, and nothing but the displacement decides then.
///
/// The frame functions are written as expressions (Symbolic) over one denominator. A combination of them is zero if and
/// only if it is term by term and power by power: these are linear conditions on its coefficients, of which at most
/// five are independent. To find them takes long: where FrameEvaluator tells that a combination is not zero, they are
/// not asked for.
class FrameIdentities {
 public:
  explicit FrameIdentities(const MotionSegment& segment);
  /// Is the sum of these coefficients times the frame functions for `pp` zero at all times of the segment? If so, it
  /// certainly is.
  bool vanishes(bool pp, const std::array<Dyadic, 5>& coefficients) const;

 private:
  using Condition = std::array<Dyadic, 5>;
  struct Side {
    bool known = false;
    std::vector<Condition> conditions;
  };
  static Side conditions_of(const std::array<Symbolic, 5>& functions, const SymbolicSegment& segment);

  Side pp_, qq_;
};

}  // namespace taut::internal
