// Motions along lines and by uniform rotations: their stretches without a model.
#pragma once

#include <span>

#include "motion/pose.hpp"
#include "spacetime/hierarchy.hpp"

namespace taut::internal::spacetime {

/// A stretch of a uniform motion. The remainder of its parabolas for the rotation is multiplied by the distance of a
/// point of P from Q. A map is large, so the error of Q's relative pose applies to a disc that is set for each box.
class UniformStretch {
 public:
  /// The stretch for points of P in this disc.
  const Stretch& near(Vector centre, double radius) {
    stretch_.in_q.error =
        (base_ + turn_error_ * (l1_norm(centre - origin_) + radius + way_)) * (1 + 0x1p-40) + underflow_slack;
    return stretch_;
  }
  const Stretch& near(const Box& box) { return near(box.centre, box.radius); }
  double r() const { return stretch_.r; }
  /// The stretch for all points: coordinates are at most 1, up to the displacement.
  const Stretch& everywhere() { return near({}, 2); }

 private:
  friend class UniformMotion;
  Stretch stretch_;
  double base_ = 0, turn_error_ = 0;  ///< of the pose in Q's frame: at Q's origin, and for each unit of distance from
                                      ///< it
  Vector origin_;                     ///< the position of Q's origin in P's frame at the middle,
  double way_ = 0;                    ///< and a bound of its distance from there in the stretch
};

/// The motions that planners use: bodies that move uniformly along a line while they rotate uniformly, and links
/// relative to links. Around any instant, such a motion is a parabola up to the third power of the angle. So a sine, a
/// cosine and a few products make a stretch, where models of general motions take microseconds.
class UniformMotion {
 public:
  /// Is the piece such a motion? It must be a line and an angle of degree at most 1, about any pivot, without an orbit.
  static bool is_even(const MotionPiece& piece);

  /// The motion of Q relative to P. Both chains of uniform pieces are in one frame, outermost first; an empty one rests
  /// there. The caller must keep them in place. No point of Q is farther from its origin than `reach`.
  UniformMotion(std::span<const MotionPiece> p, std::span<const MotionPiece> q, double reach)
      : p_(p), q_(q), reach_(reach) {}

  /// Obeys the law of Stretch, without bridges and offsets.
  UniformStretch stretch(double start, double end) const;
  /// An instant of it, in P's frame alone: nothing is claimed in Q's.
  Stretch instant(double t) const;

 private:
  std::span<const MotionPiece> p_, q_;
  double reach_;
};

}  // namespace taut::internal::spacetime
