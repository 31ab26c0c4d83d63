// The bridge over the corner between two hulls, against its definition: all pairs of vertices, each held against both
// chains.
#include "tiling/root_faces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <optional>
#include <set>
#include <vector>

#include "generators/generators.hpp"
#include "motion/motion_segments.hpp"
#include "numeric/budget.hpp"
#include "scene/body_pair.hpp"
#include "scene/placement.hpp"
#include "support/effort.hpp"
#include "support/random_scenes.hpp"
#include "support/tight_mouth.hpp"
#include "tiling/geodesic_faces.hpp"

namespace taut::testing {
using namespace internal;
namespace {

using Chain = std::vector<VertexId>;

/// The chains of two hulls that touch and whose strands do not; nothing for others.
std::optional<FreeChains> chains_of(const Chain& p, const Chain& q) {
  const auto at = [](const Chain& cycle, VertexId v) {
    return static_cast<std::size_t>(std::find(cycle.begin(), cycle.end(), v) - cycle.begin());
  };
  const auto shared = [&](std::size_t i) {
    const std::size_t j = at(q, p[i]), k = at(q, p[(i + 1) % p.size()]);
    return j < q.size() && k < q.size() && (k + 1) % q.size() == j;
  };
  for (std::size_t exit = 0; exit < p.size(); ++exit) {
    if (at(q, p[exit]) == q.size() || shared(exit)) continue;
    FreeChains c{{p[exit]}, {p[exit]}};
    for (std::size_t i = exit + 1; c.a.size() == 1 || at(q, c.a.back()) == q.size(); ++i)
      c.a.push_back(p[i % p.size()]);
    for (std::size_t j = at(q, p[exit]) + q.size() - 1; c.b.size() == 1 || c.b.back() != c.a.back(); --j)
      c.b.push_back(q[(j + q.size()) % q.size()]);
    const std::set<std::uint32_t> inner = [&c] {
      std::set<std::uint32_t> values;
      for (std::size_t i = 1; i + 1 < c.a.size(); ++i) values.insert(c.a[i].value);
      return values;
    }();
    if (inner.size() + 2 < c.a.size()) return std::nullopt;  // strands that touch
    return c;
  }
  return std::nullopt;
}

/// All bridges, by their definition.
class AllBridges {
 public:
  AllBridges(const Placement& placement, const FreeChains& chains) : place_(placement), a_(chains.a), b_(chains.b) {}

  std::vector<Bridge> run() const {
    std::vector<Bridge> found;
    const std::size_t za = a_.size() - 1, zb = b_.size() - 1;
    for (std::size_t i = 1; i < za; ++i) {
      const VertexId y = a_[i];
      const auto at_y = [&](VertexId x) {
        return left(y, x, a_[i - 1]) < 0 && (a_[i + 1] == x || left(y, x, a_[i + 1]) < 0);
      };
      for (std::size_t l = i + 2; l < za; ++l) {
        const VertexId x = a_[l];
        if (at_y(x) && left(y, x, a_[l - 1]) > 0 && left(y, x, a_[l + 1]) > 0 && clear(y, x))
          found.push_back({i, BridgeEnd::on_a, l});
      }
      for (std::size_t j = 1; j < zb; ++j) {
        const VertexId x = b_[j];
        if (at_y(x) && left(y, x, b_[j - 1]) < 0 && left(y, x, b_[j + 1]) < 0 && clear(y, x))
          found.push_back({i, BridgeEnd::on_b, j});
      }
      const VertexId z = a_[za];
      if (i + 1 < za && at_y(z) && left(y, z, b_[zb - 1]) < 0 && left(y, z, a_[za - 1]) > 0 && clear(y, z))
        found.push_back({i, BridgeEnd::at_z_a, zb});
    }
    return found;
  }

 private:
  int left(VertexId y, VertexId x, VertexId v) const {
    if (y == v) return 0;
    return x == v ? -1 : place_.orientation(y, x, v);
  }
  bool clear(VertexId y, VertexId x) const { return clear_of(a_, y, x) && clear_of(b_, y, x); }
  bool clear_of(const Chain& chain, VertexId y, VertexId x) const {
    for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
      const VertexId v = chain[k], w = chain[k + 1];
      if (v == y || v == x || w == y || w == x) continue;
      if (left(y, x, v) != left(y, x, w) && left(v, w, y) != left(v, w, x)) return false;
    }
    return true;
  }

