#include "support/simulated_worlds.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/pieces.hpp"
#include "motion/pose.hpp"

namespace taut::testing {
using namespace internal;

Answer fresh_answer(const Scene& scene, Touch touch) {
  CheckOptions options;
  options.touch = touch;
  options.engine = EngineChoice::spacetime;
  options.tell_touching = false;
  return check(scene, options);
}

Answer asked_afresh(const Simulation& simulation, Touch touch) {
  Scene rest = simulation.scene();
  rest.start = simulation.time();
  rest.at_rest = AtRest::never;
  return fresh_answer(rest, touch);
}

void expect_ended(const Simulation& simulation, const Answer& answer, SimulationCounts& counts) {
  if (answer.outcome == Outcome::free) {
    ASSERT_EQ(simulation.state(), SimulationState::finished) << simulation.reason();
    ++counts.finished;
    return;
  }
  if (answer.outcome == Outcome::untested) {
    // Something may have been tested before the last change.
    const SimulationState state = simulation.state();
    ASSERT_TRUE(state == SimulationState::untested || state == SimulationState::finished) << simulation.reason();
    return;
  }
  if (answer.outcome == Outcome::overlap_at_start) {
    ASSERT_EQ(simulation.state(), SimulationState::overlap_at_start) << simulation.reason();
    ++counts.overlaps;
    if (answer.pair) {
      EXPECT_EQ(*simulation.pair(), *answer.pair);
    }
    return;
  }
  ASSERT_EQ(answer.outcome, Outcome::contact) << answer.reason;
  ASSERT_EQ(simulation.state(), SimulationState::contact) << simulation.reason();
  ++counts.contacts;
  const Contact &found = *simulation.contact(), &expected = *answer.contact;
  EXPECT_NEAR(found.time.lo, expected.time.lo, 1e-9);
  EXPECT_NEAR(found.time.hi, expected.time.hi, 1e-9);
  EXPECT_LE(simulation.time(), found.time.hi);
  if (answer.pair && answer.also.empty()) {
    EXPECT_EQ(*simulation.pair(), *answer.pair);
  }
  if (expected.grazing || expected.time.lo == expected.time.hi || !answer.also.empty()) return;
  EXPECT_EQ(found.vertex, expected.vertex);
  EXPECT_EQ(found.edge, expected.edge);
}

Motion going_on(const Body& body, double t, Rng& rng) {
  MotionPiece piece;
  Pose<double> at;
  if (body.motion.pieces.empty()) {
    at = pose(piece, Ball<double>::exact(t));
  } else {
    at = pose(piece_at(body.motion.pieces, t), Ball<double>::exact(t));
  }
  const double vx = rng.real(-2, 2), vy = rng.real(-2, 2), spin = rng.chance(0.5) ? rng.real(-2, 2) : 0;
  piece.x = {at.ox.v.mid - vx * t, vx};
  piece.y = {at.oy.v.mid - vy * t, vy};
  piece.rotation = AngleRotation{{std::atan2(at.xy.v.mid, at.xx.v.mid) - spin * t, spin}};
  if (rng.chance(0.3)) {
    piece.x = {at.ox.v.mid};
    piece.y = {at.oy.v.mid};
  }
  Motion motion;
  motion.pieces = {piece};
  return motion;
}

}  // namespace taut::testing
