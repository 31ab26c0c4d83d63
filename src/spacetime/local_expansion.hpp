// The local behaviour of a certificate function within a window: first and second order bounds.
#pragma once

#include "certificate/fast_function.hpp"
#include "spacetime/frame_window.hpp"

namespace taut::internal::spacetime {

/// Value, slope and second derivative of a function at t, with the orientation in which `sign` is positive.
struct LocalExpansion {
  Bounded value, slope, second;
  LocalExpansion(const FastFunction& f, FrameWindow& window, double t, int sign);
  /// The largest h <= limit such that the function is certainly positive on [0, h); 0 if it is not certain at 0.
  double positive_until(double limit) const;
  /// Some h at which the function is certainly negative, soon after its first root, if the function certainly falls on
  /// [0, h]; infinite if there is none up to `limit`. `falls_until` is the time for which it certainly falls.
  double negative_from(double limit, double& falls_until) const;
};

}  // namespace taut::internal::spacetime
