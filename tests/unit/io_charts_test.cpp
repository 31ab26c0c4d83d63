// Charts over time: what is in them, and where.
#include <gtest/gtest.h>

#include <regex>

#include "draw/svg_canvas.hpp"
#include "io/text.hpp"
#include "taut/clearance.hpp"
#include "taut/intervals.hpp"
#include "taut/io.hpp"

namespace taut {
using namespace internal;
namespace {

Scene charted_scene() {
  Scene scene;
  scene.end = 10;
  for (const char* name : {"a", "b<", "c"}) {
    Body body;
    body.name = name;
    scene.bodies.push_back(body);
  }
  return scene;
}

int times_in(const std::string& text, const std::string& what) {
  int n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

TEST(Charts, InstantsCanBeToldApartLongAfterTimeZero) {
  EXPECT_EQ(io::instant_text(0.25, 0, 10, 6), "0.25");
  EXPECT_EQ(io::instant_text(3.5765178123, 0, 10, 6), "3.57652");
  EXPECT_EQ(io::instant_text(1790000003.576518, 1790000000, 1790000010, 6), "1790000003.5765");
  const io::PlotPanel panel{0, 0, 600, 100, 1790000000, 1790000010, 0, 1};
  const std::string axis = panel.time_axis("t");
  for (const char* const tick : {">1790000000<", ">1790000002<", ">1790000010<"})
    EXPECT_NE(axis.find(tick), std::string::npos) << tick;
  // So long a name does not fit ten times.
  EXPECT_EQ(axis.find(">1790000001<"), std::string::npos);
}

TEST(Charts, RoundNumbers) {
  EXPECT_EQ(io::round_numbers(0, 10, 5), (std::vector<double>{0, 2, 4, 6, 8, 10}));
  EXPECT_EQ(io::round_numbers(-1.5, 1.7, 4), (std::vector<double>{-1, 0, 1}));
  EXPECT_EQ(io::round_numbers(3, 3, 4), (std::vector<double>{3}));
  for (const double hi : {1e-300, 0.0031, 7.7, 99.0, 1e200}) {
    const auto numbers = io::round_numbers(0, hi, 8);
    EXPECT_GE(numbers.size(), 3u) << hi;
    EXPECT_LE(numbers.size(), 9u) << hi;
    EXPECT_LE(numbers.back(), hi * (1 + 1e-9)) << hi;
  }
}

TEST(Charts, LanesOfOverlaps) {
  const Scene scene = charted_scene();
  Intervals answer;
  Contact contact;
  answer.intervals.push_back({{0, 1}, {0, 0}, {2.5, 2.5}, {}, contact});
  answer.intervals.push_back({{0, 1}, {5, 5}, {7.5, 7.5}, contact, contact});
  answer.intervals.push_back({{0, 2}, {9, 9}, {10, 10}, contact, {}});
  answer.undecided.push_back({{1, 2}, Outcome::undecided, {}, 4, "too hard"});
  const std::string svg = intervals_svg(scene, answer, Touch::closed, 800);
  EXPECT_EQ(times_in(svg, "class=\"lane\""), 3);
  EXPECT_EQ(times_in(svg, "class=\"overlap\""), 3);
  // Four ends are enclosed, and two are those of the scene's time.
  EXPECT_EQ(times_in(svg, "class=\"end\""), 4);
  EXPECT_EQ(times_in(svg, "class=\"open\""), 2);
  EXPECT_EQ(times_in(svg, "url(#hatched)"), 1);
  EXPECT_NE(svg.find("a x b&lt;"), std::string::npos);
  EXPECT_NE(svg.find("5 to 7.5"), std::string::npos);
  // The bar from 5 to 7.5 is a quarter of the axis, and begins in its middle.
  std::smatch axis, bar;
  ASSERT_TRUE(std::regex_search(svg, axis, std::regex("<path d=\"M([0-9.]+),[0-9.]+h([0-9.]+)\"")));
  const std::string rest = svg.substr(svg.find("overlap from t = 5 "));
  ASSERT_TRUE(std::regex_search(rest, bar, std::regex("<rect x=\"([0-9.]+)\" y=\"[0-9.]+\" width=\"([0-9.]+)\"")));
  const double left = std::stod(axis[1]), width = std::stod(axis[2]);
  EXPECT_NEAR(std::stod(bar[1]), left + width / 2, 0.02);
  EXPECT_NEAR(std::stod(bar[2]), width / 4, 0.02);
  EXPECT_NE(intervals_svg(scene, {}, Touch::open).find("no tested pair overlaps"), std::string::npos);
}

/// Pictures claim no more than answers do: two bodies that overlap at rest are not tested, and a third one moves.
TEST(Charts, SayWhatWasNotTested) {
  Scene scene;
  scene.end = 1;
  const Polygon square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  scene.bodies = {{"a", square, {}}, {"b", square, {}}, {"c", {{5, 0}, {6, 0}, {6, 1}}, {}}};
  scene.bodies[2].motion.pieces.push_back({});
  scene.bodies[2].motion.pieces[0].x = {0, 1};
  const auto pictures = [&] {
    return std::vector<std::string>{intervals_svg(scene, intervals(scene), Touch::open),
                                    range_svg(scene, 0.5, range(scene, 0.5)),
                                    profile_svg(scene, distance_profile(scene)), clearance_svg(scene, clearance(scene)),
                                    margin_svg(scene, 0.5, check_clearance(scene, 0.5))};
  };
  for (const std::string& svg : pictures()) EXPECT_NE(svg.find("; 1 pair not tested"), std::string::npos) << svg;
  scene.ignore = {{"c", "*"}, {"a", "b"}};
  for (const std::string& svg : pictures()) {
    EXPECT_NE(svg.find("; nothing was tested"), std::string::npos) << svg;
    for (const char* const claim : {"no tested pair overlaps", "all keep", "undecided"})
      EXPECT_EQ(svg.find(claim), std::string::npos) << svg;
  }
}

DistanceProfile some_profile() {
  DistanceProfile answer;
  DistanceCurve curve;
  curve.pair = {{0, 1}};
  curve.instants = {{0, 1, 1}, {5, 4, 4}, {10, 2, 2}};
  curve.stretches = {{0, 5, 1, 4.5}, {5, 10, 1.5, 4.25}};
  curve.largest_lo = curve.largest_hi = 4;
  curve.largest_at = 5;
  curve.settled = true;
  answer.curves = {curve};
  curve.pair.reset();
  answer.curves.push_back(curve);
  return answer;
}

TEST(Charts, CurvesOfDistance) {
  const Scene scene = charted_scene();
  const std::string svg = profile_svg(scene, some_profile(), 800);
  EXPECT_EQ(times_in(svg, "class=\"curve\""), 2);
  EXPECT_NE(svg.find("a x b&lt;"), std::string::npos);
  EXPECT_NE(svg.find("least distance of all pairs"), std::string::npos);
  std::smatch line, dot;
  ASSERT_TRUE(std::regex_search(
      svg, line, std::regex("class=\"distance\" d=\"M([0-9.]+),([0-9.]+)L([0-9.]+),([0-9.]+)L([0-9.]+),([0-9.]+)\"")));
  const auto number = [&](std::size_t i) { return std::stod(line[i]); };
  EXPECT_NEAR(number(3), (number(1) + number(5)) / 2, 0.02);
  // Up by 3, down by 2.
  EXPECT_NEAR((number(2) - number(4)) * 2, (number(6) - number(4)) * 3, 0.1);
  ASSERT_TRUE(std::regex_search(svg, dot, std::regex("class=\"largest\" cx=\"([0-9.]+)\" cy=\"([0-9.]+)\"")));
  EXPECT_NEAR(std::stod(dot[1]), number(3), 0.02);
  EXPECT_NEAR(std::stod(dot[2]), number(4), 0.02);
}

TEST(Charts, OfALateProfileSayWhenItIsGreatest) {
  Scene late = charted_scene();
  late.start = 1790000000;
  late.end = late.start + 10;
  DistanceProfile profile = some_profile();
  profile.curves[0].largest_at = late.start + 5;
  EXPECT_NE(profile_svg(late, profile, 800).find("at t = 1790000005<"), std::string::npos);
}

TEST(Charts, ProfileAsValues) {
  Scene scene = charted_scene();
  scene.bodies[0].name = "with \"quotes\", and a comma";
  EXPECT_EQ(profile_csv(scene, some_profile()),
            "first,second,t,lo,hi,until_lo,until_hi\n"
            "\"with \"\"quotes\"\", and a comma\",b<,0,1,1,1,4.5\n"
            "\"with \"\"quotes\"\", and a comma\",b<,5,4,4,1.5,4.25\n"
            "\"with \"\"quotes\"\", and a comma\",b<,10,2,2,,\n"
            ",,0,1,1,1,4.5\n,,5,4,4,1.5,4.25\n,,10,2,2,,\n");
  EXPECT_NE(profile_json(scene, some_profile()).find("\"largest\":{\"lo\":4,\"hi\":4,\"t\":5,\"settled\":true}"),
            std::string::npos);
}

}  // namespace
}  // namespace taut
