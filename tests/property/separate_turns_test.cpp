// Assemblies taken apart along ways that may turn: against a search on the grid, check(), and known answers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "support/effort.hpp"
#include "support/rng.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/motions.hpp"
#include "taut/path.hpp"
#include "taut/separate.hpp"

namespace taut::testing {
namespace {

using GridCell = std::array<int, 2>;
using GridPiece = std::set<GridCell>;

std::vector<GridPiece> random_pieces(Rng& rng, int pieces, int side) {
  std::vector<GridPiece> all(static_cast<std::size_t>(pieces));
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) {
      const int owner = rng.below(pieces + 1);
      if (owner < pieces) all[static_cast<std::size_t>(owner)].insert({x, y});
    }
  }
  std::erase_if(all, [](const GridPiece& piece) { return piece.empty(); });
  return all;
}

Scene scene_of_pieces(const std::vector<GridPiece>& pieces) {
  Scene scene;
  for (const GridPiece& piece : pieces) {
    Body body;
    body.name = "piece " + std::to_string(scene.bodies.size());
    for (const auto& [i, j] : piece) {
      const double x = i, y = j;
      body.parts.push_back({{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}, {}});
    }
    scene.bodies.push_back(std::move(body));
  }
  return scene;
}

/// Does it leave the others by unit steps along the axes? A step passes over the two places only.
bool leaves_by_steps(const GridPiece& piece, const GridPiece& others) {
  constexpr int far = 12;
  const auto fits = [&](const GridCell& by) {
    return std::none_of(piece.begin(), piece.end(), [&](const GridCell& c) {
      return others.count({c[0] + by[0], c[1] + by[1]}) > 0;
    });
  };
  std::set<GridCell> seen{{0, 0}};
  std::vector<GridCell> open{{0, 0}};
  while (!open.empty()) {
    const GridCell at = open.back();
    open.pop_back();
    if (std::abs(at[0]) == far || std::abs(at[1]) == far) return true;
    for (const auto& [dx, dy] : {GridCell{1, 0}, GridCell{-1, 0}, GridCell{0, 1}, GridCell{0, -1}}) {
      const GridCell to{at[0] + dx, at[1] + dy};
      if (fits(to) && seen.insert(to).second) open.push_back(to);
    }
  }
  return false;
}

bool apart_by_steps(std::vector<GridPiece> pieces) {
  while (pieces.size() > 1) {
    const auto leaver = std::find_if(pieces.begin(), pieces.end(), [&](const GridPiece& piece) {
      GridPiece others;
      for (const GridPiece& other : pieces)
        if (&other != &piece) others.insert(other.begin(), other.end());
      return leaves_by_steps(piece, others);
    });
    if (leaver == pieces.end()) return false;
    pieces.erase(leaver);
  }
  return true;
}

SeparateOptions with_turns(std::uint64_t max_cells = 3000) {
  SeparateOptions options;
  options.turns = true;
  options.max_cells = max_cells;
  return options;
}

/// A vertex of the body at a place of its way, by definition.
Point moved_vertex(const RemovalWay& way, const WayPoint& at, const Point& p) {
  const double a = at.deg * (std::acos(-1.0) / 180), x = p.x - way.pivot.x, y = p.y - way.pivot.y;
  return {way.pivot.x + at.x + std::cos(a) * x - std::sin(a) * y,
          way.pivot.y + at.y + std::sin(a) * x + std::cos(a) * y};
}

/// Each way begins where the body is, ends outside of the box of all that are left, and check() proves all of it.
void expect_proved_ways(const Scene& scene, const Separation& answer) {
  std::set<BodyId> left;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) left.insert(static_cast<BodyId>(k));
  for (const RemovalWay& way : answer.ways) {
    ASSERT_EQ(left.erase(way.body), 1u);
    ASSERT_FALSE(way.points.empty());
    EXPECT_EQ(way.points[0].x, 0);
    EXPECT_EQ(way.points[0].y, 0);
    EXPECT_EQ(way.points[0].deg, 0);
    std::array<double, 4> own{1e9, -1e9, 1e9, -1e9}, rest = own;
    const auto include = [](std::array<double, 4>& box, const Point& p) {
      box = {std::min(box[0], p.x), std::max(box[1], p.x), std::min(box[2], p.y), std::max(box[3], p.y)};
    };
    const auto each_vertex = [&](BodyId body, const auto& use) {
      const Body& of = scene.bodies[static_cast<std::size_t>(body)];
      for (const Point& p : of.polygon) use(p);
      for (const Part& part : of.parts)
        for (const Point& p : part.outline) use(p);
    };
    each_vertex(way.body, [&](const Point& p) { include(own, moved_vertex(way, way.points.back(), p)); });
    for (const BodyId body : left) each_vertex(body, [&](const Point& p) { include(rest, p); });
    const double gap = std::max({own[0] - rest[1], rest[0] - own[1], own[2] - rest[3], rest[2] - own[3]});
    EXPECT_GE(gap, -1e-9);
  }
  const std::size_t known = answer.ways.size() + answer.stuck.size() + answer.unsure.size();
  EXPECT_EQ(known + (answer.outcome == SeparationOutcome::free ? 1 : 0), scene.bodies.size());
  CheckOptions options;
  options.engine = EngineChoice::spacetime;
  const Scene leaving = removal_scene(scene, answer);
  if (leaving.end > 0) {
    EXPECT_EQ(check(leaving, options).outcome, Outcome::free);
  }
}

