// Proofs of two bodies that are stopped before their end prove what was written until then.
#include <gtest/gtest.h>

#include <sstream>

#include "taut/clearance.hpp"
#include "taut/motions.hpp"
#include "taut/proof.hpp"

namespace taut::testing {
namespace {

/// A bar that rotates a million times, beside a box that comes nearer.
Scene many_turns(double speed) {
  Scene scene;
  scene.end = 8;
  scene.bodies = {{"bar", {{-1, -0.125}, {1, -0.125}, {1, 0.125}, {-1, 0.125}}, from_velocity({0, 0}, 45e6)},
                  {"box", {{2, -1}, {4, -1}, {4, 1}, {2, 1}}, from_velocity({-speed, 0})}};
  return scene;
}

CheckOptions soon() {
  CheckOptions options;
  options.engine = EngineChoice::spacetime;
  options.limits.max_seconds = 0.5;
  return options;
}

template <class AnyAnswer>
Verified expect_proved_in_part(const Scene& scene, const AnyAnswer& answer, const std::string& log) {
  EXPECT_STREQ(to_string(answer.outcome), "undecided");
  EXPECT_NE(answer.reason.find("its proof was not finished"), std::string::npos) << answer.reason;
  EXPECT_GT(answer.free_until, scene.start);
  EXPECT_LT(answer.free_until, scene.end);
  std::istringstream in(log);
  Verified verified = verify(scene, in);
  EXPECT_STREQ(to_string(verified.outcome), "undecided");
  EXPECT_EQ(verified.free_until, answer.free_until);
  EXPECT_GT(verified.separations, 0u);
  return verified;
}

TEST(UnfinishedProofs, OfFreedom) {
  std::ostringstream log;
  const Scene scene = many_turns(0.0625);
  const Answer answer = prove(scene, log, soon());
  EXPECT_NE(answer.reason.find("the answer is free"), std::string::npos) << answer.reason;
  expect_proved_in_part(scene, answer, log.str());
}

TEST(UnfinishedProofs, OfAClearance) {
  std::ostringstream log;
  const Scene scene = many_turns(0.0625);
  const MarginAnswer answer = prove_clearance(scene, 0.0625, log, soon());
  EXPECT_EQ(expect_proved_in_part(scene, answer, log.str()).clearance, 0.0625);
}

/// The stretch in which the proof was stopped comes after others, and after bridges between them.
TEST(UnfinishedProofs, AfterSeveralPieces) {
  Scene scene = many_turns(0);
  MotionPiece slow, fast = scene.bodies[0].motion.pieces[0];
  slow.until = 1;
  scene.bodies[0].motion.pieces = {slow, slow, fast};
  scene.bodies[0].motion.pieces[1].until = 2;
  std::ostringstream log;
  const Answer answer = prove(scene, log, soon());
  expect_proved_in_part(scene, answer, log.str());
  EXPECT_GT(answer.free_until, 2);
}

}  // namespace
}  // namespace taut::testing
