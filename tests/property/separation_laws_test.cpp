// What the checking of separations rests on: ranges contain their edges, windows contain the motion, boxes contain the
// bodies. In exact rationals, in 960 bits, and by poses that share nothing with the library.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>

#include "certificate/precise_triple.hpp"
#include "proof/edge_ranges.hpp"
#include "proof/motion_window.hpp"
#include "proof/separation.hpp"
#include "proof/stated_box.hpp"
#include "scene/instance.hpp"
#include "scene/meeting_boxes.hpp"
#include "support/effort.hpp"
#include "support/made_world.hpp"
#include "support/random_scenes.hpp"
#include "support/rng.hpp"

namespace taut::testing {
using namespace internal;
namespace {

using proof::EdgeRange;
using proof::EdgeRanges;
using proof::MotionWindow;
using proof::WindowModel;

/// Is the point in the rectangle? Exactly: the rectangle's directions need not be unit vectors.
bool contains(const EdgeRange& r, const DisplacedPoint& p) {
  const mpq_class ux(r.along.x), uy(r.along.y), square = ux * ux + uy * uy;
  const mpq_class x = mpq_class(p.x) + mpq_class(p.dx) - mpq_class(r.centre.x),
                  y = mpq_class(p.y) + mpq_class(p.dy) - mpq_class(r.centre.y);
  const mpq_class s = (ux * x + uy * y) / square, t = (ux * y - uy * x) / square;
  return abs(s) <= mpq_class(r.half_length) && abs(t) <= mpq_class(r.half_width);
}

/// Every range with all of its edges; how many edges the ranges of one edge have in all.
void expect_contained(const DisplacedPolygon& body, const EdgeRanges& ranges, std::uint32_t index,
                      std::vector<int>& seen) {
  const EdgeRange& range = ranges[index];
  const auto next = [&](std::uint32_t k) {
    return body.next.empty() ? (k + 1) % static_cast<std::uint32_t>(body.points.size()) : body.next[k];
  };
  if (range.single()) {
    ++seen[range.first];
    EXPECT_TRUE(contains(range, body.points[range.first]) && contains(range, body.points[next(range.first)]));
    return;
  }
  std::vector<int> below(body.points.size(), 0);
  for (const std::uint32_t half : range.halves) expect_contained(body, ranges, half, below);
  std::uint32_t count = 0;
  for (std::uint32_t k = 0; k < below.size(); ++k) {
    if (below[k] == 0) continue;
    ++count;
    ++seen[k];
    ASSERT_TRUE(contains(range, body.points[k]) && contains(range, body.points[next(k)]));
  }
  EXPECT_EQ(count, range.count);
}

TEST(SeparationLaws, RangesContainTheirEdges) {
  for (std::uint64_t seed = 100; seed < 100 + effort(60); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene = scene_of(random_world(seed));
    const Instance instance(scene);
    for (const InstanceBody& body : instance.bodies()) {
      for (const Offset offset : {Offset::outward, Offset::inward}) {
        const DisplacedPolygon& displaced = *body.rings->displaced(offset);
        std::vector<int> seen(displaced.points.size(), 0);
        expect_contained(displaced, EdgeRanges(displaced), EdgeRanges::all, seen);
        for (const int times : seen) EXPECT_EQ(times, 1);
      }
    }
  }
}

using Exact = Ball<Real960>;

struct ExactVectorBall {
  Exact x, y;
};
ExactVectorBall operator*(const ExactVectorBall& a, const ExactVectorBall& b) {
  return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}
ExactVectorBall operator+(const ExactVectorBall& a, const ExactVectorBall& b) { return {a.x + b.x, a.y + b.y}; }
ExactVectorBall operator-(const ExactVectorBall& a, const ExactVectorBall& b) { return {a.x - b.x, a.y - b.y}; }
ExactVectorBall exactly(Vector v) { return {Exact::exact(v.x), Exact::exact(v.y)}; }
ExactVectorBall with_offset(const MotionSegment& segment, bool of_p, Vector v) {
  ExactVectorBall r = exactly(v);
  add_offset(segment, of_p, r.x, r.y);
  return r;
}

/// The most that |x| + |y| can be.
double size_of(const ExactVectorBall& v) {
  return std::fabs(v.x.mid.to_double()) + v.x.rad + std::fabs(v.y.mid.to_double()) + v.y.rad;
}

/// The law of a WindowModel for a moving point v and a fixed point a, at one instant.
void expect_law(const MotionSegment& segment, const WindowModel& model, bool from_p, double middle, double t, Vector v,
                Vector a) {
  const auto [pp, qq] = frame_values(segment, Exact::exact(t));
  const auto& f = from_p ? pp : qq;
  ExactVectorBall shift{f[1], f[2]}, rotation{f[3], f[4]};
  if (!from_p) {
    shift = ExactVectorBall{Exact::exact(0), Exact::exact(0)} - shift;
    rotation.y = Exact::exact(0) - rotation.y;
  }
  const ExactVectorBall scale{f[0], Exact::exact(0)};
  // Relative to the fixed point, as both are.
  const ExactVectorBall truly =
      shift + rotation * with_offset(segment, !from_p, v) - scale * with_offset(segment, from_p, a);
  const Exact h = Exact::exact(t) - Exact::exact(middle);
  const ExactVectorBall by{h, Exact::exact(0)}, half_square{h * h * 0.5, Exact::exact(0)};
  const auto second_order = [&](Vector value, Vector rate, Vector second) {
    return exactly(value) + by * exactly(rate) + half_square * exactly(second);
  };
  const ExactVectorBall said = second_order(model.shift, model.shift_rate, model.shift_second) +
                               second_order(model.rotation, model.rotation_rate, model.rotation_second) * exactly(v) -
                               exactly(a);
  const double allowed = model.shift_error + model.rotation_error * l1_norm(v) + model.scale_error * l1_norm(a) +
                         0x1p-44 * (model.size * (1 + l1_norm(v)) + l1_norm(a));
  if (!std::isfinite(allowed)) return;
  EXPECT_LE(size_of(truly - said), allowed * (1 + 0x1p-30)) << "at " << t;
}

void expect_window_contains(const MotionSegment& segment, const MotionWindow& window, Rng& rng) {
  const double from = window.from(), to = window.to(), middle = from + (to - from) / 2;
  for (const double t : {from, to, middle, from + rng.real(0, 1) * (to - from)}) {
    if (t < from || t > to) continue;
    const Vector v{rng.real(-1, 1), rng.real(-1, 1)}, a{rng.real(-1, 1), rng.real(-1, 1)};
    expect_law(segment, window.from_p(), true, middle, t, v, a);
    expect_law(segment, window.from_q(), false, middle, t, v, a);
  }
}

/// By itself, and by the model of one that is longer.
void expect_windows_contain(const MotionSegments& segments, Rng& rng) {
  for (const MotionSegment& segment : segments) {
    for (int i = 0; i < 6; ++i) {
      const double length = (segment.end - segment.start) * std::ldexp(1.0, -rng.below(30));
      const double from = segment.start + rng.real(0, 1) * (segment.end - segment.start - length),
                   to = std::min(segment.end, from + length);
      if (!(from >= segment.start && from <= to)) continue;
      expect_window_contains(segment, MotionWindow(segment, from, to), rng);
      if (segment.bridge) continue;
      const double before = std::max(segment.start, from - rng.real(0, 1) * length),
                   after = std::min(segment.end, to + rng.real(0, 1) * length);
      expect_window_contains(segment, MotionWindow(segment, FrameModel::over(segment, before, after), from, to), rng);
    }
  }
}

TEST(SeparationLaws, WindowsContainTheMotion) {
  for (std::uint64_t seed = 300; seed < 300 + effort(120); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    SceneOptions options;
    options.grid = seed % 3 == 0;
    const Scene scene = seed % 4 == 0 ? scene_of(random_world(seed))
                                      : random_scene(seed, all_families[seed % std::size(all_families)], options);
    const Instance instance(scene);
    for (int a = 0; a + 1 < static_cast<int>(instance.bodies().size()); a += 2)
      expect_windows_contain(instance.segments(instance.pair(a, a + 1)), rng);
  }
}

TEST(SeparationLaws, SweptBoxesContainTheBodies) {
  for (std::uint64_t seed = 500; seed < 500 + effort(80); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const MadeWorld world = random_world(seed);
    const Instance instance(scene_of(world));
    const double scale = std::ldexp(1.0, instance.exponent());
    for (std::size_t i = 0; i < instance.bodies().size(); ++i) {
      const double from = rng.real(0, world.end), to = rng.chance(0.2) ? world.end : rng.real(from, world.end);
      const AxisBox box = swept_box(instance.bodies()[i], from, to);
      for (int k = 0; k <= 8; ++k) {
        for (const PartAtPose& part : posed(world, static_cast<int>(i), from + (to - from) * k / 8)) {
          for (const Complex& p : part.rings[0]) {
            const double x = p.real() * scale, y = p.imag() * scale, rounding = 1e-12;
            ASSERT_TRUE(x >= box.lo_x - rounding && x <= box.hi_x + rounding);
            ASSERT_TRUE(y >= box.lo_y - rounding && y <= box.hi_y + rounding);
          }
        }
      }
      // No more than a window's motion larger than need be.
      const AxisBox now = swept_box(instance.bodies()[i], from, from);
      EXPECT_LE(now.longest(), 3 * diagonal(instance.bodies()[i].rings->bounds()) + 1e-9);
    }
  }
}

/// Boxes that a log may state contain the body at every instant, and no box that leaves out a part of it passes.
TEST(SeparationLaws, StatedBoxesContainTheBodies) {
  int refused = 0;
  for (std::uint64_t seed = 900; seed < 900 + effort(80); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const MadeWorld world = random_world(seed);
    const proof::VerifierScene scene(scene_of(world));
    const double scale = std::ldexp(1.0, scene.exponent());
    for (int i = 0; i < scene.size(); ++i) {
      if (scene[i].rests()) continue;
      const double from = rng.real(0, world.end), to = rng.chance(0.2) ? world.end : rng.real(from, world.end);
      const std::optional<AxisBox> box = proof::box_around(scene[i], {from, to, false});
      ASSERT_TRUE(box);
      proof::StatedBox cut{static_cast<float>(box->lo_x) - 1, static_cast<float>(box->lo_y) - 1,
                           static_cast<float>(box->hi_x) + 1, static_cast<float>(box->hi_y) + 1};
      EXPECT_TRUE(proof::stays_within(scene[i], {from, to, false}, proof::box_room, cut));
      double right = -INFINITY;
      for (int k = 0; k <= 8; ++k) {
        for (const PartAtPose& part : posed(world, i, from + (to - from) * k / 8)) {
          for (const Complex& p : part.rings[0]) {
            const double x = p.real() * scale, y = p.imag() * scale, rounding = 1e-12;
            ASSERT_TRUE(x >= box->lo_x - rounding && x <= box->hi_x + rounding);
            ASSERT_TRUE(y >= box->lo_y - rounding && y <= box->hi_y + rounding);
            right = std::max(right, x);
          }
        }
      }
      cut.hi_x = static_cast<float>(right - 1e-6);
      EXPECT_FALSE(proof::stays_within(scene[i], {from, to, false}, proof::box_room, cut));
      ++refused;
    }
  }
  EXPECT_GE(refused, static_cast<int>(enough(60)));
}

/// A direction that separates does so at every instant, for every point of both ranges.
TEST(SeparationLaws, DirectionsSeparate) {
  int separated = 0;
  for (std::uint64_t seed = 700; seed < 700 + effort(100); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const MadeWorld world = random_world(seed);
    const Instance instance(scene_of(world));
    const double scale = std::ldexp(1.0, instance.exponent());
    for (int a = 0; a + 1 < static_cast<int>(instance.bodies().size()); ++a) {
      const BodyPair pair = instance.pair(a, a + 1);
      const EdgeRanges p(*pair.rings[0]->displaced(Offset::inward)), q(*pair.rings[1]->displaced(Offset::inward));
      for (const MotionSegment& segment : instance.segments(pair)) {
        if (segment.bridge) continue;
        const double length = (segment.end - segment.start) / 16, from = rng.real(segment.start, segment.end - length);
        if (!proof::separating_step(MotionWindow(segment, from, from + length), p[EdgeRanges::all], q[EdgeRanges::all]))
          continue;
        ++separated;
        for (int k = 0; k <= 4; ++k) {
          const double t = from + length * k / 4;
          const BodyAtPose first = posed(world, a, t), second = posed(world, a + 1, t);
          EXPECT_FALSE(overlap_clearly(first, second, 1e-9 / scale));
        }
      }
    }
  }
  EXPECT_GE(separated, static_cast<int>(enough(100)));
}

/// Somewhere on the segment, of any length down to a thousandth.
MotionWindow random_window(const MotionSegment& segment, Rng& rng) {
  const double length = (segment.end - segment.start) * std::ldexp(1.0, -rng.below(11)),
               from = segment.start + rng.real(0, 1) * (segment.end - segment.start - length);
  return {segment, from, std::min(segment.end, from + length)};
}

/// A reason why a vertex is not on an edge that windows give holds at every instant, by the exact form; where they say
/// that it is none, it is none at some instant.
TEST(SeparationLaws, VerticesStayAsideAsWindowsSay) {
  int yes = 0, no = 0;
  for (std::uint64_t seed = 1100; seed < 1100 + effort(60); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const Instance instance(scene_of(random_world(seed)));
    const BodyPair pair = instance.pair(0, 1);
    const PairGeometry g = displaced_pair(pair, seed % 2 == 0 ? Offset::inward : Offset::outward);
    const std::uint32_t nq = g.size() - g.np;
    for (const MotionSegment& segment : instance.segments(pair)) {
      const MotionWindow window = random_window(segment, rng);
      const double from = window.from(), to = window.to();
      for (int i = 0; i < 20; ++i) {
        const VertexId p(rng.below(g.np)), q(g.np + rng.below(nq));
        const proof::Incidence incidence = i % 2 == 0 ? proof::Incidence{q, p} : proof::Incidence{p, q};
        const auto why = static_cast<proof::SeparationReason>(rng.below(4));
        const proof::SeparationInWindow seen = stays_separated_in_window(g, incidence, why, window);
        if (seen != proof::SeparationInWindow::yes && seen != proof::SeparationInWindow::no) continue;
        const bool said = seen == proof::SeparationInWindow::yes;
        const proof::KeptFunction kept = kept_functions(g, incidence, why).functions[0];
        const PreciseTriple function(segment, g, kept.function);
        const auto holds_at = [&](double t) {
          PreciseTime at = PreciseTime::between(t, t);
          return function.sign_at(at, Stage::precise) == kept.sign;
        };
        ++(said ? yes : no);
        for (int k = 0; said && k <= 4; ++k) ASSERT_TRUE(holds_at(std::min(to, from + (to - from) * k / 4)));
        if (!said) {
          ASSERT_FALSE(holds_at(from + (to - from) / 2));
        }
      }
    }
  }
  EXPECT_GE(std::min(yes, no), static_cast<int>(enough(500)));
}

/// Where a point of Q is in P's frame at some instants of a window.
class SampledPath {
 public:
  SampledPath(const MotionSegment& segment, double from, double to) {
    for (int k = 0; k <= samples; ++k) {
      const auto frames = frame_values(segment, Ball<double>::exact(std::min(to, from + (to - from) * k / samples)));
      const auto& f = frames.for_pp;
      poses_.push_back({{f[1].mid, f[2].mid}, {f[3].mid, f[4].mid}});
    }
    own_ = {segment.offset_q.x, segment.offset_q.y};
    base_ = {segment.offset_p.x, segment.offset_p.y};
  }
  /// The least and the greatest that the products with n are, of any of these points.
  std::pair<double, double> extent(Vector n, const std::vector<Vector>& points) const {
    std::pair<double, double> found{INFINITY, -INFINITY};
    for (const auto& [shift, rotation] : poses_) {
      for (const Vector v : points) {
        const double along = dot(n, shift + rotation * (v + own_) - base_);
        found = {std::min(found.first, along), std::max(found.second, along)};
      }
    }
    return found;
  }

