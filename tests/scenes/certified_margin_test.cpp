// Do bodies keep a clearance? Against certified answers, closed forms, and the least distance.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "support/effort.hpp"
#include "support/made_world.hpp"
#include "taut/clearance.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/motions.hpp"

namespace taut {
namespace {

using nlohmann::json;

std::set<std::string> names_in(const Scene& scene, const std::array<BodyId, 2>& pair) {
  return {scene.bodies[static_cast<std::size_t>(pair[0])].name, scene.bodies[static_cast<std::size_t>(pair[1])].name};
}

void compare_margin(const Scene& scene, double margin, Touch touch, const json& want) {
  CheckOptions options;
  options.touch = touch;
  const MarginAnswer got = check_clearance(scene, margin, options);
  ASSERT_EQ(to_string(got.outcome), want["outcome"].get<std::string>()) << got.reason;
  if (got.outcome != Outcome::contact) return;
  const double lo = want["t"][0], hi = want["t"][1], tolerance = want["tolerance"];
  EXPECT_LE(got.first->time.lo, hi + tolerance);
  EXPECT_GE(got.first->time.hi, lo - tolerance);
  EXPECT_LE(got.first->time.hi - got.first->time.lo, 1e-14 * (scene.end - scene.start));
  bool named = names_in(scene, got.first->bodies) == want["pair"].get<std::set<std::string>>();
  for (const json& other : want["also"])
    named = named || names_in(scene, got.first->bodies) == other.get<std::set<std::string>>();
  EXPECT_TRUE(named);
  ASSERT_TRUE(got.first->nearest && got.first->features);
  EXPECT_LE(got.first->nearest->hi, margin);
  const CloseFeatures& features = *got.first->features;
  EXPECT_NE(features.edge.has_value(), features.other.has_value());
  EXPECT_NE(features.vertex.body, features.edge ? features.edge->body : features.other->body);
  // The points are rounded; the features are as far apart as the margin.
  const auto [a, b] = got.first->nearest->points;
  EXPECT_NEAR(std::hypot(a.x - b.x, a.y - b.y), margin, 1e-9 * (1 + margin));
}

TEST(CertifiedWorlds, Margins) {
  if (!std::filesystem::exists("../shared/worlds")) GTEST_SKIP() << "the worlds with certified answers are not here";
  int compared = 0;
  for (const auto& entry : std::filesystem::directory_iterator("../shared/worlds")) {
    const std::string file = entry.path().string(), suffix = ".answer.json";
    if (file.size() < suffix.size() || file.substr(file.size() - suffix.size()) != suffix) continue;
    std::ifstream stream(entry.path());
    const json answer = json::parse(stream);
    if (!answer.contains("margin")) continue;
    SCOPED_TRACE(file);
    const json& margin = answer["margin"];
    const Scene scene = read_scene(file.substr(0, file.size() - suffix.size()) + ".json");
    compare_margin(scene, margin["clearance"], Touch::open, margin["open"]);
    compare_margin(scene, margin["clearance"], Touch::closed, margin["closed"]);
    ++compared;
  }
  EXPECT_GE(compared, 50);
}

/// A clearance is kept if and only if it is less than the least distance.
TEST(Margins, AreKeptBelowTheLeastDistance) {
  using testing::effort;
  int kept = 0, broken = 0;
  for (std::uint64_t seed = 3000; seed < 3000 + effort(80); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const testing::MadeWorld world = testing::random_world(seed);
    const Scene scene = testing::scene_of(world);
    const Clearance least = clearance(scene);
    if (!least.nearest || least.nearest->hi <= 0) continue;
    const double share = seed % 2 == 0 ? 0.999 : 1.001, margin = least.nearest->hi * share;
    const MarginAnswer answer = check_clearance(scene, margin);
    if (share < 1) {
      EXPECT_STREQ(to_string(answer.outcome), "free");
      ++kept;
      continue;
    }
    ASSERT_TRUE(answer.outcome == Outcome::contact || answer.outcome == Outcome::closer_at_start ||
                answer.outcome == Outcome::overlap_at_start);
    ++broken;
    // By poses that share nothing with the library: not closer before, and closer then.
    const auto distance = [&](double t) {
      double nearest = INFINITY;
      for (int a = 0; a < static_cast<int>(world.bodies.size()); ++a) {
        const auto [first, second] = answer.first->bodies;
        if (a != first) continue;
        nearest = testing::between_rings(testing::posed(world, first, t), testing::posed(world, second, t));
      }
      return nearest;
    };
    if (answer.outcome != Outcome::contact) continue;
    for (int k = 0; k < 8; ++k) EXPECT_GE(distance(answer.first->time.lo * k / 8), margin - 1e-9);
    EXPECT_LE(distance(answer.first->time.hi), margin + 1e-9);
  }
  EXPECT_GE(kept, static_cast<int>(testing::enough(5)));
  EXPECT_GE(broken, static_cast<int>(testing::enough(5)));
}

/// Parallel to a face and past a corner, at distances that are the clearance at one instant, to every order in time.
TEST(Margins, AtOneInstantAlone) {
  const Polygon square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, small{{-0.5, 0}, {0.5, 0}, {0.5, 1}, {-0.5, 1}};
  for (const int order : {2, 4, 6}) {
    SCOPED_TRACE(order);
    Scene scene;
    scene.start = -1;
    Coefficients y(static_cast<std::size_t>(order) + 1);
    y.front() = 3;
    y.back() = 1;
    MotionPiece piece;
    piece.y = y;
    scene.bodies = {{"rests", square, {}}, {"dips", small, Motion{{piece}}}};
    CheckOptions options;
    EXPECT_EQ(check_clearance(scene, 2, options).outcome, Outcome::free);
    options.touch = Touch::closed;
    EXPECT_EQ(check_clearance(scene, std::nextafter(2, 0), options).outcome, Outcome::free);
    const MarginAnswer touches = check_clearance(scene, 2, options);
    ASSERT_EQ(touches.outcome, Outcome::contact);
    // A root of order m is known to about 2^(-200 / m).
    EXPECT_LE(touches.first->time.lo, 0);
    EXPECT_GE(touches.first->time.hi, 0);
    EXPECT_LE(touches.first->time.hi - touches.first->time.lo, 4 * std::exp2(-199.0 / order));
    EXPECT_EQ(touches.first->grazing, order > 2);
    options.touch = Touch::open;
    const double beyond = std::nextafter(2, 3);
    const MarginAnswer passes = check_clearance(scene, beyond, options);
    ASSERT_EQ(passes.outcome, Outcome::contact);
    const double reached = -std::pow(beyond - 2, 1.0 / order);
    EXPECT_NEAR(passes.first->time.lo, reached, 1e-14);
    EXPECT_NEAR(passes.first->time.hi, reached, 1e-14);
  }
}

/// A corner that turns in place, beside another one: their distance is constant, but only because all of its motion
/// cancels.
TEST(Margins, OfACornerThatTurnsInPlace) {
  Scene scene;
  MotionPiece piece;
  piece.rotation = AngleRotation{{0, 1}};
  scene.bodies = {{"rests", {{-1, -1}, {0, 0}, {-2, 0}}, {}}, {"turns", {{3, 4}, {7, 4}, {7, 6}}, Motion{{piece}}}};
  scene.bodies[1].motion.pieces[0].pivot = {3, 4};
  scene.end = 0.3;
  EXPECT_EQ(check_clearance(scene, 4.999).outcome, Outcome::free);
  const MarginAnswer close = check_clearance(scene, 5.001);
  ASSERT_EQ(close.outcome, Outcome::closer_at_start);
  EXPECT_NEAR(close.first->nearest->hi, 5, 1e-9);
  // No precision tells that; it is said, and soon.
  CheckOptions options;
  options.limits.max_seconds = 60;
  const MarginAnswer open = check_clearance(scene, 5, options);
  EXPECT_EQ(open.outcome, Outcome::undecided);
  EXPECT_NE(open.reason.find("the clearance"), std::string::npos) << open.reason;
}

Scene falling_square(double end) {
  Scene scene;
  scene.end = end;
  scene.bodies = {{"rests", {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, {}},
                  {"falls", {{-0.5, 4}, {0.5, 4}, {0.5, 5}, {-0.5, 5}}, from_velocity({0, -1})}};
  return scene;
}

TEST(Margins, InClosedForm) {
  // 3 - t is less than 1 after 2.
  const MarginAnswer falls = check_clearance(falling_square(3), 1);
  ASSERT_EQ(falls.outcome, Outcome::contact);
  EXPECT_LE(falls.first->time.lo, 2);
  EXPECT_GE(falls.first->time.hi, 2);
  EXPECT_LE(falls.first->time.hi - falls.first->time.lo, 1e-10);
  EXPECT_NEAR(falls.first->nearest->hi, 1, 1e-9);
  EXPECT_EQ(check_clearance(falling_square(1.9), 1).outcome, Outcome::free);
  EXPECT_EQ(check_clearance(falling_square(3), 3.5).outcome, Outcome::closer_at_start);
  // Past a corner, at a distance of the square root of 2.
  Scene past = falling_square(1);
  past.bodies[1].polygon = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
  past.bodies[1].motion = from_keyframes({{0, 4, 1}, {1, 1, 4}});
  EXPECT_EQ(check_clearance(past, 1.4142).outcome, Outcome::free);
  const MarginAnswer close = check_clearance(past, 1.4143);
  ASSERT_EQ(close.outcome, Outcome::contact);
  EXPECT_LT(close.first->time.hi, 0.5);
  // It stays at the clearance.
  Scene slides = falling_square(1);
  slides.bodies[1].motion = from_velocity({0.25, 0});
  EXPECT_EQ(check_clearance(slides, 3).outcome, Outcome::free);
  CheckOptions closed;
  closed.touch = Touch::closed;
  const MarginAnswer touching = check_clearance(slides, 3, closed);
  ASSERT_EQ(touching.outcome, Outcome::contact);
  EXPECT_EQ(touching.first->time.hi, 0);
  EXPECT_EQ(check_clearance(slides, 3.0000001, closed).outcome, Outcome::closer_at_start);
  // Bodies that overlap are not said to be merely close, and the other way round.
  Scene meets = falling_square(3);
  meets.bodies.push_back({"rests too", {{0, 0}, {2, 0}, {2, 2}, {0, 2}}, from_velocity({0.25, 0})});
  const MarginAnswer overlap = check_clearance(meets, 3.5);
  EXPECT_EQ(overlap.outcome, Outcome::overlap_at_start);
  EXPECT_EQ(overlap.first->bodies, (std::array{0, 2}));
  ASSERT_EQ(overlap.also.size(), 2u);
  for (const PairMargin& also : overlap.also) EXPECT_EQ(also.outcome, Outcome::closer_at_start);
  EXPECT_THROW(check_clearance(slides, 0), InputError);
  EXPECT_THROW(check_clearance(slides, NAN), InputError);
}

TEST(Margins, AllPairsAndLimits) {
  Scene scene = falling_square(10);
  scene.bodies.push_back({"far", {{50, 50}, {51, 50}, {51, 51}}, {}});
  CheckOptions options;
  options.all_pairs = true;
  const MarginAnswer answer = check_clearance(scene, 0.5, options);
  ASSERT_EQ(answer.pairs.size(), 1u);
  EXPECT_EQ(answer.pairs[0].outcome, Outcome::contact);
  EXPECT_EQ(answer.coverage.apart, 1u);
  EXPECT_EQ(answer.coverage.at_rest, 1u);
  std::atomic<bool> stop{true};
  Scene spins = falling_square(10);
  spins.bodies[1].motion.pieces = {{{}, {0.51}, AngleRotation{{0, 1e5}}}};
  options.limits.stop = &stop;
  const MarginAnswer stopped = check_clearance(spins, 2, options);
  EXPECT_EQ(stopped.outcome, Outcome::undecided);
  EXPECT_EQ(stopped.reason, "interrupted");
}

}  // namespace
}  // namespace taut
