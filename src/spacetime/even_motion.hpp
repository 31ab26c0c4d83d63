// Motions along lines and by even turns: stretches of them without a model.
#pragma once

#include <span>

#include "motion/pose.hpp"
#include "spacetime/stretch.hpp"

namespace taut::spacetime {

/// What planners ask about: bodies that move evenly along a line while they turn evenly, links seen from links. Around
/// any instant such a motion is a parabola up to the third power of the angle, so that a sine, a cosine and a few
/// products make a stretch, where models of general motions take microseconds.
class EvenMotion {
 public:
  /// Is the piece one of those? A line and an angle of degree at most 1, about any pivot, and no orbit.
  static bool is_even(const MotionPiece& piece);

  /// Of Q seen from P. Both chains of even pieces are seen from one frame, outermost first; an empty one rests there.
  /// They must stay where they are.
  EvenMotion(std::span<const MotionPiece> p, std::span<const MotionPiece> q) : p_(p), q_(q) {}

  /// Keeps the law of Stretch, with no bridges and no offsets.
  Stretch stretch(double start, double end) const;

 private:
  std::span<const MotionPiece> p_, q_;
};

}  // namespace taut::spacetime
