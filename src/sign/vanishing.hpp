// Functions that are zero at all times before the displacement.
#pragma once

#include "relative/leg.hpp"
#include "sign/mixed_triple.hpp"

namespace taut {

/// Is the function of three vertices, before their displacement, zero at all times of the leg? Where it is not known,
/// it counts as different. Not for bridges.
bool vanishes_before_displacement(const Leg& leg, const PairGeometry& g, const MixedTriple& triple,
                                  Measure measure = Measure::orientation);

/// What is to be looked at of a function: all of it, or, where it is zero at all times before the displacement, what
/// the displacement makes of it.
enum class Portion : unsigned char { whole, displacement };
Portion portion_of(const Leg& leg, const PairGeometry& g, const MixedTriple& triple, Measure measure);

}  // namespace taut
