// Which layers are read together: holes on other layers, and layers that cross or have lines in common.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>

#include "support/drawings.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

using drawing::Import;
using drawing::ImportSettings;
using testing::DxfText;
using testing::examine;
using testing::expect_totals;

using Entity = std::function<void(DxfText&)>;

Entity box(const Point& low, const Point& high, const std::string& layer) {
  return [=](DxfText& text) { text.polyline({low, {high.x, low.y}, high, {low.x, high.y}}, true, layer); };
}

/// The four sides, one by one.
void add_sides(std::vector<Entity>& all, const Point& low, const Point& high, const std::string& layer) {
  const Point corners[] = {low, {high.x, low.y}, high, {low.x, high.y}};
  for (int k = 0; k < 4; ++k) {
    const Point a = corners[k], b = corners[(k + 1) % 4];
    all.push_back([=](DxfText& text) { text.line(a, b, layer); });
  }
}

std::map<std::string, double> areas_of(const Import& import) {
  std::map<std::string, double> areas;
  for (const drawing::BodyReport& body : import.bodies) areas[body.name] += body.area;
  return areas;
}

Import read(const std::vector<Entity>& entities, const ImportSettings& settings = {}) {
  DxfText text;
  for (const Entity& entity : entities) entity(text);
  return examine(text, settings);
}

/// In all orders of up to five entities, in a hundred orders of more.
void expect_areas(std::vector<Entity> entities, const std::map<std::string, double>& areas,
                  const ImportSettings& settings = {}) {
  std::vector<std::size_t> order(entities.size());
  std::iota(order.begin(), order.end(), 0);
  std::uint64_t state = 1;
  for (int round = 0; round < 120; ++round) {
    std::vector<Entity> shuffled;
    for (const std::size_t k : order) shuffled.push_back(entities[k]);
    const Import import = read(shuffled, settings);
    ASSERT_TRUE(import.faults.empty()) << import.faults.front().what();
    ASSERT_EQ(areas_of(import), areas) << drawing::report_text(import, {});
    if (entities.size() <= 5) {
      if (!std::next_permutation(order.begin(), order.end())) return;
      continue;
    }
    for (std::size_t i = order.size(); i > 1; --i) {
      state = state * 6364136223846793005u + 1442695040888963407u;
      std::swap(order[i - 1], order[(state >> 33) % i]);
    }
  }
}

TEST(ImportLayers, TakesContoursOnOtherLayersForHoles) {
  DxfText layers;
  layers.box({0, 0}, {20, 20}, "outer")
      .circle({5, 5}, 2, "inner")
      .circle({15, 5}, 2, "inner")
      .box({30, 0}, {40, 10}, "inner");
  const double holes = 8 * 3.14159265;
  const Import import = examine(layers);
  expect_totals(import, 500 - holes, 2, 2, 0.2);
  EXPECT_EQ(import.bodies.size(), 2u);
  ASSERT_EQ(import.files[0].notes.size(), 1u);
  EXPECT_NE(import.files[0].notes[0].find("layer inner: 2 contours are holes"), std::string::npos);
  ImportSettings settings;
  settings.by = drawing::Grouping::layer;
  expect_totals(examine(layers, settings), 500 + holes, 4, 0, 0.2);
  settings.by = drawing::Grouping::nesting;
  const Import nested = examine(layers, settings);
  expect_totals(nested, 500 - holes, 2, 2, 0.2);
  EXPECT_EQ(nested.bodies.size(), 2u);
  settings = {};
  settings.merge_all = true;
  const Import merged = examine(layers, settings);
  expect_totals(merged, 500 - holes, 2, 2, 0.2);
  EXPECT_EQ(merged.bodies.size(), 1u);
  settings = {};
  settings.layers = {"inner"};
  expect_totals(examine(layers, settings), 100 + holes, 3, 0, 0.2);
  settings.layers = {"iner"};
  EXPECT_THROW(examine(layers, settings), InputError);
}

TEST(ImportLayers, JoinsAnOutlineWhosePiecesAreOnDifferentLayers) {
  DxfText spread;
  spread.line({0, 0}, {20, 0}, "a")
      .line({20, 0}, {20, 20}, "b")
      .line({20, 20}, {0, 20}, "a")
      .line({0, 20}, {0, 0}, "c");
  spread.circle({10, 10}, 4, "d");
  expect_totals(examine(spread), 400 - 16 * 3.14159265, 1, 1, 0.3);
}

