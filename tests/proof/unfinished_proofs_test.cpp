// Proofs that are stopped before their end prove what was written until then: of two bodies, of worlds, and of curves.
#include <gtest/gtest.h>

#include <sstream>

#include "support/effort.hpp"
#include "taut/clearance.hpp"
#include "taut/motions.hpp"
#include "taut/outline.hpp"
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

/// What `prove(log, options)` answers within a time that suffices for a part: how long that is depends on the machine
/// and on what else it does, so that a limit in which nothing was proved is doubled.
template <class Prove>
auto in_part(const Scene& scene, CheckOptions options, std::string& log, const Prove& prove) {
  for (constexpr double longest = 60;; options.limits.max_seconds *= 2) {
    std::ostringstream out;
    auto answer = prove(out, options);
    log = out.str();
    if (answer.free_until > scene.start || options.limits.max_seconds > longest) return answer;
  }
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
  std::string log;
  const Scene scene = many_turns(0.0625);
  const Answer answer = in_part(
      scene, soon(), log, [&](std::ostream& out, const CheckOptions& options) { return prove(scene, out, options); });
  EXPECT_NE(answer.reason.find("the answer is free"), std::string::npos) << answer.reason;
  expect_proved_in_part(scene, answer, log);
}

TEST(UnfinishedProofs, OfAClearance) {
  std::string log;
  const Scene scene = many_turns(0.0625);
  const MarginAnswer answer = in_part(scene, soon(), log, [&](std::ostream& out, const CheckOptions& options) {
    return prove_clearance(scene, 0.0625, out, options);
  });
  EXPECT_EQ(expect_proved_in_part(scene, answer, log).clearance, 0.0625);
}

/// The stretch in which the proof was stopped comes after others, and after bridges between them.
TEST(UnfinishedProofs, AfterSeveralPieces) {
  Scene scene = many_turns(0.0625);
  MotionPiece slow, fast = scene.bodies[0].motion.pieces[0];
  slow.until = 1;
  scene.bodies[0].motion.pieces = {slow, slow, fast};
  scene.bodies[0].motion.pieces[1].until = 2;
  std::string log;
  const Answer answer = in_part(
      scene, soon(), log, [&](std::ostream& out, const CheckOptions& options) { return prove(scene, out, options); });
  expect_proved_in_part(scene, answer, log);
  EXPECT_GT(answer.free_until, 2);
}

/// A third body far away, which comes near the box at the end.
Scene turns_of_three(double speed) {
  Scene scene = many_turns(0.0625);
  scene.bodies.push_back({"far", {{20, -1}, {24, -1}, {24, 1}, {20, 1}}, from_velocity({speed, 0})});
  return scene;
}

const char* const slow_here = "with sanitizers, the time limit does not suffice for a part";

/// Enough for the shortest of the parts, and not for the whole.
CheckOptions later() {
  CheckOptions options;
  options.limits.max_seconds = 2;
  return options;
}

TEST(UnfinishedProofs, OfWorlds) {
  if (watched) GTEST_SKIP() << slow_here;
  for (const double speed : {0.5, -2.25}) {
    const Scene scene = turns_of_three(speed);
    std::string log;
    const Answer answer = in_part(scene, later(), log, [&](std::ostream& out, const CheckOptions& options) {
      return prove(scene, out, options);
    });
    const char* const whole = speed > 0 ? "the answer is free" : "the answer is contact";
    EXPECT_NE(answer.reason.find(whole), std::string::npos) << answer.reason;
    expect_proved_in_part(scene, answer, log);
  }
}

TEST(UnfinishedProofs, OfAClearanceInAWorld) {
  if (watched) GTEST_SKIP() << slow_here;
  const Scene scene = turns_of_three(0.5);
  std::string log;
  const MarginAnswer answer = in_part(scene, later(), log, [&](std::ostream& out, const CheckOptions& options) {
    return prove_clearance(scene, 0.0625, out, options);
  });
  EXPECT_EQ(expect_proved_in_part(scene, answer, log).clearance, 0.0625);
}

TEST(UnfinishedProofs, OfCurves) {
  if (watched) GTEST_SKIP() << slow_here;
  Scene scene = turns_of_three(0.5);
  scene.bodies[1].polygon.clear();
  scene.bodies[1].curves = parse_path("M4 0 A1 1 0 0 1 2 0 A1 1 0 0 1 4 0 Z");
  std::string log;
  const Answer answer = in_part(
      scene, later(), log, [&](std::ostream& out, const CheckOptions& options) { return prove(scene, out, options); });
  EXPECT_EQ(answer.reason.rfind("the answer is free"), 0U) << answer.reason;
  expect_proved_in_part(scene, answer, log);
}

}  // namespace
}  // namespace taut::testing
