// The second engine's parts: boxes that contain, and bounds of motion that hold.
#include <gtest/gtest.h>

#include <cmath>

#include "kinetic/session.hpp"
#include "motion/motion_plan.hpp"
#include "spacetime/box_separation.hpp"
#include "spacetime/first_contact.hpp"
#include "support/random_scenes.hpp"

namespace taut::testing {
namespace {

using spacetime::Bounded;
using spacetime::Box;
using spacetime::BoxNode;
using spacetime::Course;
using spacetime::DirectedDistance;
using spacetime::FrameWindow;
using spacetime::Hierarchy;

struct Setting {
  PairGeometry geometry;
  std::vector<Leg> legs;
};

Setting setting(const Scene& scene, bool inwards = true) {
  const PairPlan plan = plan_pair(scene);
  return {displaced_pair(plan, inwards), make_legs(plan.pieces[0], plan.pieces[1], scene.start, scene.end)};
}

DisplacedPoint exactly(const Point& p) { return {p.x, p.y, 0, 0}; }

void expect_inside(const PairGeometry& g, const BoxNode& node) {
  VertexId v(node.first);
  for (std::uint32_t k = 0; k <= node.count; ++k, v = g.next(v)) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Point &a = node.box.corners[i], &b = node.box.corners[(i + 1) % 4];
      ASSERT_GT(orientation(exactly(a), exactly(b), g.point(v)), 0) << "vertex " << v.value;
    }
  }
}

TEST(SpacetimeHierarchy, BoxesContainTheirEdgesAndLeavesCoverEachEdgeOnce) {
  for (const Family family : all_families) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      const Setting s = setting(random_scene(seed, family, {seed % 2 == 0, {}}), seed % 3 == 0);
      for (const bool of_p : {true, false}) {
        const Hierarchy tree(s.geometry, of_p);
        std::vector<int> covered(s.geometry.size());
        for (std::uint32_t i = 0; i < tree.size(); ++i) {
          const BoxNode& node = tree.node(i);
          expect_inside(s.geometry, node);
          if (node.count == 1) {
            ++covered[node.first];
          } else {
            const BoxNode &l = tree.node(node.left), &r = tree.node(node.right);
            EXPECT_EQ(l.first, node.first);
            EXPECT_EQ(r.first, l.first + l.count);
            EXPECT_EQ(l.count + r.count, node.count);
          }
        }
        for (std::uint32_t v = 0; v < s.geometry.size(); ++v) {
          EXPECT_EQ(covered[v], s.geometry.in_p(VertexId(v)) == of_p ? 1 : 0);
        }
      }
    }
  }
}

/// Value, slope and bend at many instants against 320 bits; and the bound of the step against samples.
void check_bounds(const Setting& s, const Leg& leg, const MixedTriple& m) {
  const PreciseFunction<Real320> truth(leg, s.geometry, m, Measure::projection);
  const DisplacedPoint &a = s.geometry.point(m.a), &b = s.geometry.point(m.b), &c = s.geometry.point(m.c);
  const DirectedDistance f(leg, m.pp, {b.x - a.x, b.y - a.y}, {a.x, a.y}, {c.x, c.y});
  double length = leg.end - leg.start;
  for (double t = leg.start; t < leg.end;) {
    FrameWindow window(leg, t, leg.end, length);
    length = window.length() * 2;
    const auto encloses = [](const Bounded& bound, const Ball<Real320>& exact) {
      const double difference = std::fabs(Real320(exact.mid - bound.value).convert_to<double>());
      return difference <= bound.error * (1 + 1e-9) + exact.rad;
    };
    for (int i = 0; i <= 4; ++i) {
      const double at = std::min(window.end(), window.start() + window.length() * (i / 4.0));
      const Jet<Real320> exact = truth(Ball<Real320>(Real320(at), 0.0));
      if (!window.smooth()) {
        ASSERT_TRUE(encloses(f.value(window.range(m.pp)), exact.v)) << at;
        continue;
      }
      ASSERT_TRUE(encloses(f.value(window.at(at, m.pp)), exact.v)) << at;
      ASSERT_TRUE(encloses(f.slope(window.at(at, m.pp)), exact.d)) << at;
      ASSERT_TRUE(encloses(f.bend(window.bend(m.pp)), exact.dd)) << at;
      const int sign = exact.v.sign();
      const double free = Course(f, window, at, sign).positive_until(window.end() - at);
      for (const double share : {0.25, 0.5, 0.75, 0.999}) {
        ASSERT_NE(truth(Ball<Real320>(Real320(at) + Real320(free * share), 0.0)).v.sign(), -sign) << at;
      }
    }
    t = window.end();
  }
}

TEST(SpacetimeMotionBound, HoldsForEveryFormOfMotion) {
  for (const MotionKind kind : all_motions) {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      SCOPED_TRACE(std::string(to_string(kind)) + " seed " + std::to_string(seed));
      const Setting s = setting(random_scene(seed, Family::stars, {seed % 2 == 0, {kind}}));
      const std::uint32_t np = s.geometry.np;
      for (const Leg& leg : s.legs) {
        check_bounds(s, leg, {VertexId(1u), VertexId(2u), VertexId(np + 1), true});
        check_bounds(s, leg, {VertexId(np), VertexId(np + 1), VertexId(0u), false});
        if (HasFatalFailure()) return;
      }
    }
  }
}

/// Boxes that are said to be apart: their corners, placed at samples of time, are separated by a side of one box.
TEST(SpacetimeBoxes, ApartUntilIsTrue) {
  int apart = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Setting s = setting(random_scene(seed, all_families[seed % 8]));
    const Hierarchy p(s.geometry, true), q(s.geometry, false);
    for (const Leg& leg : s.legs) {
      if (leg.bridge) continue;
      FrameWindow window(leg, leg.start, leg.end, leg.end - leg.start);
      if (!window.smooth()) continue;
      for (std::uint32_t k = 0; k < 12; ++k) {
        const Box& a = p.node((k * 7 + 1) % static_cast<std::uint32_t>(p.size())).box;
        const Box& b = q.node((k * 5 + 2) % static_cast<std::uint32_t>(q.size())).box;
        const double t = spacetime::apart_until(leg, window, a, b, window.start(), window.end());
        if (!(t > window.start())) continue;
        ++apart;
        for (int i = 0; i < 8; ++i) {
          const double at = window.start() + (t - window.start()) * (i / 8.0);
          EXPECT_TRUE(spacetime::apart_at(leg, window, a, b, at)) << "seed " << seed << " at " << at;
        }
      }
    }
  }
  EXPECT_GT(apart, 200);
}

}  // namespace
}  // namespace taut::testing
