// A body that turns about a pivot c is one whose coordinates are taken from c, and whose origin is c farther. Where no
// difference rounds, the answers must be the same, by both engines, in the tiling after every event, and in the proof.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "support/audit.hpp"
#include "support/effort.hpp"
#include "support/random_scenes.hpp"
#include "taut/check.hpp"
#include "taut/proof.hpp"

namespace taut::testing {
namespace {

/// Adds without rounding, or says that it cannot.
bool add_exactly(double& x, double y) {
  const double sum = x + y;
  if (sum - y != x || sum - x != y) return false;
  x = sum;
  return true;
}

bool add_to_constant(Coefficients& c, double y) {
  if (c.empty()) c.push_back(0);
  return add_exactly(c[0], y);
}

/// The same motion of the same shape, written with a pivot. False if a number would round.
bool give_pivot(Body& body, const Point& c) {
  for (Point& v : body.polygon) {
    if (!add_exactly(v.x, c.x) || !add_exactly(v.y, c.y)) return false;
  }
  if (body.motion.pieces.empty()) body.motion.pieces.emplace_back();
  for (MotionPiece& piece : body.motion.pieces) {
    piece.pivot = c;
    if (!add_to_constant(piece.x, -c.x) || !add_to_constant(piece.y, -c.y)) return false;
  }
  return true;
}

struct Seen {
  int contacts = 0, free = 0, rounded = 0;
};

void expect_same(const Answer& plain, const Answer& pivoted) {
  ASSERT_STREQ(to_string(plain.outcome), to_string(pivoted.outcome));
  if (!plain.contact) return;
  EXPECT_NEAR(plain.contact->time.lo, pivoted.contact->time.lo, 1e-12);
  EXPECT_NEAR(plain.contact->time.hi, pivoted.contact->time.hi, 1e-12);
  EXPECT_EQ(plain.contact->vertex.body, pivoted.contact->vertex.body);
  EXPECT_EQ(plain.contact->vertex.index, pivoted.contact->vertex.index);
  EXPECT_EQ(plain.contact->edge.index, pivoted.contact->edge.index);
  const Point &p = plain.contact->point, &q = pivoted.contact->point;
  EXPECT_NEAR(p.x, q.x, 1e-9 * (1 + std::fabs(p.x)));
  EXPECT_NEAR(p.y, q.y, 1e-9 * (1 + std::fabs(p.y)));
}

void compare(const Scene& scene, const Scene& pivoted, Seen& seen) {
  const Answer plain = check(scene);
  CheckOptions both;
  both.engine = EngineChoice::both;
  ASSERT_NO_FATAL_FAILURE(expect_same(plain, check(pivoted, both)));
  AuditCounts counts;
  EXPECT_EQ(audit(pivoted, Touch::open, counts).fault, "");
  std::stringstream log;
  prove(pivoted, log);
  if (plain.outcome == Outcome::overlap_at_start) return;
  EXPECT_STREQ(to_string(verify(pivoted, log).outcome), to_string(plain.outcome));
  ++(plain.contact ? seen.contacts : seen.free);
}

TEST(Pivot, IsAShiftOfTheOrigin) {
  Seen seen;
  SceneOptions options;
  options.kinds = {MotionKind::angle,  MotionKind::direction, MotionKind::half_angle,
                   MotionKind::cosine, MotionKind::orbit,     MotionKind::pieces};
  for (const Family family : all_families) {
    for (std::uint64_t seed = 0; seed < effort(12); ++seed) {
      SCOPED_TRACE(std::string(to_string(family)) + " seed " + std::to_string(seed));
      const Scene scene = random_scene(700 + seed, family, options);
      Scene pivoted = scene;
      // One body, the other, or both.
      const bool fits = (seed % 3 == 1 || give_pivot(pivoted.bodies[0], {1024.5, -512})) &&
                        (seed % 3 == 0 || give_pivot(pivoted.bodies[1], {-256, 4096.25}));
      if (!fits) {
        ++seen.rounded;
        continue;
      }
      ASSERT_NO_FATAL_FAILURE(compare(scene, pivoted, seen));
    }
  }
  EXPECT_GT(seen.contacts, static_cast<int>(enough(20)));
  EXPECT_GT(seen.free, static_cast<int>(enough(10)));
  EXPECT_LT(seen.rounded, static_cast<int>(effort(30)));
}

}  // namespace
}  // namespace taut::testing
