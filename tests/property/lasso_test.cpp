// The paper's lasso, built literally: a geodesic homotopic to the boundary of Q, pinned to a vertex p of P (section
// 2.1, Fig. 2). It must give exactly the root's edges that the rules of root_faces.cpp give, in all four states.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "motion/pieces.hpp"
#include "scene/placement.hpp"
#include "support/effort.hpp"
#include "support/random_scenes.hpp"
#include "support/tiling_run.hpp"
#include "tiling/geodesic_faces.hpp"
#include "tiling/root_faces.hpp"

namespace taut::testing {
using namespace internal;
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;
Edge undirected(VertexId a, VertexId b) { return {std::min(a.value, b.value), std::max(a.value, b.value)}; }

class Lasso {
 public:
  Lasso(const Placement& placement, const FreeTriangulation& t) : place_(placement), t_(t), g_(placement.geometry()) {}

  /// The vertices of the geodesic, from p back to p.
  std::vector<VertexId> run(VertexId p) {
    p_ = p;
    lead();
    around();
    // Back the way we came: the diagonal d is crossed once, between the two visits of its end on P.
    cross(entry_);
    for (std::size_t i = lead_.size(); i-- > 0;) cross(t_.twin[lead_[i]]);
    std::size_t lo = 0, hi = sleeve_.size();
    while (lo < hi && touches(sleeve_[lo])) ++lo;
    while (hi > lo && touches(sleeve_[hi - 1])) --hi;
    return funnel(lo, hi);
  }

 private:
  bool touches(std::uint32_t d) const { return t_.origin[d] == p_ || t_.target(d) == p_; }
  /// Half-edges from u, counterclockwise through free space, from the edge to its predecessor to that to its successor
  /// (both excluded).
  std::vector<std::uint32_t> fan(VertexId u) const {
    std::vector<std::uint32_t> out;
    std::uint32_t h = t_.boundary[g_.previous(u).value];
    for (;;) {
      h = t_.twin[FreeTriangulation::previous(h)];
      if (h == FreeTriangulation::none) return out;
      out.push_back(h);
    }
  }
  /// Crosses diagonal d with its origin on the left; crossing back cancels.
  void cross(std::uint32_t d) {
    if (!sleeve_.empty() && sleeve_.back() == t_.twin[d]) {
      sleeve_.pop_back();
    } else {
      sleeve_.push_back(d);
    }
  }
  /// From p clockwise along P (P on the right) to the first diagonal that leads to Q. The string starts towards
  /// infinity: p is on the hull of both polygons together, so that it has a diagonal to the box.
  void lead() {
    const auto to_box = [this](std::uint32_t h) { return t_.target(h).value >= place_.size(); };
    bool first = true;
    for (VertexId u = p_;; u = g_.previous(u), first = false) {
      std::vector<std::uint32_t> f = fan(u);
      std::reverse(f.begin(), f.end());
      if (first) f.erase(f.begin(), std::find_if(f.rbegin(), f.rend(), to_box).base());
      for (const std::uint32_t h : f) {
        const VertexId w = t_.target(h);
        if (w.value < place_.size() && !g_.in_p(w)) {
          entry_ = h;
          return;
        }
        if (first) continue;  // the string starts at p: what p touches is not crossed
        lead_.push_back(t_.twin[h]);
        cross(t_.twin[h]);
      }
    }
  }
  /// Clockwise around Q, Q on the right, from one side of the entry diagonal to the other.
  void around() {
    const VertexId w = t_.target(entry_);
    std::vector<std::uint32_t> f = fan(w);
    std::reverse(f.begin(), f.end());
    const auto at = std::find(f.begin(), f.end(), t_.twin[entry_]);
    for (auto i = at + 1; i != f.end(); ++i) cross(t_.twin[*i]);
    for (VertexId u = g_.previous(w); u != w; u = g_.previous(u)) {
      std::vector<std::uint32_t> all = fan(u);
      std::reverse(all.begin(), all.end());
      for (const std::uint32_t h : all) cross(t_.twin[h]);
    }
    for (auto i = f.begin(); i != at; ++i) cross(t_.twin[*i]);
  }

