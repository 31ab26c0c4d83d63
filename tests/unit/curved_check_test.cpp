// First contacts of curves against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "numeric/budget.hpp"
#include "support/rng.hpp"
#include "taut/check.hpp"
#include "taut/clearance.hpp"
#include "taut/error.hpp"
#include "taut/intervals.hpp"
#include "taut/io.hpp"
#include "taut/motions.hpp"
#include "taut/outline.hpp"

namespace taut {
using namespace internal;
namespace {

std::string disc(double x, double y, double r) {
  const auto n = [](double v) {
    char text[32];
    std::snprintf(text, sizeof text, " %.17g", v);
    return std::string(text);
  };
  const std::string arc = " A" + n(r) + n(r) + " 0 0 1";
  return "M" + n(x + r) + n(y) + arc + n(x - r) + n(y) + arc + n(x + r) + n(y) + " Z";
}

Body curve_body(const std::string& name, const std::string& path, const MotionPiece& piece = {}) {
  Body body;
  body.name = name;
  body.curves = parse_path(path);
  body.motion.pieces = {piece};
  return body;
}

MotionPiece curve_motion(std::vector<double> x, std::vector<double> y) {
  MotionPiece piece;
  piece.x = std::move(x);
  piece.y = std::move(y);
  return piece;
}

Scene scene_of(std::vector<Body> bodies, double end = 10) {
  Scene scene;
  scene.end = end;
  scene.bodies = std::move(bodies);
  return scene;
}

void expect_contact_at(const Answer& answer, long double t, double width) {
  ASSERT_EQ(answer.outcome, Outcome::contact) << answer.reason;
  EXPECT_LE(answer.contact->time.lo, t);
  EXPECT_GE(answer.contact->time.hi, t);
  EXPECT_LE(answer.contact->time.hi - answer.contact->time.lo, width);
  ASSERT_TRUE(answer.geometry);
  EXPECT_GT(answer.geometry->segments, 8u);
}

TEST(CurvedCheck, CircleMeetsCircle) {
  for (const double y : {0.1, 1.0, 2.5}) {
    const Answer answer =
        check(scene_of({curve_body("a", disc(0, 0, 1)), curve_body("b", disc(10, y, 2), curve_motion({0, -1}, {}))}));
    expect_contact_at(answer, 10 - std::sqrt((long double)9 - (long double)y * y), 1e-8);
    EXPECT_TRUE(answer.contact->vertex.parameter && answer.contact->edge.parameter);
  }
}

TEST(CurvedCheck, CircleMeetsLine) {
  Body wall;
  wall.name = "wall";
  wall.polygon = {{0, 0}, {30, 40}, {-8, 6}};
  // The distance of (20, -5 + t) from the line through (0, 0) and (30, 40) is |4 x - 3 y| / 5.
  const Answer answer = check(scene_of({wall, curve_body("disc", disc(20, -5, 2), curve_motion({}, {0, 3}))}));
  expect_contact_at(answer, (80.0L + 15 - 10) / 9, 1e-8);
  EXPECT_EQ(answer.contact->vertex.body, 1);
  EXPECT_FALSE(answer.contact->edge.parameter) << "the wall is a polygon";
}

TEST(CurvedCheck, EllipseTurnsAgainstLine) {
  MotionPiece turning;
  turning.rotation = AngleRotation{{0, 0.3}};
  Body wall;
  wall.name = "wall";
  wall.polygon = {{-9, 2}, {9, 2}, {9, 3}, {-9, 3}};
  const Answer answer = check(scene_of({curve_body("e", "M3 0 A3 1.5 0 0 1 -3 0 A3 1.5 0 0 1 3 0 Z", turning), wall}));
  // Its height is sqrt(9 sin^2 + 2.25 cos^2).
  expect_contact_at(answer, std::asin(std::sqrt(1.75L / 6.75L)) / 0.3L, 1e-8);
}

TEST(CurvedCheck, WhatFitsExactlyAlongAxesIsFree) {
  Body slot;
  slot.name = "slot";
  slot.polygon = {{0, 0}, {20, 0}, {20, 1}, {1, 1}, {1, 3}, {20, 3}, {20, 4}, {0, 4}};
  const Body pin = curve_body("pin", "M5 1 H10 A1 1 0 0 1 10 3 H5 A1 1 0 0 1 5 1 Z", curve_motion({0, 1}, {}));
  EXPECT_EQ(check(scene_of({slot, pin})).outcome, Outcome::free);
  const Body stopped = curve_body("pin", disc(10, 2, 1), curve_motion({0, -1}, {}));
  expect_contact_at(check(scene_of({slot, stopped})), 8, 1e-8);
  // Also on an axis, where what is left of the centre by rounding is no zero.
  for (Point& p : slot.polygon) p.y -= 2;
  const Body about_origin = curve_body("pin", disc(2, 0, 1), curve_motion({0, 1}, {}));
  EXPECT_EQ(check(scene_of({slot, about_origin})).outcome, Outcome::free);
}

TEST(CurvedCheck, EqualRadiiAreUndecidedWithARemedy) {
  const std::string ring = "M6 0 A6 6 0 0 1 -6 0 A6 6 0 0 1 6 0 Z M5 0 A5 5 0 0 0 -5 0 A5 5 0 0 0 5 0 Z";
  MotionPiece turning;
  turning.rotation = AngleRotation{{0, 1}};
  const Scene scene = scene_of({curve_body("hub", ring), curve_body("pin", disc(0, 0, 5), turning)});
  const Answer answer = check(scene);
  EXPECT_EQ(answer.outcome, Outcome::undecided);
  EXPECT_NE(answer.reason.find("--fit"), std::string::npos) << answer.reason;
  CheckOptions options;
  options.fit = 0.001;
  EXPECT_EQ(check(scene, options).outcome, Outcome::free);
  const Scene smaller = scene_of({curve_body("hub", ring), curve_body("pin", disc(0, 0, 4.9), turning)});
  EXPECT_EQ(check(smaller).outcome, Outcome::free);
}

TEST(CurvedCheck, GrazingIsUndecidedAndBracketed) {
  // They are 5 apart at t = 3, at (3, 4): not where tangents lie along the axes.
  const Answer answer = check(
      scene_of({curve_body("a", disc(0, 0, 2.5)), curve_body("b", disc(15, -5, 2.5), curve_motion({0, -4}, {0, 3}))}));
  EXPECT_EQ(answer.outcome, Outcome::undecided);
  EXPECT_LE(answer.free_until, 3);
  EXPECT_GT(answer.free_until, 2.999);
}

TEST(CurvedCheck, OverlapAtTheStartNeedsInnerPolygonsThatOverlap) {
  EXPECT_EQ(check(scene_of({curve_body("a", disc(0, 0, 1)), curve_body("b", disc(1.99, 0, 1))})).outcome,
            Outcome::overlap_at_start);
  // Corners of the outer polygons overlap, the discs do not.
  EXPECT_EQ(check(scene_of({curve_body("a", disc(0, 0, 1)), curve_body("b", disc(1.45, 1.45, 1))})).outcome,
            Outcome::free);
}

TEST(CurvedCheck, WorldsAndAllPairs) {
  Scene scene = scene_of({curve_body("a", disc(0, 0, 1)), curve_body("b", disc(10, 0.5, 1), curve_motion({0, -1}, {})),
                          curve_body("c", disc(0, 5, 1), curve_motion({}, {0, -0.125}))});
  const Answer first = check(scene);
  expect_contact_at(first, 10 - std::sqrt(3.75L), 1e-8);
  ASSERT_TRUE(first.pair);
  EXPECT_EQ((*first.pair)[1], 1);
  CheckOptions options;
  options.all_pairs = true;
  scene.end = 30;
  const Answer each = check(scene, options);
  ASSERT_TRUE(each.pairs);
  ASSERT_EQ(each.pairs->size(), each.coverage.tested);
  ASSERT_EQ(each.coverage.tested + each.coverage.apart, 3u);
  EXPECT_EQ((*each.pairs)[0].outcome, Outcome::contact);
  ASSERT_EQ((*each.pairs)[1].outcome, Outcome::contact);
  EXPECT_NEAR((*each.pairs)[1].contact->time.hi, 24, 1e-6);
  EXPECT_EQ((*each.pairs)[1].contact->edge.body + (*each.pairs)[1].contact->vertex.body, 2);
}

TEST(CurvedCheck, ScenesKeepTheirPaths) {
  const char* const text = R"({"format":"taut-scene/1","time":[0,10],"bodies":[
    {"name":"a","polygon":{"path":"M1 0 A1 1 0 0 1 -1 0 A1 1 0 0 1 1 0 Z"}},
    {"name":"b","parts":[{"path":"M3 0 C 5 0 5 4 3 4 Z"},[[6,0],[7,0],[7,1]]],"motion":{"x":[0,-1]}},
    {"name":"c","polygon":{"path":"m0 50 h1 v1 z"}},
    {"name":"d","parts":[{"path":"m0 70 h1 v1 z"}]}]})";
  const Scene scene = parse_scene(text, "text");
  EXPECT_EQ(scene.bodies[0].curves.size(), 1u);
  EXPECT_EQ(scene.bodies[1].curves.size(), 2u) << "a polygon among curves is one of lines";
  EXPECT_EQ(scene.bodies[2].polygon.size(), 3u) << "lines only are a polygon";
  EXPECT_EQ(scene.bodies[3].polygon.size(), 3u) << "also as the only part";
  const Scene again = parse_scene(write_scene(scene), "again");
  EXPECT_EQ(write_scene(again), write_scene(scene));
  EXPECT_EQ(answer_json(again, check(again), Touch::open), answer_json(scene, check(scene), Touch::open));
}

