// Bounds of the relative motion that hold however often the bodies rotate.
#pragma once

#include "spacetime/hierarchy.hpp"
#include "spacetime/stretch.hpp"

namespace taut::internal::spacetime {

/// The relative motion over a long interval, in which only the translation is enclosed; rotations may be any. Each
/// box then stays in a ring about the point that the other body's frame rotates about, so that a million rotations next
/// to something out of reach cost as much as one.
class AnyRotation {
 public:
  /// On [start, end] of the parameter of a segment that is no bridge.
  AnyRotation(const MotionSegment& segment, double start, double end);
  /// Certainly farther than `margin` from each other at all times of the interval.
  bool farther(const Box& p, const Box& q, double margin) const;
  /// The same of a hole and a body in it, if one of the nodes belongs to a hole.
  bool nested(const TreePair& trees, const BoxNode& p, const BoxNode& q, double margin) const;

 private:
  /// One body as seen from the other: its point v is at about + R (v + moving) + e, for a rotation R, |e| <= error.
  struct Side {
    Vector about, moving;
    double error = 0;
    bool farther(const Box& fixed, const Box& moved, double margin) const;
    bool holds(const Disc& fixed, const Disc& moved, double margin) const;
  };
  Side in_p_, in_q_;
  /// Where both bodies rotate: how far the points are from each other about which they do; unset for chains of parents.
  double least_ = 0, most_ = -1;
};

}  // namespace taut::internal::spacetime
