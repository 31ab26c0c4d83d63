// What it costs to verify a log: not the segments times the corners.
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "generators/generators.hpp"
#include "numeric/budget.hpp"
#include "taut/proof.hpp"

namespace taut {
using namespace internal;
namespace {

/// Two combs, one of which trembles in the slots of the other.
Scene trembling(int teeth, int pieces) {
  gen::CombOptions options;
  options.teeth = teeth;
  Scene scene = gen::make_combs(options);
  Motion& motion = scene.bodies[1].motion;
  const MotionPiece start = motion.pieces.empty() ? MotionPiece{} : motion.pieces.front();
  motion.pieces.clear();
  for (int i = 1; i <= pieces; ++i) {
    MotionPiece piece;
    piece.x = {(start.x.empty() ? 0 : start.x[0]) + (i % 3) * 1e-9};
    piece.y = {start.y.empty() ? 0 : start.y[0]};
    piece.until = i;
    motion.pieces.push_back(piece);
  }
  scene.start = 0;
  scene.end = pieces;
  return scene;
}

CheckOptions by_kinetic() {
  CheckOptions options;
  options.engine = EngineChoice::kinetic;
  return options;
}

struct Work {
  std::uint64_t points = 0, segments_times_corners = 0;
};

/// Interruption points passed until the log is accepted: each look at a corner passes at least one.
Work work_of(int teeth, int pieces) {
  const Scene scene = trembling(teeth, pieces);
  std::ostringstream log;
  const Answer answer = prove(scene, log, by_kinetic());
  EXPECT_EQ(answer.outcome, Outcome::free);
  Work work;
  work.segments_times_corners = answer.certificates_initial * static_cast<std::uint64_t>(pieces);
  for (work.points = 1 << 12;; work.points *= 2) {
    try {
      const Budget scope(work.points);
      std::istringstream in(log.str());
      EXPECT_EQ(verify(scene, in).outcome, Outcome::free);
      return work;
    } catch (const Interrupted&) {
    }
  }
}

TEST(WorkOfVerification, GrowsWithTheSceneAndTheLog) {
  const Work small = work_of(100, 500), large = work_of(400, 2000);
  EXPECT_GT(large.segments_times_corners, 15 * small.segments_times_corners);
  EXPECT_LE(large.points, 8 * small.points);
  EXPECT_LT(large.points, large.segments_times_corners / 4);
}

/// A swarm that flies diagonally, so that the boxes of all its bodies meet along both axes.
Scene swarm(int bodies, bool ignored) {
  Scene scene;
  scene.end = 1;
  for (int i = 0; i <= bodies; ++i) {
    const double x = 3.0 * (i % 20), y = 3.0 * (i / 20);
    Body body{"body " + std::to_string(i), {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}, {}};
    MotionPiece piece;
    piece.x = {0, i == bodies ? -1e5 : 1e5 + (ignored ? i : 0)};
    piece.y = {i == bodies ? -1e3 : 0, i == bodies ? -1e5 : 1e5};
    body.motion.pieces = {piece};
    scene.bodies.push_back(body);
    if (ignored && i > 0 && i < bodies) scene.ignore.push_back({body.name, "*"});
  }
  return scene;
}

TEST(WorkOfVerification, IsLinearInBodiesThatAreNotTested) {
  for (const bool ignored : {false, true}) {
    SCOPED_TRACE(ignored ? "ignored" : "moving alike");
    std::uint64_t work[2];
    for (const int k : {0, 1}) {
      const Scene scene = swarm(500 << k, ignored);
      std::stringstream log;
      ASSERT_EQ(prove(scene, log).outcome, Outcome::free);
      const std::uint64_t before = work_spent();
      EXPECT_EQ(verify(scene, log).outcome, Outcome::free);
      work[k] = work_spent() - before;
    }
    EXPECT_LT(2 * work[1], 5 * work[0]);
  }
}

TEST(WorkOfVerification, EndsWhereALimitSays) {
  const Scene scene = trembling(100, 500);
  std::ostringstream log;
  prove(scene, log, by_kinetic());
  std::istringstream in(log.str());
  const Budget scope(std::uint64_t{1000});
  EXPECT_THROW(verify(scene, in), Interrupted);
}

}  // namespace
}  // namespace taut
