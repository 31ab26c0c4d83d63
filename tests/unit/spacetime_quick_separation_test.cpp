// A glance that says two bodies are apart, against the search that makes models of their motion.
#include "spacetime/first_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "motion/motion_segments.hpp"
#include "scene/body_pair.hpp"
#include "support/effort.hpp"
#include "support/rng.hpp"

namespace taut::internal::spacetime {
namespace {

using testing::Rng;

Polygon star(Rng& rng) {
  const int n = rng.between(3, 12);
  Polygon ring;
  for (int k = 0; k < n; ++k) {
    const double angle = 6.283185307179586 * k / n, radius = rng.real(0.3, 1);
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return ring;
}

MotionPiece uniform_piece(Rng& rng) {
  MotionPiece piece;
  piece.x = {rng.real(-3, 3), rng.real(-3, 3)};
  piece.y = {rng.real(-3, 3), rng.real(-3, 3)};
  if (rng.chance(0.8)) piece.rotation = AngleRotation{{rng.real(-4, 4), rng.real(-6, 6)}};
  if (rng.chance(0.3)) piece.pivot = {rng.real(-1, 1), rng.real(-1, 1)};
  return piece;
}

TEST(Glances, WhatTheyShowIsFree) {
  std::uint64_t shown = 0, left = 0, met = 0;
  for (std::uint64_t seed = 0; seed < testing::effort(4000); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    Scene scene;
    scene.end = 1;
    for (const char* name : {"a", "b"}) scene.bodies.push_back({name, star(rng), {{uniform_piece(rng)}}});
    const BodyPair bodies = pair_of(scene);
    const PairGeometry geometry = displaced_pair(bodies, rng.chance(0.5) ? Offset::inward : Offset::outward);
    const Hierarchy p = hierarchy_of_p(geometry), q = hierarchy_of_q(geometry);
    const double from = rng.real(0, 1), to = from + (1 - from) * rng.unit();
    const MotionSegments segments = segments_of(bodies, from, to);
    for (const MotionSegment& segment : segments) {
      const bool apart = quickly_apart({p, q}, segment, segment.start, segment.end);
      const SpacetimeResult truth = first_contact(geometry, {p, q}, MotionSegments(segment));
      if (truth.outcome == SpacetimeResult::contact) ++met;
      if (apart) {
        ++shown;
        EXPECT_EQ(truth.outcome, SpacetimeResult::free);
      } else if (!segment.translation && truth.outcome == SpacetimeResult::free) {
        ++left;
      }
    }
  }
  EXPECT_GT(shown, testing::enough(1500));
  EXPECT_GT(met, testing::enough(300));
  // Those that overlap all the time are among what is left.
  EXPECT_LT(left, shown);
}

}  // namespace
}  // namespace taut::internal::spacetime
