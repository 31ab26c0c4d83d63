// Separators whose answers are known beforehand.
#include "taut/separator.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/effort.hpp"
#include "support/link_search.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut {
namespace {

using testing::is_separator;

Polygon box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

void expect_exact(const Polygon& p, const Polygon& q, int links, bool closed) {
  const Separator found = separator(p, q);
  ASSERT_FALSE(found.overlap);
  EXPECT_EQ(found.minimum_link.lower, links);
  EXPECT_EQ(found.minimum_link.upper, links);
  EXPECT_EQ(found.minimum_link.closed, closed);
  EXPECT_TRUE(is_separator(found.minimum_link.vertices, closed, p, q));
}

TEST(Separator, BodiesApartHaveALine) {
  expect_exact(box(0, 0, 1, 1), box(3, 0, 4, 1), 1, false);
  const MovingSeparator moving = separator(box(0, 0, 1, 1), box(3, 0, 4, 1)).moving;
  EXPECT_EQ(moving.hulls[0].size(), 4u);
  EXPECT_EQ(moving.hulls[1].size(), 4u);
  EXPECT_TRUE(moving.contact.empty());
}

/// The coordinates of a vertex that a motion has moved need not be valid ones of a polygon.
TEST(Separator, VerticesMayMoveOutOfTheRangeOfCoordinates) {
  Scene scene;
  scene.end = 1;
  scene.bodies = {{"a", box(0, 0, 1, 1), {}}, {"b", box(3, 0, 4, 1), {}}};
  MotionPiece slow;
  slow.x = {0, 1e-100};
  scene.bodies[0].motion.pieces = {slow};
  const Separator small = separator(scene, 1e-30);
  EXPECT_FALSE(small.overlap);
  EXPECT_EQ(small.minimum_link.upper, 1);
  EXPECT_TRUE(is_separator(small.minimum_link.vertices, false, box(0, 0, 1, 1), box(3, 0, 4, 1)));

  const double far = 0x1p399;
  slow.x = {far};
  scene.bodies = {{"a", box(far, 0, far + far / 2, far), {}}, {"b", box(-far, 0, far / 2, far), {}}};
  scene.bodies[0].motion.pieces = {slow};
  const Separator large = separator(scene, 0);
  EXPECT_FALSE(large.overlap);
  EXPECT_EQ(large.minimum_link.upper, 1);
  for (const Point& v : large.minimum_link.vertices) EXPECT_TRUE(std::isfinite(v.x) && std::isfinite(v.y));
}

TEST(Separator, ALineThatJustPassesIsFound) {
  // Face to face.
  expect_exact(box(0, 0, 1, 1), box(1, 0, 2, 1), 1, false);
  expect_exact(box(0, 0, 1, 1), box(0.25, 1, 0.75, 2), 1, false);
  // The tips of one comb between those of the other, all on one line.
  const Polygon lower{{-1, -3}, {6, -3}, {5, 0}, {4, -2}, {3, 0}, {2, -2}, {1, 0}, {0, -2}, {-1, 0}};
  const Polygon upper{{0, 0}, {1, 2}, {2, 0}, {3, 2}, {4, 0}, {5, 3}, {-1, 3}};
  expect_exact(lower, upper, 1, false);
}

TEST(Separator, ANotchTakesAWedge) {
  const Polygon notched{{0, 0}, {8, 0}, {8, 4}, {4, 1}, {0, 4}};
  const Polygon wedge{{4, 2}, {6, 6}, {2, 6}};
  expect_exact(notched, wedge, 2, false);
  const MovingSeparator moving = separator(notched, wedge).moving;
  EXPECT_EQ(moving.bichromatic_edges[0], 2);
  EXPECT_EQ(moving.bichromatic_edges[1], 0);
  EXPECT_EQ(moving.contact, (std::vector<VertexRef>{{1, 0}}));
}

TEST(Separator, ABodyInAPocketIsSurrounded) {
  // The mouth lies around the corner.
  const Polygon vault{{0, 0}, {10, 0}, {10, 10}, {6, 10}, {6, 8},  {8, 8},
                      {8, 2}, {2, 2},  {2, 8},   {5, 8},  {5, 10}, {0, 10}};
  expect_exact(vault, box(2.5, 2.5, 3, 3), 3, true);
  expect_exact(box(2.5, 2.5, 3, 3), vault, 3, true);
}

TEST(Separator, OverlapIsSaid) {
  EXPECT_TRUE(separator(box(0, 0, 2, 2), box(1, 1, 3, 3)).overlap);
  EXPECT_TRUE(separator(box(0, 0, 9, 9), box(1, 1, 3, 3)).overlap);
}

TEST(Separator, WhatIsNotSimpleIsRefused) {
  EXPECT_THROW(separator(box(0, 0, 1, 1), {{5, 0}, {6, 1}, {6, 0}, {5, 1}}), InputError);
  EXPECT_THROW(separator({{0, 0}, {1, 0}}, box(3, 0, 4, 1)), InputError);
}

TEST(Separator, OrientationAndUnitsDoNotMatter) {
  Polygon notched{{0, 4}, {4, 1}, {8, 4}, {8, 0}, {0, 0}}, wedge{{4, 2}, {6, 6}, {2, 6}};
  for (const double scale : {0x1p-300, 1e-9, 1.0, 1e9, 0x1p+300}) {
    Polygon p = notched, q = wedge;
    for (Polygon* polygon : {&p, &q}) {
      for (Point& v : *polygon) v = {scale * v.x, scale * v.y};
    }
    expect_exact(p, q, 2, false);
  }
}

TEST(Separator, OfMovingBodies) {
  const Scene scene = read_scene("examples/gears.json");
  for (const double t : {0.123, 0.0, 0.7}) {
    const Separator found = separator(scene, t);
    const auto bodies = placed(scene, t);
    EXPECT_TRUE(is_separator(found.minimum_link.vertices, found.minimum_link.closed, bodies[0], bodies[1]));
    EXPECT_EQ(found.minimum_link.lower, found.minimum_link.upper);
    EXPECT_GE(found.minimum_link.lower, 7);
    if (testing::watched) break;  // twenty seconds each
  }
  EXPECT_THROW(separator(scene, scene.end + 1), InputError);
}

}  // namespace
}  // namespace taut
