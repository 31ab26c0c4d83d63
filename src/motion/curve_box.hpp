// A box of values that the motion of a mechanism is in right before a dead point, where its equations become singular.
#pragma once

#include <array>
#include <vector>

#include "motion/loop_solver.hpp"

namespace taut::internal {

/// Ranges of the unknowns, and last of the time. As functions of one of the unknowns, the parameter, all others and the
/// time are regular at a dead point, too.
struct CurveBox {
  int parameter = 0;
  std::vector<std::array<double, 2>> ranges;

  Ball<double> range(std::size_t unknown) const {
    return Ball<double>::between(ranges[unknown][0], ranges[unknown][1]);
  }
};

/// The weights of what the curve leads through: of the unknowns, and in the parameter's place of the time, in which a
/// drive moves by its own.
std::vector<double> weights_along(const LoopCurve& curve, double time);

/// |Y F| at constant y for all parameters in a range, by the mean value theorem about `middle`: Y F hardly changes with
/// the parameter where y does not.
std::vector<double> residual_over(const LoopCurve& curve, const Balls<double>& y, double middle,
                                  const Ball<double>& range, const Square<double>& inverse);

/// Proves that the motion that is within `last` at the time `from` is in the box until `to`, or as long as it goes on
/// before: for each value of the parameter there is one solution in the box, so that these are one curve, and the
/// curve leaves the box only where the parameter's range ends, at times outside of [from, to].
bool holds_motion(const CurveBox& box, const LoopEquations& equations, std::size_t piece, double from, double to,
                  const Balls<double>& last);

}  // namespace taut::internal
