// Margins of their own for pairs, which change with time: against distances by definition, closed forms, and laws.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "support/effort.hpp"
#include "support/made_world.hpp"
#include "taut/clearance.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/motions.hpp"
#include "taut/proof.hpp"
#include "taut/simulation.hpp"

namespace taut {
namespace {

double value_at(const Margin& margin, double t) {
  double sum = 0;
  for (std::size_t k = margin.coefficients.size(); k-- > 0;) sum = sum * (t - margin.origin) + margin.coefficients[k];
  return sum;
}

const std::string& name_in(const Scene& scene, BodyId body) {
  return scene.bodies[static_cast<std::size_t>(body)].name;
}

/// Of degree 0 to 3, between about 0.01 and 1 on [0, 4].
Margin made_margin(testing::Rng& rng) {
  Margin margin{{rng.real(0.01, 0.5)}, 0};
  const int degree = rng.between(0, 3);
  for (int k = 1; k <= degree; ++k) margin.coefficients.push_back(rng.real(0, 0.3) / std::pow(4, k));
  // From the end backwards: it falls.
  if (rng.chance(0.4)) {
    margin.origin = 4;
    for (std::size_t k = 1; k < margin.coefficients.size(); k += 2) margin.coefficients[k] *= -1;
  }
  return margin;
}

using TwoBodies = std::array<BodyId, 2>;

/// What the definition says that each pair has, computed without the library's table.
using MarginOfPair = std::map<TwoBodies, Margin>;

/// A margin for each pair, by entries of all kinds.
MarginOfPair add_margins(testing::Rng& rng, double others, Scene& scene) {
  const auto n = static_cast<BodyId>(scene.bodies.size());
  MarginOfPair wanted;
  for (BodyId a = 0; a < n; ++a) {
    for (BodyId b = a + 1; b < n; ++b) wanted[{a, b}] = {{others}, 0};
  }
  const auto give = [&](const Margin& margin, const auto& concerns) {
    for (auto& [pair, own] : wanted) {
      if (concerns(pair)) own = margin;
    }
  };
  if (rng.chance(0.3)) {
    scene.clearances.push_back({{"*", "*"}, made_margin(rng)});
    give(scene.clearances.back().margin, [](const TwoBodies&) { return true; });
  }
  if (rng.chance(0.5)) {
    const BodyId body = rng.between(0, n - 1);
    scene.clearances.push_back({{name_in(scene, body), "*"}, made_margin(rng)});
    give(scene.clearances.back().margin, [&](const TwoBodies& pair) { return pair[0] == body || pair[1] == body; });
  }
  for (BodyId a = 0; a < n; ++a) {
    for (BodyId b = a + 1; b < n; ++b) {
      if (!rng.chance(0.4)) continue;
      scene.clearances.push_back({{name_in(scene, b), name_in(scene, a)}, made_margin(rng)});
      give(scene.clearances.back().margin, [&](const TwoBodies& pair) { return pair == TwoBodies{a, b}; });
    }
  }
  std::reverse(scene.clearances.begin(), scene.clearances.end());
  return wanted;
}

/// Bodies at instants, and how much farther apart than their margin two of them are.
double excess(const testing::MadeWorld& world, const TwoBodies& pair, const Margin& margin, double t) {
  return testing::between_rings(testing::posed(world, pair[0], t), testing::posed(world, pair[1], t)) -
         value_at(margin, t);
}

/// All pairs' own answers against distances at many instants.
TEST(PairMargins, AreKeptByTheirDefinition) {
  using testing::effort;
  std::map<Outcome, int> seen;
  for (std::uint64_t seed = 7000; seed < 7000 + effort(150); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const testing::MadeWorld world = testing::random_world(seed);
    Scene scene = testing::scene_of(world);
    testing::Rng rng(seed);
    const MarginOfPair wanted = add_margins(rng, 0.05, scene);
    CheckOptions options;
    options.touch = seed % 2 == 0 ? Touch::open : Touch::closed;
    options.all_pairs = true;
    const MarginAnswer answer = check_clearance(scene, 0.05, options);
    if (answer.outcome == Outcome::untested) continue;
    for (const PairMargin& pair : answer.pairs) {
      const Margin& margin = wanted.at(pair.bodies);
      EXPECT_EQ(pair.margin.coefficients, margin.coefficients);
      ++seen[pair.outcome];
      ASSERT_NE(pair.outcome, Outcome::undecided) << pair.reason;
      if (pair.outcome == Outcome::overlap_at_start) continue;
      if (pair.outcome == Outcome::closer_at_start) {
        EXPECT_LE(excess(world, pair.bodies, margin, 0), 1e-9);
        continue;
      }
      const double until = pair.outcome == Outcome::contact ? pair.time.lo : scene.end;
      for (int k = 0; k <= 60; ++k) EXPECT_GE(excess(world, pair.bodies, margin, until * k / 60), -1e-9);
      if (pair.outcome != Outcome::contact) continue;
      EXPECT_LE(excess(world, pair.bodies, margin, pair.time.hi), 1e-9);
      EXPECT_NEAR(pair.margin_at, value_at(margin, pair.time.hi), 1e-12);
      EXPECT_NEAR(std::hypot(pair.nearest->points[0].x - pair.nearest->points[1].x,
                             pair.nearest->points[0].y - pair.nearest->points[1].y),
                  pair.margin_at, 1e-9);
    }
    // Those that are said to be apart are.
    if (answer.coverage.at_rest + answer.coverage.moving_alike + answer.coverage.ignored > 0) continue;
    for (const auto& entry : wanted) {
      const auto is_it = [&](const PairMargin& p) { return p.bodies == entry.first; };
      if (std::any_of(answer.pairs.begin(), answer.pairs.end(), is_it)) continue;
      for (int k = 0; k <= 20; ++k) EXPECT_GT(excess(world, entry.first, entry.second, scene.end * k / 20), -1e-9);
    }
  }
  EXPECT_GE(seen[Outcome::contact], static_cast<int>(testing::enough(20)));
  EXPECT_GE(seen[Outcome::free], static_cast<int>(testing::enough(20)));
}

std::string first_of(const MarginAnswer& answer) {
  std::ostringstream s;
  s.precision(17);
  s << to_string(answer.outcome);
  if (answer.first)
    s << " " << answer.first->bodies[0] << " " << answer.first->bodies[1] << " " << answer.first->time.lo << " "
      << answer.first->time.hi;
  return s.str();
}

/// A table that says the same of all pairs is a clearance, in whatever words.
TEST(PairMargins, ThatAreAllAlikeAreAClearance) {
  using testing::effort;
  for (std::uint64_t seed = 100; seed < 100 + effort(60); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Scene scene = testing::scene_of(testing::random_world(seed));
    testing::Rng rng(seed);
    const double clearance = rng.real(0.01, 0.6);
    const std::string wanted = first_of(check_clearance(scene, clearance));
    scene.clearances = {{{"*", "*"}, {{clearance}, 0}}};
    EXPECT_EQ(first_of(check_clearance(scene, 1e-3)), wanted);
    scene.clearances = {{{name_in(scene, 0), "*"}, {{clearance, 0}, 3}}};
    EXPECT_EQ(first_of(check_clearance(scene, clearance)), wanted);
    scene.clearances.clear();
    for (std::size_t a = 0; a < scene.bodies.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b)
        scene.clearances.push_back({{scene.bodies[a].name, scene.bodies[b].name}, {{clearance}, 0}});
    }
    EXPECT_EQ(first_of(check_clearance(scene, 1e-3)), wanted);
    EXPECT_EQ(first_of(check_clearance(parse_scene(write_scene(scene)), 1e-3)), wanted);
  }
}

/// A scene later is the same scene, and so are its margins.
TEST(PairMargins, MoveWithTheTime) {
  using testing::effort;
  for (std::uint64_t seed = 400; seed < 400 + effort(40); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Scene scene = testing::scene_of(testing::random_world(seed));
    testing::Rng rng(seed);
    add_margins(rng, 0.1, scene);
    const MarginAnswer now = check_clearance(scene, 0.1);
    const double by = seed % 3 == 0 ? 0x1p20 : 32;
    scene.start += by;
    scene.end += by;
    for (Body& body : scene.bodies) {
      for (MotionPiece& piece : body.motion.pieces) {
        piece.origin += by;
        piece.until += by;
      }
    }
    for (PairClearance& entry : scene.clearances) entry.margin.origin += by;
    const MarginAnswer later = check_clearance(scene, 0.1);
    ASSERT_EQ(later.outcome, now.outcome);
    if (now.outcome != Outcome::contact) continue;
    EXPECT_EQ(later.first->bodies, now.first->bodies);
    EXPECT_NEAR(later.first->time.lo - by, now.first->time.lo, 1e-14 * by);
    EXPECT_NEAR(later.first->margin_at, now.first->margin_at, 1e-9);
  }
}

Scene falling(double end) {
  Scene scene;
  scene.end = end;
  scene.bodies = {{"rests", {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, {}},
                  {"falls", {{-0.5, 4}, {0.5, 4}, {0.5, 5}, {-0.5, 5}}, from_velocity({0, -1})}};
  return scene;
}

void expect_contact_at(const MarginAnswer& answer, double t, double margin) {
  ASSERT_EQ(answer.outcome, Outcome::contact) << answer.reason;
  EXPECT_LE(answer.first->time.lo, t);
  EXPECT_GE(answer.first->time.hi, t);
  EXPECT_LE(answer.first->time.hi - answer.first->time.lo, 4e-15);
  EXPECT_NEAR(answer.first->margin_at, margin, 1e-14);
  EXPECT_EQ(answer.first->nearest->hi, answer.first->margin_at);
}

TEST(PairMargins, InClosedForm) {
  // 3 - t < 1 + t / 4 after 8 / 5, and 3 - t < t^2 / 2 after sqrt(7) - 1.
  Scene scene = falling(3);
  scene.clearances = {{{"rests", "falls"}, {{1, 0.25}, 0}}};
  expect_contact_at(check_clearance(scene, 9), 1.6, 1.4);
  scene.clearances = {{{"falls", "*"}, {{0, 0, 0.5}, 0}}};
  expect_contact_at(check_clearance(scene, 9), std::sqrt(7.0) - 1, 4 - std::sqrt(7.0));
  // As fast as the body: never, or from the start on.
  scene.clearances = {{{"*", "*"}, {{3, -1}, 0}}};
  EXPECT_EQ(check_clearance(scene, 9).outcome, Outcome::free);
  CheckOptions closed;
  closed.touch = Touch::closed;
  const MarginAnswer along = check_clearance(scene, 9, closed);
  ASSERT_EQ(along.outcome, Outcome::contact);
  EXPECT_EQ(along.first->time.hi, 0);
  scene.clearances[0].margin.coefficients = {3.125, -1};
  EXPECT_EQ(check_clearance(scene, 9).outcome, Outcome::closer_at_start);
  EXPECT_EQ(check_clearance(scene, 9).first->margin_at, 3.125);
}

/// A margin that reaches the distance at one instant alone, and bodies of which only the margin moves.
TEST(PairMargins, ReachTheDistanceAtOneInstant) {
  Scene scene = falling(2);
  scene.bodies[1].motion = {};
  scene.at_rest = AtRest::test;
  CheckOptions closed;
  closed.touch = Touch::closed;
  // 3 - (t - 1)^2
  scene.clearances = {{{"rests", "falls"}, {{2, 2, -1}, 0}}};
  EXPECT_EQ(check_clearance(scene, 1).outcome, Outcome::free);
  const MarginAnswer touches = check_clearance(scene, 1, closed);
  ASSERT_EQ(touches.outcome, Outcome::contact) << touches.reason;
  EXPECT_LE(touches.first->time.lo, 1);
  EXPECT_GE(touches.first->time.hi, 1);
  EXPECT_LE(touches.first->time.hi - touches.first->time.lo, 1e-14);
  scene.clearances[0].margin = {{3 + 0x1p-30, 0, -1}, 1};
  expect_contact_at(check_clearance(scene, 1), 1 - 0x1p-15, 3);
  // Beside a corner: 5 apart, and two vertices.
  scene.bodies[1].polygon = {{4, 5}, {6, 5}, {5, 7}};
  scene.clearances[0].margin = {{5, 0, -1}, 1};
  EXPECT_EQ(check_clearance(scene, 1).outcome, Outcome::free);
  EXPECT_EQ(check_clearance(scene, 1, closed).outcome, Outcome::contact);
  scene.clearances[0].margin = {{4.5, 0.5}, 0};
  const MarginAnswer grows = check_clearance(scene, 1);
  expect_contact_at(grows, 1, 5);
  EXPECT_TRUE(grows.first->features->other);
}

/// Bodies that are only where they have been before, while the margin grows.
TEST(PairMargins, GrowWhileMotionsRepeatThemselves) {
  Scene scene;
  scene.end = 100;
  MotionPiece turns;
  turns.rotation = AngleRotation{{0, 6.283185307179586}};
  scene.bodies = {{"rotor", {{-2, -0.5}, {2, -0.5}, {2, 0.5}, {-2, 0.5}}, Motion{{turns}}},
                  {"wall", {{5, -9}, {6, -9}, {6, 9}, {5, 9}}, {}}};
  scene.clearances = {{{"rotor", "wall"}, {{1, 0.0625}, 0}}};
  // The tip reaches sqrt(4.25), when the margin is what is left of 5; it does so up to four times a turn.
  const double left = 5 - std::sqrt(4.25), meets = (left - 1) / 0.0625;
  const MarginAnswer answer = check_clearance(scene, 9);
  ASSERT_EQ(answer.outcome, Outcome::contact) << answer.reason;
  EXPECT_GE(answer.first->time.hi, meets - 1e-9);
  EXPECT_LE(answer.first->time.lo, meets + 0.5);
  scene.clearances[0].margin = {{1, 0.0625 / 4}, 0};
  EXPECT_EQ(check_clearance(scene, 9).outcome, Outcome::free);
}

/// Between curves, as between polygons.
TEST(PairMargins, OfCurves) {
  const Scene scene = parse_scene(R"({"format":"taut-scene/1","time":[0,4],"bodies":[
    {"name":"disc","polygon":{"path":"M1 0 A1 1 0 0 1 -1 0 A1 1 0 0 1 1 0 Z"}},
    {"name":"ball","polygon":{"path":"M1 0 A1 1 0 0 1 -1 0 A1 1 0 0 1 1 0 Z"},"motion":{"x":[8,-1]}},
    {"name":"block","polygon":[[0,-9],[1,-9],[1,-7],[0,-7]]}],
    "clearances":[{"pair":["disc","ball"],"margin":[0.5,0.75]},{"pair":["block","*"],"margin":0.5}]})");
  // 6 - t < 0.5 + 0.75 t after 22 / 7.
  CheckOptions options;
  options.all_pairs = true;
  const MarginAnswer answer = check_clearance(scene, 0.1, options);
  ASSERT_EQ(answer.outcome, Outcome::contact) << answer.reason;
  EXPECT_NEAR(answer.first->time.lo, 22.0 / 7, 1e-8);
  EXPECT_NEAR(answer.first->margin_at, 0.5 + 0.75 * 22 / 7, 1e-8);
  ASSERT_EQ(answer.pairs.size(), 1u);
  EXPECT_EQ(answer.pairs[0].margin.coefficients, (Coefficients{0.5, 0.75}));
  EXPECT_NEAR(answer.pairs[0].margin_at, 0.5 + 0.75 * 22 / 7, 1e-8);
  // The least distance is asked with margins of its own.
  const Clearance least = clearance(scene);
  EXPECT_NEAR(least.nearest->hi, 2, 1e-6);
}

