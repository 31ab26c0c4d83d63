// Motions along lines and by even turns: stretches of them without a model.
#pragma once

#include <span>

#include "motion/pose.hpp"
#include "spacetime/hierarchy.hpp"

namespace taut::internal::spacetime {

/// A stretch of an even motion. What its parabolas leave out of the turn counts the more, the farther a point of P is
/// from Q: a map is large, so the error of Q's carriage is for what lies within a disc that is set from box to box.
class UniformStretch {
 public:
  /// For points of P in this disc.
  const Stretch& near(Vector centre, double radius) {
    stretch_.in_q.error =
        (base_ + turn_error_ * (l1_norm(centre - origin_) + radius + way_)) * (1 + 0x1p-40) + underflow_slack;
    return stretch_;
  }
  const Stretch& near(const Box& box) { return near(box.centre, box.radius); }
  double r() const { return stretch_.r; }
  /// For all points: coordinates are at most 1, up to the displacement.
  const Stretch& everywhere() { return near({}, 2); }

 private:
  friend class UniformMotion;
  Stretch stretch_;
  double base_ = 0, turn_error_ = 0;  ///< of Q's carriage: at Q's origin, and for each unit of distance from it
  Vector origin_;                     ///< of Q in P's frame at the middle,
  double way_ = 0;                    ///< from which it gets no farther in the stretch
};

/// What planners ask about: bodies that move evenly along a line while they turn evenly, links seen from links. Around
/// any instant such a motion is a parabola up to the third power of the angle, so that a sine, a cosine and a few
/// products make a stretch, where models of general motions take microseconds.
class UniformMotion {
 public:
  /// Is the piece one of those? A line and an angle of degree at most 1, about any pivot, and no orbit.
  static bool is_even(const MotionPiece& piece);

  /// Of Q seen from P. Both chains of even pieces are seen from one frame, outermost first; an empty one rests there.
  /// They must stay where they are. No point of Q is farther from its origin than `reach`.
  UniformMotion(std::span<const MotionPiece> p, std::span<const MotionPiece> q, double reach)
      : p_(p), q_(q), reach_(reach) {}

  /// Keeps the law of Stretch, with no bridges and no offsets.
  UniformStretch stretch(double start, double end) const;

 private:
  std::span<const MotionPiece> p_, q_;
  double reach_;
};

}  // namespace taut::internal::spacetime
