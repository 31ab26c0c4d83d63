// Roots told from roots, against the same functions in 960 bits: they change their sign within the enclosure.
#include "certificate/relative_root.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "certificate/precise_triple.hpp"
#include "motion/motion_segments.hpp"
#include "scene/body_pair.hpp"
#include "taut/io.hpp"

namespace taut::testing {
using namespace internal;
namespace {

/// A comb of four teeth, upwards or downwards, turned about the origin.
std::vector<Point> comb(bool up, double pitch, double angle) {
  std::vector<Point> points = {{4 * pitch, -1}, {4 * pitch, 0}};
  for (int k = 3; k >= 0; --k) {
    for (const auto& [x, y] : {Point{0.7, 0}, Point{0.7, 2}, Point{0.3, 2}, Point{0.3, 0}}) {
      points.push_back({(k + x) * pitch, y});
    }
  }
  points.push_back({0, 0});
  points.push_back({0, -1});
  const double c = std::cos(angle), s = std::sin(angle);
  for (Point& p : points) {
    if (!up) p = {p.x - 0.125, 3 - p.y};
    p = {c * p.x - s * p.y, s * p.x + c * p.y};
  }
  // Counterclockwise.
  if (!up) std::reverse(points.begin(), points.end());
  return points;
}

Scene combs(double pitch, double angle, const std::string& motion) {
  Scene scene = parse_scene(R"({"format":"taut-scene/1","time":[0,1],"bodies":[
    {"name":"rack","polygon":[[0,0],[1,0],[0,1]]},
    {"name":"comb","polygon":[[0,0],[1,0],[0,1]],"motion":)" +
                            motion + "}]}");
  scene.bodies[0].polygon = comb(true, pitch, angle);
  scene.bodies[1].polygon = comb(false, pitch, angle);
  return scene;
}

struct Counts {
  int roots = 0, known = 0, beside = 0, sharp = 0;
};

/// Asks for the first root of all forms of an edge and a vertex, one after the other, from those that were found
/// before.
Counts check_all(const Scene& scene) {
  Counts counts;
  const BodyPair bodies = pair_of(scene);
  const PairGeometry geometry = displaced_pair(bodies, Offset::inward);
  const MotionSegment segment = segments_of(bodies, scene.start, scene.end).front();
  FrameExpansionCache frames;
  ExpansionCache functions;
  frames.reset(segment);
  for (std::uint32_t u = 0; u < geometry.size(); ++u) {
    for (std::uint32_t v = 0; v < geometry.size(); ++v) {
      const VertexId a(u), b = geometry.next(a), c(v);
      if (geometry.same_body(a, c)) continue;
      const CertificateFunction function{a, b, c, geometry.in_p(a)};
      const PreciseFunction<Real960> f(segment, geometry, function);
      const int sign = f.value(Ball<Real960>::exact(segment.start)).sign();
      const PreciseTime start = PreciseTime::between(segment.start, segment.start);
      const auto failure = PreciseTriple(segment, geometry, function).first_failure(sign, start, segment.end);
      if (!failure) continue;
      ++counts.roots;
      const FrameExpansion* const frame = frames.around(failure->floor(), failure->ceiling());
      if (!frame) continue;
      ++counts.known;
      for (const double enough : {HUGE_VAL, 0x1p-216}) {
        const RootOfExpansion* const root = functions.root_near(*frame, segment, geometry, function, enough);
        if (!root) continue;
        ++(enough < 1 ? counts.sharp : counts.beside);
        EXPECT_EQ(root->slope_sign, -sign);
        EXPECT_EQ(f.value(Ball<Real960>(root->at.lo(), 0.0)).sign(), sign);
        EXPECT_EQ(f.value(Ball<Real960>(root->at.hi(), 0.0)).sign(), -sign);
        EXPECT_LE(root->at.width_of_sums(), 4 * root->error);
        EXPECT_LT(root->error, std::min(enough, 0x1p-60));
      }
      const auto found = FixedPointExpansion(*frame, segment, geometry, function).root(sign, Stage::precise, 0);
      if (found) functions.note_root(*frame, segment, geometry, function, *found);
    }
  }
  return counts;
}

const char* const dip = R"({"x":[0,0.0625,0.03125],"y":[1.25,-4,0.5]})";
const char* const oblique_dip = R"({"x":[-0.1,1.3,0.25],"y":[1.3,-3.9,0.4]})";
const char* const turning =
    R"({"x":[0,0.0625,0.03125],"y":[1.25,-4,0.5],"rotation":{"half_angle_tangent":[0,0.03125]}})";

TEST(RelativeRoot, OnAGridTheDisplacementAloneTellsRootsApart) {
  const Counts counts = check_all(combs(1, 0, dip));
  EXPECT_GT(counts.sharp, counts.known / 2);
  EXPECT_GE(counts.beside, counts.sharp);
}

/// Coordinates with all the digits that doubles have: parallel edges are parallel all the same.
TEST(RelativeRoot, LinesThatAreParallelNeedNoGrid) {
  const Counts counts = check_all(combs(1.1, 0, dip));
  EXPECT_GT(counts.beside, counts.known / 2);
  EXPECT_GT(counts.sharp, counts.known / 4);
}

TEST(RelativeRoot, TurnedCoordinatesAreRounded) {
  const Counts counts = check_all(combs(1.1, 0.37, oblique_dip));
  EXPECT_GT(counts.beside, counts.known / 4);
  EXPECT_LT(counts.sharp, counts.beside);
}

TEST(RelativeRoot, PointsOnOneLineFallTogetherWhileTheyTurn) {
  const Counts counts = check_all(combs(1, 0, turning));
  EXPECT_GT(counts.beside, 50);
  EXPECT_GT(counts.sharp, 50);
}

}  // namespace
}  // namespace taut::testing
