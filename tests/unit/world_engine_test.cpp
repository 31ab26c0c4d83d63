// Worlds by one engine, by both, and by both in turn.
#include <gtest/gtest.h>

#include "generators/generators.hpp"
#include "solver/portfolio_solver.hpp"
#include "taut/check.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/motions.hpp"

namespace taut {
using namespace internal;
namespace {

Answer world_answer(const Scene& scene, EngineChoice engine, bool all = false, Touch touch = Touch::open) {
  CheckOptions options;
  options.engine = engine;
  options.all_pairs = all;
  options.touch = touch;
  return check(scene, options);
}

Body far_body() {
  Body body;
  body.name = "far";
  body.polygon = {{1e4, 1e4}, {1e4 + 1, 1e4}, {1e4, 1e4 + 1}};
  body.motion = from_velocity({1, 0});
  return body;
}

/// Two that are first looked at in a window of time, since their boxes do not meet at the start.
TEST(WorldEngines, PairsInTurnsKnowTheirBodiesBeforeTheStartIsAsked) {
  Scene scene;
  scene.end = 10;
  scene.bodies = {far_body(),
                  {"rests", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}},
                  {"falls", {{0, 9}, {1, 9}, {1, 10}, {0, 10}}, from_velocity({0, -2})}};
  const Instance instance(scene);
  for (const std::uint64_t first_slice : {0, 8192}) {
    EventBudget budget(UINT64_MAX);
    const std::unique_ptr<PairSolver> pair =
        pair_solver({EngineChoice::either, first_slice}, instance, 1, 2, Offset::inward, budget);
    EXPECT_EQ(pair->result().a, 1);
    EXPECT_EQ(pair->result().b, 2);
    pair->ask(2, 10);
    ASSERT_TRUE(pair->result().contact);
    EXPECT_EQ(pair->result().a, 1);
    EXPECT_EQ(pair->result().b, 2);
    EXPECT_NEAR(pair->result().contact->time.lo, 4, 1e-12);
  }
}

/// A ring gear has inner teeth: each planet is in a cavity closed on all sides.
TEST(WorldEngines, PlanetaryGears) {
  for (const bool hit : {false, true}) {
    for (const int planets : {1, 3, 4}) {
      gen::PlanetaryOptions options;
      options.sun = 12;
      options.planet = planets == 4 ? 12 : 15;
      options.planets = planets;
      options.hit = hit;
      const Scene scene = gen::make_planetary(options);
      const Answer spacetime = world_answer(scene, EngineChoice::spacetime);
      const Answer kinetic = world_answer(scene, EngineChoice::kinetic), both = world_answer(scene, EngineChoice::both);
      EXPECT_EQ(spacetime.outcome, hit ? Outcome::contact : Outcome::free);
      EXPECT_EQ(kinetic.outcome, spacetime.outcome);
      EXPECT_EQ(both.outcome, spacetime.outcome);
      EXPECT_EQ(spacetime.engine, EngineName::spacetime);
      EXPECT_EQ(kinetic.engine, EngineName::kinetic);
      EXPECT_TRUE(both.compared);
      EXPECT_EQ(spacetime.events, 0u);
      EXPECT_GT(kinetic.events, 100u);
      EXPECT_EQ(both.events, kinetic.events);
      EXPECT_GT(kinetic.certificates_max, 0u);
      EXPECT_EQ(kinetic.pair, spacetime.pair);
      ASSERT_EQ(kinetic.contact.has_value(), hit);
      if (!hit) continue;
      EXPECT_EQ(kinetic.contact->vertex, spacetime.contact->vertex);
      EXPECT_EQ(kinetic.contact->edge, spacetime.contact->edge);
      EXPECT_EQ(kinetic.contact->edge.ring + kinetic.contact->vertex.ring, 1);
      EXPECT_LE(kinetic.contact->time.lo, spacetime.contact->time.hi);
      EXPECT_LE(spacetime.contact->time.lo, kinetic.contact->time.hi);
    }
  }
}

TEST(WorldEngines, EachIsItsOwnWhereItIsAhead) {
  gen::CombOptions combs;
  combs.teeth = 128;
  combs.swings = 16;
  Scene slots = gen::make_combs(combs);
  slots.end = 1;
  slots.bodies.push_back(far_body());
  gen::DipOptions dip;
  dip.sides = 1024;
  dip.dips = 8;
  Scene dips = gen::make_dips(dip);
  dips.bodies.push_back(far_body());
  for (const EngineChoice engine : {EngineChoice::either, EngineChoice::usual}) {
    EXPECT_EQ(world_answer(slots, engine).engine, EngineName::kinetic);
    EXPECT_GT(world_answer(slots, engine).certificates_initial, 0u);
    EXPECT_EQ(world_answer(dips, engine).engine, EngineName::spacetime);
    EXPECT_EQ(world_answer(dips, engine).outcome, Outcome::free);
  }
}

TEST(WorldEngines, AgreeAboutEveryPair) {
  for (const char* name : {"arm", "conveyor", "drawer", "geneva", "planetary", "puzzle", "room"}) {
    const Scene scene = read_scene(std::string("examples/worlds/") + name + ".json");
    for (const Touch touch : {Touch::open, Touch::closed}) {
      const Answer both = world_answer(scene, EngineChoice::both, true, touch);
      const Answer kinetic = world_answer(scene, EngineChoice::kinetic, true, touch);
      EXPECT_TRUE(both.compared) << name;
      ASSERT_TRUE(both.pairs && kinetic.pairs) << name;
      ASSERT_EQ(both.pairs->size(), kinetic.pairs->size());
      for (std::size_t i = 0; i < both.pairs->size(); ++i) {
        EXPECT_EQ((*both.pairs)[i].outcome, (*kinetic.pairs)[i].outcome) << name;
        EXPECT_NE((*both.pairs)[i].outcome, Outcome::undecided) << name;
      }
    }
  }
}

TEST(WorldEngines, LimitsOfEventsAreThoseOfAllPairsTogether) {
  const Scene scene = gen::make_planetary({});
  const Answer whole = world_answer(scene, EngineChoice::kinetic);
  ASSERT_EQ(whole.outcome, Outcome::free);
  CheckOptions options;
  options.engine = EngineChoice::kinetic;
  for (const std::uint64_t events : {std::uint64_t{0}, std::uint64_t{10}, whole.events / 2}) {
    options.max_events = events;
    const Answer part = check(scene, options);
    EXPECT_EQ(part.outcome, Outcome::undecided);
    EXPECT_LE(part.events, events);
    EXPECT_LT(part.free_until, scene.end);
    EXPECT_EQ(part.engine, EngineName::kinetic);
  }
  options.max_events = whole.events + 1;
  EXPECT_EQ(check(scene, options).outcome, Outcome::free);
}

}  // namespace
}  // namespace taut