  const Placement& place_;
  const Chain &a_, &b_;
};

/// Counts by where the bridge ends, and how many are there.
struct BridgeCounts {
  int on_b = 0, at_z_a = 0, on_a = 0;
  std::size_t longest = 0;  ///< of the chains whose bridge ends on A
};

/// The chains of the bodies' hulls, built as the tiling's are.
std::optional<FreeChains> chains_at(const Placement& placement) {
  FreeTriangulation t;
  if (triangulate_free_space(placement, t)) return std::nullopt;
  const PairGeometry& g = placement.geometry();
  PlanarMap map;
  map.reset(g.size());
  const ChainTree tree_p(g.np, node::p_tree), tree_q(g.nq, node::q_tree);
  add_polygon_edges(tree_p, 0, map);
  add_polygon_edges(tree_q, g.np, map);
  Chain p, q;
  for (const HalfedgeId h : add_geodesic_faces(placement, t, tree_p, 0, map)) p.push_back(map.origin(h));
  for (const HalfedgeId h : add_geodesic_faces(placement, t, tree_q, g.np, map)) q.push_back(map.origin(h));
  return chains_of(p, q);
}

void compare_bridges(const Placement& placement, BridgeCounts& counts) {
  const auto chains = chains_at(placement);
  if (!chains) return;
  const std::vector<Bridge> all = AllBridges(placement, *chains).run();
  ASSERT_EQ(all.size(), 1u) << "bridges by definition";
  const Bridge found = find_bridge(placement, *chains);
  EXPECT_EQ(found.from, all[0].from);
  EXPECT_EQ(found.end, all[0].end);
  EXPECT_EQ(found.to, all[0].to);
  ++(found.end == BridgeEnd::on_b ? counts.on_b : found.end == BridgeEnd::at_z_a ? counts.at_z_a : counts.on_a);
  if (found.end == BridgeEnd::on_a) counts.longest = std::max(counts.longest, chains->a.size());
}

/// At some instants of a scene's first segment.
void compare_bridges(const Scene& scene, int instants, BridgeCounts& counts) {
  const BodyPair bodies = pair_of(scene);
  const MotionSegments segments = segments_of(bodies, scene.start, scene.end);
  const PairGeometry geometry = displaced_pair(bodies, Offset::inward);
  for (int i = 0; i < instants; ++i) {
    const double t = segments[0].start + (segments[0].end - segments[0].start) * (i + 0.5) / instants;
    compare_bridges(Placement(geometry, segments[0], t), counts);
  }
}

TEST(RootBridge, IsTheOneByDefinitionInRandomScenes) {
  BridgeCounts counts;
  for (std::uint64_t seed = 0; seed < effort(250); ++seed) {
    for (const Family family : all_families) {
      for (const bool grid : {false, true}) {
        SCOPED_TRACE(std::string(to_string(family)) + " seed " + std::to_string(seed) + (grid ? " on a grid" : ""));
        SceneOptions options;
        options.grid = grid;
        compare_bridges(random_scene(90000 + seed, family, options), 3, counts);
        if (::testing::Test::HasFailure()) return;
      }
    }
  }
  std::cout << counts.on_b << " on B, " << counts.at_z_a << " at z_a, " << counts.on_a << " on A\n";
  EXPECT_GT(counts.on_b, static_cast<int>(enough(1000)));
  EXPECT_GT(counts.at_z_a, static_cast<int>(enough(20)));
  EXPECT_GT(counts.on_a, static_cast<int>(enough(19)));
}

TEST(RootBridge, IsTheOneByDefinitionBetweenManyVertices) {
  BridgeCounts counts;
  for (const double gap : {0.02, 0.1, 0.5, 2.0, 6.0}) {
    for (const double radius : {0.5, 3.0, 6.0}) {
      for (const double x : {-1.5, 0.0, 1.5}) {
        for (const double y : {-1.0, 0.1, 1.2}) {
          SCOPED_TRACE("gap " + std::to_string(gap) + ", radius " + std::to_string(radius) + " at " +
                       std::to_string(x) + ", " + std::to_string(y));
          compare_bridges(tight_mouth({24, gap, radius, x, y}), 1, counts);
        }
      }
    }
  }
  gen::SpiralOptions spiral;
  for (const double turns : {1.0, 2.0, 4.0}) {
    spiral.turns = turns;
    spiral.side_points = 150;
    compare_bridges(gen::make_spiral(spiral), 8, counts);
  }
  std::cout << counts.on_b << " on B, " << counts.at_z_a << " at z_a, " << counts.on_a << " on A, longest "
            << counts.longest << "\n";
  EXPECT_GT(counts.on_b, 10);
  EXPECT_GT(counts.on_a, 10);
  EXPECT_GT(counts.longest, 20u);
}

TEST(RootBridge, CostsInProportionToTheChains) {
  const auto cost = [](int lip_points) {
    const Scene scene = tight_mouth({lip_points, 0.1, 6, 0, 1.2});
    const BodyPair bodies = pair_of(scene);
    const MotionSegments segments = segments_of(bodies, scene.start, scene.end);
    const PairGeometry geometry = displaced_pair(bodies, Offset::inward);
    const Placement placement(geometry, segments[0], scene.start);
    const FreeChains chains = chains_at(placement).value();
    EXPECT_GT(chains.a.size() + chains.b.size(), static_cast<std::size_t>(lip_points) / 2);
    const std::uint64_t before = work_spent();
    EXPECT_EQ(find_bridge(placement, chains).end, BridgeEnd::on_a);
    return work_spent() - before;
  };
  const std::uint64_t small = cost(250), large = cost(1000);
  EXPECT_LT(large, 5 * small) << small << " and " << large;
  EXPECT_LT(large, 20000u);
  EXPECT_GT(large, 1000u) << "where it cannot be interrupted, there is no work to count";
}

}  // namespace
}  // namespace taut::testing
