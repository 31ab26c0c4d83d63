// The tests' own tools: are the random scenes what they promise, and is the oracle right?
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/brute_force.hpp"
#include "support/brute_motion.hpp"
#include "support/effort.hpp"
#include "support/random_scenes.hpp"
#include "taut/validate.hpp"

namespace taut::testing {
namespace {

std::int64_t turn(const Point& a, const Point& b, const Point& c) {
  const auto i = [](double x) { return static_cast<std::int64_t>(x); };
  return (i(b.x) - i(a.x)) * (i(c.y) - i(a.y)) - (i(b.y) - i(a.y)) * (i(c.x) - i(a.x));
}

bool between(const Point& a, const Point& b, const Point& p) {
  return turn(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

/// Closed segments, exact on integers.
bool meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (between(a, b, c) || between(a, b, d) || between(c, d, a) || between(c, d, b)) return true;
  return (turn(a, b, c) > 0) != (turn(a, b, d) > 0) && (turn(c, d, a) > 0) != (turn(c, d, b) > 0);
}

bool inside(const Polygon& polygon, const Point& c) {
  bool in = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if ((a.y > c.y) != (b.y > c.y) && (turn(a, b, c) > 0) == (b.y > a.y)) in = !in;
  }
  return in;
}

void expect_sound(const Polygon& polygon) {
  std::int64_t area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& p = polygon[i];
    ASSERT_EQ(p.x, std::floor(p.x));
    ASSERT_EQ(p.y, std::floor(p.y));
    ASSERT_LT(std::max(std::fabs(p.x), std::fabs(p.y)), 0x1p20);
    area += turn(polygon[0], p, polygon[(i + 1) % polygon.size()]);
    for (std::size_t j = i + 2; j < polygon.size(); ++j)
      if (!(i == 0 && j + 1 == polygon.size())) {
        ASSERT_FALSE(meet(p, polygon[i + 1], polygon[j], polygon[(j + 1) % polygon.size()]));
      }
  }
  ASSERT_GT(area, 0);
  ASSERT_NO_THROW(validate_polygon(polygon, "random"));
}

void expect_disjoint(const PolygonPair& pair) {
  for (std::size_t i = 0; i < pair.p.size(); ++i)
    for (std::size_t j = 0; j < pair.q.size(); ++j)
      ASSERT_FALSE(meet(pair.p[i], pair.p[(i + 1) % pair.p.size()], pair.q[j], pair.q[(j + 1) % pair.q.size()]));
  ASSERT_FALSE(inside(pair.p, pair.q[0]));
  ASSERT_FALSE(inside(pair.q, pair.p[0]));
}

TEST(RandomPairs, AreSimpleAndDisjoint) {
  for (const Family family : all_families)
    for (const bool grid : {false, true})
      for (std::uint64_t seed = 0; seed < 100; ++seed) {
        Rng rng(seed);
        const PolygonPair pair = random_pair(rng, family, grid);
        SCOPED_TRACE(std::string(to_string(family)) + (grid ? " grid " : " ") + std::to_string(seed));
        ASSERT_NO_FATAL_FAILURE(expect_sound(pair.p));
        ASSERT_NO_FATAL_FAILURE(expect_sound(pair.q));
        ASSERT_NO_FATAL_FAILURE(expect_disjoint(pair));
      }
}

TEST(RandomPairs, GridsAreFullOfCollinearTriplesAndAxisParallelEdges) {
  int collinear = 0, axis = 0, edges = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Rng rng(seed);
    const Polygon p = random_pair(rng, Family::intertwined, true).p;
    for (std::size_t i = 0; i < p.size(); ++i, ++edges) {
      const Point &a = p[i], &b = p[(i + 1) % p.size()], &c = p[(i + 2) % p.size()];
      collinear += turn(a, b, c) == 0;
      axis += a.x == b.x || a.y == b.y;
    }
  }
  EXPECT_GT(collinear, edges / 20);
  EXPECT_GT(axis, edges / 5);
}

TEST(Rng, TheSequenceIsFixed) {
  Rng rng(1);
  EXPECT_EQ(rng.next(), 0x910a2dec89025cc1u);
  EXPECT_EQ(rng.next(), 0xbeeb8da1658eec67u);
  for (const double turns : {0.0, 0.125, 0.3, 0.77, 2.5, -0.2}) {
    EXPECT_NEAR(unit_vector(turns).x, std::cos(2 * std::acos(-1.0) * turns), 1e-15);
    EXPECT_NEAR(unit_vector(turns).y, std::sin(2 * std::acos(-1.0) * turns), 1e-15);
  }
}

BrutePiece piece_at(const Motion& m, std::size_t k) {
  return BrutePiece(m.pieces.empty() ? MotionPiece{} : m.pieces[k]);
}

