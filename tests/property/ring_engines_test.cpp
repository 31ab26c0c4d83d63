// The kinetic engine on pairs of rings: what is in a cavity that is closed on all sides. After every event its map
// equals the map built from scratch, and it answers as the second engine does.
#include <gtest/gtest.h>

#include <iostream>

#include "search/pair_search.hpp"
#include "support/audit.hpp"
#include "support/cavity_scenes.hpp"
#include "support/effort.hpp"

namespace taut::testing {
namespace {

struct RingCounts {
  AuditCounts maps;
  std::uint64_t contained = 0, free = 0, contact = 0, overlap = 0;
};

/// By the second engine.
void expect_same_answer(const WorldPlan& world, bool inwards, const RingAudit& kinetic) {
  const PairSearch pair(world, 0, 1, inwards);
  if (spacetime::overlapping(pair.geometry, pair.trees(), pair.legs()[0], world.start())) {
    EXPECT_EQ(kinetic.outcome, Outcome::overlap_at_start);
    return;
  }
  const spacetime::SpacetimeResult other = spacetime::first_contact(pair.geometry, pair.trees(), pair.legs());
  ASSERT_NE(other.outcome, spacetime::SpacetimeResult::undecided) << other.reason;
  ASSERT_EQ(kinetic.outcome == Outcome::contact, other.outcome == spacetime::SpacetimeResult::contact);
  if (!kinetic.found) return;
  EXPECT_EQ(kinetic.found->leg, other.leg);
  EXPECT_EQ(kinetic.found->contact.vertex, other.vertex);
  EXPECT_EQ(kinetic.found->contact.edge, other.edge);
  EXPECT_LE(kinetic.found->contact.lo, other.hi);
  EXPECT_LE(other.lo, kinetic.found->contact.hi);
}

void examine(const Scene& scene, bool inwards, RingCounts& counts) {
  const WorldPlan world(scene);
  const RingAudit result = audit_rings(world, 0, 1, inwards, counts.maps);
  ASSERT_EQ(result.fault, "");
  counts.contained += result.contained;
  ++(result.outcome == Outcome::free      ? counts.free
     : result.outcome == Outcome::contact ? counts.contact
                                          : counts.overlap);
  ASSERT_NO_FATAL_FAILURE(expect_same_answer(world, inwards, result));
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
      ASSERT_NO_FATAL_FAILURE(examine(scene, seed % 4 != 3, counts));
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
    ASSERT_NO_FATAL_FAILURE(examine(cavity_scene(seed, Cavity::island, options), seed % 2 == 0, counts));
  }
  print(counts);
}

}  // namespace
}  // namespace taut::testing
