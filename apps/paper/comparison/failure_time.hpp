// When the orientation of three moving vertices changes.
#pragma once

#include <array>
#include <cstdint>

#include "comparison/moving_bodies.hpp"

namespace taut::paper {

/// Three vertices, whose orientation is asked about. Kept in the order of their numbers, so that a triple has one value
/// at one instant, whatever the order in which it is named.
class Triple {
 public:
  Triple(int u, int v, int w);
  const std::array<int, 3>& vertices() const { return vertices_; }
  /// Positive where u, v, w turn counterclockwise; twice the area of the triangle, rounded.
  double value(const MovingBodies& bodies, double t) const;
  /// Its sign: 0 where the rounded value is.
  int sign(const MovingBodies& bodies, double t) const;

 private:
  friend double failure_time(const MovingBodies&, const Triple&, int, double, double, std::uint64_t*);
  std::array<int, 3> vertices_;
  int parity_ = 1;
};

/// The first instant in [from, until] at which the sign of the triple is the opposite of `sign`; infinite if there is
/// none. Between `from` and `until`, no motion has a joint.
///
/// The value, its slope and a bound on its second derivative give a step within which the sign cannot change. Steps end
/// where they are down to the resolution of time, and the sign has changed: so roots are isolated up to rounding, not
/// certified. `steps` counts them, if it is not null.
double failure_time(const MovingBodies& bodies, const Triple& triple, int sign, double from, double until,
                    std::uint64_t* steps = nullptr);

}  // namespace taut::paper
