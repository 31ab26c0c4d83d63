// A scene: bodies, their motions, and the time interval in question.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "taut/geometry.hpp"
#include "taut/mechanism.hpp"
#include "taut/motion.hpp"
#include "taut/outline.hpp"

namespace taut::internal {
class PreparedShape;
struct AssembledMechanism;
}  // namespace taut::internal

namespace taut {

/// A rigid body, moving: the interior of a simple polygon, or of the union of parts that move together. The parts of a
/// body may touch and overlap each other.
struct Body {
  std::string name;
  /// The boundary of a body that is one polygon; empty where `parts` say what the body is.
  Polygon polygon;
  Motion motion;
  /// What prepare(polygon) returned (taut/shape.hpp), for scenes of shapes that come again; may be null. `polygon` is
  /// then best left empty. If it is not, each check compares it with the prepared one, and anything but the same
  /// polygon is an InputError.
  std::shared_ptr<const internal::PreparedShape> prepared = nullptr;
  /// What the user calls it by: a JSON value, as text, which is handed through to answers; may be empty.
  std::string id = {};
  /// The parts of a body that is not one polygon.
  std::vector<Part> parts = {};
  /// The name of another body of the scene, in whose frame the motion is seen; empty: the world's. Chains of parents
  /// have at most max_depth bodies, and no cycles.
  std::string relative_to = {};
  /// The parts of a body that is bounded by curves; `polygon`, `parts` and `prepared` are empty then. Questions that
  /// do not take curves refuse it: flatten() makes polygons of it.
  std::vector<CurvedPart> curves = {};
  /// The layers that its parts reach through, but for those that have layers of their own.
  Layers z = {};
};

/// A distance that may change with time, in the scene's units: a polynomial in t - origin, in ascending powers, of
/// degree at most 16. It must not be negative at any time of the scene, nor 0 at all of them.
struct Margin {
  Coefficients coefficients = {};
  double origin = 0;
};

/// A clearance of its own for some pairs of bodies.
struct PairClearance {
  std::array<std::string, 2> pair;  ///< by name; "*" is every other body
  Margin margin;
};

/// The most bodies that a chain of `relative_to` may have.
inline constexpr int max_depth = 16;

/// What to do about pairs of bodies that do not move relative to each other: both rest, or both have the same motion at
/// all times, parents included.
enum class AtRest {
  /// Test them only if no two bodies, of those not ignored altogether, move relative to each other, as in a layout.
  /// Otherwise leave them out; Coverage::at_rest and Coverage::moving_alike count them.
  skip,
  test,   ///< test them at the start, which decides them for all times
  never,  ///< leave them out, even if nothing moves: in a part of a longer motion's time, say. Files do not say this
};

/// Bodies and a closed time interval [start, end] (start <= end). The question is about every two bodies that are not
/// ignored and that move relative to each other, and about the others as `at_rest` says.
struct Scene {
  double start = 0;
  double end = 0;
  std::vector<Body> bodies;
  /// Pairs of bodies that are not tested, by name; "*" is every other body.
  std::vector<std::array<std::string, 2>> ignore = {};
  /// What the user calls it by: a JSON value, as text, which is handed through to the answer; may be empty.
  std::string id = {};
  AtRest at_rest = AtRest::skip;
  /// How bodies are joined; assembled() gives them their motions. Those bodies have neither a motion nor a parent of
  /// their own.
  std::optional<Mechanism> mechanism = {};
  /// Made by assembled(): where the mechanism locks, within the time or at its end. The scene then ends there.
  std::optional<MechanismLock> lock = {};
  /// Made by assembled(); null before.
  std::shared_ptr<const internal::AssembledMechanism> assembly = nullptr;
  /// For check_clearance(): what certain pairs are to keep instead of the clearance that is asked about. What names
  /// both bodies counts before what names one of them, and that before "*" twice. Two that name one body each of a
  /// pair, and say different things, are an error unless a third one names both. Other questions pass over it.
  std::vector<PairClearance> clearances = {};
};

/// What counts as a collision.
enum class Touch {
  open,    ///< the interiors overlap; touching without overlap is no collision
  closed,  ///< touching counts
};

}  // namespace taut
