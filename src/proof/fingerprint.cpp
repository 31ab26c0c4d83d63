// What is hashed, byte for byte: docs/proof-format.md.
#include <variant>

#include "motion/pieces.hpp"
#include "motion/pose.hpp"
#include "pair/validate_world.hpp"
#include "proof/bytes.hpp"
#include "proof/sha256.hpp"
#include "taut/error.hpp"
#include "taut/proof.hpp"
#include "taut/shape.hpp"

namespace taut {
namespace {

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

/// One overload for each form: one that is forgotten does not compile.
struct RotationHasher {
  Hasher& hash;

  void operator()(const NoRotation&) const { hash.byte(0); }
  void operator()(const AngleRotation& r) const {
    hash.byte(1);
    hash.polynomial(r.angle);
  }
  void operator()(const DirectionRotation& r) const {
    hash.byte(2);
    hash.polynomial(r.a);
    hash.polynomial(r.b);
  }
  void operator()(const HalfAngleRotation& r) const {
    hash.byte(3);
    hash.polynomial(r.s);
  }
  void operator()(const CosineRotation& r) const {
    hash.byte(4);
    hash.polynomial(r.a);
  }
};

void add_piece(Hasher& hash, const MotionPiece& piece) {
  hash.number(piece.until);
  hash.polynomial(piece.x);
  hash.polynomial(piece.y);
  if (orbits(piece)) {
    hash.byte(5);
    hash.point(piece.orbit.centre);
    hash.polynomial(piece.orbit.angle);
  }
  std::visit(RotationHasher{hash}, piece.rotation);
  if (turns(piece) || orbits(piece)) hash.point(piece.pivot);
}

void add_body(Hasher& hash, const Body& body, const Scene& scene) {
  const Polygon& polygon = polygon_of(body);
  hash.count(polygon.size());
  for (const Point& v : polygon) hash.point(v);
  const std::vector<MotionPiece> pieces = given_pieces_between(body.motion, scene.start, scene.end);
  hash.count(pieces.size());
  for (const MotionPiece& piece : pieces) add_piece(hash, piece);
}

}  // namespace

Fingerprint scene_fingerprint(const Scene& scene, Touch touch) {
  if (is_world(scene))
    throw InputError("bodies", "fingerprints are of scenes of two bodies, each one polygon in the world's frame",
                     "`check` takes worlds; proofs are about two bodies");
  Hasher hash("taut scene 2");
  hash.byte(touch == Touch::closed ? 1 : 0);
  hash.number(scene.start);
  hash.number(scene.end);
  for (const Body& body : scene.bodies) add_body(hash, body, scene);
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
