// Closed contours that cross each other: cuts, tabs, or a mistake.
#include <gtest/gtest.h>

#include "support/drawings.hpp"

namespace taut {
namespace {

using drawing::Crossing;
using drawing::Import;
using drawing::ImportSettings;
using testing::DxfText;
using testing::examine;
using testing::expect_totals;

ImportSettings with(Crossing crossing) {
  ImportSettings settings;
  settings.crossing = crossing;
  return settings;
}

std::vector<Point> box(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

/// A plate of 40 by 40 with a hole of 4 by 4, and a slot of 4 by 20 across its upper edge.
DxfText keyway() {
  DxfText text;
  text.box({0, 0}, {40, 40}).polyline(box(10, 10, 4, 4), true).polyline(box(18, 30, 4, 20), true);
  return text;
}

TEST(ImportCrossing, IsAnErrorUnlessItIsSaidWhatBecomesOfIt) {
  const Import import = examine(keyway());
  ASSERT_EQ(import.faults.size(), 1u);
  const std::string problem = import.faults[0].problem();
  for (const char* said : {"(area 80)", "(area 1600)", "with 40 in common", "near (18, 40)"})
    EXPECT_NE(problem.find(said), std::string::npos) << problem;
  EXPECT_NE(import.faults[0].hint().find("--crossing subtract"), std::string::npos);
  expect_totals(examine(keyway(), with(Crossing::subtract)), 1600 - 16 - 40, 1, 1);
  expect_totals(examine(keyway(), with(Crossing::unite)), 1600 - 16 + 40, 1, 1);
  expect_totals(examine(keyway(), with(Crossing::parts)), 1600 - 16 + 40, 3, 1);
  ASSERT_EQ(examine(keyway(), with(Crossing::subtract)).files[0].notes.size(), 1u);
}

TEST(ImportCrossing, TakesCutsOutOfWhateverTheyCross) {
  // A slot across two plates, and a smaller slot across the first one.
  DxfText text;
  text.polyline(box(0, 0, 30, 30), true).polyline(box(40, 0, 31, 30), true);
  text.polyline(box(20, 10, 30, 4), true).polyline(box(22, 8, 2, 8), true);
  expect_totals(examine(text, with(Crossing::subtract)), 900 + 930 - 80 - 8, 2, 0);
  // One that shares a part of the edge is a cut as well; a plate that shares a side is none.
  DxfText notch;
  notch.polyline(box(0, 0, 20, 20), true).polyline(box(20, 0, 30, 20), true).polyline(box(0, 5, 5, 5), true);
  expect_totals(examine(notch, with(Crossing::subtract)), 1000 - 25, 2, 0);
  expect_totals(examine(notch, with(Crossing::unite)), 1000, 2, 0);
  expect_totals(examine(notch), 1000, 3, 0);
  EXPECT_NE(examine(notch).files[0].notes.at(0).find("the smallest one 25"), std::string::npos);
}

TEST(ImportCrossing, OfContoursThatAreAlikeNoneIsTheSmallerOne) {
  DxfText cross;
  cross.polyline(box(0, 4, 10, 2), true).polyline(box(4, 0, 2, 10), true);
  expect_totals(examine(cross, with(Crossing::parts)), 36, 5, 0);
  expect_totals(examine(cross, with(Crossing::unite)), 36, 1, 0);
  const Import import = examine(cross, with(Crossing::subtract));
  ASSERT_EQ(import.faults.size(), 1u);
  EXPECT_NE(import.faults[0].problem().find("neither is the smaller one"), std::string::npos);
}

TEST(ImportCrossing, IsOneHoleInMaterial) {
  DxfText text;
  text.polyline(box(0, 4, 10, 2), true).polyline(box(4, 0, 2, 10), true).box({-5, -5}, {15, 15});
  for (const Crossing crossing : {Crossing::error, Crossing::subtract, Crossing::unite, Crossing::parts})
    expect_totals(examine(text, with(crossing)), 400 - 36, 1, 1);
  EXPECT_NE(examine(text).files[0].notes.at(0).find("are one hole"), std::string::npos);
}

TEST(ImportCrossing, NothingCrossesThatIsDrawnTwiceOrFilled) {
  DxfText twice;
  twice.polyline(box(0, 0, 30, 30), true).polyline(box(0, 0, 30, 30), true).polyline({{0, 0}, {30, 0}}, false);
  twice.circle({50, 50}, 5).circle({50, 50}, 5);
  expect_totals(examine(twice), 900 + 25 * 3.14159265, 2, 0, 0.5);
  const Import filled = examine("<svg><path fill-rule='nonzero' d='M0 0H6V6H0ZM4 4H10V10H4Z'/></svg>", "d.svg");
  expect_totals(filled, 68, 1, 0);
}

}  // namespace
}  // namespace taut
