// Trees, the sweep status, the free triangulation, and the checks of the tiling.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>

#include "geometry/displacement.hpp"
#include "scene/placement.hpp"
#include "support/rng.hpp"
#include "tiling/planar_map.hpp"
#include "tiling/prepared_tiling.hpp"
#include "tiling/root_faces.hpp"
#include "tiling/sweep_status.hpp"

namespace taut::testing {
using namespace internal;
namespace {

TEST(ChainTree, LeavesAndChainsOfEverySize) {
  for (std::uint32_t n = 3; n < 200; ++n) {
    const ChainTree tree(n, node::p_tree);
    EXPECT_EQ(tree.chain(tree.root()), (std::pair<std::uint32_t, std::uint32_t>{0, n}));
    std::set<std::uint32_t> codes;
    int low = 99, high = 0;
    for (std::uint32_t e = 0; e < n; ++e) {
      const ChainNode leaf = tree.leaf(e);
      EXPECT_TRUE(tree.is_leaf(leaf));
      EXPECT_TRUE(node::in_p(leaf));
      EXPECT_FALSE(node::in_q(leaf));
      EXPECT_EQ(tree.chain(leaf), (std::pair<std::uint32_t, std::uint32_t>{e, e + 1}));
      codes.insert(leaf.code);
      low = std::min(low, node::depth(leaf));
      high = std::max(high, node::depth(leaf));
    }
    EXPECT_EQ(codes.size(), n);
    EXPECT_LE(high - low, 1);  // complete: leaves on two adjacent levels
    std::function<void(ChainNode)> walk = [&](ChainNode x) {
      if (tree.is_leaf(x)) return;
      const auto whole = tree.chain(x), left = tree.chain(node::left(x)), right = tree.chain(node::right(x));
      EXPECT_EQ(whole.first, left.first);
      EXPECT_EQ(left.second, right.first);
      EXPECT_EQ(whole.second, right.second);
      walk(node::left(x));
      walk(node::right(x));
    };
    walk(tree.root());
  }
}

/// The median by walking up parents in the joined tree.
TEST(ChainTree, MedianLiesOnAllThreePaths) {
  const auto parent = [](std::uint32_t c) { return c == 3 ? 1u : (c / 2 == 3 ? 1u : c / 2); };
  const auto path = [&](std::uint32_t a, std::uint32_t b) {
    std::set<std::uint32_t> up, out;
    for (std::uint32_t x = a; x != 0; x = x == 1 ? 0 : parent(x)) up.insert(x);
    std::uint32_t meet = b;
    while (!up.count(meet)) meet = parent(meet);
    for (std::uint32_t x = a; x != meet; x = parent(x)) out.insert(x);
    for (std::uint32_t x = b; x != meet; x = parent(x)) out.insert(x);
    out.insert(meet);
    return out;
  };
  std::vector<std::uint32_t> nodes = {1, 2, 7};
  for (const std::uint32_t top : {4u, 6u}) {
    for (std::uint32_t level = 1; level < 32; level *= 2) {
      for (std::uint32_t i = 0; i < level; ++i) nodes.push_back(top * level + i);
    }
  }
  for (const std::uint32_t a : nodes) {
    for (const std::uint32_t b : nodes) {
      for (const std::uint32_t c : nodes) {
        const std::uint32_t m = node::median({a}, {b}, {c}).code;
        ASSERT_TRUE(path(a, b).count(m) && path(b, c).count(m) && path(c, a).count(m)) << a << " " << b << " " << c;
      }
    }
  }
}

TEST(SweepStatus, BehavesLikeASortedSequence) {
  Rng rng(9);
  SweepStatus status;
  std::vector<std::pair<std::uint32_t, SweepStatus::Slot>> model;  // sorted by edge
  for (int i = 0; i < 20000; ++i) {
    if (model.size() < 3 || rng.chance(model.size() < 300 ? 0.6 : 0.4)) {
      const auto value = static_cast<std::uint32_t>(rng.below(1 << 30));
      const auto below = status.last_below([value](std::uint32_t e) { return e < value; });
      const auto at = std::lower_bound(model.begin(), model.end(), std::pair{value, SweepStatus::Slot{0}});
      ASSERT_EQ(below, at == model.begin() ? SweepStatus::nil : std::prev(at)->second);
      model.insert(at, {value, status.insert_above(below, value)});
    } else {
      const int k = rng.below(static_cast<int>(model.size()));
      status.erase(model[static_cast<std::size_t>(k)].second);
      model.erase(model.begin() + k);
    }
    if (i % 100) continue;
    for (std::size_t k = 0; k < model.size(); ++k) {
      ASSERT_EQ(status.edge(model[k].second), model[k].first);
      ASSERT_EQ(status.below(model[k].second), k == 0 ? SweepStatus::nil : model[k - 1].second);
      ASSERT_EQ(status.above(model[k].second), k + 1 == model.size() ? SweepStatus::nil : model[k + 1].second);
    }
  }
}

PairGeometry two_stars(Rng& rng, std::uint32_t n, double distance) {
  std::vector<DisplacedPoint> stars[2];
  for (int body = 0; body < 2; ++body) {
    std::vector<Point> polygon;
    for (std::uint32_t i = 0; i < n; ++i) {
      // The first vertex sticks out: it lies on the hull.
      const double a = 2 * 3.141592653589793 * i / n + 0.1, r = i == 0 ? 0.5 : rng.real(0.1, 0.49);
      polygon.push_back({body * distance + r * std::cos(a), r * std::sin(a)});
    }
    stars[body] = displace(polygon, Offset::inward, displacement_unit, static_cast<std::uint64_t>(body)).points;
  }
  return {stars[0], stars[1]};
}

/// Area and counts: the triangles tile the box without the polygons.
TEST(FreeTriangulation, TilesTheFreeSpace) {
  Rng rng(10);
  const MotionSegment segment = MotionSegment::motion({}, {}, 0, 1);
  for (std::uint32_t n = 3; n < 120; n += 3) {
    const PairGeometry g = two_stars(rng, n, 1.0);
    const Placement placement(g, segment, 0);
    FreeTriangulation t;
    ASSERT_FALSE(triangulate_free_space(placement, t));
    const std::size_t triangles = t.origin.size() / 3;
    EXPECT_EQ(triangles, 2u * n + 4 + 2);  // V = 2n + 4, two holes
    double area = 0;
    for (std::size_t k = 0; k < triangles; ++k) {
      const VertexId a = t.origin[3 * k], b = t.origin[3 * k + 1], c = t.origin[3 * k + 2];
      EXPECT_EQ(placement.orientation(a, b, c), 1);
      const Point p = placement.approximate(a), q = placement.approximate(b), r = placement.approximate(c);
      area += ((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)) / 2;
    }
    double expected = 0;
    const auto add_ring = [&](std::uint32_t first, std::uint32_t count, double side) {
      for (std::uint32_t i = 0; i < count; ++i) {
        const Point p = placement.approximate(VertexId(first + i));
        const Point q = placement.approximate(VertexId(first + (i + 1) % count));
        expected += side * (p.x * q.y - q.x * p.y) / 2;
      }
    };
    add_ring(2 * n, 4, 1);
    add_ring(0, n, -1);
    add_ring(n, n, -1);
    EXPECT_NEAR(area, expected, 1e-9 * expected);
    for (std::uint32_t h = 0; h < t.origin.size(); ++h) {
      if (t.twin[h] == FreeTriangulation::none) continue;
      EXPECT_EQ(t.twin[t.twin[h]], h);
      EXPECT_EQ(t.origin[t.twin[h]], t.target(h));
    }
  }
}

TEST(FreeTriangulation, FindsOverlaps) {
  Rng rng(11);
  const MotionSegment segment = MotionSegment::motion({}, {}, 0, 1);
  int overlaps = 0;
  for (int i = 0; i < 200; ++i) {
    const PairGeometry g = two_stars(rng, 12, rng.real(0, 1.2));
    const Placement placement(g, segment, 0);
    FreeTriangulation t;
    const auto overlap = triangulate_free_space(placement, t);
    bool crossing = false;
    for (std::uint32_t a = 0; a < 12; ++a) {
      for (std::uint32_t c = 12; c < 24; ++c) {
        const VertexId u(a), v = g.next(u), w(c), x = g.next(w);
        crossing = crossing || (placement.orientation(u, v, w) != placement.orientation(u, v, x) &&
                                placement.orientation(w, x, u) != placement.orientation(w, x, v));
      }
    }
    // Stars of this size around nearby centres never contain one another without crossing.
    EXPECT_EQ(overlap.has_value(), crossing);
    overlaps += crossing;
    if (overlap) {
      EXPECT_TRUE(g.in_p(overlap->edge_p));
      EXPECT_FALSE(g.in_p(overlap->edge_q));
    }
  }
  EXPECT_GT(overlaps, 50);
}

TEST(FreeTriangulation, FindsAPolygonInsideTheOther) {
  const auto square = [](double r) {
    return displace(std::vector<Point>{{-r, -r}, {r, -r}, {r, r}, {-r, r}}, Offset::inward, displacement_unit, 3)
        .points;
  };
  const PairGeometry g(square(2), square(0.5));
  const MotionSegment segment = MotionSegment::motion({}, {}, 0, 1);
  FreeTriangulation t;
  EXPECT_TRUE(triangulate_free_space(Placement(g, segment, 0), t).has_value());
}

TEST(Checks, NoticeWhatIsWrong) {
  Rng rng(12);
  const MotionSegment segment = MotionSegment::motion({}, {}, 0, 1);
  const PairGeometry g = two_stars(rng, 20, 1.0);
  const Placement placement(g, segment, 0);
  const StaticTiling good = build_tiling(placement);
  ASSERT_EQ(find_fault(good.map, placement), "");
  EXPECT_EQ(difference(good.map, good.map), "");
  int noticed = 0, spoiled = 0;
  for (std::uint32_t i = 0; i < good.map.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    if (!good.map.alive(h) || good.map.is_interior(h)) continue;
    PlanarMap relabelled = good.map, relinked = good.map;
    relabelled.set_node(h, {good.map.node(h).code + 1});
    relinked.link(h, good.map.next(good.map.next(h)));
    spoiled += 2;
    noticed += !find_fault(relabelled, placement).empty();
    noticed += !find_fault(relinked, placement).empty();
    EXPECT_NE(difference(good.map, relabelled), "");
    EXPECT_NE(difference(good.map, relinked), "");
  }
  EXPECT_EQ(noticed, spoiled);
}

/// All of a map, by half-edge.
std::vector<std::array<std::uint32_t, 4>> contents(const PlanarMap& map) {
  std::vector<std::array<std::uint32_t, 4>> out;
  for (std::uint32_t i = 0; i < map.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    out.push_back({map.origin(h).value, map.next(h).value, map.previous(h).value, map.node(h).code});
  }
  return out;
}

TEST(PlanarMap, OfTwoBodiesReadsTheirsUntilItIsChanged) {
  Rng rng(14);
  const PairGeometry g = two_stars(rng, 40, 2.0);
  const auto p = tile_shape(g.p(), node::p_tree), q = tile_shape(g.q(), node::q_tree);
  const auto before_p = contents(p->map), before_q = contents(q->map);
  PlanarMap map = PlanarMap::joined(p->map, q->map);
  const auto number_p = PlanarMap::first_in_joined(p->map, q->map);
  const auto number_q = PlanarMap::second_in_joined(p->map, q->map);
  const auto look = [&](const PlanarMap& part, const PlanarMap::Renumbering& number, std::uint32_t first,
                        std::set<std::uint32_t>& seen) {
    for (std::uint32_t i = 0; i < part.halfedge_count(); ++i) {
      const HalfedgeId h(i), joined = number(h);
      EXPECT_TRUE(seen.insert(joined.value).second);
      EXPECT_EQ(map.origin(joined).value, part.origin(h).value + first);
      EXPECT_EQ(map.target(joined).value, part.target(h).value + first);
      EXPECT_EQ(map.next(joined), number(part.next(h)));
      EXPECT_EQ(map.previous(joined), number(part.previous(h)));
      EXPECT_EQ(map.node(joined), part.node(h));
      EXPECT_EQ(map.is_polygon_edge(joined), part.is_polygon_edge(h));
    }
  };
  std::set<std::uint32_t> seen;
  look(p->map, number_p, 0, seen);
  look(q->map, number_q, g.np, seen);
  EXPECT_EQ(seen.size(), map.halfedge_count());
  map.for_each_changed_edge([](HalfedgeId, VertexId, VertexId) { ADD_FAILURE() << "nothing has been changed"; });

  // Changes here and there, followed by a list of what everything should be.
  auto expected = contents(map);
  std::set<std::uint32_t> added;
  for (int step = 0; step < 200; ++step) {
    const auto i = static_cast<std::uint32_t>(rng.below(static_cast<int>(map.halfedge_count())));
    const HalfedgeId h(i);
    if (step % 4 == 0 && !map.is_polygon_edge(h) && map.alive(h)) {
      map.remove_edge(h);
      expected[i] = expected[i ^ 1u] = {0xffffffffu, 0xffffffffu, 0xffffffffu, 0};
      added.erase(i & ~1u);
    } else if (step % 4 == 1) {
      const HalfedgeId fresh = map.add_edge(VertexId(1u), VertexId(2u));
      if (fresh.value + 1 >= expected.size()) expected.resize(fresh.value + 2u);
      expected[fresh.value] = {1, 0xffffffffu, 0xffffffffu, 0};
      expected[fresh.value ^ 1u] = {2, 0xffffffffu, 0xffffffffu, 0};
      added.insert(fresh.value);
    } else if (step % 4 == 2) {
      map.set_node(h, {77});
      expected[i][3] = 77;
    } else {
      const PlanarMap copy = map;
      map.set_node(h, {99});
      EXPECT_EQ(contents(copy), expected);
      expected[i][3] = 99;
    }
    ASSERT_EQ(contents(map), expected) << "after step " << step;
  }
  map.for_each_changed_edge([&](HalfedgeId h, VertexId from, VertexId to) {
    EXPECT_EQ(from, map.origin(h));
    EXPECT_EQ(to, map.target(h));
    added.erase(h.value);
  });
  EXPECT_TRUE(added.empty()) << "an edge was added and not shown";
  EXPECT_EQ(contents(p->map), before_p);
  EXPECT_EQ(contents(q->map), before_q);
}

}  // namespace
}  // namespace taut::testing
