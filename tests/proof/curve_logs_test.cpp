// Logs about curves: what prove() writes is accepted and proves what check() says; polygons that are not where they
// should be are refused, whatever is proved about them; damaged logs are rejected, or what they still prove is true.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

#include "curve_log.hpp"
#include "log_text.hpp"
#include "soak/curve_examination.hpp"
#include "support/effort.hpp"
#include "support/rng.hpp"
#include "taut/io.hpp"

namespace taut::testing {
namespace {

using proof::PolygonsOfBodies;

const std::array<Touch, 2> both_touches{Touch::open, Touch::closed};

CheckOptions touching(Touch touch) {
  CheckOptions options;
  options.touch = touch;
  return options;
}

Verified verify_curve_log(const Scene& scene, const std::string& log) {
  std::istringstream in(log);
  return verify(scene, in);
}

/// Why the log is refused; empty if it is not.
std::string refusal(const Scene& scene, const std::string& log) {
  try {
    verify_curve_log(scene, log);
    return {};
  } catch (const ProofError& error) {
    return error.what();
  }
}

/// What is wrong with a claim, by the answer; empty if nothing is.
std::string untruth(const Verified& v, const Answer& a, const Scene& scene) {
  if (a.outcome == Outcome::overlap_at_start) return "the bodies overlap at the start";
  if (a.contact && v.free_until > a.contact->time.hi) return "free beyond the contact";
  if (v.outcome == Outcome::undecided) return {};
  if (v.outcome != a.outcome) return "another outcome";
  if (v.outcome == Outcome::free) return v.free_until == scene.end ? "" : "free, but not to the end";
  const bool meet = v.contact->time.lo <= a.contact->time.hi && a.contact->time.lo <= v.contact->time.hi;
  return meet ? "" : "another time";
}

/// prove() finds a log of what check() answers, and verify() accepts it.
void expect_proved(const Scene& scene, Touch touch, std::array<int, 3>& outcomes) {
  std::ostringstream log;
  const Answer answer = check(scene, touching(touch)), proved = prove(scene, log, touching(touch));
  ASSERT_STREQ(to_string(proved.outcome), to_string(answer.outcome)) << proved.reason;
  if (answer.outcome == Outcome::overlap_at_start || answer.free_until <= scene.start) {
    EXPECT_TRUE(log.str().empty());
    return;
  }
  ++outcomes[static_cast<std::size_t>(answer.outcome == Outcome::undecided ? 2 : answer.contact ? 1 : 0)];
  const Verified v = verify_curve_log(scene, log.str());
  ASSERT_EQ(v.kind, ProofKind::curves);
  ASSERT_STREQ(to_string(v.outcome), to_string(answer.outcome));
  ASSERT_EQ(v.touch, touch);
  ASSERT_EQ(v.fingerprint, scene_fingerprint(scene, touch));
  ASSERT_EQ(untruth(v, answer, scene), "");
  ASSERT_LE(std::fabs(v.free_until - answer.free_until), 2e-9 * (scene.end - scene.start));
  ASSERT_EQ(v.free_until, proved.free_until);
  if (!v.contact) return;
  ASSERT_EQ(v.contact->time.lo, proved.contact->time.lo);
  ASSERT_EQ(v.contact->time.hi, proved.contact->time.hi);
  ASSERT_LE(v.contact->time.hi - v.contact->time.lo, 1e-8 * (scene.end - scene.start));
  ASSERT_EQ(v.contact->vertex.body, answer.contact->vertex.body);
  ASSERT_EQ(v.contact->vertex.index, answer.contact->vertex.index);
  ASSERT_EQ(v.contact->edge.index, answer.contact->edge.index);
}

TEST(CurveLogs, ExamplesAreProved) {
  std::array<int, 3> outcomes{};
  for (const char* name : {"cam", "geneva", "slot", "hinge"}) {
    for (const Touch touch : both_touches) {
      SCOPED_TRACE(std::string(name) + ", " + to_string(touch));
      expect_proved(read_scene(std::string("examples/curves/") + name + ".json"), touch, outcomes);
    }
  }
  EXPECT_EQ(outcomes[0], 2);
  EXPECT_EQ(outcomes[1], 6);
}

TEST(CurveLogs, RandomScenesAreProved) {
  std::array<int, 3> outcomes{};
  for (std::uint64_t k = 0; k < effort(120); ++k) {
    SCOPED_TRACE(k);
    expect_proved(curved_soak_scene(k).scene, both_touches[k % 2], outcomes);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(outcomes[0], static_cast<int>(effort(120) / 20));
  EXPECT_GT(outcomes[1], static_cast<int>(effort(120) / 4));
}

Body body_of(const std::string& name, const std::string& path) {
  Body body;
  body.name = name;
  body.curves = parse_path(path);
  return body;
}

/// A disc of radius 1 about the origin, and a small square that passes above it at a height of `height`.
Scene disc_and_square(double height) {
  Scene scene;
  scene.start = 0;
  scene.end = 10;
  scene.bodies.push_back(body_of("disc", "M1 0 A1 1 0 0 1 -1 0 A1 1 0 0 1 1 0 Z"));
  Body square;
  square.name = "square";
  square.polygon = {{-0.1, 0}, {0.1, 0}, {0.1, 0.2}, {-0.1, 0.2}};
  square.motion.pieces.push_back({});
  square.motion.pieces[0].x = {-5, 1};
  square.motion.pieces[0].y = {height};
  scene.bodies.push_back(square);
  return scene;
}

/// A regular polygon whose corners are at that distance from the origin.
Polygon regular(int n, double radius, double turn = 0) {
  Polygon polygon;
  for (int i = 0; i < n; ++i) {
    const double angle = turn + 2 * 3.14159265358979323846 * i / n;
    polygon.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return polygon;
}

/// A log about these polygons, wherever they are; what is proved of them is true.
std::string log_about(const Scene& scene, const PolygonsOfBodies& around, const PolygonsOfBodies& within = {},
                      Touch touch = Touch::open) {
  CurveLog parts;
  for (const PolygonsOfBodies* polygons : {&around, &within}) {
    if (polygons->empty()) continue;
    std::ostringstream log;
    prove(proof::with_polygons(scene, *polygons), log, touching(touch));
    const std::string text = log.str();
    parts.sides.push_back({*polygons, text.substr(0, text.size() - std::min(text.size(), checksum_size))});
  }
  return put_together(parts, scene, touch);
}

PolygonsOfBodies only_first(const Polygon& polygon) { return {{{polygon, {}}}, {}}; }

TEST(CurveLogs, ABulgeThatIsCutOffIsRefused) {
  // The square passes between the disc's top and a polygon with its corners on the disc, or so it seems.
  const Scene scene = disc_and_square(0.985);
  ASSERT_EQ(check(scene).outcome, Outcome::contact);
  const Polygon chords = regular(8, 1, 3.14159265358979323846 / 8);
  ASSERT_EQ(check(proof::with_polygons(scene, only_first(chords))).outcome, Outcome::free);
  EXPECT_NE(refusal(scene, log_about(scene, only_first(chords))).find("is not shown to lie within"), std::string::npos);
  // Also if nearly everything is around.
  Polygon most = regular(64, 1.01);
  for (Point& p : most) p.y = std::min(p.y, 0.98);
  EXPECT_NE(refusal(scene, log_about(scene, only_first(most))), "");
}

TEST(CurveLogs, APolygonElsewhereIsRefused) {
  const Scene scene = disc_and_square(0.5);
  const Polygon far{{20, 20}, {21, 20}, {21, 21}, {20, 21}}, small = regular(5, 0.25);
  EXPECT_NE(refusal(scene, log_about(scene, only_first(far))), "");
  EXPECT_NE(refusal(scene, log_about(scene, only_first(small))), "");
  // Within, it would have to be in the disc: not beside it, not around it, and not through it.
  const PolygonsOfBodies around = only_first(regular(40, 1.01));
  const Polygon beside{{-4, 0.4}, {-3, 0.4}, {-3, 0.8}, {-4, 0.8}};
  EXPECT_NE(refusal(scene, log_about(scene, around, only_first(beside))).find("does not go around"), std::string::npos);
  EXPECT_NE(refusal(scene, log_about(scene, around, only_first(regular(40, 1.005)))), "");
  EXPECT_NE(refusal(scene, log_about(scene, around, only_first(regular(5, 1.1)))), "");
  EXPECT_EQ(refusal(scene, log_about(scene, around, only_first(regular(40, 0.99)))), "");
}

TEST(CurveLogs, AnyPolygonThatIsAroundWillDo) {
  const Scene scene = disc_and_square(1.5);
  const Verified v = verify_curve_log(scene, log_about(scene, only_first({{-2, -1.1}, {2, -1.1}, {0, 2.2}})));
  EXPECT_EQ(v.outcome, Outcome::undecided);
  EXPECT_LT(v.free_until, 5);
  EXPECT_GT(v.free_until, 3);
  // One that touches: tangents at the ends of the axes.
  const Polygon square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  EXPECT_EQ(verify_curve_log(scene, log_about(scene, only_first(square))).outcome, Outcome::free);
  EXPECT_EQ(verify_curve_log(scene, log_about(scene, only_first(square), {}, Touch::closed)).outcome, Outcome::free);
  // By one unit in the last place too little.
  Polygon less = square;
  less[2].y = less[3].y = std::nextafter(1, 0);
  EXPECT_NE(refusal(scene, log_about(scene, only_first(less))), "");
}

TEST(CurveLogs, HolesAreTheOtherWayRound) {
  Scene scene = disc_and_square(0);
  scene.bodies[0] = body_of("ring", "M3 0 A3 3 0 0 1 -3 0 A3 3 0 0 1 3 0 Z M2 0 A2 2 0 0 0 -2 0 A2 2 0 0 0 2 0 Z");
  scene.bodies[1].motion.pieces[0].x = {0, 0.1};
  ASSERT_EQ(check(scene).outcome, Outcome::free);
  const auto with_hole = [](double outline, double hole) {
    return PolygonsOfBodies{{{regular(60, outline), {regular(60, hole)}}}, {}};
  };
  EXPECT_EQ(verify_curve_log(scene, log_about(scene, with_hole(3.1, 1.9))).outcome, Outcome::free);
  EXPECT_NE(refusal(scene, log_about(scene, with_hole(3.1, 2.1))).find("hole 1"), std::string::npos);
  EXPECT_NE(refusal(scene, log_about(scene, with_hole(2.9, 1.9))), "");
}

/// Polygons around a disc with corners moved at random: those that are accepted have no edge through the disc.
TEST(CurveLogs, MovedCornersAreRefusedOrHarmless) {
  const Scene scene = disc_and_square(3);
  Rng rng(7);
  std::uint64_t accepted = 0, refused = 0;
  for (std::uint64_t k = 0; k < effort(400); ++k) {
    Polygon polygon = regular(24, 1.01 + 0.002 * rng.below(10));
    for (int i = 0; i < 3; ++i) {
      Point& p = polygon[static_cast<std::size_t>(rng.below(24))];
      const double by = std::ldexp(1.0, -3 - rng.below(12)) * (rng.below(2) == 0 ? 1 : -1);
      p = {p.x * (1 + by), p.y * (1 + by)};
    }
    double nearest = INFINITY;
    for (std::size_t i = 0; i < 24; ++i) {
      const Point &a = polygon[i], &b = polygon[(i + 1) % 24];
      const double dx = b.x - a.x, dy = b.y - a.y;
      const double t = std::clamp(-(a.x * dx + a.y * dy) / (dx * dx + dy * dy), 0.0, 1.0);
      nearest = std::min(nearest, std::hypot(a.x + t * dx, a.y + t * dy));
    }
    if (std::fabs(nearest - 1) < 1e-12) continue;
    const bool holds = refusal(scene, log_about(scene, only_first(polygon))).empty();
    ASSERT_EQ(holds, nearest > 1) << nearest;
    ++(holds ? accepted : refused);
  }
  EXPECT_GT(accepted, effort(400) / 20);
  EXPECT_GT(refused, effort(400) / 20);
}

TEST(CurveLogs, DamagedLogsAreRejectedOrTrue) {
  Rng rng(11);
  std::uint64_t accepted = 0, rejected = 0;
  for (std::uint64_t k = 0; k < effort(15); ++k) {
    const Scene scene = curved_soak_scene(k).scene;
    const Touch touch = both_touches[k % 2];
    std::ostringstream out;
    const Answer answer = prove(scene, out, touching(touch));
    const std::string log = out.str();
    if (log.empty()) continue;
    const CurveLog parts = curve_log_of(scene, log);
    ASSERT_EQ(put_together(parts, scene, touch), log);
    for (int i = 0; i < 40; ++i) {
      try {
        const Verified v = verify_curve_log(scene, damaged(parts, scene, touch, [&](int n) { return rng.below(n); }));
        ASSERT_EQ(untruth(v, answer, scene), "") << "scene " << k << ", damage " << i;
        ++accepted;
      } catch (const ProofError&) {
        ++rejected;
      }
    }
  }
  EXPECT_GT(rejected, effort(15) * 10);
  EXPECT_GT(accepted, effort(15));
}

TEST(CurveLogs, AreAboutOneScene) {
  const Scene scene = disc_and_square(1.5);
  std::ostringstream out;
  ASSERT_EQ(prove(scene, out).outcome, Outcome::free);
  const auto with_arc = [&](const std::function<void(ArcTo&)>& change) {
    Scene other = scene;
    change(std::get<ArcTo>(other.bodies[0].curves[0].outline.segments[1]));
    return other;
  };
  EXPECT_EQ(refusal(scene, out.str()), "");
  for (const Scene& other :
       {with_arc([](ArcTo& arc) { arc.rx = std::nextafter(1, 0); }), with_arc([](ArcTo& arc) { arc.rotation_deg = 1; }),
        with_arc([](ArcTo& arc) { arc.large = !arc.large; }), with_arc([](ArcTo& arc) { arc.sweep = !arc.sweep; })})
    EXPECT_NE(refusal(other, out.str()).find("another scene"), std::string::npos);
  // The log of one kind of scene is none of the other kind.
  const Scene flat = proof::with_polygons(scene, only_first(regular(8, 1.2)));
  EXPECT_NE(refusal(flat, out.str()).find("about curves"), std::string::npos);
  std::ostringstream plain;
  prove(flat, plain);
  EXPECT_NE(refusal(scene, plain.str()).find("about polygons"), std::string::npos);
  // A ring that is left out.
  EXPECT_THROW(proof::CurvedBodies(scene).require({{}, {}}, proof::Bodies::around), ProofError);
}

TEST(CurveLogs, ClearancesAreProved) {
  for (const double height : {1.5, 1.25}) {
    const Scene scene = disc_and_square(height);
    std::ostringstream out;
    const MarginAnswer answer = prove_clearance(scene, 0.3, out);
    const Verified v = verify_curve_log(scene, out.str());
    ASSERT_EQ(v.outcome, height > 1.3 ? Outcome::free : Outcome::contact) << answer.reason;
    ASSERT_EQ(v.outcome, answer.outcome);
    ASSERT_EQ(v.clearance, 0.3);
    if (!v.closer) continue;
    // The square's lower right corner comes within 1.3 of the centre.
    const double truth = 5 - 0.1 - std::sqrt(1.3 * 1.3 - height * height);
    EXPECT_LE(v.closer->time.lo, truth + 1e-12);
    EXPECT_GE(v.closer->time.hi, truth - 1e-12);
    EXPECT_LT(v.closer->time.hi - v.closer->time.lo, 1e-7);
  }
}

TEST(CurveLogs, WhatFitsExactlyIsProved) {
  Scene scene;
  scene.start = 0;
  scene.end = 4;
  scene.bodies.push_back(body_of("slot", "M0 0 H20 V1 H1 V3 H20 V4 H0 Z"));
  scene.bodies.push_back(body_of("pin", "M12 2 A1 1 0 0 1 10 2 A1 1 0 0 1 12 2 Z"));
  scene.bodies[1].motion.pieces.push_back({});
  scene.bodies[1].motion.pieces[0].x = {0, -1};
  std::array<int, 3> outcomes{};
  expect_proved(scene, Touch::open, outcomes);
  EXPECT_EQ(outcomes[0], 1);
}

}  // namespace
}  // namespace taut::testing
