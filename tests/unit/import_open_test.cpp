// Lines that stay open: those that seem meant to be closed are an error, the others are listed.
#include <gtest/gtest.h>

#include "support/drawings.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

using drawing::Import;
using drawing::ImportSettings;
using testing::DxfText;
using testing::examine;
using testing::expect_totals;
using testing::totals_of;

DxfText broken_outline() {
  DxfText broken;
  broken.line({0, 0}, {20, 0})
      .line({20, 0}, {20, 20})
      .line({20, 20}, {0.5, 20})
      .line({0, 20}, {0, 0})
      .circle({10, 10}, 4);
  return broken;
}

TEST(ImportOpen, RefusesAnOutlineThatStaysOpen) {
  const Import import = examine(broken_outline());
  ASSERT_EQ(import.faults.size(), 1u);
  EXPECT_NE(import.faults[0].problem().find("a gap of 0.5 from (0"), std::string::npos) << import.faults[0].what();
  EXPECT_NE(import.faults[0].hint().find("--join 0.505"), std::string::npos) << import.faults[0].what();
  ASSERT_EQ(import.files[0].open.size(), 1u);
  EXPECT_EQ(import.files[0].open[0].points.size(), 5u);
  EXPECT_NEAR(import.files[0].open[0].gap_start, 0.5, 1e-12);
  EXPECT_NE(drawing::report_svg(import).find("#d62828"), std::string::npos);
  ImportSettings settings;
  settings.join = 0.51;
  expect_totals(examine(broken_outline(), settings), 400 - 16 * 3.14159265, 1, 1, 5.5);
  settings = {};
  settings.open = drawing::OpenRings::close;
  const Import closed = examine(broken_outline(), settings);
  expect_totals(closed, 400 - 16 * 3.14159265, 1, 1, 0.4);
  EXPECT_EQ(closed.files[0].closed.size(), 1u);
  settings.open = drawing::OpenRings::skip;
  expect_totals(examine(broken_outline(), settings), 16 * 3.14159265, 1, 0, 0.4);
}

TEST(ImportOpen, SeesThatFourLinesWithGapsWereAnOutline) {
  DxfText corners;
  corners.line({0.3, 0}, {19.7, 0}).line({20, 0.3}, {20, 19.7}).line({19.7, 20}, {0.3, 20}).line({0, 19.7}, {0, 0.3});
  corners.circle({10, 10}, 4).line({100, 0}, {120, 7});
  const Import import = examine(corners);
  ASSERT_EQ(import.faults.size(), 1u);
  EXPECT_NE(import.faults[0].problem().find("and 3 gaps more"), std::string::npos) << import.faults[0].what();
  EXPECT_EQ(import.files[0].open.size(), 5u);
}

/// Three sides of a plate: to leave them out would make a disc of its hole.
TEST(ImportOpen, RefusesAnOpenOutlineAroundAHoleWhateverTheGap) {
  DxfText plate;
  plate.polyline({{0, 0}, {0, 40}, {100, 40}, {100, 0}}, false).circle({50, 20}, 8);
  const Import import = examine(plate);
  ASSERT_EQ(import.faults.size(), 1u);
  EXPECT_NE(import.faults[0].hint().find("--open close"), std::string::npos) << import.faults[0].what();
  EXPECT_EQ(import.faults[0].hint().find("--join"), std::string::npos) << "it would swallow the hole";
  ImportSettings settings;
  settings.open = drawing::OpenRings::close;
  expect_totals(examine(plate, settings), 4000 - 64 * 3.14159265, 1, 1, 0.5);
  // In a plate that is closed, such lines may be engraved.
  plate.box({-5, -5}, {105, 45});
  EXPECT_TRUE(examine(plate).faults.empty());
}

TEST(ImportOpen, LeavesOutOpenLinesThatEncloseNothing) {
  DxfText marks;
  marks.box({0, 0}, {20, 20}).line({3, 3}, {3, 9}).line({4, 17}, {4, 9}).arc({16, 10}, 2, 30, 270);
  // A hinge: many cuts, whose ends are as near to each other as to others.
  for (int k = 0; k < 6; ++k) marks.line({6.0 + k, 0}, {6.0 + k, 8}).line({6.0 + k, 9}, {6.0 + k, 20});
  const Import import = examine(marks);
  expect_totals(import, 400, 1, 0);
  EXPECT_EQ(import.files[0].open.size(), 15u);
}