  int turn(VertexId a, VertexId b, VertexId c) const {
    return (a == b || b == c || c == a) ? 0 : place_.orientation(a, b, c);
  }
  std::vector<VertexId> funnel(std::size_t lo, std::size_t hi) const {
    std::vector<VertexId> path{p_}, left{p_}, right{p_};
    const auto add = [&](std::vector<VertexId>& side, std::vector<VertexId>& other, VertexId v, int sign) {
      if (v == side.back()) return;
      while (side.size() > 1 && sign * turn(side[side.size() - 2], side.back(), v) <= 0) side.pop_back();
      if (side.size() == 1) {
        while (other.size() > 1 && sign * turn(other[0], other[1], v) <= 0) {
          path.push_back(other[1]);
          other.erase(other.begin());
          side[0] = other[0];
        }
      }
      side.push_back(v);
    };
    for (std::size_t i = lo; i < hi; ++i) {
      add(left, right, t_.origin[sleeve_[i]], 1);
      add(right, left, t_.target(sleeve_[i]), -1);
    }
    add(left, right, p_, 1);
    path.insert(path.end(), left.begin() + 1, left.end());
    return path;
  }

  const Placement& place_;
  const FreeTriangulation& t_;
  const PairGeometry& g_;
  VertexId p_;
  std::uint32_t entry_ = 0;
  std::vector<std::uint32_t> lead_, sleeve_;
};

/// The end of a diametral pair of P such that no point of Q lies beyond it.
VertexId pin(const Placement& placement) {
  const PairGeometry& g = placement.geometry();
  const auto at = [&](std::uint32_t i) { return placement.approximate(VertexId(i)); };
  std::pair<std::uint32_t, std::uint32_t> best{0, 1};
  double longest = 0;
  for (std::uint32_t i = 0; i < g.np; ++i) {
    for (std::uint32_t j = 0; j < i; ++j) {
      const double d = std::hypot(at(i).x - at(j).x, at(i).y - at(j).y);
      if (d > longest) longest = d, best = {i, j};
    }
  }
  const Point a = at(best.first), b = at(best.second);
  for (std::uint32_t k = g.np; k < g.size(); ++k) {
    const Point q = at(k);
    if ((q.x - a.x) * (b.x - a.x) + (q.y - a.y) * (b.y - a.y) < 0) return VertexId(best.second);
  }
  return VertexId(best.first);
}

/// Edges of the map with PT or F on both sides that belong to neither relative hull: the root's own.
std::set<Edge> root_edges(const PlanarMap& map) {
  std::set<Edge> out;
  const auto at_root = [](ChainNode n) { return n == node::root || n == node::infinite_face; };
  for (std::uint32_t i = 0; i < map.halfedge_count(); i += 2) {
    const HalfedgeId h(i);
    if (map.alive(h) && at_root(map.node(h)) && at_root(map.node(PlanarMap::twin(h))))
      out.insert(undirected(map.origin(h), map.target(h)));
  }
  return out;
}

TEST(Lasso, GivesTheRootEdgesInAllStates) {
  std::map<std::string, int> states;
  for (std::uint64_t seed = 0; seed < effort(120); ++seed) {
    for (const Family family : {Family::apart, Family::intertwined, Family::nested, Family::corridor}) {
      SCOPED_TRACE(std::string(to_string(family)) + " seed " + std::to_string(seed));
      const Scene scene = random_scene(5000 + seed, family);
      TilingRun run(scene);
      for (int sample = 0; sample < 6 && !run.finished(); ++sample) {
        const double t = scene.start + (scene.end - scene.start) * sample / 6;
        while (run.step(t)) {
        }
        if (run.finished() || run.engine().segment().bridge) break;
        const Placement placement(run.engine().geometry(), run.engine().segment(), t);
        FreeTriangulation triangulation;
        ASSERT_FALSE(triangulate_free_space(placement, triangulation));
        const StaticTiling tiling = build_tiling(placement);
        ++states[to_string(tiling.root)];
        const std::vector<VertexId> lasso = Lasso(placement, triangulation).run(pin(placement));
        std::set<Edge> drawn, known;
        for (std::size_t i = 0; i + 1 < lasso.size(); ++i) drawn.insert(undirected(lasso[i], lasso[i + 1]));
        for (std::uint32_t i = 0; i < tiling.map.halfedge_count(); i += 2) {
          const HalfedgeId h(i);
          if (tiling.map.alive(h)) known.insert(undirected(tiling.map.origin(h), tiling.map.target(h)));
        }
        for (const Edge& e : drawn) EXPECT_TRUE(known.count(e)) << e.first << "-" << e.second << " is not in the map";
        for (const Edge& e : root_edges(tiling.map))
          EXPECT_TRUE(drawn.count(e)) << e.first << "-" << e.second << " is not on the lasso, "
                                      << to_string(tiling.root);
        if (HasFailure()) return;
      }
    }
  }
  for (const char* state : {"disjoint", "bridged", "mouth", "pinched"})
    EXPECT_GT(states[state], static_cast<int>(enough(5))) << state;
}

}  // namespace
}  // namespace taut::testing
