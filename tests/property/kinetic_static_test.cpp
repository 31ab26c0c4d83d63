// The strongest test there is: after every event the kinetic map equals the map built from scratch, and the first
// contact is that of brute force. Run over many random scenes, with a count of what was exercised.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "support/audit.hpp"
#include "support/brute_force.hpp"
#include "support/effort.hpp"
#include "support/random_scenes.hpp"

namespace taut::testing {
namespace {

constexpr Family families[] = {Family::apart, Family::intertwined, Family::nested, Family::corridor,
                               Family::combs, Family::spirals,     Family::stars,  Family::convex};

struct OracleCounts {
  int agreed = 0, skipped = 0;
};

/// Compares an outcome with brute force unless that is degenerate within rounding.
void compare_with_oracle(const Scene& scene, const AuditResult& result, OracleCounts& counts) {
  const OracleAnswer oracle = brute_force(scene);
  if (oracle.verdict == Verdict::unclear || oracle.margin < 1e-7) {
    ++counts.skipped;
    return;
  }
  ++counts.agreed;
  ASSERT_STREQ(to_string(result.outcome), to_string(oracle.verdict));
  if (!result.contact) return;
  EXPECT_NEAR(result.contact->time.lo, oracle.t, oracle.time_error + 1e-12);
  if (oracle.lead < 1e-7) return;
  EXPECT_EQ(result.contact->vertex.body, oracle.vertex_body);
  EXPECT_EQ(result.contact->vertex.index, oracle.vertex);
  EXPECT_EQ(result.contact->edge.body, oracle.edge_body);
  EXPECT_EQ(result.contact->edge.index, oracle.edge);
}

void print(const AuditCounts& counts) {
  std::cout << counts.scenes << " scenes, " << counts.events << " events, " << counts.compared << " maps compared, "
            << counts.not_compared << " not (events closer than doubles), " << counts.collisions << " collisions, "
            << counts.pinch_rule << " by the pinch rule, " << counts.three_corners << " triple convex\n";
  for (const auto& [name, count] : counts.roots) std::cout << "  " << name << ": " << count << '\n';
  for (const auto& [name, count] : counts.repairs) std::cout << "  " << name << ": " << count << '\n';
}

TEST(KineticEqualsStatic, RandomScenes) {
  AuditCounts counts;
  OracleCounts oracle;
  for (std::uint64_t seed = 0; seed < effort(300); ++seed) {
    for (const Family family : families) {
      SCOPED_TRACE(std::string(to_string(family)) + " seed " + std::to_string(seed));
      const Scene scene = random_scene(seed, family);
      const AuditResult result = audit(scene, seed % 4 == 3 ? Touch::closed : Touch::open, counts);
      ASSERT_EQ(result.fault, "");
      ASSERT_NO_FATAL_FAILURE(compare_with_oracle(scene, result, oracle));
    }
  }
  print(counts);
  EXPECT_GE(counts.scenes, enough(2000));
  EXPECT_GE(static_cast<std::uint64_t>(oracle.agreed), enough(2000));
  for (const char* root : {"disjoint", "bridged", "mouth", "pinched"})
    EXPECT_GT(counts.roots[root], enough(20)) << root;
  for (const char* repair : {"convex_flip", "convex_triangle", "reflex_a", "reflex_b", "reflex_c", "collision"})
    EXPECT_GT(counts.repairs[repair], enough(20)) << repair;
  for (const char* corner : {"convex", "reflex"}) {
    for (const char* face : {"P", "Q", "PT", "F"}) {
      const std::string key = std::string(corner) + " at face " + face;
      EXPECT_GT(counts.repairs[key], enough(20)) << key;
    }
  }
  EXPECT_GT(counts.pinch_rule, enough(20));
  EXPECT_GT(counts.three_corners, enough(20));
  // Responsiveness: a repair touches a constant number of corners.
  EXPECT_LE(counts.largest_repair, 5u);
}

/// Coarse grids: collinear vertices, axis-parallel edges, events that coincide in the input.
TEST(KineticEqualsStatic, DegenerateScenes) {
  AuditCounts counts;
  OracleCounts oracle;
  SceneOptions options;
  options.grid = true;
  for (std::uint64_t seed = 0; seed < effort(60); ++seed) {
    for (const Family family : families) {
      SCOPED_TRACE(std::string(to_string(family)) + " seed " + std::to_string(seed));
      const Scene scene = random_scene(seed, family, options);
      const AuditResult result = audit(scene, seed % 2 ? Touch::closed : Touch::open, counts);
      ASSERT_EQ(result.fault, "");
      ASSERT_NO_FATAL_FAILURE(compare_with_oracle(scene, result, oracle));
    }
  }
  print(counts);
  EXPECT_GT(static_cast<std::uint64_t>(oracle.agreed), enough(300));
}

}  // namespace
}  // namespace taut::testing
