// Forms that are zero at all times before the displacement.
#pragma once

#include "sign/certificate_function.hpp"

namespace taut::internal {

/// Is the form of three vertices, before their displacement, zero at all times of the segment? Where it is not known,
/// it counts as different. Not for bridges.
bool vanishes_before_displacement(const MotionSegment& segment, const PairGeometry& g,
                                  const CertificateFunction& function);

/// What is to be looked at of a form: all of it, or, where it is zero at all times before the displacement, what the
/// displacement makes of it. (On a translation the polynomial's own coefficients have cancelled already.)
enum class Portion : unsigned char { whole, displacement };
Portion portion_of(const MotionSegment& segment, const PairGeometry& g, const CertificateFunction& function);

}  // namespace taut::internal
