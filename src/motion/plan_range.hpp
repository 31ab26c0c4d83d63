// Where the relative motion stays over a whole plan: corners that keep their sign there need no look at each joint.
#pragma once

#include <vector>

#include "motion/mixed_function.hpp"

namespace taut {

/// Ranges of the frame functions of Leg, without the shift. Bounds may be infinite; they are never NaN.
class PlanRange {
 public:
  static PlanRange over(const Leg& leg);

  /// Grows to hold both.
  void include(const PlanRange& other);
  bool contains(const PlanRange& other) const;
  /// Does the orientation of these vertices certainly have this sign wherever the motion stays in the range? The
  /// displacement is covered.
  bool keeps_sign(const PairGeometry& g, const MixedTriple& triple, int sign) const;

 private:
  struct Side {
    double lo[5], hi[5];
  };
  Side pp_, qq_;
};

/// For each leg, the range over it and all that follow.
std::vector<PlanRange> ranges_to_the_end(const std::vector<Leg>& legs);

}  // namespace taut
