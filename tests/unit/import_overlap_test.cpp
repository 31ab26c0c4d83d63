// Parts of one body that lie on each other.
#include <gtest/gtest.h>

#include "support/drawings.hpp"

namespace taut {
namespace {

using drawing::Import;
using testing::examine;

struct Area {
  double area, overlap;
};

void expect_area(const std::string& text, const std::string& file, const Area& wanted, double within = 1e-9) {
  const Import import = examine(text, file);
  ASSERT_TRUE(import.faults.empty()) << text;
  ASSERT_EQ(import.bodies.size(), 1u) << text;
  EXPECT_NEAR(import.bodies[0].area, wanted.area, within) << text;
  EXPECT_NEAR(import.bodies[0].overlap, wanted.overlap, within) << text;
  const std::string report = report_text(import, {});
  EXPECT_EQ(report.find("parts overlap by") != std::string::npos, wanted.overlap > 0) << report;
}

std::string svg_group(const std::string& inside) { return "<svg><g id='a'>" + inside + "</g></svg>"; }

TEST(ImportOverlap, GivesTheAreaOfTheUnion) {
  const std::string square = "<rect width='4' height='4'/>";
  expect_area(svg_group(square), "d.svg", {16, 0});
  expect_area(svg_group(square + square), "d.svg", {16, 16});
  expect_area(svg_group(square + "<rect x='3' width='4' height='4'/>"), "d.svg", {28, 4});
  expect_area(svg_group(square + "<rect x='4' width='4' height='4'/>"), "d.svg", {32, 0});
  expect_area(svg_group(square + "<rect x='1' y='1' width='2' height='2'/><rect x='2' y='2' width='5' height='1'/>"),
              "d.svg", {16 + 3, 4 + 2});
  // What lies in a hole is not on material.
  const std::string frame = "<path fill-rule='evenodd' d='M0 0H9V9H0ZM2 2H7V7H2Z'/>";
  expect_area(svg_group(frame + "<rect x='3' y='3' width='2' height='2'/>"), "d.svg", {60, 0});
  expect_area(svg_group(frame + "<rect x='3' y='3' width='6' height='2'/>"), "d.svg", {56 + 8, 4});
  expect_area("POLYGON((0 0,4 0,4 4,0 4))\nPOLYGON((2 2,5 2,5 5,2 5))", "d.wkt", {21, 4});
  expect_area("MULTIPOLYGON(((0 0,4 0,4 4,0 4)),((4 0,5 0,5 5)))", "d.wkt", {18.5, 0});
  expect_area("{\"type\":\"MultiPolygon\",\"coordinates\":[[[[0,0],[4,0],[4,4],[0,4]]],[[[2,2],[5,2],[5,5],[2,5]]]]}",
              "d.json", {21, 4});
}

TEST(ImportOverlap, IsNoHoleInThePicture) {
  const Import import =
      examine(svg_group("<rect width='9' height='9'/><rect x='2' y='2' width='3' height='3'/>"), "d.svg");
  const std::string picture = report_svg(import);
  std::size_t paths = 0;
  for (std::size_t at = 0; (at = picture.find("<path d=", at)) != std::string::npos; ++at) ++paths;
  EXPECT_EQ(paths, 2u) << picture;
}

TEST(ImportOverlap, SaysHowLinesOnFilledShapesAreRead) {
  const auto notes = [](const std::string& inside) { return examine(svg_group(inside), "d.svg").files[0].notes; };
  const std::string rect = "<rect width='9' height='9' ", circle = "<circle cx='4' cy='4' r='2' ",
                    line = "fill='none' stroke='red'/>";
  expect_area(svg_group(rect + "/>" + circle + line), "d.svg", {81, 12.5}, 0.1);
  ASSERT_EQ(notes(rect + "/>" + circle + line).size(), 1u);
  EXPECT_NE(notes(rect + "/>" + circle + line)[0].find("1 contour drawn as a line lies in a filled shape"),
            std::string::npos);
  ASSERT_EQ(notes(rect + line + circle + "/>").size(), 1u);
  EXPECT_NE(notes(rect + line + circle + "/>")[0].find("1 filled shape lies in a contour drawn as a line"),
            std::string::npos);
  // A white disc on a black plate, say.
  ASSERT_EQ(notes(rect + "/>" + circle + "/>").size(), 1u);
  EXPECT_NE(notes(rect + "/>" + circle + "/>")[0].find("1 filled shape lies in another one"), std::string::npos);
  EXPECT_TRUE(notes(rect + "/>" + rect + "/>").empty());
  EXPECT_TRUE(notes(rect + line + circle + line).empty());
  EXPECT_TRUE(notes(rect + "/><circle cx='20' cy='4' r='2' " + line).empty());
}

}  // namespace
}  // namespace taut