TEST(RandomMotions, BeginWhereTheyShouldAndPiecesJoinExactly) {
  for (const MotionKind kind : all_motions)
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      SCOPED_TRACE(std::string(to_string(kind)) + " " + std::to_string(seed));
      Rng rng(seed);
      Drive drive{kind, rng.real(1, 20000), rng.real(-6, 6), {}, {double(rng.below(1000)), -3}, 0};
      drive.quarter_turns = rng.pick(start_turns(kind));
      const Polygon square{{0, 0}, {7, 0}, {7, 5}, {0, 5}};
      const Body body = animate(rng, "B", square, drive);
      const Frame f = piece_at(body.motion, 0).at(0);
      for (std::size_t i = 0; i < square.size(); ++i) {
        const Point& p = body.polygon[i];
        ASSERT_EQ(f.origin.x + p.x * f.axis.x - p.y * f.axis.y, Real(square[i].x));
        ASSERT_EQ(f.origin.y + p.x * f.axis.y + p.y * f.axis.x, Real(square[i].y));
      }
      for (std::size_t k = 0; k + 1 < body.motion.pieces.size(); ++k) {
        const Real t = body.motion.pieces[k].until;
        const Frame a = piece_at(body.motion, k).at(t), b = piece_at(body.motion, k + 1).at(t);
        ASSERT_TRUE(a.origin.x == b.origin.x && a.origin.y == b.origin.y);
        ASSERT_TRUE(a.axis.x == b.axis.x && a.axis.y == b.axis.y);
      }
    }
}

TEST(RandomMotions, BoundsHold) {
  for (const MotionKind kind : all_motions)
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      SCOPED_TRACE(std::string(to_string(kind)) + " " + std::to_string(seed));
      Rng rng(seed);
      const BrutePiece piece = piece_at(random_motion(rng, 100, kind), 0);
      const Real half = std::exp2(rng.real(-12, -2)), middle = rng.real(0.25, 0.5);
      const FrameBounds b = piece.over(middle, half);
      const Frame f = piece.at(middle);
      for (int k = -8; k <= 8; ++k) {
        if (k == 0) continue;
        const Real h = half * k / 8;
        const Frame g = piece.at(middle + h);
        const Vec way = g.origin - f.origin, taylor = way - h * b.origin_velocity;
        ASSERT_LE(length(way), b.origin_way * 1.0000001L + 1e-15L);
        ASSERT_LE(length(taylor), b.acceleration * h * h / 2 * 1.0000001L + 1e-15L);
        const Real angle = std::atan2(cross(f.axis, g.axis), dot(f.axis, g.axis));
        ASSERT_LE(std::fabs(angle), b.angle_way * 1.0000001L + 1e-15L);
        ASSERT_LE(std::fabs(angle), b.rate * std::fabs(h) * 1.0000001L + 1e-15L);
        ASSERT_LE(std::fabs(angle - h * b.middle_rate), b.rate_change * h * h / 2 * 1.0000001L + 1e-15L);
      }
    }
}

TEST(RandomScenes, AreReproducibleAndAFairPartCollides) {
  for (const Family family : all_families) {
    std::map<Verdict, int> count;
    int skipped = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const Scene scene = random_scene(seed, family), again = random_scene(seed, family);
      ASSERT_EQ(scene.bodies[1].polygon, again.bodies[1].polygon);
      const OracleAnswer a = brute_force(scene);
      ++count[a.verdict];
      skipped += a.margin < 1e-9;
    }
    EXPECT_EQ(count[Verdict::overlap_at_start], 0);
    EXPECT_GE(count[Verdict::contact], 12) << to_string(family);
    EXPECT_GE(count[Verdict::free], 8) << to_string(family);
    EXPECT_LE(skipped, 3) << to_string(family);
    std::printf("%-12s contact %2d, free %2d, near-degenerate %d\n", to_string(family), count[Verdict::contact],
                count[Verdict::free], skipped);
  }
}

Scene falling_square(double height, double speed) {
  Scene scene;
  scene.end = 10;
  scene.bodies = {{"anvil", {{0, 0}, {4, 0}, {4, 1}, {0, 1}}, {}},
                  {"hammer", {{1, 5}, {3, 5}, {2, height}}, {{{{}, {0, -speed}, NoRotation{}}}}}};
  return scene;
}

