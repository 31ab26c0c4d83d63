// The second engine's parts: boxes that contain, and bounds of motion that hold.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>

#include "certificate/precise_function.hpp"
#include "motion/motion_segment.hpp"
#include "motion/motion_segments.hpp"
#include "motion/pieces.hpp"
#include "scene/placement.hpp"
#include "spacetime/box_separation.hpp"
#include "spacetime/first_contact.hpp"
#include "spacetime/leaf_test.hpp"
#include "support/random_scenes.hpp"
#include "taut/io.hpp"
#include "tiling/free_triangulation.hpp"

namespace taut::testing {
using namespace internal;
namespace {

using spacetime::Box;
using spacetime::BoxNode;
using spacetime::FrameWindow;
using spacetime::Hierarchy;
using spacetime::hierarchy_of_p;
using spacetime::hierarchy_of_q;
using spacetime::LocalExpansion;
using spacetime::Parabola;
using spacetime::Stretch;
using spacetime::TranslationPolynomial;

struct Setting {
  PairGeometry geometry;
  MotionSegments segments;
};

Setting setting(const Scene& scene, Offset offset = Offset::inward) {
  const BodyPair bodies = pair_of(scene);
  return {displaced_pair(bodies, offset), segments_of(bodies, scene.start, scene.end)};
}

DisplacedPoint exactly(const Point& p) { return {p.x, p.y, 0, 0}; }

/// Counterclockwise.
std::array<Point, 4> corners(const Box& box) {
  const Vector u = Vector{box.half_length, 0} * box.along, v = Vector{0, box.half_width} * box.along;
  const Vector at[4] = {box.centre - u - v, box.centre + u - v, box.centre + u + v, box.centre - u + v};
  std::array<Point, 4> out;
  for (std::size_t i = 0; i < 4; ++i) out[i] = {at[i].x, at[i].y};
  return out;
}

void expect_inside(const PairGeometry& g, std::uint32_t offset, const BoxNode& node) {
  const std::array<Point, 4> around = corners(node.box);
  VertexId v(offset + node.first);
  for (std::uint32_t k = 0; k <= node.count; ++k, v = g.next(v)) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Point &a = around[i], &b = around[(i + 1) % 4];
      ASSERT_GT(orientation(exactly(a), exactly(b), g.point(v)), 0) << "vertex " << v.value;
    }
  }
}

