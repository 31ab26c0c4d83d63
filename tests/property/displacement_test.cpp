// The laws of the displacement, in exact integers: everything that engines and proofs say rests on them.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "geometry/displacement.hpp"
#include "geometry/prepared_shape.hpp"
#include "support/effort.hpp"
#include "support/exact_ring.hpp"
#include "support/random_polygons.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/validate.hpp"

namespace taut::testing {
using namespace internal;
namespace {

namespace fs = std::filesystem;

/// 2^x for a random x, rounded.
double power(Rng& rng, double from, double to) { return std::exp2(rng.real(from, to)); }

Point turned(const Point& p, const Point& by) { return {p.x * by.x - p.y * by.y, p.x * by.y + p.y * by.x}; }

/// Three points u, v, w with any angle at v, often a very sharp one or nearly a full turn.
struct Corner {
  Point u, v, w;
  /// About the sine of the angle between the two edges, where that is small.
  double sharpness = 1;
};

Corner random_corner(Rng& rng) {
  Corner c;
  const double far = rng.chance(0.5) ? power(rng, -140, -2) : power(rng, -200, -140);
  const double near = far * power(rng, -60, 0);
  const double angle = rng.chance(0.7) ? power(rng, -60, 1) : rng.real(0, 3.14);
  const Point along = rng.chance(0.2) ? Point{1, 0} : unit_vector(rng.unit());
  const double cosine = std::cos(angle), sine = std::sin(angle) * rng.sign();
  c.u = turned({far, 0}, along);
  // Beside the direction itself, so that angles far below the resolution of doubles come about.
  c.w = turned({near * cosine, near * sine}, along);
  if (rng.chance(0.3)) c.v = {power(rng, -60, -1) * rng.sign(), power(rng, -60, -1) * rng.sign()};
  for (Point* p : {&c.u, &c.w}) *p = {c.v.x + p->x, c.v.y + p->y};
  if (rng.chance(0.5)) std::swap(c.u, c.w);
  return c;
}

double length(const Point& a, const Point& b) { return std::hypot(b.x - a.x, b.y - a.y); }

/// The sine of the corner's angle, from exact integers.
double exact_sine(const Corner& c) {
  const auto at = [](const Point& p) { return original_point({p.x, p.y, 0, 0}); };
  const ExactPoint u = at(c.u), v = at(c.v), w = at(c.w);
  const Integer cross = (v.x - u.x) * (w.y - v.y) - (v.y - u.y) * (w.x - v.x);
  // A multiple of 2^-1400.
  const auto bits = cross == 0 ? 0 : static_cast<int>(msb(abs(cross)));
  const Integer leading = bits > 60 ? Integer(abs(cross) >> static_cast<unsigned>(bits - 60)) : Integer(abs(cross));
  const double rounded = leading.convert_to<double>() * (cross < 0 ? -1 : 1);
  return std::ldexp(rounded / length(c.u, c.v) * 0x1p-700, std::max(bits - 60, 0) - 700) / length(c.v, c.w);
}

TEST(DisplacementLaws, RandomCorners) {
  Rng rng(1);
  std::uint64_t kept = 0, refused = 0, sharp = 0;
  for (std::uint64_t i = 0; i < effort(1000000); ++i) {
    const Corner c = random_corner(rng);
    if (c.u == c.v || c.v == c.w || c.u == c.w) continue;
    const double sine = exact_sine(c);
    const bool folds_back =
        sine == 0 && ((c.u.x - c.v.x) * (c.w.x - c.v.x) > 0 || (c.u.y - c.v.y) * (c.w.y - c.v.y) > 0);
    if (folds_back) continue;
    const Offset offset = rng.chance(0.5) ? Offset::inward : Offset::outward;
    const std::vector<Point> polygon{c.u, c.v, c.w};
    const Displacement moved = displace(polygon, offset, displacement_unit, rng.next());
    // The corners at u and w of the triangle are of no interest.
    const DisplacedPoint& v = moved.points[1];
    if (v.dx == 0 && v.dy == 0) {
      ++refused;
      ASSERT_LT(std::fabs(sine), 0x1p-41) << "a corner is refused that is not sharp";
      continue;
    }
    ASSERT_TRUE(corner_keeps_law(c.u, v, c.w, offset, displacement_unit)) << i << ": sine " << sine;
    ASSERT_LE(std::max(std::fabs(v.dx), std::fabs(v.dy)), displacement_limit);
    ++kept;
    sharp += std::fabs(sine) < 0x1p-30;
  }
  EXPECT_GT(kept, enough(400000));
  EXPECT_GT(refused, enough(50000));
  EXPECT_GT(sharp, enough(20000));
}

/// A polygon without fault keeps all laws; one with a fault is counted.
struct Count {
  std::uint64_t sound = 0, faults = 0;
};

void look_at(const Polygon& polygon, Count& count, std::uint64_t seed) {
  try {
    validate_polygon(polygon, "polygon");
  } catch (const InputError&) {
    return;
  }
  const ShapeFacts facts = facts_of(polygon);
  int exponent = 0;
  std::frexp(facts.largest, &exponent);
  const std::vector<Point> unit = normalised(polygon, facts, facts.largest > 1 ? -exponent : 0);
  for (const Offset offset : {Offset::inward, Offset::outward}) {
    const SharedPolygon displaced = displaced_polygon(unit, offset, seed);
    if (displaced->fault) {
      ++count.faults;
    } else {
      ++count.sound;
      ASSERT_STREQ(broken_law(unit, *displaced, offset), "") << (offset == Offset::inward ? "inwards" : "outwards");
    }
  }
}

TEST(DisplacementLaws, PolygonsOfAllFamilies) {
  Rng rng(2);
  Count count;
  for (std::uint64_t i = 0; i < effort(600); ++i) {
    const PolygonPair pair = random_pair(rng, all_families[i % std::size(all_families)], rng.chance(0.5));
    for (const Polygon& polygon : {pair.p, pair.q}) ASSERT_NO_FATAL_FAILURE(look_at(polygon, count, i));
  }
  EXPECT_EQ(count.faults, 0U);
  EXPECT_GT(count.sound, enough(1200));
}

/// Teeth of any width, down to less than the displacement, on a bar; some of them with a spike of their own, or with
/// vertices in line on their sides.
Polygon comb_of_needles(Rng& rng, double finest) {
  Polygon teeth{{0, 0}, {1, 0}};
  const int n = rng.between(1, 5);
  for (int k = n; k-- > 0;) {
    const double at = (k + rng.real(0.2, 0.6)) / n, width = std::min(power(rng, finest, -3), 0.3 / n);
    const double height = rng.real(0.2, 1), base = rng.chance(0.5) ? 0.1 : power(rng, finest / 2, -3);
    teeth.push_back({at + width, base});
    if (rng.chance(0.3)) teeth.push_back({at + width / 2, base + height / 2});
    teeth.push_back({at + width * rng.unit(), base + height});
    if (rng.chance(0.3)) teeth.push_back({at, base + height / 2});
    teeth.push_back({at, base});
  }
  return teeth;
}

TEST(DisplacementLaws, CombsOfNeedles) {
  Rng rng(3);
  Count coarse, fine;
  for (std::uint64_t i = 0; i < effort(20000); ++i) {
    ASSERT_NO_FATAL_FAILURE(look_at(comb_of_needles(rng, -40), coarse, i));
    ASSERT_NO_FATAL_FAILURE(look_at(comb_of_needles(rng, -52), fine, i));
  }
  EXPECT_GT(coarse.sound, enough(5000));
  EXPECT_GT(fine.sound, enough(3000));
  EXPECT_GT(fine.faults, enough(200));
}

/// Polygons about as small as the displacement: nearly all are refused, and those that are not keep the laws.
TEST(DisplacementLaws, AsSmallAsTheDisplacement) {
  Rng rng(4);
  Count count;
  for (std::uint64_t i = 0; i < effort(20000); ++i) {
    const double size = power(rng, -204, -140);
    Polygon polygon;
    if (rng.chance(0.5)) {
      for (const Point& v : comb_of_needles(rng, -30)) polygon.push_back({v.x * size, v.y * size});
    } else {
      const int n = rng.between(3, 8);
      for (int k = 0; k < n; ++k) {
        const Point at = unit_vector((k + rng.real(0, 0.9)) / n);
        polygon.push_back({at.x * size * rng.real(0.1, 1), at.y * size * rng.real(0.1, 1)});
      }
    }
    ASSERT_NO_FATAL_FAILURE(look_at(polygon, count, i));
  }
  EXPECT_GT(count.sound, enough(5000));
  EXPECT_GT(count.faults, enough(5000));
}

/// Slivers on lattices as fine as doubles have them are refused, with the place.
TEST(DisplacementLaws, SliversOfLargeIntegers) {
  Rng rng(5);
  Count count;
  for (std::uint64_t i = 0; i < effort(3000); ++i) {
    const int bits = rng.between(10, 52);
    const auto coordinate = [&] { return std::floor(rng.unit() * std::exp2(bits)); };
    const Point a{coordinate(), coordinate()}, b{coordinate(), coordinate()};
    const double share = rng.unit();
    Polygon sliver{a, b, {std::floor(a.x + (b.x - a.x) * share), std::floor(a.y + (b.y - a.y) * share)}};
    ASSERT_NO_FATAL_FAILURE(look_at(sliver, count, i));
  }
  EXPECT_GT(count.sound, enough(1000));
  EXPECT_GT(count.faults, enough(300));
}

TEST(DisplacementLaws, PolygonsOfExamplesAndCorpus) {
  Count count;
  for (const char* folder : {"examples", "tests/corpus", "fuzz/scenes"}) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      const std::string file = entry.path().string();
      if (entry.path().extension() != ".json" || file.find(".answer.") != std::string::npos) continue;
      SCOPED_TRACE(file);
      Scene scene;
      try {
        scene = read_scene(file);
      } catch (const InputError&) {
        continue;
      }
      for (const Body& body : scene.bodies) ASSERT_NO_FATAL_FAILURE(look_at(body.polygon, count, 7));
    }
  }
  EXPECT_EQ(count.faults, 0U);
  EXPECT_GT(count.sound, 40U);
}

TEST(DisplacementLaws, Coastlines) {
  const fs::path folder = "../shared/data";
  if (!fs::exists(folder)) GTEST_SKIP() << "the coastlines are not here (../shared/data)";
  Count count;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".wkt") continue;
    SCOPED_TRACE(entry.path().string());
    ASSERT_NO_FATAL_FAILURE(look_at(read_wkt(entry.path().string()), count, 1));
  }
  EXPECT_EQ(count.faults, 0U);
  EXPECT_GT(count.sound, 20U);
}

}  // namespace
}  // namespace taut::testing