/// Copies of one side that cross are two slivers, which are narrower than lines that count as one. They must not take
/// the side with them.
TEST(ImportOpen, ASideDrawnTwiceIsStillASide) {
  for (const bool closed : {true, false}) {
    DxfText text;
    text.line({-40, -40}, {40, -40}).line({40, 40}, {-40, 40}).line({-40, 40}, {-40, closed ? -40 : -39.7});
    text.line({40, -40}, {40, 40}).line({40.002, -40}, {39.998, 40}).box({10, 10}, {20, 20});
    const Import import = examine(text);
    if (closed) {
      expect_totals(import, 6300, 1, 1, 0.5);
    } else {
      EXPECT_EQ(import.faults.size(), 1u) << drawing::report_text(import, {});
      ImportSettings settings;
      settings.open = drawing::OpenRings::close;
      expect_totals(examine(text, settings), 6300, 1, 1, 0.5);
    }
  }
  // Of a line that is free at one end, too.
  DxfText text;
  text.line({-40, -40}, {40, -40}).line({40, -40}, {40, 40}).line({40, 40}, {-40, 40}).box({10, 10}, {20, 20});
  text.line({-40, 40}, {-40, -39.7}).line({-40.002, 40}, {-39.998, -39.7});
  EXPECT_EQ(examine(text).faults.size(), 1u);
}

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

/// Two sides of a plate, whose others are hidden or missing.
TEST(ImportOpen, LinesMayBeTheOutlineOfWhatLiesPartlyInTheirHull) {
  const auto sides = [] { return DxfText().line({0, 0}, {100, 0}).line({100, 0}, {100, 60}); };
  for (const Point& centre : {Point{50, 30}, {52, 35}, {60, 20}}) {
    const Import import = examine(sides().circle(centre, 5));
    ASSERT_EQ(import.faults.size(), 1u) << centre.x;
    EXPECT_NE(import.faults[0].problem().find("in it"), std::string::npos) << import.faults[0].problem();
  }
  // A long piece may cross the hull, and have no vertex in it.
  EXPECT_EQ(examine(sides().polyline({{20, 50}, {95, 10}, {96, 12}, {21, 52}}, true)).faults.size(), 1u);
  // Beyond it, or where the line hangs on it, it is no part of that.
  EXPECT_TRUE(examine(sides().circle({20, 45}, 5)).faults.empty());
  EXPECT_TRUE(examine(DxfText().box({0, 0}, {40, 40}).polyline({{40, 20}, {60, 20}, {60, 50}, {30, 50}}, false))
                  .faults.empty());
}

TEST(ImportOpen, LinesThatGoOnHiddenAreAnError) {
  const auto file = [](DxfText text) {
    std::string all = text.file();
    const std::string layer = "0\nSECTION\n2\nTABLES\n0\nLAYER\n2\nHID\n70\n1\n62\n7\n0\nENDSEC\n";
    return all.insert(all.find("0\nSECTION\n2\nENTITIES"), layer);
  };
  const auto half = [] { return DxfText().circle({20, 45}, 5).line({0, 0}, {100, 0}).line({100, 0}, {100, 60}); };
  // In one piece, or in two.
  for (const DxfText& text : {half().polyline({{100, 60.001}, {0, 60}, {0, 0}}, false, "HID"),
                              half().line({100, 60}, {0, 60}, "HID").line({0, 60}, {0, 0}, "HID")}) {
    const Import import = examine(file(text), "d.dxf");
    ASSERT_EQ(import.faults.size(), 1u);
    EXPECT_NE(import.faults[0].problem().find("where lines go on that are not visible"), std::string::npos);
    EXPECT_NE(import.faults[0].hint().find("make these lines visible"), std::string::npos);
  }
  // Where only one end goes on, or in material, nothing is missing.
  EXPECT_TRUE(examine(file(half().line({100, 60}, {0, 60}, "HID")), "d.dxf").faults.empty());
  DxfText bend;
  bend.box({0, 0}, {40, 40}).line({5, 20}, {35, 20}).line({5, 20}, {5, 30}, "HID").line({35, 20}, {35, 30}, "HID");
  EXPECT_TRUE(examine(file(bend), "d.dxf").faults.empty());
  const std::string unseen = "<path d='M 100 60 H 0 V 0' display='none'/>";
  const Import svg = examine(
      "<svg fill='none' stroke='red'><circle cx='20' cy='45' r='5'/><path d='M 0 0 H 100 V 60'/>" + unseen + "</svg>",
      "d.svg");
  ASSERT_EQ(svg.faults.size(), 1u);
  EXPECT_NE(svg.faults[0].problem().find("<path> at d.svg:1:"), std::string::npos) << svg.faults[0].problem();
  ImportSettings settings;
  settings.open = drawing::OpenRings::skip;
  EXPECT_TRUE(
      examine(file(half().polyline({{100, 60}, {0, 60}, {0, 0}}, false, "HID")), "d.dxf", settings).faults.empty());
}

