// The value of a mechanism's joint at a time, for those who do not need to know how it is found.
#pragma once

#include <cstddef>
#include <limits>

#include "motion/degrees.hpp"

namespace taut::internal {

class JointFunctions;

/// As JointFunctions::value().
template <class J, class Real>
J joint_value(const JointFunctions& functions, std::size_t joint, std::size_t piece, const Ball<Real>& t);

/// Not known near a singular end of another body's motion.
template <class J, class Real>
J joint_value(const JointFunctions&, std::size_t, std::size_t, const TimeFromEnd<Real>&) {
  return J::constant(Ball<Real>(Real(0), std::numeric_limits<double>::infinity()));
}

}  // namespace taut::internal
