// The shrinker on failures that are planted: what is left is short, and fails in the same way.
#include "shrink.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "examine.hpp"
#include "support/random_scenes.hpp"
#include "taut/check.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut::fuzz {
namespace {

std::size_t vertices(const Scene& scene) { return scene.bodies[0].polygon.size() + scene.bodies[1].polygon.size(); }

/// A stand-in for a defect: whatever touches after the start "fails".
bool touches(const Scene& scene) {
  try {
    const Answer answer = check(scene);
    return answer.contact && answer.contact->time.lo > scene.start;
  } catch (const InputError&) {
    return false;
  }
}

Scene large_scene_that_touches() {
  testing::SceneOptions options;
  options.kinds = {testing::MotionKind::pieces, testing::MotionKind::polynomial};
  for (std::uint64_t seed = 0;; ++seed) {
    const Scene scene = testing::random_scene(seed, testing::Family::stars, options);
    if (scene.bodies[0].motion.pieces.size() + scene.bodies[1].motion.pieces.size() > 2 && vertices(scene) > 20 &&
        touches(scene))
      return scene;
  }
}

TEST(Shrink, LeavesTwoTrianglesAndRoundNumbers) {
  const Scene scene = large_scene_that_touches();
  const Scene small = shrunk(scene, touches, 5000);
  EXPECT_TRUE(touches(small));
  EXPECT_EQ(vertices(small), 6u);
  EXPECT_LE(small.bodies[0].motion.pieces.size() + small.bodies[1].motion.pieces.size(), 2u);
  EXPECT_LT(write_scene(small).size(), 400u) << write_scene(small);
  EXPECT_LT(3 * write_scene(small).size(), write_scene(scene).size());
}

TEST(Shrink, KeepsWhatTheFailureNeeds) {
  const Scene scene = large_scene_that_touches();
  // Needs both the sixth vertex of the first body, by its place, and a joint.
  const Point needed = scene.bodies[0].polygon[5];
  const auto fails = [&](const Scene& s) {
    const Polygon& p = s.bodies[0].polygon;
    return std::count(p.begin(), p.end(), needed) == 1 &&
           s.bodies[0].motion.pieces.size() + s.bodies[1].motion.pieces.size() > 1 && p.size() >= 3;
  };
  ASSERT_TRUE(fails(scene));
  const Scene small = shrunk(scene, fails, 5000);
  EXPECT_TRUE(fails(small));
  EXPECT_EQ(vertices(small), 6u);
}

TEST(Shrink, StopsWhenTriesAreUsedUp) {
  int tries = 0;
  const auto fails = [&](const Scene&) { return ++tries % 2 == 0; };
  shrunk(large_scene_that_touches(), fails, 10);
  EXPECT_EQ(tries, 10);
}

TEST(ProcessApart, SurvivesACrash) {
  const Finding found = in_process_apart([](std::string&) -> Finding { std::abort(); }, 60);
  EXPECT_EQ(found.kind, FindingKind::crash);
  EXPECT_EQ(found.signature(), "crash: signal #");
}

TEST(ProcessApart, EndsAHang) {
  volatile bool for_ever = true;
  const Finding found = in_process_apart(
      [&](std::string&) {
        while (for_ever) {
        }
        return Finding{};
      },
      0.2);
  EXPECT_EQ(found.kind, FindingKind::hang);
}

TEST(ProcessApart, HandsOverFindingAndReport) {
  std::string report;
  const auto look = [](std::string& text) {
    text = "two lines\nof report\n";
    return Finding{FindingKind::tiling, "after 17 events, at t = 0.25\nmore"};
  };
  const Finding found = in_process_apart(look, 60, &report);
  EXPECT_EQ(report, "two lines\nof report\n");
  EXPECT_EQ(found.message, "after 17 events, at t = 0.25\nmore");
  EXPECT_EQ(found.signature(), "tiling: after # events, at t = #.#");
}

TEST(Examine, FindsNothingWrongWithASoundScene) {
  Evaluations looks;
  looks.max_events = 30;
  looks.max_seconds = 60;
  std::string report;
  const Finding found = examine(large_scene_that_touches(), looks, &report);
  EXPECT_EQ(found.kind, FindingKind::none) << found.message;
  EXPECT_NE(report.find("open both: contact"), std::string::npos) << report;
  EXPECT_NE(report.find("closed both: contact"), std::string::npos) << report;
}

TEST(Examine, RejectedIsNoDefect) {
  Scene scene = large_scene_that_touches();
  scene.bodies[0].polygon.resize(2);
  const Finding found = examine(scene, {});
  EXPECT_EQ(found.kind, FindingKind::rejected);
  EXPECT_FALSE(found.is_defect());
}

}  // namespace
}  // namespace taut::fuzz