TEST(Oracle, KnowsSimpleScenes) {
  Scene scene = falling_square(3, 0.5);  // the tip comes down
  std::swap(scene.bodies[1].polygon[0], scene.bodies[1].polygon[1]);
  OracleAnswer a = brute_force(scene);
  EXPECT_EQ(a.verdict, Verdict::contact);
  EXPECT_NEAR(a.t, 4, 1e-15);
  EXPECT_EQ(a.vertex_body, 1);
  EXPECT_EQ(a.vertex, 2);
  EXPECT_EQ(a.edge_body, 0);
  EXPECT_EQ(a.edge, 2);
  EXPECT_GT(a.margin, 0.05);
  EXPECT_GT(a.lead, 0.05);

  a = brute_force(falling_square(6, 0.5));  // the base lands on the anvil: two contacts at once
  EXPECT_EQ(a.verdict, Verdict::contact);
  EXPECT_NEAR(a.t, 8, 1e-15);
  EXPECT_LT(a.lead, 1e-9);

  a = brute_force(falling_square(6, 0.1));
  EXPECT_EQ(a.verdict, Verdict::free);
  EXPECT_GT(a.gap * std::hypot(4, 6), 3.0 / 4);
  EXPECT_LE(a.gap * std::hypot(4, 6), 3.0);

  EXPECT_EQ(brute_force(falling_square(0.5, 0.1)).verdict, Verdict::overlap_at_start);
  for (const double speed : {0.4, 0.39999999999999997, 0.39999999999999991})  // about to touch at the very end
    EXPECT_LT(brute_force(falling_square(6, speed)).margin, 1e-9);
}

/// The vertices of a body at a time of a scene, or just after it where pieces join.
std::vector<Vec> placed(const Body& body, double t) {
  std::size_t k = 0;
  while (k + 1 < body.motion.pieces.size() && body.motion.pieces[k].until <= t) ++k;
  const Frame f = piece_at(body.motion, k).at(t);
  std::vector<Vec> at;
  for (const Point& p : body.polygon)
    at.push_back({f.origin.x + p.x * f.axis.x - p.y * f.axis.y, f.origin.y + p.x * f.axis.y + p.y * f.axis.x});
  return at;
}

bool edges_cross(const Scene& scene, double t) {
  const std::vector<Vec> p = placed(scene.bodies[0], t), q = placed(scene.bodies[1], t);
  const auto side = [](const Vec& a, const Vec& b, const Vec& c) { return cross(b - a, c - a) > 0; };
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < q.size(); ++j) {
      const Vec &a = p[i], &b = p[(i + 1) % p.size()], &c = q[j], &d = q[(j + 1) % q.size()];
      if (side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b)) return true;
    }
  return false;
}

TEST(Oracle, IsNotContradictedBySamples) {
  int contacts = 0, skipped = 0;
  for (const Family family : all_families)
    for (const bool grid : {false, true})
      for (std::uint64_t seed = 1000; seed < 1000 + effort(30); ++seed) {
        SCOPED_TRACE(std::string(to_string(family)) + (grid ? " grid " : " ") + std::to_string(seed));
        SceneOptions options;
        options.grid = grid;
        const Scene scene = random_scene(seed, family, options);
        const OracleAnswer a = brute_force(scene);
        if (a.margin < 1e-7) {
          ++skipped;
          continue;
        }
        const double until = a.verdict == Verdict::contact ? a.t : 1;
        for (int k = 0; k < 60; ++k) ASSERT_FALSE(edges_cross(scene, until * k / 60));
        ASSERT_FALSE(edges_cross(scene, until - 1e-11));
        if (a.verdict != Verdict::contact) continue;
        ++contacts;
        ASSERT_TRUE(edges_cross(scene, a.t + 1e-11));
      }
  EXPECT_GT(contacts, enough(100));
  EXPECT_LT(skipped, 24);
}

// ---- the scenes with certified answers ----

Coefficients coefficients(const nlohmann::json& object, const char* key) {
  return object.contains(key) ? object.at(key).get<Coefficients>() : Coefficients{};
}

MotionPiece read_piece(const nlohmann::json& j) {
  MotionPiece piece{coefficients(j, "x"), coefficients(j, "y"), NoRotation{}};
  if (j.contains("until")) piece.until = j.at("until").get<double>();
  if (!j.contains("rotation")) return piece;
  const nlohmann::json& r = j.at("rotation");
  if (r.contains("angle")) piece.rotation = AngleRotation{coefficients(r, "angle")};
  if (r.contains("half_angle_tangent")) piece.rotation = HalfAngleRotation{coefficients(r, "half_angle_tangent")};
  if (r.contains("cosine")) piece.rotation = CosineRotation{coefficients(r, "cosine")};
  if (r.contains("direction"))
    piece.rotation = DirectionRotation{coefficients(r.at("direction"), "a"), coefficients(r.at("direction"), "b")};
  return piece;
}

Scene read_scene(const nlohmann::json& j) {
  Scene scene;
  scene.start = j.at("time").at(0).get<double>();
  scene.end = j.at("time").at(1).get<double>();
  for (const nlohmann::json& b : j.at("bodies")) {
    Body body;
    body.name = b.value("name", "");
    for (const nlohmann::json& p : b.at("polygon"))
      body.polygon.push_back({p.at(0).get<double>(), p.at(1).get<double>()});
    if (b.contains("motion") && b.at("motion").is_array()) {
      for (const nlohmann::json& piece : b.at("motion")) body.motion.pieces.push_back(read_piece(piece));
    } else if (b.contains("motion")) {
      body.motion.pieces.push_back(read_piece(b.at("motion")));
    }
    scene.bodies.push_back(std::move(body));
  }
  return scene;
}

