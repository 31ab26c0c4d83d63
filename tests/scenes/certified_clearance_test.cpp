// Least distances against certified answers, closed forms, and the answer of check().
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "taut/clearance.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/motions.hpp"
#include "taut/proof.hpp"

namespace taut {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

double length_of(const Point& a, const Point& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
}

void compare_clearance(const Scene& scene, const json& want) {
  const Clearance got = clearance(scene);
  ASSERT_TRUE(got.reason.empty()) << got.reason;
  ASSERT_TRUE(got.nearest);
  const NearestPoints& n = *got.nearest;
  const double lo = want["lo"], hi = want["hi"], size = want["size"];
  EXPECT_LE(n.lo, hi + 1e-11 * size);
  EXPECT_GE(n.hi, lo - 1e-11 * size);
  // Bodies very close to each other are told apart a little less well.
  EXPECT_LE(n.hi - n.lo, 1e-9 * n.hi + 2e-11 * size);
  if (hi > 0) {
    EXPECT_NEAR(length_of(n.points[0], n.points[1]), n.hi, 1e-6 * n.hi + 1e-9 * size);
  }
  // The distance is positive if and only if the bodies do not even touch.
  CheckOptions closed;
  closed.touch = Touch::closed;
  EXPECT_EQ(check(scene, closed).outcome == Outcome::free, n.lo > 0);
}

TEST(CertifiedWorlds, Clearances) {
  if (!fs::exists("../shared/worlds")) GTEST_SKIP() << "the worlds with certified answers are not here";
  int compared = 0;
  for (const auto& entry : fs::directory_iterator("../shared/worlds")) {
    const std::string file = entry.path().string(), suffix = ".answer.json";
    if (file.size() < suffix.size() || file.substr(file.size() - suffix.size()) != suffix) continue;
    SCOPED_TRACE(file);
    std::ifstream stream(entry.path());
    const json answer = json::parse(stream);
    if (!answer.contains("clearance")) continue;
    compare_clearance(read_scene(file.substr(0, file.size() - suffix.size()) + ".json"), answer["clearance"]);
    ++compared;
  }
  EXPECT_GE(compared, 80);
}

/// Worlds of our own: each file says in `note` what it once broke and why, and what is right.
TEST(Corpus, WorldsAndTheirClearances) {
  int scenes = 0;
  std::vector<fs::directory_entry> entries;
  for (const char* folder : {"tests/corpus/worlds", "tests/corpus/mechanisms"})
    entries.insert(entries.end(), fs::directory_iterator(folder), fs::directory_iterator());
  for (const auto& entry : entries) {
    if (entry.path().extension() != ".json" || entry.path().stem().extension() == ".answer") continue;
    SCOPED_TRACE(entry.path().string());
    std::ifstream stream(entry.path().parent_path() / (entry.path().stem().string() + ".answer.json"));
    const json want = json::parse(stream);
    const Scene scene = read_scene(entry.path().string());
    for (const Touch touch : {Touch::open, Touch::closed}) {
      CheckOptions options;
      options.touch = touch;
      options.engine = EngineChoice::spacetime;
      const Answer answer = check(scene, options);
      const json& expected = want[to_string(touch)];
      EXPECT_EQ(to_string(answer.outcome), expected["outcome"].get<std::string>());
      if (answer.contact) {
        EXPECT_NEAR(answer.contact->time.lo, expected["t"].get<double>(), 1e-9);
      }
      for (const EngineChoice other : {EngineChoice::kinetic, EngineChoice::usual}) {
        options.engine = other;
        EXPECT_EQ(check(scene, options).outcome, answer.outcome);
      }
      options.engine = EngineChoice::spacetime;
      std::stringstream log;
      ASSERT_EQ(prove(scene, log, options).reason, "");
      EXPECT_EQ(verify(scene, log).outcome, answer.outcome);
    }
    ++scenes;
    if (!want.contains("clearance")) continue;
    ClearanceOptions limited;
    limited.limits.max_seconds = 20;
    const Clearance got = clearance(scene, limited);
    ASSERT_EQ(got.reason, "");
    EXPECT_GE(got.nearest->lo, want["clearance"]["lo"].get<double>());
    EXPECT_LE(got.nearest->hi, want["clearance"]["hi"].get<double>());
    EXPECT_EQ(got.nearest->hi > 0, want["closed"]["outcome"] == "free");
  }
  EXPECT_GE(scenes, 8);
}

Scene squares(const Motion& motion, double end) {
  Scene scene;
  scene.end = end;
  scene.bodies = {{"rests", {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, {}},
                  {"moves", {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}, motion}};
  return scene;
}

void expect_clearance(const Scene& scene, double distance, double at) {
  const Clearance got = clearance(scene);
  ASSERT_TRUE(got.nearest);
  EXPECT_LE(got.nearest->lo, distance * (1 + 1e-14));
  EXPECT_GE(got.nearest->hi, distance * (1 - 1e-14));
  EXPECT_LE(got.nearest->hi - got.nearest->lo, 1e-9 * distance + 1e-11);
  EXPECT_NEAR(got.nearest->time.lo, at, 1e-4);
}

TEST(Clearance, OfSquaresInClosedForm) {
  // Past a corner on a straight line: the nearest points are two vertices.
  expect_clearance(squares(from_keyframes({{0, 4, 1}, {1, 1, 4}}), 1), std::sqrt(2.0), 0.5);
  // Above the face, by a parabola.
  expect_clearance(squares({{{{0}, {3, -2, 2}, NoRotation{}}}}, 1), 1.0, 0.5);
  // Turning above the face: a vertex comes down to the height of half the diagonal.
  Motion turning = from_velocity({0, 0}, 90);
  turning.pieces[0].y = {3};
  expect_clearance(squares(turning, 1), 2 - std::sqrt(0.5), 0.5);
  // Around a corner of the other one, on a circle and without turning.
  expect_clearance(squares(from_keyframes({{0, 4, 0}, {1, 0, 0, 0, Way::arc, {0, 0}, 90}}), 1),
                   4 / std::sqrt(2.0) * std::sqrt(2.0) - 1.5 * std::sqrt(2.0), 0.5);
}

TEST(Clearance, IsZeroForBodiesThatTouchOrOverlap) {
  for (const double height : {1.5, 1.25}) {
    const Clearance got = clearance(squares({{{{0}, {height}, NoRotation{}}}}, 1));
    ASSERT_TRUE(got.nearest);
    EXPECT_EQ(got.nearest->hi, 0);
  }
}

TEST(Clearance, OfAllPairs) {
  Scene scene = squares({{{{0}, {3, -1}, NoRotation{}}}}, 1);
  scene.bodies.push_back({"far", {{9, 9}, {10, 9}, {9, 10}}, {}});
  ClearanceOptions all;
  all.all_pairs = true;
  const Clearance got = clearance(scene, all);
  ASSERT_EQ(got.pairs.size(), 2u);
  EXPECT_NEAR(got.nearest->hi, 0.5, 1e-9);
  EXPECT_EQ(got.coverage.at_rest, 1u);
  EXPECT_NEAR(got.pairs[1].hi, length_of({0.5, 3.5}, {9, 9}), 1e-7);
  all.relative = 0;
  EXPECT_THROW(clearance(scene, all), InputError);
}

}  // namespace
}  // namespace taut
