// The kinetic engine on pairs of rings: what is in a cavity that is closed on all sides. After every event its map
// equals the map built from scratch, and it answers as the second engine does.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "geometry/predicates.hpp"
#include "solver/pair_solver.hpp"
#include "support/audit.hpp"
#include "support/cavity_scenes.hpp"
#include "support/effort.hpp"
#include "support/exact_oracle.hpp"
#include "taut/check.hpp"

namespace taut::testing {
using namespace internal;
namespace {

struct RingCounts {
  AuditCounts maps;
  std::uint64_t contained = 0, free = 0, contact = 0, overlap = 0;
};

/// By the second engine.
void expect_other_engine_agrees(const Instance& world, Offset offset, const RingAudit& kinetic) {
  const PairInstance pair(world, 0, 1, offset);
  if (spacetime::overlapping(pair.geometry, pair.trees(), pair.segments()[0], world.start())) {
    EXPECT_EQ(kinetic.outcome, Outcome::overlap_at_start);
    return;
  }
  const spacetime::SpacetimeResult other = spacetime::first_contact(pair.geometry, pair.trees(), pair.segments());
  ASSERT_NE(other.outcome, spacetime::SpacetimeResult::undecided) << other.reason;
  ASSERT_EQ(kinetic.outcome == Outcome::contact, other.outcome == spacetime::SpacetimeResult::contact);
  if (!kinetic.found) return;
  EXPECT_EQ(kinetic.found->segment, other.segment);
  EXPECT_EQ(kinetic.found->contact.vertex, other.found.vertex);
  EXPECT_EQ(kinetic.found->contact.edge, other.found.edge);
  EXPECT_LE(kinetic.found->contact.lo, other.found.hi);
  EXPECT_LE(other.lo, kinetic.found->contact.hi);
}

void examine(const Scene& scene, Offset offset, RingCounts& counts) {
  const Instance world(scene);
  const RingAudit result = audit_rings(world, 0, 1, offset, counts.maps);
  ASSERT_EQ(result.fault, "");
  counts.contained += result.contained;
  ++(result.outcome == Outcome::free      ? counts.free
     : result.outcome == Outcome::contact ? counts.contact
                                          : counts.overlap);
  ASSERT_NO_FATAL_FAILURE(expect_other_engine_agrees(world, offset, result));
}

void print(const RingCounts& counts) {
  const AuditCounts& maps = counts.maps;
  std::cout << maps.scenes << " scenes, " << counts.contained << " rings in a hole, " << maps.events << " events, "
            << maps.compared << " maps compared, " << maps.not_compared << " not, " << counts.free << " free, "
            << counts.contact << " contacts, " << counts.overlap << " overlaps, " << maps.pinch_rule
            << " by the pinch rule\n";
  for (const auto& [name, count] : maps.roots) std::cout << "  " << name << ": " << count << '\n';
  for (const auto& [name, count] : maps.repairs) std::cout << "  " << name << ": " << count << '\n';
}

TEST(RingEngines, KineticEqualsStaticInClosedCavities) {
  RingCounts counts;
  for (std::uint64_t seed = 0; seed < effort(500); ++seed) {
    for (const Cavity cavity : all_cavities) {
      SCOPED_TRACE(std::string(to_string(cavity)) + " seed " + std::to_string(seed));
      CavityOptions options;
      options.parents = seed % 5 == 4;
      const Scene scene = cavity_scene(seed, cavity, options);
      ASSERT_NO_FATAL_FAILURE(examine(scene, seed % 4 != 3 ? Offset::inward : Offset::outward, counts));
    }
  }
  print(counts);
  EXPECT_GE(counts.maps.scenes, enough(2000));
  EXPECT_GE(counts.contained, enough(2000));
  EXPECT_GT(counts.free, enough(100));
  EXPECT_GT(counts.contact, enough(500));
}

TEST(RingEngines, KineticEqualsStaticOnGrids) {
  RingCounts counts;
  CavityOptions options;
  options.grid = true;
  for (std::uint64_t seed = 0; seed < effort(200); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    ASSERT_NO_FATAL_FAILURE(
        examine(cavity_scene(seed, Cavity::island, options), seed % 2 == 0 ? Offset::inward : Offset::outward, counts));
  }
  print(counts);
}

/// Stars on a grid, and stars between them: two bodies of so many parts each that every ring is in many pairs.
Scene many_parts(std::uint64_t seed) {
  Rng rng(seed);
  Scene scene;
  scene.end = 1;
  for (const int body : {0, 1}) {
    Body stars;
    stars.name = body == 0 ? "grid" : "between";
    for (int i = 0; i < 9; ++i) {
      const double size = body == 0 ? rng.real(0.3, 0.7) : rng.real(0.1, 0.5);
      const int vertices = 5 + rng.below(6);
      Polygon star;
      for (int k = 0; k < vertices; ++k) {
        const double angle = 2 * M_PI * k / vertices, radius = size * rng.real(0.4, 1);
        star.push_back(
            {2.0 * (i % 3) + body + radius * std::cos(angle), 2.0 * (i / 3) + body + radius * std::sin(angle)});
      }
      stars.parts.push_back({star, {}});
    }
    scene.bodies.push_back(stars);
  }
  MotionPiece way{{0, rng.real(-1, 1)}, {0, rng.real(-1, 1)}, NoRotation{}};
  if (seed % 2) way.rotation = AngleRotation{{0, rng.real(-0.5, 0.5)}};
  scene.bodies[1].motion.pieces = {way};
  return scene;
}

TEST(RingEngines, KineticEqualsStaticWhereRingsAreInManyPairs) {
  RingCounts counts;
  for (std::uint64_t seed = 0; seed < effort(40); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    ASSERT_NO_FATAL_FAILURE(examine(many_parts(seed), seed % 4 != 3 ? Offset::inward : Offset::outward, counts));
  }
  print(counts);
  EXPECT_GT(counts.contact, enough(10));
  EXPECT_GT(counts.maps.compared, enough(1000));
}

/// As one polygon that does not close: the hole is cut open at its rightmost vertex by a slit that nothing gets
/// through, so that the oracle, which knows of no holes, decides it by definition.
std::optional<Polygon> cut_open(const Part& part) {
  const Polygon& hole = part.holes[0];
  const std::size_t n = hole.size();
  std::size_t tip = 0;
  for (std::size_t k = 1; k < n; ++k) {
    if (hole[k].x > hole[tip].x) tip = k;
  }
  const AxisBox b = box_around(part.outline);
  const double right = hole[tip].x, slit = 0x1p-20;
  if (polygon_orientation(hole) < 0) return std::nullopt;
  // Clockwise around the hole, from just above its tip to just below.
  Polygon open{{b.lo_x, b.lo_y}, {b.hi_x, b.lo_y}, {b.hi_x, hole[tip].y - slit}, {right, hole[tip].y - slit}};
  for (std::size_t k = 1; k < n; ++k) open.push_back(hole[(tip + n - k) % n]);
  open.insert(open.end(),
              {{right, hole[tip].y + slit}, {b.hi_x, hole[tip].y + slit}, {b.hi_x, b.hi_y}, {b.lo_x, b.hi_y}});
  return open;
}

/// Stars in stars that nothing but a translation, or a turn by half angles, moves: what the oracle decides exactly.
Scene decidable_scene(std::uint64_t seed) {
  Scene scene = cavity_scene(seed, Cavity::rock);
  Rng rng(seed);
  scene.bodies[0].motion = {};
  Drive drive;
  drive.kind = seed % 3 == 0 ? MotionKind::linear : seed % 3 == 1 ? MotionKind::polynomial : MotionKind::half_angle;
  drive.reach = rng.real(20, 200);
  drive.turn = rng.real(0.1, 2);
  Body& inside = scene.bodies[1];
  inside.parts[0].outline =
      animate(rng, "inside", cavity_scene(seed, Cavity::rock).bodies[1].parts[0].outline, drive).polygon;
  inside.motion = random_motion(rng, drive);
  return scene;
}

TEST(RingEngines, AnswersInCavitiesFitTheDefinition) {
  int decided = 0, contacts = 0;
  for (std::uint64_t seed = 0; seed < effort(150); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene world = decidable_scene(seed);
    Scene flat = world;
    const std::optional<Polygon> open = cut_open(world.bodies[0].parts[0]);
    if (!open) continue;
    flat.bodies[0] = Body{"around", *open, {}};
    flat.bodies[1] = Body{"inside", world.bodies[1].parts[0].outline, world.bodies[1].motion};
    const exact::ExactAnswer truth = exact::first_contact(flat, Touch::open);
    if (truth.verdict == exact::Verdict::beyond) continue;
    ++decided;
    CheckOptions options;
    options.engine = EngineChoice::kinetic;
    const Answer answer = check(world, options);
    ASSERT_STREQ(to_string(answer.outcome), exact::to_string(truth.verdict));
    if (!answer.contact) continue;
    ++contacts;
    const double t = truth.time.lo();
    EXPECT_NEAR(answer.contact->time.lo, t, 1e-5);
  }
  std::cout << decided << " decided by definition, " << contacts << " contacts\n";
  EXPECT_GE(decided, static_cast<int>(enough(100)));
  EXPECT_GE(contacts, static_cast<int>(enough(50)));
}

}  // namespace
}  // namespace taut::testing
