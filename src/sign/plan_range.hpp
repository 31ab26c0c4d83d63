// Where the relative motion stays over some time, whatever the legs: corners that keep their sign there need no look.
#pragma once

#include "sign/form.hpp"

namespace taut {

/// Ranges of the frame functions of Leg, without the shift. Bounds may be infinite; they are never NaN.
class PlanRange {
 public:
  /// Over the part [from, to] of a leg.
  static PlanRange over(const Leg& leg, double from, double to);

  /// Around some instants of the part: what over() tells is no smaller, and far more work.
  static PlanRange around_instants(const Leg& leg, double from, double to);

  /// Larger by this share of its size on all sides: its own extremes, with rounding, are well inside.
  PlanRange widened(double share = 0x1p-6) const;
  /// Grows to hold both.
  void include(const PlanRange& other);
  bool contains(const PlanRange& other) const;
  /// Until when the motion stays inside from `from` on: a lower bound, not far below; `from` if it is not inside at
  /// once, infinite if it stays until the leg's end.
  double left_at(const Leg& leg, double from) const;
  /// Does the form certainly have this sign wherever the motion stays in the range? The
  /// displacement is covered.
  bool keeps_sign(const PairGeometry& g, const Form& form, int sign) const;

 private:
  void cover(const Leg& leg, double from, double to, const PlanRange& fair, int halvings);
  static PlanRange over_part(const Leg& leg, double from, double to);
  struct Side {
    double lo[5], hi[5];
  };
  Side pp_, qq_;
};

}  // namespace taut