/// Axes beside a part could be two sides of its outline.
TEST(ImportOpen, AxesAroundAPartAreNamedWithARemedy) {
  const auto axes = [] {
    return DxfText().box({0, 0}, {40, 30}).circle({10, 10}, 3).line({-10, -10}, {90, -10}).line({-10, -10}, {-10, 80});
  };
  const Import import = examine(axes());
  ASSERT_EQ(import.faults.size(), 1u);
  EXPECT_EQ(import.faults[0].hint(),
            "if it is an axis or a mark, leave it out with --open skip; else draw what is missing");
  ImportSettings settings;
  settings.open = drawing::OpenRings::skip;
  expect_totals(examine(axes(), settings), 1200 - 9 * 3.14159265, 1, 1, 0.5);
}

/// Nothing lies in an outline that a slot crosses, and its gap is short all the same.
TEST(ImportOpen, RefusesAnOutlineThatASlotCrosses) {
  DxfText text;
  text.polyline({{0, 10.5}, {0, 20}, {20, 20}, {20, 0}, {0, 0}, {0, 10}}, false).box({18, 3}, {22, 5});
  const Import import = examine(text);
  ASSERT_EQ(import.faults.size(), 1u);
  EXPECT_NE(import.faults[0].problem().find("a gap of 0.5 from (0"), std::string::npos) << import.faults[0].what();
  ImportSettings settings;
  settings.open = drawing::OpenRings::close;
  settings.crossing = drawing::Crossing::subtract;
  expect_totals(examine(text, settings), 396, 1, 0, 0.5);
  // Another gap between the two.
  DxfText twice;
  twice.polyline({{0, 10.5}, {0, 20}, {20, 20}, {20, 0}, {12, 0}}, false);
  twice.polyline({{11.75, 0}, {0, 0}, {0, 10}}, false).box({18, 3}, {22, 5});
  ASSERT_EQ(examine(twice).faults.size(), 1u);
  expect_totals(examine(twice, settings), 396, 1, 0, 0.5);
  // Two straight lines at a plate's side are no tab.
  DxfText lines;
  lines.box({0, 0}, {20, 20}).line({20, 8}, {25, 8}).line({20, 10}, {25, 10});
  EXPECT_TRUE(examine(lines).faults.empty());
}

/// Slots across the outline cut it into several lines. Its gap is between the two ends that meet nothing, and is closed
/// there, not from one of them to a slot.
TEST(ImportOpen, ClosesTheGapOfAnOutlineThatSlotsCross) {
  const auto slotted = [](int slots) {
    DxfText text = broken_outline();
    for (int k = 0; k < slots; ++k) text.box({18, 3.0 + 8 * k}, {22, 5.0 + 8 * k});
    return text;
  };
  for (const int slots : {1, 2}) {
    SCOPED_TRACE(slots);
    const Import open = examine(slotted(slots));
    ASSERT_FALSE(open.faults.empty());
    EXPECT_NE(open.faults[0].problem().find("a gap of 0.5 from (0"), std::string::npos) << open.faults[0].what();
    ImportSettings settings;
    settings.open = drawing::OpenRings::close;
    settings.crossing = drawing::Crossing::subtract;
    const Import closed = examine(slotted(slots), settings);
    EXPECT_TRUE(closed.files[0].open.empty());
    expect_totals(closed, 400 - 4 * slots - 16 * 3.14159265, 1, 1, 0.5);
  }
}

}  // namespace
}  // namespace taut