TEST(SpacetimeHierarchy, BoxesContainTheirEdgesAndLeavesCoverEachEdgeOnce) {
  for (const Family family : all_families) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      const Setting s =
          setting(random_scene(seed, family, {seed % 2 == 0, {}}), seed % 3 == 0 ? Offset::inward : Offset::outward);
      for (const bool of_p : {true, false}) {
        const Hierarchy tree = of_p ? hierarchy_of_p(s.geometry) : hierarchy_of_q(s.geometry);
        const std::uint32_t offset = of_p ? 0 : s.geometry.np;
        std::vector<int> covered(s.geometry.size());
        for (std::uint32_t i = 0; i < tree.size(); ++i) {
          const BoxNode& node = tree.node(i);
          expect_inside(s.geometry, offset, node);
          if (node.count == 1) {
            ++covered[offset + node.first];
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
void check_bounds(const Setting& s, const MotionSegment& segment, const CertificateFunction& m) {
  const PreciseFunction<Real320> truth(segment, s.geometry, m.along());
  const FastFunction f = FastFunction::undisplaced(segment, s.geometry, m.along());
  double length = segment.end - segment.start;
  for (double t = segment.start; t < segment.end;) {
    FrameWindow window(segment, t, segment.end, length);
    length = window.length() * 2;
    const auto encloses = [](const Bounded& bound, const Ball<Real320>& exact) {
      const double difference = std::fabs(Real320(exact.mid - bound.value).to_double());
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
      ASSERT_TRUE(encloses(f.curvature(window.second(m.pp)), exact.dd)) << at;
      const int sign = exact.v.sign();
      const double free = LocalExpansion(f, window, at, sign).positive_until(window.end() - at);
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
      for (const MotionSegment& segment : s.segments) {
        check_bounds(s, segment, {VertexId(1u), VertexId(2u), VertexId(np + 1), true});
        check_bounds(s, segment, {VertexId(np), VertexId(np + 1), VertexId(0u), false});
        if (HasFatalFailure()) return;
      }
    }
  }
}

/// Calls action(stretch, start, end) with stretches of several lengths all over the segment.
template <class Action>
void for_stretches(const MotionSegment& segment, const Action& action) {
  const TranslationPolynomial polynomial(segment);
  double length = segment.end - segment.start;
  for (double t = segment.start; t < segment.end;) {
    FrameWindow window(segment, t, segment.end, length);
    length = window.length() * 2;
    const double start = window.start(), end = window.end();
    if (!window.smooth()) {
      action(Stretch::of_range(segment, window), start, end);
    } else {
      for (const auto& [from, to] : {std::pair(0.0, 1.0), std::pair(0.5, 0.75), std::pair(0.9, 0.91)}) {
        const double lo = start + from * (end - start), hi = std::min(end, start + to * (end - start));
        action(Stretch::of_window(segment, window, lo, hi), lo, hi);
        if (segment.translation) action(Stretch::of_translation(segment, polynomial, lo, hi), lo, hi);
      }
    }
    if (!segment.bridge) action(Stretch::at_instant(segment, start), start, start);
    t = end;
  }
  if (!segment.bridge) action(Stretch::at_instant(segment, segment.end), segment.end, segment.end);
}

/// At an instant nothing is left but rounding, also where the motion is singular.
TEST(SpacetimeStretch, AtAnInstantIsAsGoodAsDoublesAre) {
  const Setting s = setting(read_scene("tests/corpus/touch_as_an_infinite_speed_is_reached.json"));
  int singular = 0;
  for (const MotionSegment& segment : s.segments) {
    if (segment.bridge) continue;
    for (const double t : {segment.start, segment.end}) {
      singular += segment.singular_at(t);
      const Stretch there = Stretch::at_instant(segment, t);
      EXPECT_LE(there.in_p.error, 0x1p-43 * there.in_p.reach);
      EXPECT_LE(there.in_q.error, 0x1p-43 * there.in_q.reach);
    }
  }
  EXPECT_GT(singular, 0);
}

/// A distance along an edge as a parabola against 320 bits.
void check_stretches(const Setting& s, const MotionSegment& segment, const CertificateFunction& m) {
  const PreciseFunction<Real320> truth(segment, s.geometry, m.along());
  const DisplacedPoint &a = s.geometry.point(m.a), &b = s.geometry.point(m.b), &c = s.geometry.point(m.c);
  const Vector edge{b.x - a.x, b.y - a.y};
  for_stretches(segment, [&](const Stretch& stretch, double start, double end) {
    const spacetime::RelativePose& carriage = m.pp ? stretch.in_p : stretch.in_q;
    const Parabola f = along(edge, carriage.place({c.x, c.y}, {a.x, a.y}));
    const double error = carriage.error * l1_norm(edge) + 0x1p-150 * (1 + carriage.reach);
    for (const double share : {0.0, 0.3, 0.5, 0.8, 1.0}) {
      const double at = std::min(end, start + share * (end - start));
      const Ball<Real320> exact = truth(Ball<Real320>(Real320(at), 0.0)).v;
      const Real320 h = Real320(at) - stretch.middle;
      const Real320 found = f.a + h * (f.b + h * f.c);
      ASSERT_LE(std::fabs(Real320(exact.mid - found).to_double()), error + exact.rad) << at;
      ASSERT_GE(Real320(exact.mid + error).to_double(), f.least(stretch.r)) << at;
    }
  });
}

TEST(SpacetimeStretch, HoldsForEveryFormOfMotion) {
  for (const MotionKind kind : all_motions) {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      SCOPED_TRACE(std::string(to_string(kind)) + " seed " + std::to_string(seed));
      const Setting s = setting(random_scene(seed, Family::stars, {seed % 2 == 0, {kind}}));
      const std::uint32_t np = s.geometry.np;
      for (const MotionSegment& segment : s.segments) {
        check_stretches(s, segment, {VertexId(1u), VertexId(2u), VertexId(np + 1), true});
        check_stretches(s, segment, {VertexId(np), VertexId(np + 1), VertexId(0u), false});
        if (HasFatalFailure()) return;
      }
    }
  }
}

/// Some side of one box has all of the other box on its right.
bool separated(const Placement& place) {
  for (std::uint32_t side = 0; side < 8; ++side) {
    const VertexId a(side), b = place.geometry().next(a);
    bool beyond = true;
    for (std::uint32_t k = 0; k < 4; ++k) {
      beyond = beyond && place.orientation(a, b, VertexId((side < 4 ? 4 : 0) + k)) < 0;
    }
    if (beyond) return true;
  }
  return false;
}

/// Boxes that are said to be apart, at samples of time.
TEST(SpacetimeOverlap, AgreesWithThePlaneSweep) {
  int overlaps = 0, inside = 0, disjoint = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    Scene scene = random_scene(seed, all_families[seed % 8]);
    // A body beside itself, shrunk: often one lies inside the other.
    if (seed % 2 == 1) {
      scene.bodies[1].polygon = scene.bodies[0].polygon;
      for (Point& v : scene.bodies[1].polygon) v = {v.x / 16, v.y / 16};
    }
    const Setting s = setting(scene);
    for (const double share : {0.0, 0.3, 0.6, 0.9}) {
      const MotionSegment& segment = s.segments[0];
      const double t = segment.start + share * (segment.end - segment.start);
      const Placement placement(s.geometry, segment, t);
      FreeTriangulation triangulation;
      const bool expected = triangulate_free_space(placement, triangulation).has_value();
      const auto found = spacetime::overlapping(s.geometry, segment, t);
      ASSERT_EQ(found.has_value(), expected) << "seed " << seed << " at " << t;
      overlaps += expected;
      inside += found && !found->crossing;
      disjoint += !expected;
    }
  }
  EXPECT_GT(overlaps, 100);
  EXPECT_GT(inside, 20);
  EXPECT_GT(disjoint, 100);
}

TEST(SpacetimeBoxes, ApartIsTrue) {
  int apart = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Setting s = setting(random_scene(seed, all_families[seed % 8]));
    const Hierarchy p = hierarchy_of_p(s.geometry), q = hierarchy_of_q(s.geometry);
    for (const MotionSegment& segment : s.segments) {
      if (segment.bridge) continue;
      std::uint32_t k = 0;
      for_stretches(segment, [&](const Stretch& stretch, double start, double end) {
        ++k;
        const Box& a = p.node((k * 7 + 1) % static_cast<std::uint32_t>(p.size())).box;
        const Box& b = q.node((k * 5 + 2) % static_cast<std::uint32_t>(q.size())).box;
        if (!spacetime::apart(stretch, a, b)) return;
        ++apart;
        const auto rectangle = [](const Box& box) {
          std::vector<DisplacedPoint> out;
          for (const Point& corner : corners(box)) out.push_back(exactly(corner));
          return out;
        };
        const PairGeometry boxes(rectangle(a), rectangle(b));
        for (const double share : {0.0, 0.2, 0.5, 0.9, 1.0}) {
          const double at = std::min(end, start + share * (end - start));
          EXPECT_TRUE(separated(Placement(boxes, segment, at))) << "seed " << seed << " at " << at;
        }
      });
    }
  }
  EXPECT_GT(apart, 200);
}

}  // namespace
}  // namespace taut::testing
