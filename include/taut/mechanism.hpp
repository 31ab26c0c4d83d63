// Mechanisms: bodies joined by pins and slides, also in closed loops, of which some are driven.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "taut/motion.hpp"

namespace taut {

/// Two bodies that turn about a common point or slide along each other. All places are those of the drawn pose, the one
/// in which the bodies are given; there, every joint has the value 0.
struct MechanismJoint {
  /// How the two bodies can move against each other.
  enum class Kind {
    revolute,  ///< the second body turns about `at`; the value is the angle in degrees, counterclockwise
    slide,     ///< the second body slides along `direction`; the value is a length in the scene's units
  };
  std::string name;
  Kind kind = Kind::revolute;
  std::string first, second;  ///< the value is that of the second body, as the first one sees it
  Point at = {};              ///< of a revolute joint
  Point direction = {};       ///< of a slide; of any length but 0. It turns with the first body.
  /// Several joints have this name, one for each further body on a pin. Such a joint can be neither driven nor coupled.
  bool shared = false;
};

/// What a driven joint's value is at a time.
struct Drive {
  /// A part of it: the line from (t0, v0) to (t1, v1), or a polynomial in the time t itself.
  struct Piece {
    double until = std::numeric_limits<double>::infinity();  ///< the next piece holds from here on
    std::optional<std::array<double, 4>> line = {};          ///< t0, v0, t1, v1
    Coefficients polynomial = {};                            ///< in ascending powers of t
  };
  std::string joint;
  std::vector<Piece> pieces;  ///< at least one, in order of time, each where the one before has ended
};

/// A joint's value is `times` that of another joint: gears, racks, belts. Degrees and lengths count as they are.
struct Coupling {
  std::string joint, to;
  double times = 1;
};

/// Bodies, by their names in the scene, and how they are joined.
struct Mechanism {
  std::string ground;  ///< the body that rests
  std::vector<MechanismJoint> joints;
  std::vector<Drive> drives;
  std::vector<Coupling> couplings;
};

/// Where a mechanism cannot go on as its drives say, or not in one way only.
struct MechanismLock {
  /// Why it cannot go on.
  enum class Kind {
    dead_point,    ///< the driven joints turn back: two links are in line
    change_point,  ///< the motion could go on in more than one way
    undecided,     ///< two links come so near to a line that it is not decided whether it locks
  };
  std::array<double, 2> time{};  ///< the lock is in this interval
  Kind kind = Kind::dead_point;
  std::vector<std::string> joints;  ///< those that could move there without the driven ones
  std::vector<std::string> links;   ///< the bodies that they join
};

/// "dead point", "change point" or "undecided".
const char* to_string(MechanismLock::Kind kind);

struct Scene;

/// The scene with the motions of its mechanism's links: each link is seen from the one that carries it, and follows the
/// joint between them. The motion is followed from the drawn pose to the beginning of the drives, and from there to the
/// end. If the mechanism locks before, the scene ends there: see Scene::lock. A scene without a mechanism, or with
/// motions already, is returned as it is.
///
/// Throws InputError if the mechanism is not well defined: a name that is not there, a link that does not hang together
/// with the ground, loops that constrain each other, a number of driven joints that is not the mobility, a drawn pose
/// at a dead point, a lock on the way to the beginning.
Scene assembled(Scene scene);

}  // namespace taut
