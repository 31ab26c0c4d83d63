// The combinations of a segment's frame functions that are zero at all times: exactly, for all rotations.
#pragma once

#include <array>
#include <vector>

#include "motion/motion_segment.hpp"
#include "numeric/dyadic.hpp"

namespace taut::internal {

/// A function of a mixed triple may vanish at all times by an identity. For example, both bodies rotate alike, perhaps
/// in different representations; or a vertex moves along the other body's edge; or collinear features are at rest.
/// Interval arithmetic never shows that, at any precision, and only the displacement decides then.
///
/// The frame functions are written as expressions (Symbolic) over one denominator. A combination of them is zero if and
/// only if it is zero term by term and power by power. These are linear conditions on its coefficients, of which at
/// most five are independent. Their computation is expensive, so they are not used where FrameEvaluator shows that a
/// combination is not zero.
class FrameIdentities {
 public:
  explicit FrameIdentities(const MotionSegment& segment);
  /// Is the sum of these coefficients times the frame functions for `pp` zero at all times of the segment? A positive
  /// result is certain.
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