TEST(SeparateTurns, PiecesOfAGridAsByUnitSteps) {
  int apart = 0, locked = 0, bent = 0;
  for (std::uint64_t seed = 0; seed < effort(100); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const std::vector<GridPiece> pieces = random_pieces(rng, 2 + rng.below(2), 4 + rng.below(2));
    if (pieces.size() < 2) continue;
    const Scene scene = scene_of_pieces(pieces);
    const Separation answer = separate(scene, with_turns());
    ASSERT_FALSE(answer.overlap);
    EXPECT_EQ(answer.rounded, 0);
    ASSERT_NO_FATAL_FAILURE(expect_proved_ways(scene, answer));
    if (apart_by_steps(pieces)) {
      ASSERT_EQ(answer.outcome, SeparationOutcome::free);
      ++apart;
    }
    for (const RemovalWay& way : answer.ways) bent += way.points.size() > 2;
    locked += answer.outcome == SeparationOutcome::locked;
    // Straight ways are ways.
    if (separate(scene).outcome == SeparationOutcome::free) {
      EXPECT_EQ(answer.outcome, SeparationOutcome::free);
    }
  }
  EXPECT_GE(apart, static_cast<int>(enough(15)));
  EXPECT_GE(locked, static_cast<int>(enough(1)));
  EXPECT_GE(bent, static_cast<int>(enough(2)));
}

/// What comes apart, and what is stuck, depends neither on the order of the bodies nor on where they stand.
TEST(SeparateTurns, OtherOrderAndOtherPlace) {
  int compared = 0;
  for (std::uint64_t seed = 5000; seed < 5000 + effort(40); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const std::vector<GridPiece> pieces = random_pieces(rng, 2 + rng.below(2), 3);
    if (pieces.size() < 2) continue;
    const Scene scene = scene_of_pieces(pieces);
    const Separation answer = separate(scene, with_turns());
    Scene other = scene;
    std::reverse(other.bodies.begin(), other.bodies.end());
    for (Body& body : other.bodies)
      for (Part& part : body.parts)
        for (Point& p : part.outline) p = {-p.y + 64, p.x - 16};
    const Separation again = separate(other, with_turns());
    if (!answer.unsure.empty() || !again.unsure.empty()) continue;
    ++compared;
    ASSERT_EQ(again.outcome, answer.outcome);
    std::vector<BodyId> stuck;
    for (const BodyId k : again.stuck) stuck.push_back(static_cast<BodyId>(scene.bodies.size()) - 1 - k);
    std::sort(stuck.begin(), stuck.end());
    // Which ones are left when nothing more leaves does not depend on the order either.
    EXPECT_EQ(stuck, answer.stuck);
  }
  EXPECT_GE(compared, static_cast<int>(enough(15)));
}