std::string refusal(const Scene& scene) {
  try {
    check_clearance(scene, 1);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(PairMargins, AreRefusedWhereTheySayNothing) {
  const auto with = [](std::vector<PairClearance> clearances) {
    Scene scene = falling(2);
    scene.bodies.push_back({"floor", {{-5, -9}, {5, -9}, {0, -8}}, {}});
    scene.clearances = std::move(clearances);
    return refusal(scene);
  };
  const auto expect = [](const std::string& error, const std::string& words) {
    EXPECT_NE(error.find(words), std::string::npos) << error;
  };
  EXPECT_EQ(with({{{"falls", "*"}, {{0, 1}, 0}}, {{"*", "*"}, {{1}, 0}}}), "");
  expect(with({{{"falls", "flor"}, {{1}, 0}}}), "clearances[0]: there is no body \"flor\"");
  expect(with({{{"falls", "falls"}, {{1}, 0}}}), "with itself");
  expect(with({{{"falls", "floor"}, {{1}, 0}}, {{"floor", "falls"}, {{1}, 0}}}), "clearances[1]: it is about the same");
  expect(with({{{"falls", "*"}, {{1}, 0}}, {{"floor", "*"}, {{2}, 0}}}), "says something else than clearances[0]");
  EXPECT_EQ(with({{{"falls", "*"}, {{1}, 0}}, {{"floor", "*"}, {{2}, 0}}, {{"floor", "falls"}, {{3}, 0}}}), "");
  EXPECT_EQ(with({{{"falls", "*"}, {{1}, 0}}, {{"floor", "*"}, {{1, 0}, 5}}}), "");
  for (const Coefficients& c : {Coefficients{}, {0}, {0, 0}, {-1}, {-0.0}})
    expect(with({{{"*", "*"}, {c, 0}}}), "not positive");
  expect(with({{{"*", "*"}, {{1, -0.75}, 0}}}), "the margin is -0.5 at t = 2");
  expect(with({{{"*", "*"}, {{1, -2, 0.9375}, 0}}}), "the margin is -0.0");
  EXPECT_EQ(with({{{"*", "*"}, {{1, -2, 1}, 0}}}), "");
  EXPECT_EQ(with({{{"*", "*"}, {{0, 0, 0, 2}, 0}}}), "");
  EXPECT_EQ(with({{{"*", "*"}, {{0, -1, 0, -1}, 2}}}), "");
  expect(with({{{"*", "*"}, {Coefficients(18, 1), 0}}}), "degree 17");
  expect(with({{{"*", "*"}, {{NAN}, 0}}}), "margin[0]");
  expect(with({{{"*", "*"}, {{1, INFINITY}, 0}}}), "margin[1]");
  expect(with({{{"*", "*"}, {{1}, INFINITY}}}), "origin");
  Scene instant = falling(0);
  instant.start = instant.end = 2;
  instant.clearances = {{{"falls", "rests"}, {{5, -4, 1}, 0}}};
  EXPECT_EQ(refusal(instant), "");
  EXPECT_EQ(check_clearance(instant, 9).outcome, Outcome::free);
  instant.clearances[0].margin.coefficients = {5.5, -4, 1};
  EXPECT_EQ(check_clearance(instant, 9).outcome, Outcome::closer_at_start);
  // Every question is about a valid scene.
  Scene scene = falling(2);
  scene.clearances = {{{"falls", "nobody"}, {{1}, 0}}};
  EXPECT_THROW(check(scene), InputError);
  // Proofs are about one clearance.
  scene.clearances[0].pair[1] = "rests";
  std::ostringstream log;
  EXPECT_THROW(prove_clearance(scene, 1, log), InputError);
  EXPECT_EQ(check(scene).outcome, Outcome::free);
}

}  // namespace
}  // namespace taut
