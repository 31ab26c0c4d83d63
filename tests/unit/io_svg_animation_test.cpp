// Pictures that move: what browsers demand of SMIL, and that bodies are where the frames say.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "support/svg_text.hpp"
#include "taut/io.hpp"
#include "taut/motions.hpp"

namespace taut {
namespace {

using testing::animations;
using testing::attribute;
using testing::split;

const Polygon centred_square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

Scene turning_scene() {
  return {0, 1, {{"P & <co>", centred_square, {}}, {"Q", centred_square, from_velocity({4, 0}, 720)}}};
}

/// P rests at the origin; Q goes right from x = 3 and turns. One edge joins them, to another vertex in the second half.
std::vector<Tiling> frames(int count) {
  std::vector<Tiling> all;
  for (int k = 0; k < count; ++k) {
    const double t = static_cast<double>(k) / (count - 1), a = radians(720 * t);
    Tiling tiling;
    tiling.time = t;
    for (int i = 0; i < 4; ++i) tiling.vertices.push_back({{0, i}, centred_square[static_cast<std::size_t>(i)]});
    for (int i = 0; i < 4; ++i) {
      const Point& v = centred_square[static_cast<std::size_t>(i)];
      tiling.vertices.push_back(
          {{1, i}, {3 + 4 * t + std::cos(a) * v.x - std::sin(a) * v.y, std::sin(a) * v.x + std::cos(a) * v.y}});
    }
    tiling.edges = {{0, 1, true, false}, {1, t < 0.5 ? 4 : 5, false, true}};
    all.push_back(tiling);
  }
  return all;
}

TEST(SvgAnimation, HasTimesAndValuesInPairs) {
  for (const int count : {2, 3, 40}) {
    const auto all = animations(animate_svg(turning_scene(), frames(count)));
    ASSERT_GE(all.size(), 3u);
    for (const std::string& element : all) {
      const auto times = split(attribute(element, "keyTimes"), ';'), values = split(attribute(element, "values"), ';');
      EXPECT_EQ(times.size(), values.size()) << element;
      EXPECT_EQ(times.front(), "0") << element;
      if (attribute(element, "calcMode") != "discrete") {
        EXPECT_EQ(times.back(), "1") << element;
      }
      for (std::size_t k = 1; k < times.size(); ++k) EXPECT_LE(std::stod(times[k - 1]), std::stod(times[k])) << element;
      EXPECT_EQ(attribute(element, "dur"), "8s") << element;
    }
  }
}

TEST(SvgAnimation, TurnsAllTheWayAndLeavesWhatRests) {
  const std::string svg = animate_svg(turning_scene(), frames(41));
  std::vector<std::string> turns;
  for (const std::string& element : animations(svg)) {
    if (attribute(element, "type") == "rotate") turns = split(attribute(element, "values"), ';');
  }
  ASSERT_FALSE(turns.empty());
  EXPECT_EQ(turns.front(), "0.00");
  // Counterclockwise is negative where y points down. Two whole turns, not none.
  EXPECT_EQ(turns.back(), "-720.00");
  // One translation and one turn: P rests.
  std::size_t transforms = 0;
  for (const std::string& element : animations(svg)) transforms += attribute(element, "attributeName") == "transform";
  EXPECT_EQ(transforms, 2u);
}

TEST(SvgAnimation, JumpsWhereTheTilingChanges) {
  std::vector<std::string> times, values;
  for (const std::string& element : animations(animate_svg(turning_scene(), frames(41)))) {
    if (attribute(element, "attributeName") != "d") continue;
    times = split(attribute(element, "keyTimes"), ';');
    values = split(attribute(element, "values"), ';');
  }
  ASSERT_FALSE(times.empty());
  int jumps = 0;
  for (std::size_t k = 1; k < times.size(); ++k) jumps += times[k] == times[k - 1] && values[k] != values[k - 1];
  EXPECT_EQ(jumps, 1);
}

TEST(SvgAnimation, MarksTheContactAtTheEnd) {
  AnimateOptions options;
  const std::string without = animate_svg(turning_scene(), frames(5), options);
  EXPECT_EQ(without.find("<circle"), std::string::npos);
  EXPECT_EQ(without.find("<script"), std::string::npos);
  EXPECT_NE(without.find("onclick=\"this.animationsPaused()"), std::string::npos);
  EXPECT_NE(without.find("prefers-reduced-motion"), std::string::npos);
  EXPECT_NE(without.find("P &amp; &lt;co&gt;"), std::string::npos);
  const Contact contact{{1, 1}, {1, 0}, {0, 1}, {1, 0}, {1, 0}};
  options.contact = &contact;
  options.ending = "contact at <1>";
  const std::string with = animate_svg(turning_scene(), frames(5), options);
  EXPECT_NE(with.find("<circle"), std::string::npos);
  EXPECT_NE(with.find("contact at &lt;1&gt;"), std::string::npos);
}

}  // namespace
}  // namespace taut
