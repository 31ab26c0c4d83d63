// What is hashed, byte for byte: docs/proof-format.md.
#include <algorithm>
#include <map>
#include <variant>

#include "geometry/segment_numbers.hpp"
#include "motion/pieces.hpp"
#include "motion/pose.hpp"
#include "proof/bytes.hpp"
#include "proof/curved_scene.hpp"
#include "proof/sha256.hpp"
#include "scene/joined_parts.hpp"
#include "scene/mechanism_lock.hpp"
#include "scene/ring_set.hpp"
#include "scene/untested.hpp"
#include "taut/error.hpp"
#include "taut/path_proof.hpp"
#include "taut/proof.hpp"
#include "taut/shape.hpp"

namespace taut {
using namespace internal;
namespace {

/// Stands for the index of a parent where there is none.
constexpr std::size_t no_parent = 0xffffffffu;

/// Stands for the length of a polynomial, where a piece has an origin.
constexpr std::size_t has_origin = 0xffffffffu;

class Hasher {
 public:
  explicit Hasher(const char* name) {
    for (; *name; ++name) hash_.add(static_cast<std::uint8_t>(*name));
  }
  void byte(std::size_t x) { hash_.add(static_cast<std::uint8_t>(x)); }
  void count(std::size_t x) {
    for (int i = 0; i < 4; ++i) byte(x >> (8 * i));
  }
  /// Both zeros are one number.
  void number(double x) {
    const std::uint64_t bits = proof::bits_of(x == 0 ? 0.0 : x);
    for (int i = 0; i < 8; ++i) byte(static_cast<std::size_t>(bits >> (8 * i) & 0xff));
  }
  void point(const Point& p) {
    number(p.x);
    number(p.y);
  }
  void polynomial(const Coefficients& c) {
    count(c.size());
    for (const double x : c) number(x);
  }
  Fingerprint finish() { return hash_.finish(); }

