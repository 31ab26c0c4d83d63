// Reciprocals of small whole numbers, used in series instead of divisions: a product costs a third of a quotient.
#pragma once

#include <array>
#include <cstddef>

#include "numeric/ball.hpp"

namespace taut::internal {

/// 1/k for k = 1 .. 32, to the precision of the number type.
template <class Real>
const Ball<Real>& reciprocal(int k) {
  static const auto all = [] {
    std::array<Ball<Real>, 33> made;
    made[0] = Ball<Real>::exact(0);
    for (std::size_t i = 1; i < made.size(); ++i) {
      made[i] = Ball<Real>::exact(1) / Ball<Real>::exact(static_cast<double>(i));
    }
    return made;
  }();
  return all[static_cast<std::size_t>(k)];
}

}  // namespace taut::internal
