#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "support/svg_text.hpp"
#include "taut/io.hpp"

namespace taut {
namespace {

using testing::count;
using testing::well_formed;

/// Two triangles side by side with the three faces between them made up.
struct Picture {
  Scene scene;
  Tiling tiling;
};

Picture two_triangles(double scale = 1, double offset = 0) {
  Picture picture;
  picture.scene.bodies = {{"P & <co>", {{0, 0}, {2, 0}, {0, 2}}, {}}, {"Q", {{5, 0}, {5, 2}, {3, 2}}, {}}};
  picture.tiling.time = 0.25;
  for (int b = 0; b < 2; ++b) {
    for (int i = 0; i < 3; ++i) {
      const Point p = picture.scene.bodies[static_cast<std::size_t>(b)].polygon[static_cast<std::size_t>(i)];
      picture.tiling.vertices.push_back({{b, i}, {p.x * scale + offset, p.y * scale + offset}});
      picture.tiling.edges.push_back({3 * b + i, 3 * b + (i + 1) % 3, true, false});
    }
  }
  picture.tiling.edges.push_back({1, 3, false, true});
  picture.tiling.edges.push_back({2, 5, false, true});
  picture.tiling.faces = {{FaceKind::root, 0, 0, {1, 3, 5, 2}},
                          {FaceKind::infinite, 0, 0, {0, 2, 5, 4, 3, 1}},
                          {FaceKind::polygon_interior, 0, 0, {}}};
  return picture;
}

TEST(Svg, IsWellFormedAndNamesBodiesAndTime) {
  const Picture picture = two_triangles();
  Contact contact;
  contact.point = {2, 1};
  contact.normal = {1, 0};
  TilingDrawOptions options;
  options.contact = &contact;
  const std::string svg = draw_svg(picture.scene, picture.tiling, options);
  EXPECT_TRUE(well_formed(svg)) << svg;
  EXPECT_NE(svg.find("<title>P &amp; &lt;co&gt; and Q, t = 0.25</title>"), std::string::npos);
  EXPECT_NE(svg.find(">contact</text>"), std::string::npos);
}

TEST(Svg, PointsUp) {
  const Picture picture = two_triangles();
  const std::string svg = draw_svg(picture.scene, picture.tiling);
  // P's outline starts at the lower left: the largest y of all, at the left margin.
  const std::size_t start = svg.find("<path d=\"M24,", svg.find("fill=\"#ececec\""));
  ASSERT_NE(start, std::string::npos) << svg;
  const double y0 = std::stod(svg.substr(start + 13)),
               y1 = std::stod(svg.substr(svg.rfind(',', svg.find('Z', start)) + 1));
  EXPECT_GT(y0, y1);
}

TEST(Svg, OptionsLeaveThingsOut) {
  const Picture picture = two_triangles();
  const std::string all = draw_svg(picture.scene, picture.tiling);
  const std::string plain = draw_svg(picture.scene, picture.tiling, {.faces = false, .certificates = false});
  EXPECT_NE(all.find("convex corner"), std::string::npos);
  EXPECT_NE(all.find("#ececec"), std::string::npos);
  EXPECT_EQ(plain.find("convex corner"), std::string::npos);
  EXPECT_EQ(plain.find("#ececec"), std::string::npos);
  EXPECT_TRUE(well_formed(plain));
}

TEST(Svg, PathsLabelsAndWindow) {
  const Picture picture = two_triangles();
  GeodesicCycle cycle;
  cycle.body = 1;
  cycle.vertices = {3, 4, 5};
  cycle.pinned = {1};
  TilingDrawOptions options;
  options.title = "a < b";
  options.paths = {drawn_cycle(picture.tiling, cycle), {{{0, 0}, {1, 1}}, DrawnPath::Kind::separator, false, {}}};
  options.labels = {{{1, 1}, "u & v"}};
  const std::string whole = draw_svg(picture.scene, picture.tiling, options);
  EXPECT_TRUE(well_formed(whole)) << whole;
  EXPECT_NE(whole.find("<title>a &lt; b</title>"), std::string::npos);
  EXPECT_NE(whole.find(">geodesic of Q</text>"), std::string::npos);
  EXPECT_NE(whole.find(">separator</text>"), std::string::npos);
  EXPECT_NE(whole.find(">u &amp; v</text>"), std::string::npos);
  ASSERT_EQ(options.paths[0].stars.size(), 1u);
  EXPECT_EQ(options.paths[0].stars[0].x, 5);
  EXPECT_EQ(options.paths[0].stars[0].y, 2);
  options.legend = false;
  options.window = {{0, 0}, {1, 1}};
  const std::string part = draw_svg(picture.scene, picture.tiling, options);
  EXPECT_TRUE(well_formed(part));
  EXPECT_EQ(part.find(">separator</text>"), std::string::npos);
  // P's corner at (2, 0) lies outside the window, to the right of the picture.
  EXPECT_NE(part.find("L1528,"), std::string::npos) << part;
}

TEST(Svg, StaysSmallForManyVertices) {
  Picture picture;
  picture.scene.bodies = {{"P", Polygon(10000), {}}, {"Q", {{5, 0}, {5, 2}, {3, 2}}, {}}};
  for (int i = 0; i < 10000; ++i) {
    picture.tiling.vertices.push_back({{0, i}, {std::cos(i * 1e-3), std::sin(i * 1e-3)}});
    picture.tiling.edges.push_back({i, (i + 1) % 10000, i % 2 == 0, i % 3 == 0});
    if (i % 3 == 0) picture.tiling.faces.push_back({FaceKind::node, 0, i % 14, {i, (i + 1) % 10000, (i + 2) % 10000}});
  }
  const std::string svg = draw_svg(picture.scene, picture.tiling);
  EXPECT_LT(count(svg, "<"), 80u);
  EXPECT_LT(svg.size(), 900000u);
}

TEST(Svg, SurvivesExtremeAndEmptyInput) {
  for (double scale : {0.0, 1e-300, 1e-9, 1e300, 3e307}) {
    const Picture picture = two_triangles(scale, scale == 1e-9 ? 1e6 : 0);
    const std::string svg = draw_svg(picture.scene, picture.tiling);
    EXPECT_TRUE(well_formed(svg));
    EXPECT_EQ(svg.find("nan"), std::string::npos) << scale;
    EXPECT_EQ(svg.find("inf"), std::string::npos) << scale;
  }
  EXPECT_TRUE(well_formed(draw_svg({}, {})));
}

}  // namespace
}  // namespace taut
