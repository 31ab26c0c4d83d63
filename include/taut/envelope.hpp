// For which combinations of joint values do bodies keep apart?
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "taut/check.hpp"

namespace taut::internal {
class LoopRegion;
}

namespace taut {

/// The most joints that a linkage may have.
inline constexpr int max_joints = 4;

/// A value for each joint, in the order of Linkage::joints; those beyond mean nothing.
using JointValues = std::array<double, max_joints>;

/// A value that somebody or something sets, in [lo, hi]: an angle in degrees, or a length.
struct Joint {
  std::string name;
  double lo = 0, hi = 0;
};

/// The body turns about a point of its own coordinates, counterclockwise, by the joint's degrees.
struct Revolute {
  Point pivot;
};
/// The body moves along a vector, by the joint's value times it: give one of length 1 if the value is a length.
struct Slide {
  Point direction;
};

/// The body moves freely: it turns about a point of its own coordinates by the value of one joint, and is then moved by
/// the values of two others. A point p is at R (p - pivot) + pivot + (x, y), as with keyframes. Joints that are left
/// out move nothing; at least one is there. Each is the joint's position in Linkage::joints.
struct FreeMotion {
  std::optional<int> x, y, deg;
  Point pivot = {};
};

/// The body is a link of a mechanism, and follows one of its joints, which driven joints move. Made by assembled(), not
/// by users.
struct LinkMotion {
  JointFollower follows;  ///< without `region`, as a function of the driven joint's value
  Point pivot;            ///< if it turns
  /// If several driven joints move its loop: the joint's values as functions of theirs.
  std::shared_ptr<const internal::LoopRegion> region = nullptr;
};

/// The loops of a mechanism that one driven joint moves, or several that move them together.
struct DrivenLoops {
  int joint = 0;  ///< its position in Linkage::joints; of several, that of the first
  std::shared_ptr<const internal::AssembledMechanism> assembly;  ///< of one joint, with its value as the time
  std::shared_ptr<const internal::LoopRegion> region = nullptr;  ///< of several
};

/// How a body follows a joint: by times * value + plus, in degrees or lengths. A gear's wheel, a rack, and both jaws of
/// a gripper follow one joint.
struct JointMotion {
  std::variant<Revolute, Slide, FreeMotion, LinkMotion> kind;
  /// Its position in Linkage::joints; a FreeMotion names its own. Neither that nor a LinkMotion has times and plus.
  int joint = 0;
  double times = 1, plus = 0;
};

/// Bodies whose place is given by joint values instead of time. A mechanism in `scene` has no drives of its own: those
/// of its joints are driven that have the name of one of `joints`, whose value is then that of the driven joint. Angles
/// in radians are the sum of two terms, (pi / 180) times * value and (pi / 180) plus, each of whose coefficients is
/// rounded once, as elsewhere.
struct Linkage {
  std::vector<Joint> joints;
  /// Bodies, their frames (`relative_to`: an arm's links are chained by it), and pairs that are ignored. Its time, and
  /// the motions of its bodies, mean nothing.
  Scene scene;
  /// For each body, in order, the joint that it follows; without one it rests in its frame. May be shorter.
  std::vector<std::optional<JointMotion>> motions;
  /// Of a mechanism, made by assembled(), not by users: how driven joints move its loops.
  std::vector<DrivenLoops> loops = {};
};

/// The linkage with the motions of its mechanism's links: each is seen from the one that carries it. A linkage without
/// a mechanism, or with these motions already, is returned as it is.
///
/// A loop that follows one driven joint must not lock within that joint's range. Where several move one loop together,
/// it may: combinations at which a lock may lie are undecided, and so are those to which no way leads from the drawn
/// pose through combinations that are not. Throws InputError otherwise, and as assembled(Scene) does.
Linkage assembled(Linkage linkage);

/// What is known of a box of joint values.
enum class CellState : unsigned char {
  free,       ///< for all values in it, no asked pair touches
  colliding,  ///< for all values in it, the interiors of one pair overlap
  undecided,  ///< neither was shown before the box became as small as the tolerance
};

/// "free", "colliding", "undecided".
const char* to_string(CellState state);

/// A box of joint values: `lo[k]` to `hi[k]` of joint k.
struct EnvelopeCell {
  CellState state = CellState::undecided;
  JointValues lo{}, hi{};
  std::array<BodyId, 2> pair{};  ///< which overlaps, or was not distinguished
  /// Of an undecided cell: not the pair is why, but a mechanism that may lock in it, or does not get there.
  bool may_lock = false;
  /// Of a search that found that there is no way: cells that were not shown to collide lead here from the start.
  bool reached = false;
};

/// A combination at which two bodies overlap.
struct EnvelopeWitness {
  JointValues values{};
  std::array<BodyId, 2> pair{};
};

/// The answer of envelope().
struct Envelope {
  /// free: for every combination. contact: not for the one in `witness`. undecided: no combination was found that
  /// collides, and not all were shown to be free. untested: no pair was tested.
  Outcome outcome = Outcome::undecided;
  std::optional<EnvelopeWitness> witness;
  /// Shares of all combinations; they sum to 1, up to rounding.
  double free = 0, colliding = 0, undecided = 0;
  /// That share of `undecided` at which a mechanism may lock, or to which it does not get from the drawn pose.
  double may_lock = 0;
  /// Cells are decided for one pose of the mechanism: the one to which ways through decided cells lead. Are there
  /// perhaps ways without a lock, through undecided cells, to another pose at the same values? Only of several loops
  /// that several drives move together.
  bool other_poses = false;
  /// A partition of all combinations.
  std::vector<EnvelopeCell> cells;
  std::string reason;  ///< why cells larger than the tolerance are undecided, or nothing was tested; empty otherwise
  Coverage coverage;   ///< pairs of bodies that are fixed to each other are `at_rest`
};

/// How to ask.
struct EnvelopeOptions {
  /// Cells no side of which is longer than this share of its joint's range are not divided any more. In [1e-6, 1].
  double tolerance = 1e-3;
  Limits limits = {};
};

/// Divides all combinations of joint values into cells that are free, that collide, and small ones of which that is not
/// shown: the border between the two, and bodies that touch without overlap. Every two bodies are asked about that are
/// not ignored and are not fixed to each other. By subdivision; in each cell bodies are bounded to first order in the
/// joint values, with a certified bound of the rest. Coarse cells come first, so that a limit leaves a coarser answer.
/// Throws InputError.
Envelope envelope(const Linkage& linkage, const EnvelopeOptions& options = {});

/// Throws InputError unless the linkage can be asked about: joints and their ranges, motions, and what validate() wants
/// of shapes and frames.
void validate(const Linkage& linkage);

/// The bodies where these joint values put them, at rest, as a scene with time [0, 0]. Throws InputError if a mechanism
/// is not shown to get there.
Scene posed(const Linkage& linkage, const JointValues& values);

/// The answer of envelope() as `taut envelope --json` prints it; `cells`: with the whole partition.
std::string envelope_json(const Linkage& linkage, const Envelope& answer, double tolerance, bool cells);
/// All combinations as an SVG picture, of one or two joints. Throws InputError if there are more.
std::string envelope_svg(const Linkage& linkage, const Envelope& answer, int width = 720);

}  // namespace taut