TEST(ImportLayers, KeepsLayersThatCrossApart) {
  DxfText crossing;
  crossing.box({0, 0}, {20, 20}, "base").box({15, 5}, {30, 10}, "arm");
  const Import import = examine(crossing);
  expect_totals(import, 475, 2, 0);
  EXPECT_EQ(import.bodies.size(), 2u);
  crossing.box({4, 4}, {8, 8}, "pin").box({5, 5}, {6, 6}, "pin");
  // A hole in the base, as it would be if nothing crossed, and an island in it; and a body beside them.
  crossing.box({40, 0}, {42, 2}, "pin");
  const Import with_hole = examine(crossing);
  expect_totals(with_hole, 475 - 16 + 1 + 4, 4, 1);
  EXPECT_EQ(with_hole.files[0].notes.size(), 2u);
  ImportSettings settings;
  settings.by = drawing::Grouping::layer;
  expect_totals(examine(crossing, settings), 475 + 16 - 1 + 4, 4, 1);
}

TEST(ImportLayers, RefusesAContourInMaterialOfTwoLayersThatCross) {
  for (const bool within_both : {true, false}) {
    DxfText unclear;
    unclear.box({0, 0}, {20, 20}, "base").box({15, 5}, {30, 10}, "arm");
    // In both of them, or around them.
    if (within_both)
      unclear.box({16, 6}, {18, 8}, "pin");
    else
      unclear.box({-10, -10}, {40, 40}, "frame");
    const Import import = examine(unclear);
    ASSERT_EQ(import.faults.size(), 1u);
    EXPECT_NE(import.faults[0].hint().find("--by layer"), std::string::npos);
  }
}

TEST(ImportLayers, GroupsByColor) {
  DxfText colors;
  for (const int color : {1, 3, 1}) {
    const double x = 10.0 * color + (color == 1 ? 0 : 7);
    colors.begin("CIRCLE", "0").group(62, std::to_string(color)).at(10, {x, 0}).group(40, "2");
  }
  ImportSettings settings;
  settings.by = drawing::Grouping::color;
  const Import import = examine(colors, settings);
  ASSERT_EQ(import.bodies.size(), 2u);
  EXPECT_EQ(import.bodies[0].name, "color 1");
  EXPECT_EQ(import.bodies[1].name, "color 3");
  const std::string svg =
      "<svg><g fill='none'><rect width='9' height='9' stroke='red'/><rect x='20' width='9' height='9' "
      "style='stroke:#00f'/><rect x='2' y='2' width='2' height='2' stroke='red'/></g></svg>";
  const Import by_stroke = examine(svg, "d.svg", settings);
  ASSERT_EQ(by_stroke.bodies.size(), 2u);
  EXPECT_EQ(by_stroke.bodies[0].name, "red");
  EXPECT_EQ(by_stroke.bodies[0].area, 77);
}

TEST(ImportLayers, NeighboursThatShareASideKeepTheirSquares) {
  std::vector<Entity> squares;
  add_sides(squares, {0, 0}, {10, 10}, "A");
  add_sides(squares, {10, 0}, {20, 10}, "B");
  add_sides(squares, {20, 0}, {30, 10}, "C");
  expect_areas(squares, {{"A", 100}, {"B", 100}, {"C", 100}});
  const Import import = read(squares);
  ASSERT_EQ(import.files[0].notes.size(), 1u);
  EXPECT_NE(import.files[0].notes[0].find("share a part of a line"), std::string::npos) << import.files[0].notes[0];
  EXPECT_NE(import.files[0].notes[0].find("and 1 other pair do"), std::string::npos) << import.files[0].notes[0];
  // Sides of different lengths, which share parts only.
  std::vector<Entity> steps;
  add_sides(steps, {0, 0}, {10, 10}, "A");
  add_sides(steps, {10, 3}, {20, 25}, "B");
  expect_areas(steps, {{"A", 100}, {"B", 220}});
}

TEST(ImportLayers, APegThatFillsItsHoleStays) {
  const std::vector<Entity> plate{box({0, 0}, {50, 50}, "PLATE"), box({10, 10}, {20, 20}, "PLATE"),
                                  box({10, 10}, {20, 20}, "PEG")};
  expect_areas(plate, {{"PLATE", 2400}, {"PEG", 100}});
}

