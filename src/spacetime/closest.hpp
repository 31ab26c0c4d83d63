// The nearest points of two segments.
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/vector.hpp"

namespace taut::internal::spacetime {

/// The nearest points of two segments that do not cross, rounded.
struct Closest {
  Vector on_p, on_q;
  double distance = INFINITY;

  static Closest of(Vector a, Vector b, Vector c, Vector d) {
    Closest best;
    best.attempt(a, c, d, true);
    best.attempt(b, c, d, true);
    best.attempt(c, a, b, false);
    best.attempt(d, a, b, false);
    return best;
  }

 private:
  void attempt(Vector v, Vector from, Vector to, bool v_of_p) {
    const Vector e = to - from, w = v - from;
    const double share = std::clamp(dot(w, e) / dot(e, e), 0.0, 1.0);
    const Vector foot{from.x + share * e.x, from.y + share * e.y}, relative = v - foot;
    const double d = std::sqrt(dot(relative, relative));
    if (!(d < distance)) return;
    on_p = v_of_p ? v : foot;
    on_q = v_of_p ? foot : v;
    distance = d;
  }
};

}  // namespace taut::internal::spacetime