TEST(SeparateTurns, ABarThatTurnsOutOfItsChannel) {
  const Scene scene = read_scene("examples/worlds/bent_bar.json");
  const Separation straight = separate(scene);
  EXPECT_EQ(straight.outcome, SeparationOutcome::locked);
  EXPECT_EQ(straight.stuck, (std::vector<BodyId>{0, 1}));
  const Separation answer = separate(scene, with_turns(100'000));
  ASSERT_EQ(answer.outcome, SeparationOutcome::free) << answer.reason;
  EXPECT_TRUE(answer.stuck.empty());
  ASSERT_EQ(answer.ways.size(), 2u);
  EXPECT_EQ(answer.ways[0].body, 2);
  EXPECT_NE(answer.ways[1].points.back().deg, 0);
  SeparateOptions near = with_turns(100'000);
  near.travel = 1e-3;
  EXPECT_EQ(separate(scene, near).ways.size(), 2u) << "ways go as far as they have to";
  expect_proved_ways(scene, answer);
  // With the plug fixed to the block, nothing moves.
  Scene closed = scene;
  closed.bodies[0].parts = {{closed.bodies[0].polygon, {}}, {closed.bodies[2].polygon, {}}};
  closed.bodies[0].polygon.clear();
  closed.bodies.pop_back();
  const Separation shut = separate(closed, with_turns(1'000'000));
  EXPECT_EQ(shut.outcome, SeparationOutcome::locked) << shut.reason;
  EXPECT_EQ(shut.stuck, (std::vector<BodyId>{0, 1}));
  // Too few cells to show that: undecided, and why.
  const Separation few = separate(closed, with_turns(10));
  EXPECT_EQ(few.outcome, SeparationOutcome::undecided);
  EXPECT_EQ(few.unsure, (std::vector<BodyId>{0, 1}));
  EXPECT_NE(few.reason, "");
}

/// The scene's start decides where bodies stand: here all are turned and moved, by a motion and by a parent.
TEST(SeparateTurns, BodiesStandAsAtTheStart) {
  Scene scene = read_scene("examples/worlds/bent_bar.json");
  scene.start = 2;
  scene.end = 5;
  Body carrier{"carrier", {{100, 100}, {101, 100}, {100, 101}}, from_velocity({0.3, -0.7}, 20)};
  for (Body& body : scene.bodies) body.relative_to = "carrier";
  scene.bodies.push_back(carrier);
  scene.ignore.push_back({"carrier", "*"});
  const Separation answer = separate(scene, with_turns(100'000));
  ASSERT_EQ(answer.outcome, SeparationOutcome::free) << answer.reason;
  EXPECT_GT(answer.rounded, 0);
  EXPECT_LT(answer.rounded, 1e-9);
  const Scene leaving = removal_scene(scene, answer);
  EXPECT_EQ(check(leaving).outcome, Outcome::free);
  // By definition: 40 degrees about the origin, then (0.6, -1.4).
  const double a = 40 * (std::acos(-1.0) / 180);
  const Point &p = scene.bodies[1].polygon[3], &q = leaving.bodies[1].parts[0].outline[3];
  EXPECT_NEAR(q.x, 0.6 + std::cos(a) * p.x - std::sin(a) * p.y, 1e-9);
  EXPECT_NEAR(q.y, -1.4 + std::sin(a) * p.x + std::cos(a) * p.y, 1e-9);
}

/// A peg that fits its slot exactly leaves it, however both stand at the start.
TEST(SeparateTurns, ExactFitsThatAMotionTurns) {
  for (const double angle : {0.0, 37.123, 45.0, 90.0, 211.7}) {
    SCOPED_TRACE(angle);
    Scene scene;
    scene.end = 1;
    const Motion motion = from_keyframes({{0, 0.1, 0.2, angle}, {1, 1, 0.2, angle}});
    scene.bodies = {{"slot", {{0, 0}, {5, 0}, {5, 5}, {3, 5}, {3, 1}, {2, 1}, {2, 5}, {0, 5}}, motion},
                    {"peg", {{2, 1}, {3, 1}, {3, 4}, {2, 4}}, motion}};
    EXPECT_EQ(separate(scene).outcome, SeparationOutcome::free);
    const Separation answer = separate(scene, with_turns());
    ASSERT_EQ(answer.outcome, SeparationOutcome::free) << answer.reason;
    EXPECT_LT(answer.rounded, 1e-9);
    EXPECT_EQ(check(removal_scene(scene, answer)).outcome, Outcome::free);
  }
}

TEST(SeparateTurns, IgnoredBodiesAndOtherLayersBlockNothing) {
  Scene scene = read_scene("examples/worlds/bent_bar.json");
  scene.ignore.push_back({"plug", "bar"});
  scene.ignore.push_back({"plug", "block"});
  EXPECT_EQ(separate(scene, with_turns(100'000)).outcome, SeparationOutcome::free);
  Scene shut = read_scene("examples/worlds/bent_bar.json");
  shut.bodies[0].z = {0, 1};
  shut.bodies[1].z = {2, 3};
  shut.bodies[2].z = {0, 3};
  const Separation layers = separate(shut, with_turns(100'000));
  EXPECT_EQ(layers.outcome, SeparationOutcome::free) << layers.reason;
}

TEST(SeparateTurns, ErrorsSayWhatToDo) {
  Scene scene = read_scene("examples/worlds/bent_bar.json");
  SeparateOptions options = with_turns();
  options.tolerance = 0;
  EXPECT_THROW(separate(scene, options), InputError);
  options = with_turns();
  options.limits.max_seconds = 1e-9;
  const Separation stopped = separate(scene, options);
  EXPECT_EQ(stopped.outcome, SeparationOutcome::undecided);
  EXPECT_NE(stopped.reason, "");
  scene.bodies[0].polygon[0] = {2, 2};
  EXPECT_THROW(separate(scene, with_turns()), InputError);
}

/// Of the problems with known answers, those in which a body that may turn is to leave another.
TEST(SeparateTurns, KnownAnswers) {
  namespace fs = std::filesystem;
  if (!fs::exists("../shared/paths")) GTEST_SKIP() << "the problems with known answers are not here (../shared/paths)";
  for (const char* name : {"clip_goes", "clip_slide", "slider_goes", "clip_not", "tee_not"}) {
    SCOPED_TRACE(name);
    const std::string file = std::string("../shared/paths/") + name + ".json";
    const PathProblem problem = read_path_problem(file);
    ASSERT_EQ(problem.linkage.scene.bodies.size(), 2u);
    const bool goes = std::string(name).find("not") == std::string::npos;
    const Separation answer = separate(posed(problem.linkage, problem.start), with_turns(1'000'000));
    EXPECT_EQ(answer.outcome, goes ? SeparationOutcome::free : SeparationOutcome::locked) << answer.reason;
  }
}

}  // namespace
}  // namespace taut::testing
