#include "spacetime/local_expansion.hpp"

#include <cmath>
#include <limits>

#include "numeric/quadratic_bound.hpp"

namespace taut::internal::spacetime {

LocalExpansion::LocalExpansion(const FastFunction& f, FrameWindow& window, double t, int sign)
    : value(f.value(window.at(t, f.pp))), slope(f.slope(window.at(t, f.pp))), second(f.curvature(window.second(f.pp))) {
  value.value *= sign;
  slope.value *= sign;
  second.value *= sign;
}

double LocalExpansion::positive_until(double limit) const {
  return value.lower() > 0 ? internal::positive_until(value.lower(), slope.lower(), second.lower(), limit) : 0;
}

double LocalExpansion::negative_from(double limit, double& falls_until) const {
  const double b = slope.upper(), c = second.upper();
  falls_until = 0;
  if (!(b < 0)) return std::numeric_limits<double>::infinity();
  falls_until = c > 0 ? std::fmin(limit, -b / c * (1 - 0x1p-48)) : limit;
  const double h = internal::negative_from(value.upper(), b, c);
  return h < falls_until ? h : std::numeric_limits<double>::infinity();
}

}  // namespace taut::internal::spacetime