 private:
  proof::Sha256 hash_;
};

void add_piece(Hasher& hash, const MotionPiece& piece) {
  hash.number(piece.until);
  if (piece.origin != 0) {
    hash.count(has_origin);
    hash.number(piece.origin);
  }
  hash.polynomial(piece.x);
  hash.polynomial(piece.y);
  if (orbits(piece)) {
    hash.byte(5);
    hash.point(piece.orbit.centre);
    hash.polynomial(piece.orbit.angle);
  }
  // A form's number is its place in the variant.
  hash.byte(piece.rotation.index());
  for_each_polynomial(piece.rotation, [&](const Coefficients& c) { hash.polynomial(c); });
  if (turns(piece) || orbits(piece)) hash.point(piece.pivot);
}

void add_ring(Hasher& hash, const Polygon& ring) {
  hash.count(ring.size());
  for (const Point& v : ring) hash.point(v);
}

void add_outline(Hasher& hash, const Outline& outline) {
  hash.point(outline.start);
  hash.count(outline.segments.size());
  for (const CurveSegment& segment : outline.segments) {
    hash.byte(segment.index());
    for_each_number(segment, [&](double x) { hash.number(x); });
    const auto* arc = std::get_if<ArcTo>(&segment);
    if (arc) hash.byte((arc->large ? 1 : 0) + (arc->sweep ? 2 : 0));
  }
}

/// Of a scene with curves: which bodies have some, and those.
void add_curves(Hasher& hash, const Scene& scene) {
  for (const Body& body : scene.bodies) {
    hash.count(body.curves.size());
    for (const CurvedPart& part : body.curves) {
      hash.count(1 + part.holes.size());
      add_outline(hash, part.outline);
      for (const Outline& hole : part.holes) add_outline(hash, hole);
    }
  }
}

/// Stands for the number of pieces of a body that a joint moves.
constexpr std::size_t follows_joint = 0xfffffffeu;

void add_motion(Hasher& hash, const Body& body, const Scene& scene) {
  const bool joined = std::any_of(body.motion.pieces.begin(), body.motion.pieces.end(),
                                  [](const MotionPiece& piece) { return followed_joint(piece); });
  if (joined) return hash.count(follows_joint);
  const std::vector<MotionPiece> pieces = given_pieces_between(body.motion, scene.start, scene.end);
  hash.count(pieces.size());
  for (const MotionPiece& piece : pieces) add_piece(hash, piece);
}

/// Of each body those of its parts; nothing if all parts are on all layers.
void add_layers(Hasher& hash, const Scene& scene) {
  std::vector<std::vector<Layers>> all;
  bool layered = false;
  for (const Body& body : scene.bodies) {
    all.push_back(layers_of_parts(body));
    for (const Layers& z : all.back()) layered = layered || !(z == Layers{});
  }
  if (!layered) return;
  hash.byte(2);
  for (const std::vector<Layers>& body : all) {
    hash.count(body.size());
    for (const Layers& z : body) {
      hash.number(z.lo);
      hash.number(z.hi);
    }
  }
}

void add_drive(Hasher& hash, const Drive& drive) {
  hash.count(drive.pieces.size());
  for (const Drive::Piece& piece : drive.pieces) {
    hash.number(piece.until);
    hash.byte(piece.line ? 1 : 0);
    if (piece.line) {
      for (const double x : *piece.line) hash.number(x);
    } else {
      hash.polynomial(piece.polynomial);
    }
  }
}

/// How bodies are joined; nothing without a mechanism.
void add_mechanism(Hasher& hash, const Scene& scene) {
  if (!scene.mechanism) return;
  const Mechanism& mechanism = *scene.mechanism;
  const std::map<std::string, int> bodies = bodies_by_name(scene);
  const auto add_body = [&](const std::string& name) { hash.count(static_cast<std::size_t>(bodies.at(name))); };
  const auto add_joint = [&](const std::string& name) {
    const auto found = std::find_if(mechanism.joints.begin(), mechanism.joints.end(),
                                    [&](const MechanismJoint& joint) { return joint.name == name; });
    hash.count(static_cast<std::size_t>(found - mechanism.joints.begin()));
  };
  hash.byte(3);
  add_body(mechanism.ground);
  hash.count(mechanism.joints.size());
  for (const MechanismJoint& joint : mechanism.joints) {
    const bool slides = joint.kind == MechanismJoint::Kind::slide;
    hash.byte(slides ? 1 : 0);
    add_body(joint.first);
    add_body(joint.second);
    hash.point(slides ? joint.direction : joint.at);
  }
  hash.count(mechanism.drives.size());
  for (const Drive& drive : mechanism.drives) {
    add_joint(drive.joint);
    add_drive(hash, drive);
  }
  hash.count(mechanism.couplings.size());
  for (const Coupling& coupling : mechanism.couplings) {
    add_joint(coupling.joint);
    add_joint(coupling.to);
    hash.number(coupling.times);
  }
}

/// What a body follows, and how.
void add_joint_motion(Hasher& hash, const JointMotion& motion) {
  hash.byte(motion.kind.index());
  // The mechanism says the rest.
  if (std::holds_alternative<LinkMotion>(motion.kind)) return hash.byte(static_cast<std::size_t>(motion.joint));
  if (const auto* free = std::get_if<FreeMotion>(&motion.kind)) {
    for (const std::optional<int>& joint : {free->x, free->y, free->deg})
      hash.byte(joint ? static_cast<std::size_t>(*joint) : 255);
    return hash.point(free->pivot);
  }
  const auto* revolute = std::get_if<Revolute>(&motion.kind);
  hash.point(revolute ? revolute->pivot : std::get<Slide>(motion.kind).direction);
  hash.byte(static_cast<std::size_t>(motion.joint));
  hash.number(motion.times);
  hash.number(motion.plus);
}

/// Of each joint of a linkage its number among those of the mechanism.
void add_driven_joints(Hasher& hash, const Mechanism& mechanism, const std::vector<Joint>& joints) {
  for (const Joint& joint : joints) {
    const auto found = std::find_if(mechanism.joints.begin(), mechanism.joints.end(),
                                    [&](const MechanismJoint& m) { return m.name == joint.name && !m.shared; });
    hash.count(found == mechanism.joints.end() ? no_parent
                                               : static_cast<std::size_t>(found - mechanism.joints.begin()));
  }
}

/// All bodies with their parts and parents, then which pairs are not tested.
void add_bodies(Hasher& hash, const Scene& scene) {
  const std::map<std::string, int> by_name = bodies_by_name(scene);
  const IgnoredPairs ignored(scene);
  hash.count(scene.bodies.size());
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    const std::vector<Part> parts = body.curves.empty() ? parts_of(body) : std::vector<Part>{};
    hash.count(parts.size());
    for (const Part& part : parts) {
      hash.count(1 + part.holes.size());
      add_ring(hash, part.outline);
      for (const Polygon& hole : part.holes) add_ring(hash, hole);
    }
    hash.count(body.relative_to.empty() ? no_parent : static_cast<std::size_t>(by_name.at(body.relative_to)));
    add_motion(hash, body, scene);
    hash.byte(ignored.has_all(static_cast<int>(i)) ? 1 : 0);
  }
  hash.count(ignored.pairs().size());
  for (const auto& [a, b] : ignored.pairs()) {
    hash.count(static_cast<std::size_t>(a));
    hash.count(static_cast<std::size_t>(b));
  }
  if (scene.at_rest == AtRest::test) hash.byte(1);
  if (scene.at_rest == AtRest::never) hash.byte(2);
  add_layers(hash, scene);
  add_mechanism(hash, scene);
}

}  // namespace

