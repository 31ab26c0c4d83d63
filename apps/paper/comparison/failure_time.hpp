// When the orientation of three moving vertices changes.
#pragma once

#include <array>
#include <cstdint>

#include "comparison/moving_bodies.hpp"

namespace taut::paper {

/// The cross product of two differences of moving vertices: (b - a) x (d - c).
struct Cross {
  int a = 0, b = 0, c = 0, d = 0;
  double value(const MovingBodies& bodies, double t) const;
};

/// Three vertices, whose orientation is asked about. Kept in the order of their numbers, so that a triple has one value
/// at one instant, whatever the order in which it is named.
class Triple {
 public:
  Triple(int u, int v, int w);
  const std::array<int, 3>& vertices() const { return vertices_; }
  /// Positive where u, v, w turn counterclockwise, times parity().
  Cross cross() const { return {vertices_[0], vertices_[1], vertices_[0], vertices_[2]}; }
  int parity() const { return parity_; }
  /// The sign of the rounded orientation of u, v, w.
  int sign(const MovingBodies& bodies, double t) const;

 private:
  std::array<int, 3> vertices_;
  int parity_ = 1;
};

/// The first instant in [from, until] at which `sign` times the cross product is negative; infinite if there is none.
/// Between `from` and `until`, no motion has a joint.
///
/// The value, its slope and a bound on its second derivative give a step within which the sign cannot change. Steps end
/// where they are down to the resolution of time, and the sign has changed: so roots are isolated up to rounding, not
/// certified. `steps` counts them, if it is not null.
double failure_time(const MovingBodies& bodies, const Cross& cross, int sign, double from, double until,
                    std::uint64_t* steps = nullptr);

}  // namespace taut::paper
