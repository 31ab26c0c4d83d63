// Directions in which bodies come apart, against their definition: moving that way.
#include "taut/separate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/effort.hpp"
#include "support/made_world.hpp"
#include "taut/error.hpp"
#include "taut/motions.hpp"

namespace taut::testing {
namespace {

constexpr double to_radians = 3.14159265358979323846 / 180;

/// Is the angle certainly in the arc, or certainly outside of it? By less than a hair, neither.
enum class PlaceInArcs { inside, outside, near };

PlaceInArcs place_of(double deg, const BodyDirections& body) {
  if (body.all) return PlaceInArcs::inside;
  const double hair = 1e-7;
  const auto turned = [](double x) { return x - 360 * std::floor(x / 360); };
  PlaceInArcs place = PlaceInArcs::outside;
  for (const DirectionArc& arc : body.free) {
    const double width = arc.point ? 0 : turned(arc.to.lo - arc.from.hi), at = turned(deg - arc.from.hi);
    if (at > hair && at < width - hair) return PlaceInArcs::inside;
    if (at < hair || at > 360 - hair || std::fabs(at - width) < hair) place = PlaceInArcs::near;
  }
  return place;
}

/// The last body moves away in that direction, farther than everything.
bool leaves(Scene scene, std::size_t moving, double deg, double travel = 200) {
  for (Body& body : scene.bodies) body.relative_to.clear();
  scene.start = 0;
  scene.end = 1;
  scene.bodies[moving].motion =
      from_velocity({travel * std::cos(deg * to_radians), travel * std::sin(deg * to_radians)});
  // Only pairs of the one that moves.
  CheckOptions options;
  options.engine = EngineChoice::spacetime;
  return check(scene, options).outcome == Outcome::free;
}

/// Two bodies near each other, often interlocked: a comb or a star beside a star in a notch.
Scene random_neighbours(std::uint64_t seed) {
  Rng rng(seed);
  Scene scene;
  Body first, second;
  first.name = "first";
  second.name = "second";
  first.parts = {star_part(rng, {0, 0}, 2, 0)};
  if (rng.chance(0.5)) first.parts.push_back(star_part(rng, {rng.real(2, 4), rng.real(-2, 2)}, 1.5, 0));
  second.parts = {star_part(rng, {rng.real(-4, 4), rng.real(-4, 4)}, rng.real(0.3, 1.5), 0)};
  scene.bodies = {first, second};
  return scene;
}

/// A U of grid cells around a T, on small integers: exact slots, shared lines, faces that lie on each other.
Scene random_cells(std::uint64_t seed) {
  Rng rng(seed);
  Scene scene;
  std::array<std::vector<Part>, 2> cells;
  for (int x = 0; x < 4; ++x) {
    for (int y = 0; y < 4; ++y) {
      const int owner = rng.below(3);
      if (owner == 2) continue;
      const double a = x, b = y;
      cells[static_cast<std::size_t>(owner)].push_back({{{a, b}, {a + 1, b}, {a + 1, b + 1}, {a, b + 1}}, {}});
    }
  }
  for (std::size_t i = 0; i < 2; ++i) {
    if (cells[i].empty()) cells[i].push_back({{{9, 9}, {10, 9}, {9, 10}}, {}});
    Body body;
    body.name = i == 0 ? "first" : "second";
    body.parts = cells[i];
    scene.bodies.push_back(body);
  }
  return scene;
}

struct DirectionCounts {
  int inside = 0, outside = 0, points = 0, locked = 0;
};

void expect_as_moving(const Scene& scene, std::uint64_t seed, DirectionCounts& counts) {
  const Separation answer = separate(scene);
  ASSERT_EQ(answer.reason, "");
  if (answer.overlap) {
    EXPECT_EQ(check(scene).outcome, Outcome::overlap_at_start);
    return;
  }
  ASSERT_EQ(answer.bodies.size(), 1u);
  ASSERT_EQ(answer.bodies[0].body, 1);
  if (answer.bodies[0].free.empty()) ++counts.locked;
  Rng rng(seed);
  for (int i = 0; i < 24; ++i) {
    const double deg = 15 * i + rng.real(0, 15);
    const PlaceInArcs place = place_of(deg, answer.bodies[0]);
    if (place == PlaceInArcs::near) continue;
    ++(place == PlaceInArcs::inside ? counts.inside : counts.outside);
    ASSERT_EQ(leaves(scene, 1, deg), place == PlaceInArcs::inside) << deg;
  }
  for (const DirectionArc& arc : answer.bodies[0].free) {
    EXPECT_LE(arc.from.lo, arc.from.hi);
    EXPECT_LE(arc.to.lo, arc.to.hi);
    EXPECT_LE(arc.from.hi - arc.from.lo, 1e-9);
    counts.points += arc.point ? 1 : 0;
  }
}

TEST(Separate, StarsAsWhenMoved) {
  DirectionCounts counts;
  for (std::uint64_t seed = 0; seed < effort(150); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    ASSERT_NO_FATAL_FAILURE(expect_as_moving(random_neighbours(seed), seed, counts));
  }
  EXPECT_GE(counts.inside, static_cast<int>(enough(500)));
  EXPECT_GE(counts.outside, static_cast<int>(enough(300)));
}

TEST(Separate, CellsAsWhenMoved) {
  DirectionCounts counts;
  for (std::uint64_t seed = 0; seed < effort(150); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    ASSERT_NO_FATAL_FAILURE(expect_as_moving(random_cells(seed), seed, counts));
  }
  EXPECT_GE(counts.locked, static_cast<int>(enough(20)));
  EXPECT_GE(counts.points, static_cast<int>(enough(3)));
  EXPECT_GE(counts.outside, static_cast<int>(enough(300)));
}

/// On the grid, exact slots are along the axes: there the answer can be compared at the very direction.
TEST(Separate, ExactSlotsAreFree) {
  int slots = 0;
  for (std::uint64_t seed = 1000; seed < 1000 + effort(300); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene = random_cells(seed);
    const Separation answer = separate(scene);
    if (answer.overlap) continue;
    for (int quarter = 0; quarter < 4; ++quarter) {
      Scene moved = scene;
      moved.end = 1;
      const double way[4][2] = {{100, 0}, {0, 100}, {-100, 0}, {0, -100}};
      moved.bodies[1].motion = from_velocity({way[quarter][0], way[quarter][1]});
      const bool free = check(moved).outcome == Outcome::free;
      const double deg = 90 * quarter;
      const bool said = answer.bodies[0].all ||
                        std::any_of(answer.bodies[0].free.begin(), answer.bodies[0].free.end(), [&](const auto& arc) {
                          const auto turned = [](double x) { return x - 360 * std::floor((x + 1e-9) / 360); };
                          const double width = arc.point ? 0 : turned(arc.to.hi - arc.from.lo);
                          slots += arc.point ? 1 : 0;
                          return turned(deg - arc.from.lo) <= width + 1e-9;
                        });
      EXPECT_EQ(said, free) << deg;
    }
  }
  EXPECT_GE(slots, static_cast<int>(enough(10)));
}

/// Turned by an angle that no double is exact for, the directions are turned.
TEST(Separate, TurnsWithTheScene) {
  for (std::uint64_t seed = 50; seed < 50 + effort(40); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Scene scene = random_neighbours(seed);
    const Separation before = separate(scene);
    if (before.overlap) continue;
    const double angle = 1.25;
    for (Body& body : scene.bodies) body.motion.pieces = {{{3, 1}, {-2, 5}, AngleRotation{{angle, 2}}}};
    const Separation after = separate(scene);
    ASSERT_EQ(after.bodies[0].free.size(), before.bodies[0].free.size());
    for (const DirectionArc& arc : before.bodies[0].free) {
      const double expected = std::fmod(arc.from.lo + angle / to_radians, 360);
      EXPECT_TRUE(std::any_of(after.bodies[0].free.begin(), after.bodies[0].free.end(), [&](const DirectionArc& other) {
        const double off = std::fabs(other.from.lo - expected);
        return before.bodies[0].all || std::min(off, 360 - off) < 1e-9;
      }));
    }
  }
}

/// As far as a travel that ends in the midst of things: what is beyond does not matter, and ends of arcs are where a
/// vertex comes to an edge at the travel's end.
TEST(Separate, AsFarAsATravelAsWhenMoved) {
  int inside = 0, outside = 0, reached = 0;
  for (std::uint64_t seed = 0; seed < 2 * effort(150); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene = seed % 2 == 0 ? random_neighbours(seed) : random_cells(seed);
    Rng rng(seed);
    SeparateOptions options;
    options.travel = seed % 6 == 1 ? rng.below(4) + 1 : std::exp(rng.real(-2, 1.3));
    const Separation answer = separate(scene, options);
    ASSERT_EQ(answer.reason, "");
    if (answer.overlap) continue;
    for (int i = 0; i < 24; ++i) {
      const double deg = 15 * i + rng.real(0, 15);
      const PlaceInArcs place = place_of(deg, answer.bodies[0]);
      if (place == PlaceInArcs::near) continue;
      ++(place == PlaceInArcs::inside ? inside : outside);
      ASSERT_EQ(leaves(scene, 1, deg, options.travel), place == PlaceInArcs::inside) << deg << " by " << options.travel;
    }
    for (const DirectionArc& arc : answer.bodies[0].free) reached += arc.from_reach || arc.to_reach ? 1 : 0;
  }
  EXPECT_GE(inside, static_cast<int>(enough(1000)));
  EXPECT_GE(outside, static_cast<int>(enough(500)));
  EXPECT_GE(reached, static_cast<int>(enough(60)));
}

TEST(Separate, ATravelThatEndsAtAFace) {
  Scene scene;
  Body wall, box;
  wall.name = "wall";
  wall.polygon = {{2, -10}, {3, -10}, {3, 10}, {2, 10}};
  box.name = "box";
  box.polygon = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  scene.bodies = {wall, box};
  SeparateOptions options;
  // It comes to the face, and no farther: touching is allowed.
  options.travel = 1;
  EXPECT_TRUE(separate(scene, options).bodies[0].all);
  options.travel = 2;
  const Separation answer = separate(scene, options);
  ASSERT_EQ(answer.bodies[0].free.size(), 1u);
  const DirectionArc& arc = answer.bodies[0].free[0];
  EXPECT_LE(arc.from.lo, 60);
  EXPECT_GE(arc.from.hi, 60);
  EXPECT_LE(arc.to.lo, 300);
  EXPECT_GE(arc.to.hi, 300);
  ASSERT_TRUE(arc.from_reach && arc.to_reach);
  EXPECT_EQ(arc.from_reach->vertex.body, 1);
  EXPECT_EQ(arc.from_reach->edge, (EdgeRef{0, 3, 0, 0}));
  EXPECT_FALSE(arc.from_vertices || arc.to_vertices);
  options.travel = 0;
  EXPECT_THROW(separate(scene, options), InputError);
}

TEST(Separate, AssembliesComeApart) {
  int whole = 0, stuck = 0;
  for (std::uint64_t seed = 0; seed < effort(40); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene cells = random_cells(seed);
    Scene scene;
    for (const Body& body : cells.bodies) {
      for (std::size_t i = 0; i < body.parts.size(); i += 2) {
        Body piece;
        piece.name = body.name + std::to_string(i);
        piece.parts = {body.parts[i]};
        if (i + 1 < body.parts.size()) piece.parts.push_back(body.parts[i + 1]);
        scene.bodies.push_back(piece);
      }
    }
    if (scene.bodies.size() < 3) continue;
    const Separation answer = separate(scene);
    ASSERT_FALSE(answer.overlap);
    Scene left = scene;
    for (const RemovalStep& step : answer.order) {
      const std::string& name = scene.bodies[static_cast<std::size_t>(step.body)].name;
      const auto body =
          std::find_if(left.bodies.begin(), left.bodies.end(), [&](const Body& b) { return b.name == name; });
      ASSERT_NE(body, left.bodies.end());
      if (!step.free.point) {
        EXPECT_TRUE(leaves(left, static_cast<std::size_t>(body - left.bodies.begin()), step.direction_deg)) << name;
      }
      left.bodies.erase(body);
    }
    EXPECT_EQ(answer.stuck.empty() ? 1u : answer.stuck.size(), left.bodies.size());
    ++(answer.stuck.empty() ? whole : stuck);
    for (const BodyDirections& body : answer.bodies) {
      const double deg = 33 + 7 * static_cast<double>(seed);
      const PlaceInArcs place = place_of(std::fmod(deg, 360), body);
      if (place == PlaceInArcs::near) continue;
      EXPECT_EQ(leaves(scene, static_cast<std::size_t>(body.body), deg), place == PlaceInArcs::inside);
    }
  }
  EXPECT_GE(whole, static_cast<int>(enough(5)));
}

TEST(Separate, InAHoleAndFarAway) {
  Scene scene;
  Body ring, coin;
  ring.name = "ring";
  ring.parts = {{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{{1, 1}, {8, 1}, {8, 8}, {1, 8}}}}};
  coin.name = "coin";
  coin.polygon = {{4, 4}, {5, 4}, {5, 5}};
  scene.bodies = {ring, coin};
  Separation answer = separate(scene);
  EXPECT_TRUE(answer.bodies[0].free.empty());
  EXPECT_FALSE(answer.bodies[0].all);
  scene.ignore = {{"ring", "coin"}};
  answer = separate(scene);
  EXPECT_EQ(answer.outcome, SeparationOutcome::untested);
  EXPECT_TRUE(answer.bodies.empty());
  scene.ignore.clear();
  scene.bodies[1].polygon = {{1, 1}, {20, 1}, {20, 2}};
  answer = separate(scene);
  ASSERT_TRUE(answer.overlap);
  scene.bodies[1].polygon = {{20, 4}, {21, 4}, {21, 5}};
  answer = separate(scene);
  // Blocked is what leads from the coin to the ring.
  ASSERT_EQ(answer.bodies[0].free.size(), 1u);
  const DirectionArc& arc = answer.bodies[0].free[0];
  const double from = std::atan2(-5, -12) / to_radians + 360, to = std::atan2(5, -11) / to_radians;
  EXPECT_LE(arc.from.lo, from + 1e-9);
  EXPECT_GE(arc.from.hi, from - 1e-9);
  EXPECT_LE(arc.to.lo, to + 1e-9);
  EXPECT_GE(arc.to.hi, to - 1e-9);
  EXPECT_EQ((*arc.from_vertices)[0].body, 1);
  EXPECT_EQ((*arc.from_vertices)[1], (VertexRef{0, 1, 0, 0}));
}

}  // namespace
}  // namespace taut::testing
