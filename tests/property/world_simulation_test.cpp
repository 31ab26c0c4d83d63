// Simulations of worlds: they answer as check() does, from the start and after every change of a plan.
#include <gtest/gtest.h>

#include <iostream>

#include "generators/generators.hpp"
#include "session/world_simulation.hpp"
#include "support/cavity_scenes.hpp"
#include "support/effort.hpp"
#include "support/made_world.hpp"
#include "support/simulated_worlds.hpp"
#include "taut/check.hpp"
#include "taut/error.hpp"
#include "taut/motions.hpp"
#include "taut/simulation.hpp"

namespace taut::testing {
namespace {

TEST(WorldSimulation, AnswersAsCheckDoes) {
  SimulationCounts counts;
  for (std::uint64_t seed = 0; seed < effort(400); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene = scene_of(random_world(seed));
    if (scene.bodies.size() == 2 && scene.bodies[0].parts.empty() && scene.bodies[1].parts.empty()) continue;
    const Touch touch = seed % 3 == 2 ? Touch::closed : Touch::open;
    Simulation simulation(scene, touch);
    if (seed % 2) {
      simulation.advance_to(scene.end);
    } else {
      while (simulation.step()) {
      }
    }
    ASSERT_NO_FATAL_FAILURE(expect_ended(simulation, fresh_answer(scene, touch), counts));
  }
  std::cout << counts.contacts << " contacts, " << counts.finished << " free, " << counts.overlaps << " overlaps\n";
  EXPECT_GE(counts.contacts, static_cast<int>(enough(100)));
  EXPECT_GE(counts.finished, static_cast<int>(enough(20)));
}

/// After each change the rest of the scene is asked about afresh: what comes of it is what the simulation comes to, or
/// it has nothing yet at the next change.
void change_plans(Scene scene, Touch touch, Rng& rng, SimulationCounts& counts) {
  Simulation simulation(scene, touch);
  double now = scene.start;
  for (int k = 0; k < 4; ++k) {
    const Answer answer = fresh_answer(scene, touch);
    const double next = now + (scene.end - now) * rng.real(0.05, 0.4);
    if (answer.outcome == Outcome::overlap_at_start || (answer.contact && answer.contact->time.hi <= next) || k == 3) {
      simulation.advance_to(scene.end);
      return expect_ended(simulation, answer, counts);
    }
    if (answer.contact && answer.contact->time.lo <= next) return;
    ASSERT_EQ(simulation.advance_to(next), SimulationState::running) << simulation.reason();
    EXPECT_EQ(simulation.time(), next);
    if (rng.chance(0.3)) simulation.step();
    if (rng.chance(0.3)) simulation.next_event();
    if (simulation.state() != SimulationState::running) return;
    now = simulation.time();
    if (answer.contact && answer.contact->time.lo <= now) return;
    const int body = rng.below(static_cast<int>(scene.bodies.size()));
    Body& changed = scene.bodies[static_cast<std::size_t>(body)];
    changed.motion = going_on(changed, now, rng);
    simulation.set_motion(body, changed.motion);
    scene.start = now;
    ++counts.changes;
  }
}

TEST(WorldSimulation, AnswersAsIfAskedAfreshAfterEveryChange) {
  SimulationCounts counts;
  for (std::uint64_t seed = 0; seed < effort(600); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed + 77);
    const Scene scene = scene_of(random_world(seed + 5000));
    if (scene.bodies.size() == 2 && scene.bodies[0].parts.empty() && scene.bodies[1].parts.empty()) continue;
    ASSERT_NO_FATAL_FAILURE(change_plans(scene, seed % 3 == 2 ? Touch::closed : Touch::open, rng, counts));
  }
  for (std::uint64_t seed = 0; seed < effort(200); ++seed) {
    SCOPED_TRACE("cavity " + std::to_string(seed));
    Rng rng(seed + 99);
    CavityOptions options;
    options.parents = seed % 2;
    const Scene scene = cavity_scene(seed, all_cavities[seed % 4], options);
    ASSERT_NO_FATAL_FAILURE(change_plans(scene, Touch::open, rng, counts));
  }
  std::cout << counts.changes << " changes, " << counts.contacts << " contacts, " << counts.finished << " free, "
            << counts.overlaps << " overlaps\n";
  EXPECT_GE(counts.changes, static_cast<int>(enough(400)));
  EXPECT_GE(counts.contacts, static_cast<int>(enough(200)));
}

Polygon square_at(double x, double y) { return {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}; }

Body square_body(const std::string& name, double x, double y, const Motion& motion = {}) {
  Body body{name, square_at(x, y), motion};
  return body;
}

TEST(WorldSimulation, WhatIsFarHasNoCertificates) {
  Scene scene;
  scene.end = 1;
  scene.bodies = {square_body("a", 0, 0), square_body("b", 1.25, 0, from_velocity({-0.25, 0}))};
  scene.ignore = {{"a", "a far body"}};
  scene.bodies.push_back(square_body("a far body", 0, 50, from_velocity({0.5, 0}, 20)));
  Simulation few(scene, Touch::open);
  for (int k = 0; k < 300; ++k)
    scene.bodies.push_back(square_body("far " + std::to_string(k), 10 * k, 100, from_velocity({0, 0.01 * k})));
  Simulation many(scene, Touch::open);
  for (Simulation* simulation : {&few, &many}) simulation->advance_to(0.5);
  EXPECT_GT(few.certificates(), 0u);
  EXPECT_EQ(few.certificates(), many.certificates());
  EXPECT_EQ(few.events(), many.events());
}

TEST(WorldSimulation, EventsComeInOrder) {
  gen::PlanetaryOptions options;
  options.turns = 0.25;
  const Scene scene = gen::make_planetary(options);
  Simulation simulation(scene, Touch::open);
  double last = 0;
  std::uint64_t steps = 0;
  for (;; ++steps) {
    const std::optional<TimeInterval> next = simulation.next_event();
    if (!next) break;
    EXPECT_GE(next->hi, last);
    last = next->hi;
    ASSERT_TRUE(simulation.step());
    EXPECT_GE(simulation.time(), next->lo);
  }
  simulation.advance_to(scene.end);
  EXPECT_EQ(simulation.state(), SimulationState::finished);
  EXPECT_GT(steps, 100u);
  EXPECT_GE(simulation.events(), steps);
}

/// Symmetric bodies have events that coincide but for rounding, so that enclosures overlap.
TEST(WorldSimulation, TheNextEventIsNeverInThePast) {
  gen::GearOptions gears;
  gen::DipOptions dips;
  gen::PlanetaryOptions planetary;
  planetary.turns = 0.25;
  std::uint64_t steps = 0;
  for (const Scene& scene : {gen::make_gears(gears), gen::make_dips(dips), gen::make_planetary(planetary)}) {
    Simulation simulation(scene);
    double time = simulation.time();
    for (;; ++steps) {
      const std::optional<TimeInterval> next = simulation.next_event();
      if (!next) break;
      ASSERT_GE(simulation.time(), time);
      ASSERT_GE(next->lo, simulation.time()) << next->lo - simulation.time();
      ASSERT_LE(next->lo, next->hi);
      time = simulation.time();
      if (!simulation.step()) break;
    }
  }
  EXPECT_GT(steps, 300u);
}

TEST(WorldSimulation, BodiesThatPartFromTheirGroupAreAskedAbout) {
  Scene scene;
  scene.end = 10;
  scene.bodies = {square_body("a", 0, 0), square_body("b", 0.5, 0), square_body("c", 0, 5, from_velocity({0, 1}))};
  Simulation simulation(scene, Touch::open);
  EXPECT_EQ(simulation.advance_to(1), SimulationState::running);
  simulation.set_motion(0, Motion{{{{1, -1}, {}, NoRotation{}}}});
  EXPECT_EQ(simulation.state(), SimulationState::overlap_at_start);
  EXPECT_EQ(*simulation.pair(), (std::array<BodyId, 2>{0, 1}));
  ASSERT_TRUE(simulation.overlap_point());
  EXPECT_GT(simulation.overlap_point()->x, 0.5);
  EXPECT_LT(simulation.overlap_point()->x, 1);
}

TEST(WorldSimulation, ChildrenGoWithTheirParents) {
  Scene scene;
  scene.end = 10;
  scene.bodies = {square_body("cart", 0, 0), square_body("load", 0, 1.5), square_body("post", 8, 1.5)};
  scene.bodies[1].relative_to = "cart";
  Simulation simulation(scene, Touch::open);
  EXPECT_EQ(simulation.advance_to(2), SimulationState::running);
  simulation.set_motion(0, Motion{{{{-2, 1}, {}, NoRotation{}}}});  // one a unit of time, from 0 at t = 2
  EXPECT_EQ(simulation.advance_to(10), SimulationState::contact);
  EXPECT_NEAR(simulation.contact()->time.lo, 9, 1e-12);
  EXPECT_EQ(*simulation.pair(), (std::array<BodyId, 2>{1, 2}));
}

TEST(WorldSimulation, RefusesWhatItCannotDoAndGoesOn) {
  Scene scene;
  scene.end = 10;
  scene.bodies = {square_body("a", 0, 0), square_body("b", 3, 0, from_velocity({-0.1, 0})), square_body("c", 0, 5)};
  Simulation simulation(scene, Touch::open);
  simulation.advance_to(1);
  EXPECT_THROW(simulation.set_motion(3, {}), InputError);
  EXPECT_THROW(simulation.set_motion(-1, {}), InputError);
  EXPECT_THROW(simulation.set_motion(1, from_velocity({1, 0})), InputError);  // a jump
  EXPECT_THROW(simulation.tiling(), InputError);
  EXPECT_THROW(simulation.active_set(), InputError);
  EXPECT_EQ(simulation.state(), SimulationState::running);
  EXPECT_EQ(simulation.advance_to(10), SimulationState::finished);
  scene.bodies[1].motion = from_velocity({-0.25, 0});
  SimulationOptions none;
  none.max_events = 0;
  Simulation limited(scene, none);
  EXPECT_EQ(limited.advance_to(10), SimulationState::undecided);
  EXPECT_NE(limited.reason().find("limit of 0 events"), std::string::npos);
  EXPECT_LE(limited.time(), 10);
}

/// A change of plan costs what it is about: no tiling is built anew, also not of bodies that are attached.
TEST(WorldSimulation, TilingsStayWhereAMotionChanges) {
  Scene scene;
  scene.end = 10;
  scene.bodies = {square_body("cart", 0, 0, from_velocity({0.25, 0})), square_body("load", 0, 0.5),
                  square_body("post", 1.875, 0)};
  scene.bodies[1].relative_to = "cart";
  internal::WorldSimulation world(scene, Touch::open, UINT64_MAX);
  world.advance(3);
  const void *const cart = world.engines(0, 2), *const load = world.engines(1, 2);
  ASSERT_NE(cart, nullptr);
  ASSERT_NE(load, nullptr);
  world.set_motion(0, Motion{{{{0.15, 0.2}, {}, NoRotation{}}}});  // slower, from the same place
  EXPECT_EQ(world.engines(0, 2), cart);
  EXPECT_EQ(world.engines(1, 2), load);
  world.advance(10);
  ASSERT_EQ(world.answer().outcome, Outcome::contact);
  EXPECT_NEAR(world.answer().contact->time.lo, 3.625, 1e-12);
  EXPECT_EQ(world.answer().also.size(), 1u);
}

/// Two bodies of one ring have one tiling, wherever they are attached.
TEST(WorldSimulation, ACarriedPolygonHasATilingInTheWorld) {
  Scene scene;
  scene.end = 10;
  scene.bodies = {square_body("cart", 0, 0, from_velocity({0.5, 1})),
                  square_body("load", 3, 0, from_velocity({-0.1, 0}))};
  scene.bodies[1].relative_to = "cart";
  Simulation simulation(scene, Touch::open);
  EXPECT_EQ(simulation.advance_to(4), SimulationState::running);
  const Tiling tiling = simulation.tiling();
  ASSERT_EQ(tiling.vertices.size(), 8u);
  for (const TilingVertex& v : tiling.vertices) {
    const Point local =
        scene.bodies[static_cast<std::size_t>(v.vertex.body)].polygon[static_cast<std::size_t>(v.vertex.index)];
    const double along = v.vertex.body == 0 ? 2 : 2 - 0.4;
    EXPECT_NEAR(v.position.x, local.x + along, 1e-12);
    EXPECT_NEAR(v.position.y, local.y + 4, 1e-12);
  }
}

Polygon triangle(double x, double y) { return {{x, y}, {x + 1, y}, {x, y + 1}}; }

/// A pair of bodies with parts has several tilings. A step must not process a later event of one of them.
TEST(WorldSimulation, StepsThroughAllTilingsOfAPairInOrder) {
  Scene scene;
  scene.end = 8;
  Body two{"two", {}, from_velocity({0.5, -0.5})};
  two.parts = {{triangle(-3, 2), {}}, {triangle(-1, 2), {}}};
  scene.bodies = {two, {"one", triangle(2, 0), from_velocity({-0.5, 0})}};
  const Answer answer = check(scene);
  ASSERT_TRUE(answer.contact);
  Simulation simulation(scene);
  simulation.step();
  EXPECT_EQ(simulation.advance_to(0.5), SimulationState::running);
  EXPECT_EQ(simulation.advance_to(8), SimulationState::contact);
  EXPECT_NEAR(simulation.contact()->time.lo, answer.contact->time.lo, 1e-12);
  scene.bodies = {two, {"one", triangle(0, 8), from_velocity({-0.5, 0})}};
  scene.bodies[0].motion = {};
  Simulation changed(scene);
  changed.step();
  changed.advance_to(2);
  EXPECT_NO_THROW(changed.set_motion(0, {}));
  EXPECT_EQ(changed.advance_to(8), SimulationState::finished);
}

TEST(WorldSimulation, StepsOnAfterABodyThatRestedMoves) {
  Scene scene;
  scene.end = 10;
  scene.bodies = {{"a", triangle(0, 0), {}}, {"b", {{1, 0.5}, {2, 0.5}, {1, 1.5}}, {}}, {"c", triangle(0, 5), {}}};
  SimulationOptions options;
  options.limits.max_seconds = 5;
  Simulation simulation(scene, options);
  simulation.advance_to(5);
  MotionPiece left;
  left.x = {0, -0.5};
  left.origin = 5;
  simulation.set_motion(0, Motion{{left}});
  while (simulation.step()) {
  }
  EXPECT_EQ(simulation.state(), SimulationState::finished) << simulation.reason();
  EXPECT_EQ(simulation.time(), 10);
}

}  // namespace
}  // namespace taut::testing