TEST(CurvedCheck, PathsThatAreNoneAreRefusedWithThePlace) {
  const auto problem = [](const std::string& path) -> std::string {
    try {
      parse_path(path);
    } catch (const InputError& error) {
      return error.problem();
    }
    return "";
  };
  EXPECT_NE(problem("M0 0 L1 x").find("at character 9"), std::string::npos) << problem("M0 0 L1 x");
  EXPECT_NE(problem("L0 0").find("begins with M"), std::string::npos);
  EXPECT_NE(problem("M0 0 A1 1 0 2 0 3 3").find("flag"), std::string::npos);
  EXPECT_NE(problem("M0 0 X").find("no command"), std::string::npos);
  const auto refused = [](const std::string& path) -> std::string {
    try {
      check(scene_of({curve_body("a", path), curve_body("b", disc(50, 0, 1))}));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refused("M0 0 C 12 10 -2 10 10 0 L10 -1 L0 -1 Z").find("segment 0 meets itself near"), std::string::npos);
  EXPECT_NE(refused("M0 0 C 10 10 0 10 10 0 L10 -1 L0 -1 Z").find("turns back on itself"), std::string::npos);
  // An arc that comes down to a line, and one that stays above it.
  EXPECT_NE(refused("M0 0 H10 V4 Q5 -4 0 4 Z").find("segment 0 meets segment 2 near"), std::string::npos)
      << refused("M0 0 H10 V4 Q5 -4 0 4 Z");
  EXPECT_EQ(refused("M0 -1 H10 V4 Q5 -4 0 4 Z"), "");
}

/// A disc that passes another one: its distance is known at every instant.
TEST(CurvedProfile, TwoDiscsAgainstTheFormula) {
  const Scene scene =
      scene_of({curve_body("a", disc(0, 0, 1)), curve_body("b", disc(5, 4, 2), curve_motion({0, -1}, {}))});
  const auto distance = [](long double t) { return std::hypot(5 - t, 4.0L) - 3; };
  ProfileOptions options;
  options.instants = 11;
  const DistanceProfile answer = distance_profile(scene, options);
  ASSERT_EQ(answer.curves.size(), 1u) << answer.reason;
  const DistanceCurve& curve = answer.curves[0];
  ASSERT_EQ(curve.instants.size(), 11u);
  for (const DistanceAt& d : curve.instants) {
    EXPECT_LE(d.lo, distance(d.t));
    EXPECT_GE(d.hi, distance(d.t));
    EXPECT_LE(d.hi - d.lo, 2e-9 * d.hi + 1e-11) << d.t;
  }
  for (const DistanceWithin& s : curve.stretches) {
    // The least is at the end nearer to 5.
    const long double least = distance(s.from < 5 && s.to > 5 ? 5 : s.to <= 5 ? s.to : s.from);
    EXPECT_LE(s.lo, least);
    EXPECT_GE(s.lo, least - 3e-3) << s.from;
    EXPECT_GE(s.hi, std::max(distance(s.from), distance(s.to)));
  }
  EXPECT_LE(curve.largest_lo, distance(0));
  EXPECT_GE(curve.largest_hi, distance(0));
  ASSERT_TRUE(answer.geometry);
  EXPECT_LE(answer.geometry->tolerance, 1e-8);
}

TEST(CurvedProfile, ZeroWhileTheyOverlapAndEachPair) {
  ProfileOptions options;
  options.instants = 6;
  options.all_pairs = true;
  options.relative = 1e-6;
  const DistanceProfile answer = distance_profile(
      scene_of({curve_body("a", disc(0, 0, 1)), curve_body("b", disc(5, 0, 1), curve_motion({0, -1}, {})),
                curve_body("c", disc(0, 9, 1))}),
      options);
  ASSERT_EQ(answer.curves.size(), 3u) << "those at rest are not asked about" << answer.reason;
  for (const DistanceAt& d : answer.curves[1].instants) {
    const double own = std::max(0.0, std::fabs(5 - d.t) - 2);
    EXPECT_LE(d.lo, own + 1e-12);
    EXPECT_GE(d.hi, own - 1e-12);
    EXPECT_LE(d.hi - d.lo, 1e-5);
  }
  EXPECT_EQ(answer.curves[1].instants[2].hi, 0) << "at 4 they overlap";
}

std::string bore(double r) { return disc(0, 0, 6) + " " + disc(0, 0, r); }

Body hub_of(double r) {
  Body body;
  body.name = "hub";
  body.curves = parse_path(bore(r), FillRule::evenodd);
  return body;
}

MotionPiece turning_beside(double x, double y) {
  MotionPiece piece = curve_motion({x}, {y});
  piece.rotation = AngleRotation{{0, 1}};
  return piece;
}

/// All of the arcs is equally near: the bracket is honest, and does not take for ever.
TEST(CurvedClearance, NearlyConcentricArcsEndSoon) {
  for (const double off : {0.0, 1e-3}) {
    for (const bool turns : {false, true}) {
      const MotionPiece piece = turns ? turning_beside(off, 0) : curve_motion({off}, {});
      const Clearance found = clearance(scene_of({hub_of(5), curve_body("pin", disc(0, 0, 4.9), piece)}, 1));
      ASSERT_TRUE(found.nearest) << found.reason;
      EXPECT_LE(found.nearest->lo, 0.1 - off + 1e-12);
      EXPECT_GE(found.nearest->hi, 0.1 - off - 1e-12);
      EXPECT_LE(found.nearest->hi - found.nearest->lo, 1e-3);
      const bool narrow = found.nearest->hi - found.nearest->lo <= 1e-9 * found.nearest->hi + 1e-11;
      EXPECT_EQ(found.wide.empty(), narrow) << "a bracket that is wide says so";
      EXPECT_LT(found.geometry->segments, 60000u);
    }
  }
}

/// That radii are equal is foreseen long before the limit of edges.
TEST(CurvedCheck, EqualRadiiEndSoon) {
  const Answer answer = check(scene_of({hub_of(5), curve_body("pin", disc(0, 0, 5), turning_beside(0, 0))}, 1));
  EXPECT_EQ(answer.outcome, Outcome::undecided);
  ASSERT_TRUE(answer.geometry);
  EXPECT_LT(answer.geometry->segments, 4000u);
  // A hundred-thousandth less is told from it.
  const Body less = curve_body("pin", disc(0, 0, 5 - 1e-5), curve_motion({}, {}));
  EXPECT_EQ(check(scene_of({hub_of(5), less}, 1)).outcome, Outcome::free);
}

/// Discs that pass through each other in turn, beside polygons that do: each end is told in a window of its own, and
/// pairs that are settled are not asked about again.
TEST(CurvedIntervals, TakeLittleMoreWorkThanPolygons) {
  Scene discs, polygons;
  discs.end = 6;
  testing::Rng rng(12);
  for (int i = 0; i < 8; ++i) {
    // From place to place on a grid, one at a time.
    std::vector<Keyframe> way(7);
    for (std::size_t t = 0; t < way.size(); ++t) {
      way[t].t = static_cast<double>(t);
      way[t].x = t == 0 ? i % 4 : way[t - 1].x;
      way[t].y = t == 0 ? i / 4 : way[t - 1].y;
      const double step = t == 0 ? 0 : rng.between(-1, 1);
      (rng.chance(0.5) ? way[t].x : way[t].y) += step;
    }
    const Motion motion = from_keyframes(way, {});
    const std::string name = "d" + std::to_string(i);
    discs.bodies.push_back({name, {}, motion});
    discs.bodies.back().curves = parse_path("M0.45 0 A0.45 0.45 0 0 1 -0.45 0 A0.45 0.45 0 0 1 0.45 0 Z");
    Polygon gon;
    for (int k = 0; k < 24; ++k)
      gon.push_back({0.45 * std::cos(k * 0.2617993877991494), 0.45 * std::sin(k * 0.2617993877991494)});
    polygons.bodies.push_back({name, gon, motion});
  }
  polygons.end = discs.end;
  const auto work_of = [](const Scene& scene, std::size_t& count) {
    const std::uint64_t before = work_spent();
    const Intervals found = intervals(scene);
    EXPECT_TRUE(found.undecided.empty());
    count = found.intervals.size();
    return work_spent() - before;
  };
  std::size_t of_discs = 0, of_polygons = 0;
  const std::uint64_t curved = work_of(discs, of_discs), plain = work_of(polygons, of_polygons);
  EXPECT_GE(of_discs, 3u);
  EXPECT_NEAR(static_cast<double>(of_discs), static_cast<double>(of_polygons), 3);
  EXPECT_LT(curved, 16 * plain);
  std::cout << "work " << curved << " beside " << plain << " of polygons\n";
}

}  // namespace
}  // namespace taut
