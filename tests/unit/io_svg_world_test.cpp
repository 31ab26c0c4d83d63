// Pictures of worlds: all bodies where their chains of parents put them, holes, marks, and a legend that can be read.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "support/svg_text.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/motions.hpp"
#include "taut/pose.hpp"

namespace taut {
namespace {

using testing::animations;
using testing::attribute;
using testing::count;
using testing::split;
using testing::well_formed;

const Polygon unit_block{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

Body named(const std::string& name, const Polygon& polygon, const Motion& motion = {}) {
  Body body;
  body.name = name;
  body.polygon = polygon;
  body.motion = motion;
  return body;
}

Polygon moved(Polygon polygon, double x, double y) {
  for (Point& p : polygon) p = {p.x + x, p.y + y};
  return polygon;
}

/// A room, a turning crank in it, and a rod on the crank, which the file names first.
Scene crank_scene() {
  Scene scene;
  scene.end = 1;
  Body rod = named("rod", {{5, -0.5}, {9, -0.5}, {9, 0.5}, {5, 0.5}}, from_velocity({0, 0}, -90, {5, 0}));
  rod.relative_to = "crank <&>";
  Body room;
  room.name = "room";
  room.parts = {
      {moved({{-20, -20}, {20, -20}, {20, 20}, {-20, 20}}, 0, 0), {{{-18, -18}, {18, -18}, {18, 18}, {-18, 18}}}}};
  scene.bodies = {rod, named("crank <&>", {{0, -1}, {5, -1}, {5, 1}, {0, 1}}, from_velocity({0, 0}, 90)), room};
  scene.ignore = {{"rod", "crank <&>"}, {"room", "*"}};
  return scene;
}

TEST(PosesAt, MultipliesParentsIn) {
  const Scene scene = crank_scene();
  const std::vector<BodyPose> poses = poses_at(scene, 1);
  ASSERT_EQ(poses.size(), 3U);
  // The crank has turned by a right angle, its end from (5, 0) to (0, 5); the rod has turned back by as much about it.
  EXPECT_NEAR(poses[1].axis.x, 0, 1e-15);
  EXPECT_NEAR(poses[1].axis.y, 1, 1e-15);
  EXPECT_NEAR(poses[0].axis.x, 1, 1e-15);
  EXPECT_NEAR(poses[0].axis.y, 0, 1e-15);
  EXPECT_NEAR(poses[0].origin.x, -5, 1e-14);
  EXPECT_NEAR(poses[0].origin.y, 5, 1e-14);
  EXPECT_EQ(poses[2].origin, Point{});
  EXPECT_EQ(poses[2].axis, (Point{1, 0}));
}

TEST(PosesAt, RefusesParentsThatAreNotThereOrNeverEnd) {
  Scene scene = crank_scene();
  scene.bodies[0].relative_to = "craank";
  EXPECT_THROW(poses_at(scene, 0), InputError);
  scene.bodies[0].relative_to = "crank <&>";
  scene.bodies[1].relative_to = "rod";
  EXPECT_THROW(poses_at(scene, 0), InputError);
}

TEST(SvgWorld, DrawsEveryBodyAndLeavesHolesOpen) {
  const std::string svg = draw_svg(crank_scene(), 0.5);
  EXPECT_TRUE(well_formed(svg)) << svg;
  EXPECT_NE(svg.find("<title>rod, crank &lt;&amp;&gt;, room, t = 0.5</title>"), std::string::npos) << svg;
  EXPECT_EQ(count(svg, "fill-rule=\"evenodd\""), 3U);
  // The room is painted first, as one path of two rings.
  const std::size_t first = svg.find("<path d=\"") + 9;
  const std::string room = svg.substr(first, svg.find('"', first) - first);
  EXPECT_EQ(count(room, "Z"), 2U) << room;
}

TEST(SvgWorld, DrawsPartsThatOverlapAsOne) {
  Scene scene = crank_scene();
  scene.bodies[1].parts = {{unit_block, {}}, {moved(unit_block, 1, 0), {}}};
  scene.bodies[1].polygon.clear();
  const std::string svg = draw_svg(scene, 0);
  EXPECT_TRUE(well_formed(svg));
  // Each part is a path of its own, or what both cover would be left open; then the lines inside are covered.
  EXPECT_EQ(count(svg, "<path"), 6U);
  EXPECT_EQ(count(svg, "stroke=\"none\""), 2U);
}

TEST(SvgWorld, SaysWhoIsWhoseParentAndWhatIsIgnored) {
  const std::string svg = draw_svg(crank_scene(), 0);
  EXPECT_NE(svg.find("ignored (2): rod x crank &lt;&amp;&gt;, room x every other body"), std::string::npos) << svg;
  // The rod comes below the crank, one step to the right.
  const std::size_t crank = svg.find(">crank &lt;&amp;&gt;</text>"), rod = svg.find(">rod</text>");
  ASSERT_NE(crank, std::string::npos);
  ASSERT_NE(rod, std::string::npos);
  EXPECT_LT(crank, rod);
  const auto place = [&](std::size_t text) { return split(svg.substr(svg.rfind("translate(", text) + 10, 20), ' '); };
  EXPECT_EQ(std::stod(place(rod)[0]), std::stod(place(crank)[0]) + 14);
  EXPECT_EQ(std::stod(place(rod)[1]), std::stod(place(crank)[1]) + 18);
}

TEST(SvgWorld, CountsWhatIsTooMuchToList) {
  Scene scene;
  scene.end = 1;
  for (int i = 0; i < 75; ++i) {
    scene.bodies.push_back(named("body " + std::to_string(i), moved(unit_block, 3 * (i % 10), 3 * (i / 10))));
    if (i > 0) scene.ignore.push_back({"body 0", "body " + std::to_string(i)});
  }
  const std::string svg = draw_svg(scene, 0);
  EXPECT_TRUE(well_formed(svg));
  EXPECT_EQ(count(svg, "fill-rule=\"evenodd\""), 75U);
  EXPECT_EQ(count(svg, "</text></g>\n") - count(svg, "font-size=\"11\""), 0U);
  EXPECT_NE(svg.find("and 15 more bodies"), std::string::npos);
  EXPECT_NE(svg.find("ignored (74): "), std::string::npos);
  EXPECT_NE(svg.find("and 66 more"), std::string::npos);
  EXPECT_EQ(svg.find(">body 60<"), std::string::npos);
  const double height = std::stod(attribute(svg.substr(0, svg.find('>')), "height"));
  EXPECT_LT(height, 1300);
}

/// A number over another body would be read as that one's; in a hole of that body it is seen.
TEST(SvgWorld, WritesNoNumberOverAnotherBody) {
  Scene scene;
  scene.end = 1;
  Body frame;
  frame.name = "frame";
  frame.parts = {{{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}, {{{-4, -4}, {4, -4}, {4, 4}, {-4, 4}}}}};
  frame.motion = from_velocity({20, 0});
  scene.bodies = {named("low", {{-3, -3}, {3, -3}, {3, 3}, {-3, 3}}), frame};
  scene.bodies[0].z = {0, 1};
  scene.bodies[1].z = {1, 2};
  const auto numbers = [&](double t) {
    const std::string picture = draw_svg(scene, t);
    return std::array{count(picture, "text-anchor=\"middle\" font-size=\"11\" fill=\"#fff\">1<"),
                      count(picture, "text-anchor=\"middle\" font-size=\"11\" fill=\"#000\">2<")};
  };
  // In the picture and in the legend; the frame covers the other body as it passes, from 4 to 9 to its right.
  const auto seen = numbers(0), covered = numbers(0.325), passed = numbers(1);
  EXPECT_EQ(seen, passed);
  EXPECT_EQ(covered[0] + 1, seen[0]);
  EXPECT_EQ(covered[1], seen[1]);
}

TEST(SvgWorld, NamesThePairThatMeetsOrOverlaps) {
  DrawOptions options;
  Contact contact;
  contact.vertex = {0, 1};
  contact.edge = {2, 1, 0, 1};
  contact.point = {18, 0};
  contact.normal = {-1, 0};
  options.contacts = {contact};
  const std::string met = draw_svg(crank_scene(), 0, options);
  EXPECT_TRUE(well_formed(met));
  EXPECT_NE(met.find(">contact: rod x room<"), std::string::npos) << met;
  options.contacts.clear();
  options.overlaps = {{0, 1}};
  const std::string overlapping = draw_svg(crank_scene(), 0, options);
  EXPECT_NE(overlapping.find(">overlap: rod x crank &lt;&amp;&gt;<"), std::string::npos);
}

TEST(SvgWorldAnimation, MovesChildrenWithTheirParents) {
  AnimateOptions options;
  options.frames = 5;
  options.ending = "free <all>";
  Scene scene = crank_scene();
  // Ten turns between two frames are still ten turns.
  scene.bodies[1].motion = from_velocity({0, 0}, 4 * 360);
  const std::string svg = animate_svg(scene, 1, options);
  EXPECT_TRUE(well_formed(svg));
  EXPECT_NE(svg.find("free &lt;all&gt;"), std::string::npos);
  EXPECT_NE(svg.find("prefers-reduced-motion"), std::string::npos);
  // Green is a claim.
  EXPECT_EQ(svg.find("#138a4e"), std::string::npos);
  options.free = true;
  EXPECT_NE(animate_svg(scene, 1, options).find("#138a4e"), std::string::npos);
  std::vector<std::string> ends;
  for (const std::string& element : animations(svg)) {
    const auto values = split(attribute(element, "values"), ';'), times = split(attribute(element, "keyTimes"), ';');
    EXPECT_EQ(times.size(), values.size()) << element;
    if (attribute(element, "type") == "rotate") ends.push_back(values.back());
  }
  // Larger bodies first: the crank, then the rod, which turns back by a right angle meanwhile.
  EXPECT_EQ(ends, (std::vector<std::string>{"-1440.00", "-1350.00"}));
}

/// Q goes right and turns. One line joins the bodies, to another vertex of Q in the second half.
TEST(SvgWorldAnimation, LinesOfTilingsMoveAndJumpWhereTheTilingChanges) {
  const Polygon square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const Scene scene{0, 1, {{"P", square, {}}, {"Q", square, {{{{3, 4}, {}, AngleRotation{{0, 12.566370614359172}}}}}}}};
  for (const int count : {2, 3, 41}) {
    AnimateOptions options;
    options.frames = count;
    options.tilings = [](double t) {
      return std::vector<NearTiling>{{{0, 1}, false, {{{0, 1}, {1, t < 0.5 ? 0 : 1}, true}}}};
    };
    const std::string svg = animate_svg(scene, 1, options);
    EXPECT_TRUE(well_formed(svg));
    std::vector<std::string> times, values;
    for (const std::string& element : animations(svg)) {
      if (attribute(element, "attributeName") != "d") continue;
      times = split(attribute(element, "keyTimes"), ';');
      values = split(attribute(element, "values"), ';');
    }
    ASSERT_EQ(times.size(), values.size());
    ASSERT_FALSE(times.empty());
    EXPECT_EQ(times.front(), "0");
    EXPECT_EQ(times.back(), "1");
    int jumps = 0;
    for (std::size_t k = 1; k < times.size(); ++k) {
      EXPECT_LE(std::stod(times[k - 1]), std::stod(times[k]));
      jumps += times[k] == times[k - 1] && values[k] != values[k - 1];
    }
    EXPECT_EQ(jumps, 1) << count;
  }
}

TEST(SvgWorldAnimation, EndsWhereTheStillPictureIs) {
  const Scene scene = crank_scene();
  AnimateOptions options;
  options.frames = 3;
  const std::string svg = animate_svg(scene, 1, options);
  const std::string last = svg.substr(svg.find("<g class=\"still\">"));
  // The room rests: it is at the same place in both layers.
  const auto room = [](const std::string& part) {
    const std::size_t at = part.find("<g transform=");
    return part.substr(at, part.find('>', at) - at);
  };
  EXPECT_EQ(room(svg), room(last));
  // What moves stands, in the still layer, where the moving one comes to.
  for (const std::string& element : animations(svg)) {
    if (attribute(element, "type") != "translate") continue;
    EXPECT_NE(last.find("translate(" + split(attribute(element, "values"), ';').back() + ")"), std::string::npos)
        << element;
  }
}

/// The head of the pin is a part of it on the highest layer, and its foot one on the lowest.
TEST(SvgWorld, PaintsPartsOfABodyOnTheirLayers) {
  const Scene scene = read_scene("examples/worlds/layers.json");
  const std::string fills[] = {"#2a6f9e", "#e59345", "#0f7d74"};
  for (const bool moving : {false, true}) {
    DrawOptions options;
    options.legend = false;
    AnimateOptions animation;
    animation.draw = options;
    const std::string svg = moving ? animate_svg(scene, scene.end, animation) : draw_svg(scene, 0, options);
    std::vector<int> order;
    for (std::size_t at = svg.find("<g fill=\"#"); at != std::string::npos; at = svg.find("<g fill=\"#", at + 1))
      for (int body = 0; body < 3; ++body)
        if (svg.compare(at + 9, 7, fills[body]) == 0) order.push_back(body);
    // Foot and shaft, the lower blade, the upper one, the head.
    const std::vector<int> once{2, 2, 0, 1, 2};
    ASSERT_GE(order.size(), once.size()) << moving;
    EXPECT_EQ(std::vector<int>(order.begin(), order.begin() + 5), once) << moving;
  }
}

TEST(SvgWorld, NamesLayersInTheLegend) {
  const std::string svg = draw_svg(read_scene("examples/worlds/layers.json"), 0, {});
  EXPECT_NE(svg.find(">upper blade, z 2..4<"), std::string::npos);
  EXPECT_NE(svg.find(">pin, 3 layers<"), std::string::npos);
  EXPECT_EQ(draw_svg(read_scene("examples/worlds/room.json"), 0, {}).find("layers"), std::string::npos);
}

/// Where the marks of joints are, in pixels, in the order of the mechanism.
std::vector<Point> joints_in(const std::string& svg) {
  const std::string head = "<g transform=\"translate(";
  std::vector<Point> places;
  for (std::size_t at = svg.find("class=\"joint\""); at != std::string::npos;
       at = svg.find("class=\"joint\"", at + 1)) {
    const std::size_t from = svg.rfind(head, at) + head.size();
    const std::vector<std::string> place = split(svg.substr(from, svg.find(')', from) - from), ',');
    places.push_back({std::stod(place[0]), std::stod(place[1])});
  }
  return places;
}

TEST(SvgWorld, MarksJointsWhereTheirBodiesCarryThem) {
  const std::string svg = draw_svg(read_scene("examples/mechanisms/crank_rocker.json"), 90);
  EXPECT_TRUE(well_formed(svg));
  const std::vector<Point> joints = joints_in(svg);
  ASSERT_EQ(joints.size(), 4U);
  // The crank of length 18 points to the left; the pins on the base are 60 apart.
  const Point &a = joints[0], &b = joints[1], &c = joints[2], &d = joints[3];
  const double unit = (d.x - a.x) / 60;
  EXPECT_GT(unit, 1);
  EXPECT_NEAR(d.y, a.y, 0.02);
  EXPECT_NEAR(b.x, a.x - 18 * unit, 0.02);
  EXPECT_NEAR(b.y, a.y, 0.02);
  // The coupler and the rocker keep their lengths.
  EXPECT_NEAR(std::hypot(c.x - b.x, c.y - b.y), std::hypot(50.857, 38.941 - 18) * unit, 0.05);
  EXPECT_NEAR(std::hypot(c.x - d.x, c.y - d.y), std::hypot(60 - 50.857, 38.941) * unit, 0.05);
  EXPECT_LT(svg.rfind("fill-rule=\"evenodd\""), svg.find("class=\"joint\"")) << "above the bodies";
  EXPECT_EQ(count(draw_svg(crank_scene(), 0), "class=\"joint\""), 0U) << "only those of mechanisms";
}

/// A pin of three bodies is one pin; a slide is a pair of rails along its direction, which turns with its bodies.
TEST(SvgWorld, MarksSlidesByRails) {
  EXPECT_EQ(joints_in(draw_svg(read_scene("examples/mechanisms/jansen.json"), 0)).size(), 7U);
  const Scene scene = read_scene("examples/mechanisms/excavator.json");
  const std::string svg = draw_svg(scene, scene.end);
  std::size_t slides = 0, at = 0;
  for (const MechanismJoint& joint : scene.mechanism->joints) {
    if (joint.kind != MechanismJoint::Kind::slide) continue;
    ++slides;
    std::size_t first = 0;
    while (scene.bodies[first].name != joint.first) ++first;
    const Point axis = poses_at(scene, scene.end)[first].axis, d = joint.direction;
    const Point along{axis.x * d.x - axis.y * d.y, axis.y * d.x + axis.x * d.y};
    at = svg.find("<g class=\"joint\"", at + 1);
    ASSERT_NE(at, std::string::npos);
    const std::string path = attribute(svg.substr(svg.find("<path", at), 90), "d");
    const std::vector<std::string> line = split(split(path.substr(1), 'M')[0], 'L');
    const std::vector<std::string> from = split(line[0], ','), to = split(line[1], ',');
    // Upwards in the world is downwards in pixels.
    const Point rail{std::stod(to[0]) - std::stod(from[0]), std::stod(from[1]) - std::stod(to[1])};
    EXPECT_NEAR((rail.x * along.y - rail.y * along.x) / std::hypot(along.x, along.y), 0, 0.05) << joint.name;
    EXPECT_GT(rail.x * along.x + rail.y * along.y, 0) << joint.name;
  }
  EXPECT_GT(slides, 0U);
  EXPECT_EQ(count(svg, "<g class=\"joint\""), slides);
}

TEST(SvgWorldAnimation, MovesJointsWithTheirBodies) {
  const Scene scene = read_scene("examples/mechanisms/toggle_press.json");
  AnimateOptions options;
  options.frames = 5;
  const std::string svg = animate_svg(scene, scene.end, options);
  EXPECT_TRUE(well_formed(svg));
  // In the moving layer and in the still one.
  EXPECT_EQ(count(svg, "class=\"joint\""), 2 * scene.mechanism->joints.size());
  const std::vector<Point> end = joints_in(draw_svg(scene, scene.end));
  const std::vector<Point> still = joints_in(svg.substr(svg.find("<g class=\"still\">")));
  ASSERT_EQ(still.size(), end.size());
  // The sizes of both pictures differ, their proportions do not: the toggle is straight.
  for (const std::vector<Point>& joints : {end, still}) EXPECT_NEAR(joints[0].x, joints[2].x, 0.02);
  EXPECT_GT(std::abs(joints_in(svg)[1].x - still[1].x), 3) << "the elbow has moved";
}

}  // namespace
}  // namespace taut
