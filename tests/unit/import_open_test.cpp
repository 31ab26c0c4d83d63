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

}  // namespace
}  // namespace taut
