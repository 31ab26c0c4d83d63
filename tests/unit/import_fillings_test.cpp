// Filled shapes that repeat what lines of another layer enclose.
#include <gtest/gtest.h>

#include "support/drawings.hpp"

namespace taut {
namespace {

using drawing::Import;
using drawing::ImportSettings;
using testing::DxfText;
using testing::examine;
using testing::expect_totals;

using Rings = std::vector<std::vector<Point>>;

std::vector<Point> square(double low, double high) { return {{low, low}, {high, low}, {high, high}, {low, high}}; }

void add_hatch(DxfText& text, const Rings& rings, const std::string& layer) {
  text.begin("HATCH", layer).at(10, {0, 0}).group(30, "0").group(2, "ANSI31").group(70, "0");
  text.group(91, std::to_string(rings.size()));
  for (const std::vector<Point>& ring : rings) {
    text.group(92, "7").group(72, "0").group(73, "1").group(93, std::to_string(ring.size()));
    for (const Point& p : ring) text.at(10, p);
    text.group(97, "0");
  }
  text.group(75, "0").group(76, "1");
}

/// A square plate with a square hole on layer CUT, and a hatch on layer SECTION.
Import hatched(const Rings& rings, const ImportSettings& settings = {}) {
  DxfText text;
  text.box({0, 0}, {40, 40}, "CUT").polyline(square(10, 20), true, "CUT");
  add_hatch(text, rings, "SECTION");
  return examine(text, settings);
}

TEST(ImportFillings, ThatFollowContoursOfAnotherLayerAreTheSamePart) {
  const Import import = hatched({square(0, 40), square(10, 20)});
  expect_totals(import, 1500, 1, 1);
  ASSERT_EQ(import.files[0].notes.size(), 1u);
  EXPECT_NE(import.files[0].notes[0].find("layer SECTION: 1 filled shape follows contours of layer CUT"),
            std::string::npos);
  // Other vertices, and ends that do not quite meet, make no difference.
  expect_totals(hatched({{{0, 0}, {17, 0.001}, {40, 0}, {40, 40}, {0, 40}}, square(10, 20)}), 1500, 1, 1);
  // Where the hatch goes over the hole, the lines count.
  const Import covering = hatched({square(0, 40)});
  expect_totals(covering, 1500, 1, 1);
  EXPECT_NE(covering.files[0].notes[0].find("holes that are covered are holes"), std::string::npos);
}

TEST(ImportFillings, ThatLinesDoNotEncloseAreBodies) {
  expect_totals(hatched({square(10, 20)}), 1500 + 100, 2, 1);
  expect_totals(hatched({square(0, 41)}), 1500 + 41 * 41, 2, 1);
  expect_totals(hatched({{{0, 0}, {40, 0}, {0, 40}}}), 1500 + 800, 2, 1);
  ImportSettings settings;
  settings.by = drawing::Grouping::layer;
  expect_totals(hatched({square(0, 40), square(10, 20)}, settings), 3000, 2, 2);
  settings.by = drawing::Grouping::automatic;
  settings.layers = {"SECTION"};
  expect_totals(hatched({square(0, 40), square(10, 20)}, settings), 1500, 1, 1);
}

TEST(ImportFillings, OfGroupsOfSvgMayHaveNoName) {
  const Import import = examine(
      "<svg><g><rect width='40' height='40'/></g><g fill='none' stroke='red'><rect width='40' height='40'/>"
      "<circle cx='20' cy='20' r='5'/></g></svg>",
      "d.svg");
  expect_totals(import, 1600 - 25 * 3.14159265, 1, 1, 0.5);
  ASSERT_EQ(import.files[0].notes.size(), 1u);
  EXPECT_NE(import.files[0].notes[0].find("layer without a name: 1 filled shape"), std::string::npos);
}

TEST(ImportFillings, ThatAreDrawnTwiceAreNamed) {
  const auto notes = [](const std::string& second) {
    return examine("<svg><g id='a'><rect width='40' height='40'/></g><g id='b'>" + second + "</g></svg>", "d.svg")
        .files[0]
        .notes;
  };
  ASSERT_EQ(notes("<path d='M40 0H0V40H20H40Z'/>").size(), 1u);
  EXPECT_NE(notes("<path d='M40 0H0V40H20H40Z'/>")[0].find("1 filled shape is that of another layer or group again"),
            std::string::npos);
  EXPECT_TRUE(notes("<path d='M40 0H0V40Z'/>").empty());
  EXPECT_TRUE(notes("<path fill-rule='evenodd' d='M40 0H0V40H40ZM5 5H9V9H5Z'/>").empty());
}

}  // namespace
}  // namespace taut