 private:
  static constexpr int samples = 64;
  std::vector<std::pair<Vector, Vector>> poses_;
  Vector own_, base_;
};

Vector unit(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// P with an edge of which a vertex stays aside, for that reason, as long as it is beyond `level` in direction n; and Q
/// with that vertex.
PairGeometry pair_with_edge(Vector n, double level, double length, proof::SeparationReason why, Vector v) {
  const Vector from{n.x * level, n.y * level}, along{n.x * length, n.y * length};
  const Vector edge = why == proof::SeparationReason::left           ? -turned(along)
                      : why == proof::SeparationReason::right        ? turned(along)
                      : why == proof::SeparationReason::behind_first ? -along
                                                                     : along;
  const Vector a = why == proof::SeparationReason::behind_second ? from - edge : from, b = a + edge,
               c = a + turned(edge);
  const auto point = [](Vector p) { return DisplacedPoint{p.x, p.y, 0, 0}; };
  return {std::vector{point(a), point(b), point(c)},
          std::vector{point(v), point(v + Vector{0.5, 0}), point(v + Vector{0, 0.5})}};
}

/// Edges and rectangles are put where the way comes to them, or nearly: windows never say that it does not, and where
/// it stays well off, they seldom fail to see that.
TEST(SeparationLaws, WindowsSeeWhatWaysComeTo) {
  int asked = 0, seen = 0;
  for (std::uint64_t seed = 1300; seed < 1300 + effort(60); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const Instance instance(scene_of(random_world(seed)));
    for (const MotionSegment& segment : instance.segments(instance.pair(0, 1))) {
      if (segment.bridge) continue;
      for (int i = 0; i < 30; ++i) {
        const MotionWindow window = random_window(segment, rng);
        const SampledPath path(segment, window.from(), window.to());
        const Vector v{rng.real(-1, 1), rng.real(-1, 1)}, n = unit(rng.real(0, 7));
        const auto why = static_cast<proof::SeparationReason>(rng.below(4));
        const auto [low, high] = path.extent(n, {v});
        const double rounding = 1e-10 * (1 + std::fabs(low)), room = 0.2 * (high - low) + rounding;
        const auto stays_beyond = [&](double level) {
          return stays_separated_in_window(pair_with_edge(n, level, rng.real(0.1, 1), why, v),
                                           {VertexId(3), VertexId(0)}, why, window) == proof::SeparationInWindow::yes;
        };
        ASSERT_FALSE(stays_beyond(low + rounding));
        EdgeRange p, q;
        p.along = n;
        p.half_length = rng.real(0, 1);
        q.centre = v;
        q.along = unit(rng.real(0, 7));
        q.half_length = rng.real(0, 1);
        q.half_width = rng.real(0, q.half_length);
        std::vector<Vector> corners;
        for (const double x : {-q.half_length, q.half_length}) {
          for (const double y : {-q.half_width, q.half_width}) corners.push_back(v + q.along * Vector{x, y});
        }
        const auto [near, far] = path.extent(n, corners);
        const auto separates_from = [&, least = near](double off) {
          const double level = least + off - p.half_length;
          p.centre = {n.x * level, n.y * level};
          return proof::separates(proof::step::along_p, window, p, q);
        };
        ASSERT_FALSE(separates_from(rounding));
        asked += 2;
        seen += stays_beyond(low - room) + separates_from(-0.2 * (far - near) - rounding);
      }
    }
  }
  EXPECT_GE(seen, asked / 2);
}

}  // namespace
}  // namespace taut::testing
