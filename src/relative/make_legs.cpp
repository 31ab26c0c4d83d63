#include "relative/make_legs.hpp"

#include <algorithm>

namespace taut {

std::vector<Leg> make_legs(const std::vector<MotionPiece>& p, const std::vector<MotionPiece>& q, double start,
                           double end) {
  std::vector<Leg> legs;
  std::size_t i = 0, j = 0;
  double t = start;
  // After a change of one body's plan, the other one may be in a later piece already.
  while (p[i].until <= t) ++i;
  while (q[j].until <= t) ++j;
  for (;;) {
    const double until = std::min({p[i].until, q[j].until, end});
    legs.push_back(Leg::motion(p[i], q[j], t, until));
    if (until >= end) return legs;
    t = until;
    const std::size_t old_i = i, old_j = j;
    while (p[i].until <= t) ++i;
    while (q[j].until <= t) ++j;
    if (!same_motion(p[old_i], p[i]) || !same_motion(q[old_j], q[j])) {
      legs.push_back(Leg::bridging(p[old_i], q[old_j], p[i], q[j], t));
    }
  }
}

}  // namespace taut
