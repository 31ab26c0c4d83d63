// Certificate functions that are zero at all times before the displacement.
#pragma once

#include "certificate/certificate_function.hpp"

namespace taut::internal {

/// Is the certificate function of three vertices, before their displacement, zero at all times of the segment? If this
/// is not known, the result is false. Not for bridges.
bool vanishes_before_displacement(const MotionSegment& segment, const PairGeometry& g,
                                  const CertificateFunction& function);

/// The part of a certificate function to evaluate: all of it, or, where it is zero at all times before the
/// displacement, only the contribution of the displacement. (On a translation, the polynomial's own coefficients have
/// cancelled already.)
enum class Portion : unsigned char { whole, displacement };
Portion portion_of(const MotionSegment& segment, const PairGeometry& g, const CertificateFunction& function);

}  // namespace taut::internal
