#include "spacetime/motion_bound.hpp"

#include <cmath>
#include <limits>

#include "numeric/quadratic_bound.hpp"

namespace taut::spacetime {
namespace {

/// A point as the leg sees it.
Point seen(const Leg& leg, const Point& v, bool of_p) {
  const ExactVector& offset = leg.offset(of_p);
  return {v.x + offset.x, v.y + offset.y};
}

double size_of(const Point& v) { return std::fabs(v.x) + std::fabs(v.y); }

}  // namespace

DirectedDistance::DirectedDistance(const Leg& leg, bool pp, const Point& n, const Point& fixed, const Point& moving)
    : pp_(pp) {
  const Point a = seen(leg, fixed, pp), c = seen(leg, moving, !pp);
  const double side = pp ? 1 : -1;
  const double shift = leg.offset_size();
  const double w = size_of(n), size_a = size_of(fixed) + shift, size_c = size_of(moving) + shift;
  a_[1] = side * n.x;
  a_[2] = side * n.y;
  m_[1] = m_[2] = w;
  if (leg.translation) {
    a_[0] = n.x * (c.x - a.x) + n.y * (c.y - a.y);
    a_[3] = a_[4] = m_[3] = m_[4] = 0;
    m_[0] = w * (size_a + size_c);
  } else {
    a_[0] = -(n.x * a.x + n.y * a.y);
    a_[3] = n.x * c.x + n.y * c.y;
    a_[4] = side * (n.y * c.x - n.x * c.y);
    m_[0] = w * size_a;
    m_[3] = m_[4] = w * size_c;
  }
  // For the displacement; combine() multiplies by 2^-49.
  for (double& m : m_) m += 0x1p50 * displacement_room * (1 + size_a + size_c + w);
}

Course::Course(const DirectedDistance& f, FrameWindow& window, double t, int sign)
    : value(f.value(window.at(t, f.pp()))), slope(f.slope(window.at(t, f.pp()))), bend(f.bend(window.bend(f.pp()))) {
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
