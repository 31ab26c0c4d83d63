// Distances along a direction that is fixed to one body, as functions of time, with first and second order bounds.
#pragma once

#include "pair/pair_geometry.hpp"
#include "spacetime/frame_window.hpp"

namespace taut::spacetime {

/// A value with a bound of its error.
struct Bounded {
  double value, error;
  double lower() const { return value - error; }
  double upper() const { return value + error; }
  int sign() const { return value > error ? 1 : (-value > error ? -1 : 0); }
};

/// n . (moving point - fixed point), where n and the fixed point belong to one body and the moving point to the other,
/// in the first body's frame (on a bridge times its scale, squared). Displaced vertices are covered: the error bounds
/// hold for points and directions that are up to 2^-155 away from those given.
class DirectedDistance {
 public:
  /// `pp`: the fixed point is P's.
  DirectedDistance(const Leg& leg, bool pp, const Point& n, const Point& fixed, const Point& moving);

  bool pp() const { return pp_; }
  Bounded value(const FrameSample& s) const { return combine(s.f, s.error); }
  Bounded slope(const FrameSample& s) const { return combine(s.d, s.error_d); }
  Bounded bend(const FrameBend& b) const { return combine(b.mid, b.rad); }

 private:
  Bounded combine(const double* f, const double* error) const {
    double v = 0, e = 0;
    for (int i = 0; i < 5; ++i) {
      v += a_[i] * f[i];
      e += m_[i] * (error[i] + 0x1p-49 * (f[i] < 0 ? -f[i] : f[i]));
    }
    return {v, e * (1 + 0x1p-40) + underflow_slack};
  }

  double a_[5], m_[5];  ///< coefficients, and magnitudes that bound their rounding
  bool pp_;
};

/// Value, slope and bend of a function at t, turned so that `sign` is positive.
struct Course {
  Bounded value, slope, bend;
  Course(const DirectedDistance& f, FrameWindow& window, double t, int sign);
  /// The largest h <= limit such that the function is certainly positive on [0, h); 0 if it is not certain at 0.
  double positive_until(double limit) const;
  /// Some h at which the function is certainly negative, soon after its first root, if the function certainly falls
  /// on [0, h]; infinite if there is none up to `limit`. `falls_until`: how long it certainly falls.
  double negative_from(double limit, double& falls_until) const;
};

}  // namespace taut::spacetime
