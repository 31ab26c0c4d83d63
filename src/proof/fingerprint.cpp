#include <variant>

#include "proof/bytes.hpp"
#include "taut/shape.hpp"

namespace taut {
namespace {

class Hasher {
 public:
  void add(std::uint64_t x) {
    for (int i = 0; i < 8; ++i) sum_.add(static_cast<std::uint8_t>(x >> (8 * i)));
  }
  /// Both zeros are one number.
  void add(double x) { add(proof::bits_of(x == 0 ? 0.0 : x)); }
  void add(const Coefficients& c) {
    add(static_cast<std::uint64_t>(c.size()));
    for (const double x : c) add(x);
  }
  void add(const Rotation& rotation) {
    add(static_cast<std::uint64_t>(rotation.index()));
    if (const auto* angle = std::get_if<AngleRotation>(&rotation)) add(angle->angle);
    if (const auto* half = std::get_if<HalfAngleRotation>(&rotation)) add(half->s);
    if (const auto* cosine = std::get_if<CosineRotation>(&rotation)) add(cosine->a);
    if (const auto* direction = std::get_if<DirectionRotation>(&rotation)) {
      add(direction->a);
      add(direction->b);
    }
  }
  std::uint64_t value() const { return sum_.value(); }

 private:
  proof::Checksum sum_;
};

}  // namespace

std::uint64_t scene_fingerprint(const Scene& scene) {
  Hasher hash;
  hash.add(scene.start);
  hash.add(scene.end);
  for (const Body& body : scene.bodies) {
    const Polygon& polygon = polygon_of(body);
    hash.add(static_cast<std::uint64_t>(polygon.size()));
    for (const Point& v : polygon) {
      hash.add(v.x);
      hash.add(v.y);
    }
    hash.add(static_cast<std::uint64_t>(body.motion.pieces.size()));
    for (const MotionPiece& piece : body.motion.pieces) {
      hash.add(piece.x);
      hash.add(piece.y);
      hash.add(piece.rotation);
      hash.add(piece.until);
      if (piece.pivot == Point{}) continue;  // as before there were pivots
      hash.add(piece.pivot.x);
      hash.add(piece.pivot.y);
    }
  }
  return hash.value();
}

}  // namespace taut