bool is_named_feature(const nlohmann::json& answer, const Scene& scene, const OracleAnswer& got) {
  const auto is = [&](const nlohmann::json& f, int body, int index) {
    return f.at(0).get<std::string>() == scene.bodies[body].name && f.at(1).get<int>() == index;
  };
  for (const nlohmann::json& f : answer.at("features"))
    if (is(f.at("vertex"), got.vertex_body, got.vertex) && is(f.at("edge"), got.edge_body, got.edge)) return true;
  return false;
}

double extent_at_start(const Scene& scene) {
  Real lo[2] = {INFINITY, INFINITY}, hi[2] = {-INFINITY, -INFINITY};
  for (const Body& b : scene.bodies) {
    std::size_t k = 0;
    while (k + 1 < b.motion.pieces.size() && b.motion.pieces[k].until <= scene.start) ++k;
    const Frame f = piece_at(b.motion, k).at(scene.start);
    for (const Point& p : b.polygon) {
      const Real at[2] = {f.origin.x + p.x * f.axis.x - p.y * f.axis.y, f.origin.y + p.x * f.axis.y + p.y * f.axis.x};
      for (int c = 0; c < 2; ++c) lo[c] = std::min(lo[c], at[c]), hi[c] = std::max(hi[c], at[c]);
    }
  }
  return static_cast<double>(std::hypot(hi[0] - lo[0], hi[1] - lo[1]));
}

void compare_with_certified(const nlohmann::json& answer, const Scene& scene, const OracleAnswer& got) {
  ASSERT_EQ(to_string(got.verdict), answer.at("outcome").get<std::string>());
  if (got.verdict == Verdict::free && answer.contains("min_gap_upper_bound")) {
    EXPECT_LE(got.gap * extent_at_start(scene), answer.at("min_gap_upper_bound").get<double>() * (1 + 1e-9));
    EXPECT_GE(got.gap * extent_at_start(scene), answer.at("min_gap_lower_bound").get<double>() / 4 * (1 - 1e-9));
  }
  if (got.verdict != Verdict::contact) return;
  const double lo = answer.at("t").at(0).get<double>(), hi = answer.at("t").at(1).get<double>();
  const double tolerance = got.time_error;
  if (answer.value("generic", false)) {
    EXPECT_LE(tolerance, 1e-12 * (scene.end - scene.start) + 1e-15 / got.margin);
  }
  EXPECT_GE(got.t, lo - tolerance);
  EXPECT_LE(got.t, hi + tolerance);
  if (got.lead > 1e-9) {
    EXPECT_TRUE(is_named_feature(answer, scene, got));
  }
}

TEST(Oracle, AgreesWithTheCertifiedScenes) {
  const std::filesystem::path folder = "../shared/scenes";
  if (!std::filesystem::is_directory(folder))
    GTEST_SKIP() << "the scenes with certified answers are not here (" << folder.string() << ")";
  int compared = 0, unclear = 0, total = 0;  // the oracle declines scenes that are degenerate
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string(), ending = ".answer.json";
    if (name.size() < ending.size() || name.substr(name.size() - ending.size()) != ending) continue;
    std::ifstream answer_file(entry.path()),
        scene_file(folder / (name.substr(0, name.size() - ending.size()) + ".json"));
    const nlohmann::json answer = nlohmann::json::parse(answer_file);
    const Scene scene = read_scene(nlohmann::json::parse(scene_file));
    const bool generic = answer.value("generic", false);
    // It takes as long as there are pairs of vertices, but for scenes that it finds degenerate, which take far longer.
    const std::size_t pairs = scene.bodies[0].polygon.size() * scene.bodies[1].polygon.size();
    if (pairs > (generic ? effort(100000) : 10000)) continue;
    SCOPED_TRACE(name);
    const OracleAnswer got = brute_force(scene);
    ++total;
    if (got.margin < 1e-9) {  // the oracle says that it does not know
      EXPECT_FALSE(generic && name.rfind("degenerate_", 0) != 0)
          << to_string(got.verdict) << " margin " << got.margin << " gap " << got.gap << " at " << got.t;
      ++unclear;
      continue;
    }
    ASSERT_NO_FATAL_FAILURE(compare_with_certified(answer, scene, got));
    ++compared;
  }
  std::printf("%d scenes: %d compared, %d near-degenerate\n", total, compared, unclear);
  EXPECT_GT(compared, 70);
}

}  // namespace
}  // namespace taut::testing
