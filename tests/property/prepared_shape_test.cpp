// Prepared shapes: the same tilings and the same answers as from scratch.
#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <sstream>
#include <thread>

#include "generators/generators.hpp"
#include "geometry/prepared_shape.hpp"
#include "motion/motion_segment.hpp"
#include "motion/motion_segments.hpp"
#include "motion/pieces.hpp"
#include "scene/body_pair.hpp"
#include "solver/run.hpp"
#include "support/effort.hpp"
#include "support/made_world.hpp"
#include "support/prepared_scene.hpp"
#include "support/random_scenes.hpp"
#include "support/rng.hpp"
#include "support/same_answer.hpp"
#include "taut/check.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/proof.hpp"
#include "taut/separator.hpp"
#include "taut/simulation.hpp"
#include "tiling/planar_map.hpp"
#include "tiling/prepared_tiling.hpp"

namespace taut::testing {
using namespace internal;
namespace {

struct JoinCounts {
  std::map<std::string, int> roots;
  int joined = 0, refused = 0, overlaps = 0;
};

/// Compares the tilings joined and from scratch at some instants of a scene with one piece of motion a body.
void compare_tilings(const Scene& scene, int instants, bool in_any_case, JoinCounts& counts) {
  const BodyPair bodies = pair_of(scene);
  const MotionSegments segments = segments_of(bodies, scene.start, scene.end);
  for (const Offset offset : {Offset::inward, Offset::outward}) {
    const PairGeometry geometry = displaced_pair(bodies, offset);
    const auto p = tile_shape(geometry.p(), node::p_tree);
    const auto q = tile_shape(geometry.q(), node::q_tree);
    ASSERT_TRUE(p && q);
    for (int i = 0; i < instants; ++i) {
      const double t = segments[0].start + (segments[0].end - segments[0].start) * (i + 0.5) / instants;
      const Placement placement(geometry, segments[0], t);
      const StaticTiling fresh = build_tiling(placement);
      const auto joined = join_tilings(placement, *p, *q, in_any_case);
      if (fresh.overlap) {
        EXPECT_FALSE(joined) << "bodies that overlap at " << t << " were joined";
        ++counts.overlaps;
        continue;
      }
      if (!joined) {
        EXPECT_FALSE(in_any_case) << "not joined at " << t;
        ++counts.refused;
        continue;
      }
      ++counts.joined;
      ++counts.roots[to_string(joined->root)];
      ASSERT_EQ(joined->root, fresh.root) << "at " << t;
      ASSERT_EQ(difference(joined->map, fresh.map), "") << "at " << t;
      ASSERT_EQ(find_fault(joined->map, placement), "") << "at " << t;
    }
  }
}

TEST(PreparedShape, JoinedTilingsOfLargeBodiesAreThoseFromScratch) {
  JoinCounts counts;
  gen::GearOptions gears;
  gears.flank_points = 12;
  compare_tilings(gen::make_gears(gears), 40, false, counts);
  gears.teeth_1 = gears.teeth_2 = 40;
  compare_tilings(gen::make_gears(gears), 20, false, counts);
  EXPECT_EQ(counts.refused, 0) << "a few teeth in mesh are a small part of two gears";
  gen::DipOptions dips;
  dips.sides = 300;
  compare_tilings(gen::make_dips(dips), 60, true, counts);
  gen::RotorOptions rotor;
  rotor.chain_edges = 200;
  compare_tilings(gen::make_rotor(rotor), 40, true, counts);
  compare_tilings(gen::make_spiral({}), 20, true, counts);
  compare_tilings(gen::make_combs({}), 20, true, counts);
  compare_tilings(gen::make_lock({}), 20, true, counts);
  compare_tilings(gen::make_jigsaw({}), 20, true, counts);
  SceneOptions straight;
  straight.kinds = {MotionKind::linear};
  for (std::uint64_t seed = 0; seed < effort(40); ++seed) {
    for (const Family family : all_families) compare_tilings(random_scene(seed, family, straight), 4, true, counts);
  }
  for (const auto& [root, number] : counts.roots) std::cout << number << ' ' << root << ", ";
  std::cout << counts.overlaps << " overlaps\n";
  EXPECT_GT(counts.joined, static_cast<int>(enough(300)));
  EXPECT_GT(counts.overlaps, static_cast<int>(enough(20)));
  EXPECT_EQ(counts.roots.size(), 4u) << "a state of the root was never seen";
}

/// A body on one side of the line y = 0, with collinear points and notches along it, turned and moved.
Polygon flat_sided(Rng& rng, double side, const Point& way, const Point& at) {
  Polygon p;
  double x = rng.between(-6, 0);
  for (int k = rng.between(1, 7); k >= 0; --k) {
    p.push_back({x, 0});
    x += rng.between(1, 3);
    if (k > 0 && rng.chance(0.3)) {
      // A corner on the line more, so that a notch never meets the last one.
      for (const Point& q : {Point{x, 0}, Point{x, -1}, Point{x + 1, -1}, Point{x + 1, 0}}) p.push_back(q);
      x += 1 + rng.between(1, 3);
    }
  }
  p.push_back({p.back().x + rng.between(0, 2), double(-rng.between(2, 4))});
  p.push_back({p.front().x - rng.between(0, 2), double(-rng.between(2, 4))});
  if (rng.chance(0.2)) p.erase(p.begin() + 1, p.end() - 2);  // a corner on the line
  for (Point& q : p) {
    const double y = side * q.y;
    q = {way.x * q.x - way.y * y + at.x, way.y * q.x + way.x * y + at.y};
  }
  if (side > 0) std::reverse(p.begin(), p.end());
  return p;
}

/// Hulls that doubles cannot tell apart are joined as those of bodies that are far from each other.
TEST(PreparedShape, BodiesThatRestOnEachOtherAreJoined) {
  Rng rng(81);
  JoinCounts counts;
  for (std::uint64_t round = 0; round < effort(800) && !HasFailure(); ++round) {
    const Point ways[] = {{1, 0}, {0, 1}, {-1, 0}, {3, 2}, {-1, 4}, {0.6, 0.8}, {0.1, -0.7}};
    const Point way = ways[rng.below(7)], at{rng.between(-3, 3) / 4.0, rng.between(-3, 3) / 4.0};
    Scene scene;
    scene.end = 1;
    scene.bodies = {{"below", flat_sided(rng, 1, way, at), {}}, {"above", flat_sided(rng, -1, way, at), {}}};
    const int kind = rng.below(4);
    if (kind == 1) scene.bodies[1].motion.pieces = {{{0, way.x}, {0, way.y}, NoRotation{}}};  // slides
    if (kind == 2) std::swap(scene.bodies[0], scene.bodies[1]);
    if (kind == 3) {  // turns with what it rests on
      for (Body& body : scene.bodies) body.motion.pieces = {{{0}, {0}, AngleRotation{{0, 1}}}};
    }
    compare_tilings(scene, 1, false, counts);
  }
  EXPECT_LT(counts.overlaps, counts.joined) << "displaced outwards all overlap, and some by rounding";
  EXPECT_GT(counts.joined, 9 * counts.refused) << counts.joined << " joined, " << counts.refused << " refused";
}

TEST(PreparedShape, ChordsKeepOutOfThePocketsOfAThinBody) {
  // A ring with a narrow mouth and a smooth outside: chords of its hull would cut through its cavity.
  Scene scene;
  scene.end = 1;
  Polygon ring;
  constexpr int n = 120;
  for (int i = 2; i <= n - 2; ++i) ring.push_back(unit_vector(double(i) / n));
  for (int i = n - 2; i >= 2; --i) {
    const Point v = unit_vector(double(i) / n);
    ring.push_back({0.995 * v.x, 0.995 * v.y});
  }
  Polygon dart{{0, 0}, {0.99, 0.01}, {0.2, 0.2}};
  scene.bodies = {{"ring", ring, {}}, {"dart", dart, {}}};
  scene.bodies[1].motion.pieces = {{{0, 0.9}, {0, 0.0125}, AngleRotation{{0, 3}}}};
  JoinCounts counts;
  compare_tilings(scene, 50, true, counts);
  EXPECT_GT(counts.joined, 10);
  EXPECT_GT(counts.overlaps, 0);
}

TEST(PreparedShape, AnswersAreThoseOfTheBarePolygons) {
  int scenes = 0;
  for (std::uint64_t seed = 0; seed < effort(40); ++seed) {
    for (const Family family : all_families) {
      SCOPED_TRACE(std::string(to_string(family)) + " seed " + std::to_string(seed));
      const Scene bare = random_scene(7000 + seed, family, {});
      const Scene known = prepared(bare);
      for (const Touch touch : {Touch::open, Touch::closed}) {
        for (const EngineChoice engine : {EngineChoice::kinetic, EngineChoice::spacetime}) {
          CheckOptions options;
          options.touch = touch;
          options.engine = engine;
          const Answer answer = check(bare, options);
          expect_same_answer(answer, check(known, options));
          expect_same_answer(answer, check(without_polygons(known), options));
          ++scenes;
        }
      }
    }
  }
  EXPECT_GT(scenes, static_cast<int>(enough(1000)));
}

TEST(PreparedShape, IsSharedBetweenScenesRolesAndThreads) {
  const Polygon bar{{0, 0}, {6, 0}, {6, 1}, {0, 1}}, square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const Polygon beam{{0, 0}, {90, 0}, {90, 1}, {0, 1}};
  const auto shared = prepare(bar);
  Scene first, second;
  first.end = second.end = 10;
  // Beside the square the bar is P, beside the beam it is Q, and in other units.
  first.bodies = {{"bar", bar, {}, shared}, {"square", square, {{{{2}, {5, -1}, NoRotation{}}}}, prepare(square)}};
  second.bodies = {{"bar", bar, {{{{2}, {5, -1}, NoRotation{}}}}, shared}, {"beam", beam, {}, prepare(beam)}};
  const auto ask = [&] {
    for (int i = 0; i < 50; ++i) {
      EXPECT_EQ(check(first).contact->time.lo, 4);
      EXPECT_EQ(check(second).contact->time.lo, 4);
      EXPECT_EQ(Simulation(first).state(), SimulationState::running);
    }
  };
  std::thread other(ask);
  ask();
  other.join();
}

TEST(PreparedShape, StandsForItsPolygonEverywhere) {
  const Scene bare = gen::make_lock({}), known = without_polygons(prepared(bare));
  EXPECT_EQ(write_scene(known), write_scene(bare));
  EXPECT_EQ(draw_svg(known, Simulation(known).tiling()), draw_svg(bare, Simulation(bare).tiling()));
  EXPECT_EQ(separator(known, known.start).minimum_link.vertices, separator(bare, bare.start).minimum_link.vertices);
  std::stringstream log;
  prove(known, log);
  EXPECT_EQ(verify(bare, log).outcome, check(bare).outcome);
  log.seekg(0);
  EXPECT_EQ(verify(known, log).outcome, check(bare).outcome);
  // Without either there is nothing to ask about.
  Scene nothing = bare;
  nothing.bodies[0].polygon.clear();
  EXPECT_THROW(check(nothing), InputError);
}

TEST(PreparedShape, WorldsOfThemHaveTheAnswersOfTheBarePolygons) {
  std::uint64_t contacts = 0, known = 0;
  for (std::uint64_t number = 0; number < effort(150); ++number) {
    SCOPED_TRACE("world " + std::to_string(number));
    const Scene scene = scene_of(random_world(number)), world = without_polygons(prepared(scene));
    for (const Body& body : world.bodies) known += body.prepared != nullptr;
    for (const Touch touch : {Touch::open, Touch::closed}) {
      CheckOptions options;
      options.touch = touch;
      const Answer bare = check(scene, options);
      contacts += bare.contact.has_value();
      // Again from what the shapes have kept.
      for (int round = 0; round < 2; ++round) ASSERT_NO_FATAL_FAILURE(expect_same_answer(bare, check(world, options)));
    }
  }
  EXPECT_GT(contacts, enough(80));
  EXPECT_GT(known, enough(150));
}

/// More bodies of one shape than it keeps.
TEST(PreparedShape, IsSharedByManyBodiesOfAWorld) {
  const auto shape = prepare({{0, 0}, {1, 0.1}, {0.3, 0.4}, {0.2, 1}}, "shape");
  Scene scene, bare;
  scene.end = 1;
  for (int i = 0; i < 90; ++i) {
    MotionPiece piece;
    piece.x = {1.5 * (i % 10), i % 3 - 1.0};
    piece.y = {1.5 * (i / 10), i % 4 - 1.5};
    piece.rotation = AngleRotation{{0, 0.3 * (i % 7)}};
    Body body;
    body.name = std::to_string(i);
    body.motion.pieces = {piece};
    body.prepared = shape;
    scene.bodies.push_back(body);
  }
  bare = scene;
  for (Body& body : bare.bodies) {
    body.prepared = nullptr;
    body.polygon = shape->polygon();
  }
  for (int round = 0; round < 2; ++round) expect_same_answer(check(bare), check(scene));
}

TEST(PreparedShape, OfAnotherPolygonIsRefusedInWorlds) {
  Scene scene;
  for (const char* name : {"a", "b", "c"}) scene.bodies.push_back({name, {{0, 0}, {1, 0}, {0, 1}}, {}});
  scene.bodies[1].prepared = prepare({{0, 0}, {2, 0}, {0, 1}}, "b");
  EXPECT_THROW(check(scene), InputError);
}

TEST(PreparedShape, OfAnotherPolygonIsRefused) {
  Scene scene;
  scene.end = 1;
  scene.bodies = {{"a", {{0, 0}, {1, 0}, {0, 1}}, {}}, {"b", {{5, 5}, {6, 5}, {5, 6}}, {}}};
  scene.bodies[1].prepared = prepare(scene.bodies[0].polygon);
  try {
    check(scene);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("b: the prepared shape was made of another polygon"), std::string::npos)
        << error.what();
  }
  EXPECT_THROW(prepare({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), InputError);
}

}  // namespace
}  // namespace taut::testing
