// Layers whose lines meet only at vertices.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "support/drawings.hpp"

namespace taut {
namespace {

using drawing::Import;
using testing::DxfText;
using testing::examine;

DxfText with_box() {
  DxfText text;
  return text.polyline({{0, 0}, {50, 0}, {50, 50}, {0, 50}}, true, "box");
}

void expect_kept(const DxfText& text, const std::map<std::string, double>& areas, const std::string& note) {
  const Import import = examine(text);
  ASSERT_TRUE(import.faults.empty()) << import.faults.front().what();
  std::map<std::string, double> found;
  for (const drawing::BodyReport& body : import.bodies) found[body.name] += body.area;
  ASSERT_EQ(found.size(), areas.size());
  for (const auto& [name, area] : areas) EXPECT_NEAR(found[name], area, 1e-9) << drawing::report_text(import, {});
  EXPECT_NE(drawing::report_text(import, {}).find(note), std::string::npos) << drawing::report_text(import, {});
}

TEST(ImportLayerTouch, LayersThatCrossAtVerticesKeepTheirAreas) {
  expect_kept(with_box().polyline({{15, 50}, {25, 40}, {35, 50}, {25, 60}}, true, "peg"), {{"box", 2500}, {"peg", 200}},
              "layers box and peg cross");
  // Of lines one by one, whose ends lie on the box.
  DxfText lines = with_box();
  const std::vector<Point> ring{{20, 45}, {30, 45}, {30, 50}, {30, 55}, {20, 55}, {20, 50}};
  for (std::size_t i = 0; i < ring.size(); ++i) lines.line(ring[i], ring[(i + 1) % ring.size()], "peg");
  expect_kept(lines, {{"box", 2500}, {"peg", 100}}, "layers box and peg cross");
  // At vertices of both.
  expect_kept(with_box().polyline({{0, 50}, {50, 0}, {60, 60}}, true, "peg"), {{"box", 2500}, {"peg", 1750}},
              "layers box and peg cross");
}

/// A circle has a vertex where it begins, and opposite if its chords are even in number.
TEST(ImportLayerTouch, CirclesAroundAPointOfAnEdgeDivideNothing) {
  const Import import = examine(with_box().circle({25, 50}, 5, "peg"));
  ASSERT_TRUE(import.faults.empty());
  ASSERT_EQ(import.bodies.size(), 2u);
  EXPECT_EQ(import.bodies[0].area, 2500);
  EXPECT_EQ(import.bodies[1].parts, 1u);
}

TEST(ImportLayerTouch, AContourThatTouchesTheOtherAtSeveralPointsMayBeAHoleOrABody) {
  const Import import = examine(with_box().polyline({{25, 0}, {50, 25}, {25, 50}, {0, 25}}, true, "peg"));
  ASSERT_FALSE(import.faults.empty());
  EXPECT_NE(std::string(import.faults[0].what()).find("is it a hole or a body"), std::string::npos);
  drawing::ImportSettings apart;
  apart.by = drawing::Grouping::layer;
  EXPECT_TRUE(examine(with_box().polyline({{25, 0}, {50, 25}, {25, 50}, {0, 25}}, true, "peg"), apart).faults.empty());
}

TEST(ImportLayerTouch, AtOnePointAHoleIsAHoleAndANeighbourABody) {
  const Import hole = examine(with_box().polyline({{0, 25}, {10, 20}, {10, 30}}, true, "peg"));
  ASSERT_TRUE(hole.faults.empty()) << hole.faults.front().what();
  EXPECT_EQ(testing::totals_of(hole).area, 2450);
  expect_kept(with_box().polyline({{50, 25}, {60, 20}, {60, 30}}, true, "peg"), {{"box", 2500}, {"peg", 50}},
              "body peg");
}

}  // namespace
}  // namespace taut
