#include "spacetime/course.hpp"

#include <cmath>
#include <limits>

#include "numeric/quadratic_bound.hpp"

namespace taut::spacetime {

Course::Course(const FastFunction& f, FrameWindow& window, double t, int sign)
    : value(f.value(window.at(t, f.pp))), slope(f.slope(window.at(t, f.pp))), bend(f.curvature(window.bend(f.pp))) {
  value.value *= sign;
  slope.value *= sign;
  bend.value *= sign;
}

double Course::positive_until(double limit) const {
  return value.lower() > 0 ? taut::positive_until(value.lower(), slope.lower(), bend.lower(), limit) : 0;
}

double Course::negative_from(double limit, double& falls_until) const {
  const double b = slope.upper(), c = bend.upper();
  falls_until = 0;
  if (!(b < 0)) return std::numeric_limits<double>::infinity();
  falls_until = c > 0 ? std::fmin(limit, -b / c * (1 - 0x1p-48)) : limit;
  const double h = taut::negative_from(value.upper(), b, c);
  return h < falls_until ? h : std::numeric_limits<double>::infinity();
}

}  // namespace taut::spacetime