Fingerprint scene_fingerprint(const Scene& scene, Touch touch) {
  const bool curved = proof::any_curves(scene);
  Hasher hash(curved ? "taut curve 1" : "taut scene 3");
  hash.byte(touch == Touch::closed ? 1 : 0);
  hash.number(scene.start);
  hash.number(given_end(scene));
  add_bodies(hash, scene);
  if (curved) add_curves(hash, scene);
  return hash.finish();
}

Fingerprint path_fingerprint(const PathProblem& problem) {
  const std::vector<Joint>& joints = problem.linkage.joints;
  const Scene& scene = problem.linkage.scene;
  if (proof::any_curves(scene))
    throw InputError("bodies", "logs about paths of bodies with curves cannot be written",
                     "`taut flatten` makes polygons of the curves");
  Hasher hash("taut path 1");
  hash.count(joints.size());
  for (std::size_t k = 0; k < joints.size(); ++k) {
    hash.number(joints[k].lo);
    hash.number(joints[k].hi);
    hash.byte(problem.periodic[k] ? 1 : 0);
    hash.number(problem.start[k]);
  }
  hash.byte(problem.goal_outside ? 1 : 0);
  for (std::size_t k = 0; k < joints.size() && !problem.goal_outside; ++k) {
    hash.byte(problem.goal[k] ? 1 : 0);
    if (!problem.goal[k]) continue;
    hash.number((*problem.goal[k])[0]);
    hash.number((*problem.goal[k])[1]);
  }
  Scene bodies = scene;
  for (Body& body : bodies.bodies) body.motion = {};
  add_bodies(hash, bodies);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const bool follows = i < problem.linkage.motions.size() && problem.linkage.motions[i];
    hash.byte(follows ? 1 : 0);
    if (follows) add_joint_motion(hash, *problem.linkage.motions[i]);
  }
  if (scene.mechanism) add_driven_joints(hash, *scene.mechanism, joints);
  return hash.finish();
}

std::string to_hex(const Fingerprint& fingerprint) {
  std::string text;
  for (const std::uint8_t byte : fingerprint) {
    for (const int digit : {byte >> 4, byte & 15}) text += "0123456789abcdef"[digit];
  }
  return text;
}

}  // namespace taut
