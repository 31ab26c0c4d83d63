// What a person should know of how a drawing was read: notes, lists of what was left out, and remedies.
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

std::string all_notes(const Import& import) {
  std::string all;
  for (const std::string& note : import.files.at(0).notes) all += note + "\n";
  return all;
}

bool tells(const Import& import, const std::string& text) { return all_notes(import).find(text) != std::string::npos; }

TEST(ImportNotes, TellOfContoursOnFilledShapesOfOtherBodies) {
  const Import plate = examine(
      "<svg><rect width='40' height='40'/><circle cx='20' cy='20' r='5' fill='none' stroke='red'/></svg>", "d.svg");
  EXPECT_EQ(plate.bodies.size(), 2u);
  EXPECT_TRUE(tells(plate, "it is a body of its own, not a hole")) << all_notes(plate);
  const Import filled = examine(
      "<svg><rect width='40' height='40' fill='none' stroke='red'/><circle cx='20' cy='20' r='5' fill='red'/></svg>",
      "d.svg");
  EXPECT_TRUE(tells(filled, "1 filled shape lies in a contour of another body")) << all_notes(filled);
  const Import beside = examine(
      "<svg><rect width='10' height='40'/><circle cx='20' cy='20' r='5' fill='none' stroke='red'/></svg>", "d.svg");
  EXPECT_EQ(all_notes(beside), "");
}

TEST(ImportNotes, TellOfTheBorderOfASheet) {
  DxfText sheet;
  sheet.box({-50, -50}, {250, 150}, "border").box({0, 0}, {20, 20}, "parts").circle({10, 10}, 3, "parts");
  EXPECT_TRUE(tells(examine(sheet), "layer border encloses all others")) << all_notes(examine(sheet));
  EXPECT_TRUE(tells(examine(sheet), "--layer \"parts\""));
  ImportSettings only;
  only.layers = {"parts"};
  const Import parts = examine(sheet, only);
  expect_totals(parts, 400 - 9 * 3.14159265, 1, 1, 0.2);
  EXPECT_FALSE(tells(parts, "encloses all others"));
  // With a title block, and holes on a layer of their own.
  DxfText titled;
  titled.box({-50, -50}, {250, 150}, "border")
      .box({150, -50}, {250, 0}, "border")
      .line({150, -20}, {250, -20}, "border");
  titled.box({0, 0}, {20, 20}, "parts").circle({10, 10}, 3, "holes");
  EXPECT_TRUE(tells(examine(titled), "--layer \"parts\" --layer \"holes\"")) << all_notes(examine(titled));
  only.layers = {"parts", "holes"};
  expect_totals(examine(titled, only), 400 - 9 * 3.14159265, 1, 1, 0.2);
  DxfText plate;
  plate.box({0, 0}, {20, 20}, "outer").circle({10, 10}, 3, "inner");
  EXPECT_FALSE(tells(examine(plate), "encloses all others")) << "a plate with a hole";
}

TEST(ImportNotes, FillingsApartFromAllLinesAreShapes) {
  DxfText text;
  text.box({0, 0}, {20, 20});
  text.begin("SOLID", "0").at(10, {100, 0}).at(11, {110, 0}).at(12, {100, 10}).at(13, {110, 10});
  expect_totals(examine(text), 500, 2, 0);
  text.begin("SOLID", "0").at(10, {5, 5}).at(11, {6, 5}).at(12, {5, 6}).at(13, {6, 6});
  expect_totals(examine(text), 500, 2, 0);
}

/// LibreCAD and QCAD draw a circle, ezdxf nothing.
TEST(ImportNotes, SayOfArcsThatEndAtTheirStartHowTheyAreRead) {
  DxfText text;
  text.box({0, 0}, {40, 40}).arc({10, 10}, 5, 30, 30);
  text.begin("ELLIPSE", "0").at(10, {30, 30}).at(11, {5, 0}).group(40, "0.5").group(41, "1").group(42, "1");
  const auto import = examine(text);
  testing::expect_totals(import, 1600 - 37.5 * 3.14159265, 1, 2, 0.5);
  ASSERT_EQ(import.files[0].notes.size(), 1u);
  EXPECT_NE(import.files[0].notes[0].find("2 arcs end at the angle of the start"), std::string::npos);
  // Where the end is a little behind the start, there is no doubt: a short arc, or nearly a full one.
  DxfText others;
  others.box({0, 0}, {40, 40}).arc({1e6, 10}, 1e6 - 50, 180, 180.0000001).arc({10, 10}, 5, 0, 360);
  EXPECT_TRUE(examine(others).files[0].notes.empty());
  testing::expect_totals(examine(others), 1600 - 25 * 3.14159265, 1, 1, 0.5);
}

}  // namespace
}  // namespace taut
