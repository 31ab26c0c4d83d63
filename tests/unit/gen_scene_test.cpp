// The generated scenes are what they promise: simple polygons, free of contact, or with a contact.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <ostream>
#include <string>

#include "generators/generators.hpp"
#include "taut/check.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "unit/sampled_overlap.hpp"

namespace taut {
namespace {

struct Kind {
  std::string name;
  std::function<Scene(bool hit)> make;
  int samples = 400;
};

void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.name; }

template <class Options>
std::function<Scene(bool)> with(Scene (*make)(const Options&), Options options = {}) {
  return [make, options](bool hit) mutable {
    options.hit = hit;
    return make(options);
  };
}

class Generated : public ::testing::TestWithParam<Kind> {};

TEST_P(Generated, BodiesAreSimpleAndCounterclockwise) {
  for (bool hit : {false, true}) {
    const Scene scene = GetParam().make(hit);
    ASSERT_EQ(scene.bodies.size(), 2u);
    EXPECT_LT(scene.start, scene.end);
    for (const Body& body : scene.bodies) {
      EXPECT_TRUE(test::is_simple(body.polygon)) << body.name;
      EXPECT_GT(test::signed_area(body.polygon), 0) << body.name;
    }
  }
}

TEST_P(Generated, PiecesJoin) {
  for (const Body& body : GetParam().make(false).bodies) {
    for (std::size_t k = 0; k + 1 < body.motion.pieces.size(); ++k) {
      const double t = body.motion.pieces[k].until;
      Body before = body, after = body;
      before.motion.pieces = {body.motion.pieces[k]};
      after.motion.pieces = {body.motion.pieces[k + 1]};
      const Point p = test::posed(before, t)[0], q = test::posed(after, t)[0];
      EXPECT_NEAR(p.x, q.x, 1e-9) << "piece " << k;
      EXPECT_NEAR(p.y, q.y, 1e-9) << "piece " << k;
    }
  }
}

TEST_P(Generated, IsFree) {
  const auto overlap = test::first_sampled_overlap(GetParam().make(false), GetParam().samples);
  EXPECT_FALSE(overlap) << "at " << overlap.value_or(0);
}

TEST_P(Generated, HitsWhenToldSo) {
  const Scene scene = GetParam().make(true);
  const auto overlap = test::first_sampled_overlap(scene, GetParam().samples);
  ASSERT_TRUE(overlap);
  EXPECT_GT(*overlap, scene.start);
}

TEST_P(Generated, ReadsBack) {
  const std::string text = write_scene(GetParam().make(false));
  EXPECT_EQ(write_scene(parse_scene(text)), text);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, Generated,
    ::testing::Values(
        Kind{"gears", with(gen::make_gears), 800},
        Kind{"gears_few_teeth", with(gen::make_gears, {.teeth_1 = 9, .teeth_2 = 11, .backlash = 0.02}), 800},
        Kind{"gears_pair_of_12", with(gen::make_gears, {.teeth_1 = 12, .teeth_2 = 12, .flank_points = 12}), 800},
        Kind{"gears_unequal", with(gen::make_gears, {.teeth_1 = 60, .teeth_2 = 13, .turns = 0.5}), 600},
        Kind{"combs", with(gen::make_combs)},
        Kind{"combs_many_swings", with(gen::make_combs, {.teeth = 5, .swings = 16})},
        Kind{"comb_of_one", with(gen::make_combs, {.teeth = 1, .swings = 1})}, Kind{"lock", with(gen::make_lock)},
        Kind{"lock_of_one", with(gen::make_lock, {.steps = 1})},
        Kind{"lock_large", with(gen::make_lock, {.steps = 80, .seed = 7, .clearance = 0.02})},
        Kind{"jigsaw", with(gen::make_jigsaw)},
        Kind{"jigsaw_coarse", with(gen::make_jigsaw, {.knobs = 1, .knob_points = 6})},
        Kind{"jigsaw_fine", with(gen::make_jigsaw, {.knobs = 2, .knob_points = 60, .clearance = 0.01})},
        Kind{"dips", with(gen::make_dips)}, Kind{"dips_triangle", with(gen::make_dips, {.sides = 3, .dips = 1})},
        Kind{"dips_eight", with(gen::make_dips, {.sides = 100, .dips = 8})}, Kind{"rotor", with(gen::make_rotor)},
        Kind{"rotor_small", with(gen::make_rotor, {.teeth = 3, .chain_edges = 2})},
        Kind{"rotor_large", with(gen::make_rotor, {.teeth = 100, .chain_edges = 200})},
        Kind{"spiral", with(gen::make_spiral)},
        Kind{"spiral_long", with(gen::make_spiral, {.turns = 5, .side_points = 206})},
        Kind{"spiral_short", with(gen::make_spiral, {.turns = 0.6, .side_points = 14})},
        Kind{"maze", with(gen::make_maze), 2000},
        Kind{"maze_even", with(gen::make_maze, {.passes = 7, .ship_points = 3, .seed = 0}), 1000},
        Kind{"maze_of_one", with(gen::make_maze, {.passes = 1})}),
    [](const ::testing::TestParamInfo<Kind>& kind) { return kind.param.name; });

TEST(Planetary, MeshesAtEveryRatioThatFits) {
  for (const gen::PlanetaryOptions& o :
       {gen::PlanetaryOptions{}, gen::PlanetaryOptions{.sun = 12, .planet = 15, .planets = 3},
        gen::PlanetaryOptions{.sun = 24, .planet = 12, .planets = 4, .turns = 0.4},
        gen::PlanetaryOptions{.sun = 20, .planet = 13, .planets = 1, .module = 3, .flank_points = 9}}) {
    const Scene scene = gen::make_planetary(o);
    ASSERT_EQ(scene.bodies.size(), static_cast<std::size_t>(3 + o.planets));
    const Answer answer = check(scene, {.touch = Touch::closed});
    EXPECT_STREQ(to_string(answer.outcome), "free") << o.sun << ", " << o.planet;
    EXPECT_EQ(write_scene(parse_scene(write_scene(scene))), write_scene(scene));
  }
}

TEST(Planetary, HitsTheNarrowSpaceWhenToldSo) {
  const Scene scene = gen::make_planetary({.hit = true});
  const Answer answer = check(scene);
  ASSERT_TRUE(answer.contact);
  EXPECT_GT(answer.contact->time.lo, 0);
  EXPECT_EQ(scene.bodies[static_cast<std::size_t>((*answer.pair)[0])].name, "ring");
  EXPECT_EQ(scene.bodies[static_cast<std::size_t>((*answer.pair)[1])].relative_to, "carrier");
}

TEST(Planetary, RefusesTeethThatDoNotFit) {
  EXPECT_THROW(gen::make_planetary({.planets = 5}), InputError);
  EXPECT_THROW(gen::make_planetary({.planets = 9}), InputError);
  EXPECT_THROW(gen::make_planetary({.sun = 3}), InputError);
}

TEST(Generators, AreTheSameForTheSameSeed) {
  EXPECT_EQ(write_scene(gen::make_lock({.seed = 5})), write_scene(gen::make_lock({.seed = 5})));
  EXPECT_NE(write_scene(gen::make_lock({.seed = 5})), write_scene(gen::make_lock({.seed = 6})));
}

TEST(Generators, RefuseNonsense) {
  EXPECT_THROW(gen::make_gears({.teeth_1 = 2}), InputError);
  EXPECT_THROW(gen::make_combs({.teeth = 0}), InputError);
  EXPECT_THROW(gen::make_dips({.dips = 9}), InputError);
  EXPECT_THROW(gen::make_spiral({.turns = 10, .side_points = 20}), InputError);
  EXPECT_THROW(gen::make_gears({.turns = std::nan("")}), InputError);
}

}  // namespace
}  // namespace taut
