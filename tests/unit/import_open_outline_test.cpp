// Outlines that stay open although something closed lies in them.
#include <gtest/gtest.h>

#include "support/drawings.hpp"

namespace taut {
namespace {

using drawing::Import;
using drawing::ImportSettings;
using testing::DxfText;
using testing::examine;
using testing::totals_of;

DxfText three_sides(bool hole = true) {
  DxfText text;
  text.line({0, 0}, {0, 40}).line({0, 40}, {100, 40}).line({100, 40}, {100, 0});
  if (hole) text.circle({50, 20}, 5);
  return text;
}

std::string only_fault(const Import& import) {
  EXPECT_EQ(import.faults.size(), 1u);
  return import.faults.empty() ? "" : std::string(import.faults[0].what()) + import.faults[0].hint();
}

TEST(ImportOpen, OutlinesAroundHolesAreErrorsHoweverWideTheirGapIs) {
  const std::string fault = only_fault(examine(three_sides()));
  EXPECT_NE(fault.find("an outline stays open, with a gap of 100"), std::string::npos) << fault;
  EXPECT_NE(fault.find("what is closed at"), std::string::npos) << fault;
  EXPECT_EQ(fault.find("--join"), std::string::npos) << fault;
  ImportSettings close;
  close.open = drawing::OpenRings::close;
  const Import closed = examine(three_sides(), close);
  ASSERT_TRUE(closed.faults.empty());
  EXPECT_NEAR(totals_of(closed).area, 4000 - 78.5, 0.5);
  ImportSettings skip;
  skip.open = drawing::OpenRings::skip;
  EXPECT_TRUE(examine(three_sides(), skip).faults.empty());
}

/// Also where other lines are nearer to the ends than these are to each other.
TEST(ImportOpen, OutlinesAreErrorsBesideOtherOpenLines) {
  DxfText text = three_sides();
  text.line({0, -3}, {20, -3}).line({80, -3}, {100, -3});
  EXPECT_NE(only_fault(examine(text)).find("stays open"), std::string::npos);
  // Two brackets.
  DxfText brackets;
  brackets.polyline({{20, 0}, {0, 0}, {0, 40}, {20, 40}}, false)
      .polyline({{80, 0}, {100, 0}, {100, 40}, {80, 40}}, false);
  EXPECT_NE(only_fault(examine(brackets.circle({50, 20}, 5))).find("stays open"), std::string::npos);
  // One end lies on another line.
  DxfText hung = three_sides();
  EXPECT_NE(only_fault(examine(hung.line({90, 0}, {130, 0}))).find("stays open"), std::string::npos);
}

TEST(ImportOpen, LinesThatMarkAreNone) {
  DxfText plate;
  plate.polyline({{-10, -10}, {110, -10}, {110, 50}, {-10, 50}}, true).circle({50, 20}, 5);
  // Engraved in the plate, around the hole.
  plate.line({0, 0}, {0, 40}).line({0, 40}, {100, 40}).line({100, 40}, {100, 0});
  const Import import = examine(plate);
  ASSERT_TRUE(import.faults.empty()) << import.faults[0].what();
  EXPECT_NEAR(totals_of(import).area, 7200 - 78.5, 0.5);
}

DxfText& damaged_spline(DxfText& text, const Point& a, const Point& b) {
  text.begin("SPLINE", "0").group(70, "8").group(71, "3").group(72, "3").group(73, "2");
  return text.group(40, "0").group(40, "0").group(40, "1").at(10, a).at(10, b);
}

TEST(ImportOpen, LinesThatEndAtWhatWasNotReadMayBeOutlines) {
  DxfText text = three_sides(false);
  damaged_spline(text, {0, 0}, {100, 0}).circle({300, 20}, 5);
  const std::string fault = only_fault(examine(text));
  EXPECT_NE(fault.find("SPLINE"), std::string::npos) << fault;
  EXPECT_NE(fault.find("ends open there, at ("), std::string::npos) << fault;
  DxfText around = three_sides();
  EXPECT_FALSE(examine(damaged_spline(around, {0, 0}, {100, 0})).faults.empty());
  DxfText apart = three_sides(false);
  EXPECT_TRUE(examine(damaged_spline(apart, {0, 100}, {100, 100}).circle({300, 20}, 5)).faults.empty());
}

/// A distance of joining that would eat what is drawn is no remedy.
TEST(ImportOpen, JoiningIsARemedyWhereItSparesTheRest) {
  DxfText wide;
  wide.polyline({{0, 5}, {0, 40}, {40, 40}, {40, 0}, {0, 0}}, false).circle({20, 20}, 2);
  const std::string fault = only_fault(examine(wide));
  EXPECT_EQ(fault.find("--join"), std::string::npos) << fault;
  EXPECT_NE(fault.find("--open close"), std::string::npos) << fault;
  DxfText narrow;
  narrow.polyline({{0, 0.5}, {0, 40}, {40, 40}, {40, 0}, {0, 0}}, false).circle({20, 20}, 2);
  EXPECT_NE(only_fault(examine(narrow)).find("--join 0.505"), std::string::npos);
}

}  // namespace
}  // namespace taut
