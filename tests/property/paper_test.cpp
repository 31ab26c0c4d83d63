// The paper's statements that can be counted, asserted: Observation 2.2, Lemma 2.4 with the constant of its proof,
// responsiveness, and the two lower bounds of section 3 with the families of Fig. 16 and Fig. 17.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>
#include <map>
#include <set>

#include "generators/generators.hpp"
#include "scene/placement.hpp"
#include "support/effort.hpp"
#include "support/random_scenes.hpp"
#include "support/tiling_run.hpp"
#include "taut/check.hpp"
#include "taut/io.hpp"
#include "taut/separator.hpp"
#include "taut/simulation.hpp"
#include "tiling/planar_map.hpp"
#include "tiling/root_faces.hpp"

namespace taut::testing {
using namespace internal;
namespace {

using Edges = std::multiset<std::pair<int, int>>;

Edges edges_of(const Tiling& tiling) {
  Edges out;
  for (const TilingEdge& e : tiling.edges) out.insert(std::minmax(e.from, e.to));
  return out;
}

/// Edges with the root's two faces on both sides.
std::set<std::pair<int, int>> root_edges(const Tiling& tiling) {
  std::map<std::pair<int, int>, int> sides;
  for (const TilingFace& face : tiling.faces) {
    if (face.kind != FaceKind::root && face.kind != FaceKind::infinite) continue;
    for (std::size_t i = 0; i < face.boundary.size(); ++i)
      ++sides[std::minmax(face.boundary[i], face.boundary[(i + 1) % face.boundary.size()])];
  }
  std::set<std::pair<int, int>> out;
  for (const auto& [edge, count] : sides) {
    if (count == 2) out.insert(edge);
  }
  return out;
}

std::set<std::pair<int, int>> cycle_edges(const GeodesicCycle& cycle) {
  std::set<std::pair<int, int>> out;
  const std::size_t n = cycle.vertices.size();
  for (std::size_t i = 0; i < n; ++i) out.insert(std::minmax(cycle.vertices[i], cycle.vertices[(i + 1) % n]));
  return out;
}

int mixed_edges(const Tiling& tiling, const GeodesicCycle& cycle) {
  const auto body = [&](int v) { return tiling.vertices[static_cast<std::size_t>(v)].vertex.body; };
  int count = 0;
  const std::size_t n = cycle.vertices.size();
  for (std::size_t i = 0; i < n; ++i) count += body(cycle.vertices[i]) != body(cycle.vertices[(i + 1) % n]);
  return count;
}

/// "The edges of the ERGT are obtained by superimposing O(log n) pinned geodesic cycles for each polygon, and possibly
/// some inner and outer common tangents."
TEST(Paper, Observation22CyclesAndTangentsAreAllEdges) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < effort(25); ++seed) {
    for (const Family family : all_families) {
      SCOPED_TRACE(std::string(to_string(family)) + " seed " + std::to_string(seed));
      const Scene scene = random_scene(7000 + seed, family);
      Simulation simulation(scene);
      for (const double share : {0.0, 0.3, 0.7}) {
        if (simulation.advance_to(scene.start + share * (scene.end - scene.start)) != SimulationState::running) break;
        const Tiling tiling = simulation.tiling();
        std::set<std::pair<int, int>> drawn = root_edges(tiling);
        for (const int body : {0, 1}) {
          const int levels = simulation.levels(body);
          EXPECT_LE(levels, 2 + std::log2(static_cast<double>(tiling.vertices.size())));
          for (int level = 0; level < levels; ++level) {
            const GeodesicCycle cycle = simulation.geodesic_cycle(body, level);
            const auto edges = cycle_edges(cycle);
            drawn.insert(edges.begin(), edges.end());
            EXPECT_LE(cycle.pinned.size(), std::size_t{1} << level);
          }
          // The last level is the body itself.
          EXPECT_EQ(simulation.geodesic_cycle(body, levels - 1).vertices.size(),
                    scene.bodies[static_cast<std::size_t>(body)].polygon.size());
        }
        std::set<std::pair<int, int>> known;
        for (const auto& e : edges_of(tiling)) known.insert(e);
        EXPECT_EQ(drawn, known);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, static_cast<int>(enough(200)));
}

/// Lemma 4.2: "Any QQ edge of PGC(P) is also an edge of RCH(P) and of RCH(Q)."
TEST(Paper, Lemma42ForeignEdgesAreOnBothHulls) {
  int edges = 0;
  for (std::uint64_t seed = 0; seed < effort(60); ++seed) {
    for (const Family family : {Family::intertwined, Family::nested, Family::corridor, Family::spirals}) {
      SCOPED_TRACE(std::string(to_string(family)) + " seed " + std::to_string(seed));
      const Simulation simulation(random_scene(7500 + seed, family));
      if (simulation.state() != SimulationState::running) continue;
      const Tiling tiling = simulation.tiling();
      const auto body = [&](int v) { return tiling.vertices[static_cast<std::size_t>(v)].vertex.body; };
      const std::set<std::pair<int, int>> hulls[] = {cycle_edges(simulation.geodesic_cycle(0, 0)),
                                                     cycle_edges(simulation.geodesic_cycle(1, 0))};
      for (const int own : {0, 1}) {
        for (int level = 0; level < simulation.levels(own); ++level) {
          for (const auto& e : cycle_edges(simulation.geodesic_cycle(own, level))) {
            if (body(e.first) == own || body(e.second) == own) continue;
            ++edges;
            EXPECT_EQ(hulls[0].count(e), 1u) << e.first << "-" << e.second;
            EXPECT_EQ(hulls[1].count(e), 1u) << e.first << "-" << e.second;
          }
        }
      }
    }
  }
  EXPECT_GT(edges, static_cast<int>(enough(200)));
}

/// Lemma 3.3: "Any combinatorial change to the ERGT involves the appearance or disappearance of some PP or QQ edge in a
/// pinned geodesic cycle", where a change is one of a cycle.
TEST(Paper, Lemma33ChangesShowInEdgesWithinABody) {
  struct Cycles {
    std::vector<std::vector<int>> sequences;
    std::vector<std::multiset<std::pair<int, int>>> own;  ///< PP and QQ edges, directed
  };
  const auto cycles_of = [](const Simulation& simulation) {
    Cycles out;
    const Tiling tiling = simulation.tiling();
    const auto body = [&](int v) { return tiling.vertices[static_cast<std::size_t>(v)].vertex.body; };
    for (const int b : {0, 1}) {
      for (int level = 0; level < simulation.levels(b); ++level) {
        out.sequences.push_back(simulation.geodesic_cycle(b, level).vertices);
        const std::vector<int>& v = out.sequences.back();
        out.own.emplace_back();
        for (std::size_t i = 0; i < v.size(); ++i) {
          if (body(v[i]) == body(v[(i + 1) % v.size()])) out.own.back().insert({v[i], v[(i + 1) % v.size()]});
        }
      }
    }
    return out;
  };
  int changes = 0;
  for (std::uint64_t seed = 0; seed < effort(80); ++seed) {
    for (const Family family : {Family::apart, Family::intertwined, Family::nested}) {
      SCOPED_TRACE(std::string(to_string(family)) + " seed " + std::to_string(seed));
      SceneOptions options;
      options.kinds = {MotionKind::linear, MotionKind::polynomial, MotionKind::angle};
      Simulation simulation(random_scene(9500 + seed, family, options));
      if (simulation.state() != SimulationState::running) continue;
      Cycles before = cycles_of(simulation);
      while (simulation.step() && simulation.state() == SimulationState::running) {
        const Cycles after = cycles_of(simulation);
        if (before.sequences != after.sequences) {
          EXPECT_NE(before.own, after.own);
          ++changes;
        }
        before = after;
      }
    }
  }
  EXPECT_GT(changes, static_cast<int>(enough(200)));
}

/// The proof of Lemma 2.4, with its constants: at most 2 kappa PQ edges on a cycle, 2 kappa (2 + log2 n - log2 kappa) +
/// 2 kappa in all, and four certificates an edge.
struct Compactness {
  double largest_share = 0;
  int placements = 0, intertwined = 0;

  void check(const Simulation& simulation) {
    const Tiling tiling = simulation.tiling();
    Polygon polygons[2];
    const auto n = static_cast<double>(tiling.vertices.size());
    for (const TilingVertex& v : tiling.vertices) polygons[v.vertex.body].push_back(v.position);
    const Separator found = separator(polygons[0], polygons[1]);
    if (found.overlap) return;  // rounding
    const double kappa = found.minimum_link.lower;
    const double pq_bound = 2 * kappa * (2 + std::log2(n) - std::log2(kappa)) + 2 * kappa;
    const auto pq = std::count_if(tiling.edges.begin(), tiling.edges.end(), [](const TilingEdge& e) { return e.pq; });
    EXPECT_LE(static_cast<double>(pq), pq_bound);
    EXPECT_LE(static_cast<double>(simulation.certificates()), 4 * pq_bound);
    for (const int body : {0, 1}) {
      for (int level = 0; level < simulation.levels(body); ++level)
        EXPECT_LE(mixed_edges(tiling, simulation.geodesic_cycle(body, level)), 2 * kappa) << "level " << level;
    }
    largest_share = std::max(largest_share, static_cast<double>(simulation.certificates()) / (4 * pq_bound));
    ++placements;
    intertwined += kappa > 3;
  }
};

TEST(Paper, Lemma24BoundsTheActiveSet) {
  Compactness compactness;
  for (std::uint64_t seed = 0; seed < effort(40); ++seed) {
    for (const Family family : all_families) {
      SCOPED_TRACE(std::string(to_string(family)) + " seed " + std::to_string(seed));
      const Scene scene = random_scene(8000 + seed, family);
      Simulation simulation(scene);
      for (const double share : {0.0, 0.5}) {
        if (simulation.advance_to(scene.start + share * (scene.end - scene.start)) != SimulationState::running) break;
        compactness.check(simulation);
      }
    }
  }
  for (const int teeth : {2, 5, 16, 60}) {
    SCOPED_TRACE(teeth);
    gen::CombOptions o;
    o.teeth = teeth;
    compactness.check(Simulation(gen::make_combs(o)));
  }
  std::cout << compactness.placements << " placements, " << compactness.intertwined
            << " with more than three links, largest share of the bound " << compactness.largest_share << '\n';
  EXPECT_GT(compactness.placements, static_cast<int>(enough(400)));
  EXPECT_GT(compactness.intertwined, static_cast<int>(enough(60)));
}

/// Section 2.3: "the update of the ERGT involves the destruction and creation of a constant number of edges": one of
/// each at most.
TEST(Paper, ARepairChangesAtMostOneEdgeEachWay) {
  int events = 0;
  for (std::uint64_t seed = 0; seed < effort(30); ++seed) {
    for (const Family family : all_families) {
      SCOPED_TRACE(std::string(to_string(family)) + " seed " + std::to_string(seed));
      Simulation simulation(random_scene(9000 + seed, family));
      if (simulation.state() != SimulationState::running) continue;
      Edges before = edges_of(simulation.tiling());
      while (simulation.step() && simulation.state() == SimulationState::running) {
        const Edges after = edges_of(simulation.tiling());
        Edges gone, come;
        std::set_difference(before.begin(), before.end(), after.begin(), after.end(), std::inserter(gone, gone.end()));
        std::set_difference(after.begin(), after.end(), before.begin(), before.end(), std::inserter(come, come.end()));
        EXPECT_LE(gone.size(), 1u);
        EXPECT_LE(come.size(), 1u);
        EXPECT_GE(gone.size() + come.size(), 1u);
        before = after;
        ++events;
      }
    }
  }
  EXPECT_GT(events, static_cast<int>(enough(1000)));
}

/// The scenes of docs/paper.md show what they are there to show.
TEST(Paper, ScenesOfTheFiguresHaveTheirEvents) {
  class Counter : public Tracer {
   public:
    void on_event(const TraceEvent& e) override { ++seen[to_string(e.repair)]; }
    std::map<std::string, int> seen;
  };
  Counter counter;
  Simulation(read_scene("examples/paper/fig7.json"), Touch::open, &counter).advance_to(INFINITY);
  for (const char* repair : {"reflex_a", "reflex_b", "reflex_c", "convex_flip"})
    EXPECT_GE(counter.seen[repair], 1) << repair;
  std::set<std::string> states;
  const Scene scene = read_scene("examples/paper/fig5.json");
  TilingRun run(scene);
  for (int k = 1; k < 100; ++k) {
    const double t = scene.start + (scene.end - scene.start) * k / 100;
    while (run.step(t)) {
    }
    const Placement placement(run.engine().geometry(), run.engine().segment(), run.engine().parameter());
    const StaticTiling fresh = build_tiling(placement);
    EXPECT_EQ(difference(run.engine().map(), fresh.map), "");
    states.insert(to_string(fresh.root));
  }
  EXPECT_EQ(states, (std::set<std::string>{"disjoint", "bridged", "mouth", "pinched"}));
}

std::uint64_t events_of(const Scene& scene) {
  CheckOptions kinetic;
  kinetic.engine = EngineChoice::kinetic;
  const Answer answer = check(scene, kinetic);
  EXPECT_STREQ(to_string(answer.outcome), "free");
  return answer.events;
}

/// Theorem 3.1: Omega(kn) on Fig. 16 (k/2 dips), and no more than O(kn log n).
TEST(Paper, Theorem31EventsOfFig16) {
  for (const int k : {2, 4, 8, 16}) {
    for (const int n : {16, 64, 256, 1024}) {
      gen::DipOptions o;
      o.sides = n;
      o.dips = k / 2;
      const auto events = static_cast<double>(events_of(gen::make_dips(o)));
      SCOPED_TRACE(::testing::Message() << "k = " << k << ", n = " << n);
      EXPECT_GE(events, 0.75 * k * n);
      EXPECT_LE(events, 0.5 * k * n * std::log2(n));
    }
  }
}

/// Theorem 3.2: Omega(n^2) on Fig. 17: every tooth crosses the extension of every edge of the chain, both ways.
TEST(Paper, Theorem32EventsOfFig17) {
  for (const int n : {8, 16, 32, 64}) {
    gen::RotorOptions o;
    o.teeth = n;
    o.chain_edges = n;
    const auto events = static_cast<double>(events_of(gen::make_rotor(o)));
    SCOPED_TRACE(n);
    EXPECT_GE(events, static_cast<double>(n) * n);
    EXPECT_LE(events, 8.0 * n * n);
  }
}

}  // namespace
}  // namespace taut::testing
