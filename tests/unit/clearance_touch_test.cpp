// The least distance of bodies that touch: it is 0, from their first touch on.
#include <gtest/gtest.h>

#include "taut/check.hpp"
#include "taut/clearance.hpp"
#include "taut/motions.hpp"

namespace taut {
namespace {

/// Two bodies come to a third one from both sides, at t = 2 and t = 8.
Scene between(bool early_first) {
  Scene scene;
  scene.end = 10;
  const Body table{"table", {{0, 0}, {4, 0}, {4, 1}, {0, 1}}, {}};
  const Body late{"late", {{1, 5}, {3, 5}, {2, 6}}, from_velocity({0, -0.5})};
  const Body early{"early", {{1, -2}, {3, -2}, {2, -1}}, from_velocity({0, 0.5})};
  scene.bodies = {
      table, early_first ? early : late, early_first ? late : early, {"far", {{90, 90}, {91, 90}, {90, 91}}, {}}};
  return scene;
}

TEST(ClearanceOfTouchingBodies, IsOfThePairThatTouchesFirst) {
  for (const bool early_first : {true, false}) {
    const Scene scene = between(early_first);
    const Clearance answer = clearance(scene);
    CheckOptions closed;
    closed.touch = Touch::closed;
    const Answer first = check(scene, closed);
    ASSERT_TRUE(answer.nearest && first.contact);
    EXPECT_EQ(answer.nearest->hi, 0);
    EXPECT_EQ(answer.nearest->pair, *first.pair);
    EXPECT_LE(answer.nearest->time.lo, first.contact->time.hi);
    EXPECT_GE(answer.nearest->time.hi, first.contact->time.lo);
    // All pairs whose boxes meet are tested: the three, but for those with the body that is far.
    EXPECT_EQ(answer.coverage.tested, 3u);
    EXPECT_EQ(answer.coverage.apart, 2u);
    EXPECT_EQ(answer.coverage.at_rest, 1u);
  }
}

}  // namespace
}  // namespace taut
