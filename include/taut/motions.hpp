// Motions as people write them, in degrees and by keyframes, compiled to pieces.
//
// Rounding. A motion's coefficients are doubles, and they are what check() takes exactly. Each coefficient made here is
// the double nearest to its exact value: degrees become radians and slopes are divided in 960 bits, and the result is
// rounded once. A line between two keyframes is in powers of the time since the earlier one (MotionPiece::origin). So
// x and y are exactly those written at the earlier keyframe, and the line ends within 2^-53 |b - a| of those written at
// the later one, whenever that is. Angles are rounded by 2^-53 of their size in radians besides. Pivots, velocities,
// and angles held at a multiple of 90 degrees are not rounded at all.
#pragma once

#include <optional>
#include <vector>

#include "taut/check.hpp"
#include "taut/motion.hpp"

namespace taut {

/// How a body comes to a keyframe from the one before.
enum class Way {
  straight,  ///< on a straight line, turning evenly
  turn,      ///< around a centre, turning with it, like a car: an arc driven
  arc,       ///< around a centre without turning, like a tool on a circular path
};

/// Where a body is at an instant: moved by (x, y), and turned counterclockwise about the motion's pivot.
struct Keyframe {
  double t = 0;
  double x = 0, y = 0;
  double angle_deg = 0;
  /// Around `centre`, in the coordinates in which the motion is seen, the pivot goes by `by_deg` degrees. Then x, y and
  /// angle_deg say nothing: the place is what follows from the keyframe before, as computed there, each number rounded
  /// once. The circle is exact, no polygon.
  Way way = Way::straight;
  Point centre = {};
  double by_deg = 0;
};

/// An angle in degrees, enclosed.
struct AngleInterval {
  double lo = 0, hi = 0;
};

/// The double nearest to degrees * pi / 180 (one of the two, should it lie within 2^-900 of their middle).
double radians(double degrees);

/// From each keyframe to the next, linear where the way is straight, angles as written: from 350 to 370 is 20 degrees,
/// from 350 to 10 is -340. Before the first keyframe and after the last one the body rests. Throws InputError if there
/// is none, if times do not ascend, or if a number is not finite.
Motion from_keyframes(const std::vector<Keyframe>& keyframes, const Point& pivot = {});

/// Moved by velocity * t and turned by spin_deg * t degrees about a pivot that moves along: at t = 0 the body is at its
/// own coordinates. Throws InputError if a number is not finite.
Motion from_velocity(const Point& velocity, double spin_deg = 0, const Point& pivot = {});

/// Turned about a pivot at rest by an angle that goes evenly from `from_deg` at time `start` to `to_deg` at time `end`,
/// and on at the same rate outside. Answers state the angle. Throws InputError if a number is not finite, or if
/// start >= end.
Motion from_sweep(const Point& pivot, double from_deg, double to_deg, double start, double end);

/// The angle of a sweep during an interval of time: what the motion's coefficients say, in degrees. Nothing if the
/// motion is not a sweep.
std::optional<AngleInterval> angle_at(const Motion& motion, const TimeInterval& time);
/// The same at a contact, for the body that sweeps; for the first one if both do.
std::optional<AngleInterval> contact_angle(const Scene& scene, const Contact& contact);

}  // namespace taut