/// Is it a notch, or a body that overlaps?
TEST(ImportLayers, AskWhereAnOutlineInAnotherOneSharesASide) {
  const std::vector<Entity> notch{box({0, 0}, {50, 50}, "BOX"), box({10, 0}, {20, 20}, "PEG")};
  for (const std::vector<Entity>& entities : {notch, {notch[1], notch[0]}}) {
    const Import import = read(entities);
    ASSERT_EQ(import.faults.size(), 1u);
    const std::string what = import.faults[0].what();
    EXPECT_NE(what.find("layer PEG has an outline (area 200) within layer BOX (area 2500)"), std::string::npos) << what;
    EXPECT_NE(what.find("--by layer"), std::string::npos) << what;
  }
  ImportSettings apart;
  apart.by = drawing::Grouping::layer;
  expect_areas(notch, {{"BOX", 2500}, {"PEG", 200}}, apart);
  ImportSettings merged;
  merged.merge_all = true;
  EXPECT_TRUE(read(notch, merged).faults.empty());
  const std::vector<Entity> twice{box({0, 0}, {50, 50}, "one"), box({0, 0}, {50, 50}, "two")};
  EXPECT_EQ(read(twice).faults.size(), 1u);
}

/// A layer that needs the lines of another one is read with it, whatever the order; its areas have the name of the
/// layer that has most of the outline.
TEST(ImportLayers, ThatDoNotCloseAloneAreReadTogether) {
  std::vector<Entity> squares;
  add_sides(squares, {0, 0}, {10, 10}, "A");
  squares.push_back([](DxfText& text) { text.polyline({{10, 0}, {20, 0}, {20, 10}, {10, 10}}, false, "B"); });
  expect_areas(squares, {{"A", 100}, {"B", 100}});
}

TEST(ImportLayers, ThatTouchAtAPointAreReadTogether) {
  const std::vector<Entity> hole{box({0, 0}, {20, 20}, "outer"), [](DxfText& text) {
                                   text.polyline({{0, 10}, {5, 5}, {10, 10}, {5, 15}}, true, "inner");
                                 }};
  expect_areas(hole, {{"outer", 350}});
}

/// Bends and centre lines have layers of their own. They must not make bodies of the holes that they cross.
TEST(ImportLayers, MarksChangeNothing) {
  constexpr double disc = 25 * 3.14159265;
  for (const auto& ends : std::vector<std::pair<Point, Point>>{{{0, 30}, {100, 30}},
                                                               {{22, 30}, {38, 30}},
                                                               {{-5, 30}, {105, 30}},
                                                               {{1, 30}, {99, 30}},
                                                               {{30, 0}, {30, 35}}}) {
    const Point from = ends.first, to = ends.second;
    std::vector<Entity> plate{box({0, 0}, {100, 60}, "CUT"),
                              [](DxfText& text) {
                                text.circle({30, 30}, 5, "HOLES");
                              },
                              [=](DxfText& text) { text.line(from, to, "MARK"); }};
    for (int round = 0; round < 3; ++round) {
      const Import import = read(plate);
      expect_totals(import, 6000 - disc, 1, 1, 0.3);
      // Lines that join the two are read with them, and change nothing either.
      const bool joins = to.y != from.y;
      EXPECT_EQ(drawing::report_text(import, {}).find("layer MARK encloses nothing") == std::string::npos, joins);
      std::rotate(plate.begin(), plate.begin() + 1, plate.end());
    }
  }
  // An outline whose sides are on layers of their own is none of them, closed or not.
  std::vector<Entity> sides{[](DxfText& text) { text.circle({30, 30}, 5, "HOLES"); }};
  const Point corners[] = {{0, 0}, {100, 0}, {100, 60}, {0, 60}};
  for (int k = 0; k < 4; ++k)
    sides.push_back([=](DxfText& text) {
      text.line(corners[k], corners[(k + 1) % 4], std::string(1, static_cast<char>('a' + k)));
    });
  expect_totals(read(sides), 6000 - disc, 1, 1, 0.3);
  sides.pop_back();
  sides.push_back([=](DxfText& text) { text.line(corners[3], {0, 0.4}, "d"); });
  EXPECT_FALSE(read(sides).faults.empty());
}

TEST(ImportLayers, WithoutANameAreCalledByTheirPlaces) {
  const Import import = examine(
      "<svg fill='none' stroke='red'><circle r='20'/>\n<rect x='-2' y='-30' width='4' height='20'/></svg>", "d.svg");
  ASSERT_EQ(import.files[0].notes.size(), 1u);
  EXPECT_NE(import.files[0].notes[0].find("layers at d.svg:1:31 and at d.svg:2:1 cross near"), std::string::npos)
      << import.files[0].notes[0];
}

}  // namespace
}  // namespace taut
