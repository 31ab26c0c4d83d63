// What the scene's fingerprint tells apart, and what it does not.
#include <gtest/gtest.h>

#include <functional>

#include "proof/sha256.hpp"
#include "taut/io.hpp"
#include "taut/proof.hpp"

namespace taut::testing {
using namespace internal;
namespace {

std::string sha256_of(const std::string& text) {
  proof::Sha256 hash;
  for (const char c : text) hash.add(static_cast<std::uint8_t>(c));
  return to_hex(hash.finish());
}

/// The examples of FIPS 180-4.
TEST(Sha256, StandardVectors) {
  EXPECT_EQ(sha256_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256_of(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

std::string id_of(const Scene& scene, Touch touch = Touch::open) { return to_hex(scene_fingerprint(scene, touch)); }

/// The lid of the examples, a part of whose motion is over before the scene begins.
Scene example() {
  Scene scene = read_scene("examples/lid.json");
  MotionPiece& piece = scene.bodies[1].motion.pieces[0];
  piece.x = {0, 1};
  piece.rotation = AngleRotation{{0, 0.5}};
  piece.pivot = {1, 2};
  return scene;
}

std::string id_after(const std::function<void(Scene&)>& change) {
  Scene scene = example();
  change(scene);
  return id_of(scene);
}

TEST(Fingerprint, ChangesWithEveryNumber) {
  const std::string original = id_of(example());
  EXPECT_NE(id_of(example(), Touch::closed), original);
  EXPECT_NE(id_after([](Scene& s) { s.end += 1; }), original);
  EXPECT_NE(id_after([](Scene& s) { s.start -= 1; }), original);
  EXPECT_NE(id_after([](Scene& s) { s.bodies[1].polygon[2].x += 1e-12; }), original);
  EXPECT_NE(id_after([](Scene& s) { s.bodies[1].motion.pieces[0].x[1] += 1e-12; }), original);
  EXPECT_NE(id_after([](Scene& s) { s.bodies[1].motion.pieces[0].pivot.y += 1e-12; }), original);
  EXPECT_NE(id_after([](Scene& s) { s.bodies[1].motion.pieces[0].rotation = HalfAngleRotation{{0, 0.5}}; }), original);
  EXPECT_NE(id_after([](Scene& s) { s.bodies[1].motion.pieces[0].orbit = {{3, 0}, {0, 0.5}}; }), original);
  EXPECT_NE(id_after([](Scene& s) {
              s.bodies[1].motion.pieces[0].orbit = {{3, 0}, {0, 0.5}};
            }),
            id_after([](Scene& s) {
              s.bodies[1].motion.pieces[0].orbit = {{3, 1e-12}, {0, 0.5}};
            }));
  EXPECT_NE(id_after([](Scene& s) { std::swap(s.bodies[0], s.bodies[1]); }), original);
}

TEST(Fingerprint, IsThatOfEqualScenes) {
  const std::string original = id_of(example());
  EXPECT_EQ(id_after([](Scene& s) { s.bodies[0].name = "box"; }), original);
  EXPECT_EQ(id_after([](Scene& s) { s.bodies[1].motion.pieces[0].x[0] = -0.0; }), original);
  EXPECT_EQ(id_after([](Scene& s) { s.bodies[1].motion.pieces[0].x.push_back(0); }), original);
  EXPECT_EQ(id_after([](Scene& s) { s.bodies[1].motion.pieces[0].rotation = AngleRotation{{0, 0.5, 0}}; }), original);
  EXPECT_EQ(id_after([](Scene& s) { s.bodies[1].motion.pieces[0].until = 2 * s.end; }), original);
  EXPECT_EQ(id_after([](Scene& s) {
              MotionPiece past;
              past.until = s.start;
              s.bodies[1].motion.pieces.insert(s.bodies[1].motion.pieces.begin(), past);
            }),
            original);
}

TEST(Fingerprint, IgnoresThePivotOfABodyThatDoesNotTurn) {
  const auto with_pivot = [](const Point& pivot) {
    return id_after([&pivot](Scene& s) {
      s.bodies[1].motion.pieces[0].rotation = NoRotation{};
      s.bodies[1].motion.pieces[0].pivot = pivot;
    });
  };
  EXPECT_EQ(with_pivot({1, 2}), with_pivot({0, 0}));
}

}  // namespace
}  // namespace taut::testing
