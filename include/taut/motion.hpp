// Rigid motions as a user writes them (section 3 of the paper).
#pragma once

#include <limits>
#include <memory>
#include <variant>
#include <vector>

#include "taut/geometry.hpp"

namespace taut::internal {
class JointFunctions;
}

namespace taut {

/// Coefficients of a polynomial in the time since the piece's origin, t - origin, in ascending powers. Empty means
/// zero.
using Coefficients = std::vector<double>;

/// x(t) = (1, 0): the body keeps its orientation.
struct NoRotation {};
/// x(t) = (cos theta(t), sin theta(t)), theta in radians.
struct AngleRotation {
  Coefficients angle;
};
/// x(t) = (a(t), b(t)) / sqrt(a(t)^2 + b(t)^2); (a, b) must not vanish on the piece
/// (nor be so near to it that 960 bits cannot decide).
struct DirectionRotation {
  Coefficients a, b;
};
/// x(t) = ((1 - s^2), 2 s) / (1 + s^2), s = s(t) the tangent of half the angle.
struct HalfAngleRotation {
  Coefficients s;
};
/// x(t) = (a(t), sqrt(1 - a(t)^2)); |a| must not exceed 1 on the piece (an excess below 2^-40 counts as rounding, and
/// the square root is 0 there).
struct CosineRotation {
  Coefficients a;
};
/// The body follows a joint of a mechanism (taut/mechanism.hpp): it turns about the piece's pivot, or slides. Made by
/// assembled(), not by users; all else of the piece means nothing.
struct JointFollower {
  std::shared_ptr<const internal::JointFunctions> functions;
  int joint = 0;  ///< its number there
  int piece = 0;  ///< of the drives
  bool slides = false;
  Point direction = {};  ///< of a slide
  int sign = 1;          ///< -1: the joint's first body follows, seen from the second one
  int exponent = 0;      ///< coordinates are multiplied by 2^exponent
};
/// How a piece turns: one of the forms above.
using Rotation =
    std::variant<NoRotation, AngleRotation, DirectionRotation, HalfAngleRotation, CosineRotation, JointFollower>;

/// A turn of the place at which a body is: what it would be without is turned about `centre`, by an angle in radians.
struct Orbit {
  Point centre;
  Coefficients angle;
};

/// One piece of a motion: the body's point (u, v) is at o(t) + c + (u - c.x) x(t) + (v - c.y) y(t), where o = (x, y)
/// below, c is the pivot, x(t) is given by `rotation`, and y(t) is x(t) turned by +90 degrees.
struct MotionPiece {
  Coefficients x, y;
  Rotation rotation;
  /// The piece holds before this instant; the last piece of a motion may leave it infinite.
  double until = std::numeric_limits<double>::infinity();
  /// What the body turns about, in its own coordinates. No difference u - c.x is ever rounded. Without a rotation it
  /// means nothing.
  Point pivot = {};
  /// Empty angle: none. Else the pivot is at centre + e (o(t) + c - centre), where e is the unit vector of that angle;
  /// the body's own rotation stays what `rotation` says. The centre is in the coordinates in which the motion is seen.
  Orbit orbit = {};
  /// The instant from which the piece's polynomials count time: by default 0, so that they are polynomials in t itself.
  /// The difference t - origin is never rounded. With an origin nearby, coefficients are as small as the motion itself,
  /// however late it takes place.
  double origin = 0;
};

/// Pieces in order of time; piece k holds on [until of k-1, until of k). No piece at all: the body rests at its
/// own coordinates.
struct Motion {
  std::vector<MotionPiece> pieces;
  /// The angle is the parameter of this motion: answers state it (see angle_at() in taut/motions.hpp).
  bool sweep = false;
};

/// Highest degree of a polynomial that a motion may have.
inline constexpr int max_degree = 16;

}  // namespace taut
