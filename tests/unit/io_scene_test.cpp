#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut {
namespace {

bool same(const Rotation& a, const Rotation& b) {
  if (a.index() != b.index()) return false;
  if (const auto* r = std::get_if<AngleRotation>(&a)) return r->angle == std::get<AngleRotation>(b).angle;
  if (const auto* r = std::get_if<HalfAngleRotation>(&a)) return r->s == std::get<HalfAngleRotation>(b).s;
  if (const auto* r = std::get_if<CosineRotation>(&a)) return r->a == std::get<CosineRotation>(b).a;
  if (const auto* r = std::get_if<DirectionRotation>(&a)) {
    return r->a == std::get<DirectionRotation>(b).a && r->b == std::get<DirectionRotation>(b).b;
  }
  return true;
}

void expect_same(const Scene& a, const Scene& b) {
  EXPECT_EQ(a.start, b.start);
  EXPECT_EQ(a.end, b.end);
  ASSERT_EQ(a.bodies.size(), b.bodies.size());
  for (std::size_t i = 0; i < a.bodies.size(); ++i) {
    EXPECT_EQ(a.bodies[i].name, b.bodies[i].name);
    EXPECT_EQ(a.bodies[i].polygon, b.bodies[i].polygon);
    const auto &p = a.bodies[i].motion.pieces, &q = b.bodies[i].motion.pieces;
    ASSERT_EQ(p.size(), q.size());
    for (std::size_t k = 0; k < p.size(); ++k) {
      EXPECT_EQ(p[k].x, q[k].x);
      EXPECT_EQ(p[k].y, q[k].y);
      EXPECT_EQ(p[k].until, q[k].until);
      EXPECT_EQ(p[k].pivot, q[k].pivot);
      EXPECT_TRUE(same(p[k].rotation, q[k].rotation));
    }
  }
}

Scene every_feature() {
  const double tiny = std::numeric_limits<double>::denorm_min(), huge = std::numeric_limits<double>::max();
  Scene scene;
  scene.start = -0.1;
  scene.end = 1.0 / 3;
  Body p{"a \"quoted\" \\ name, with \xC3\xA9",
         {{0.1, 1e-300}, {tiny, huge}, {-huge, 5e22}, {123456789012345680.0, 0.3}},
         {}};
  Body q{"Q", {{0, 0}, {1, 0}, {0, 1}}, {}};
  q.motion.pieces = {{{1, 0.1}, {}, NoRotation{}, 0.01},
                     {{}, {2}, AngleRotation{{1, 2, 3}}, 0.02},
                     {{}, {}, DirectionRotation{{1, 0.5}, {0, 1}}, 0.03},
                     {{}, {}, HalfAngleRotation{{0.25}}, 0.04},
                     {{}, {}, CosineRotation{{0.5, -0.1}}, std::numeric_limits<double>::infinity(), {0.1, -7}}};
  scene.bodies = {p, q};
  return scene;
}

TEST(SceneText, RoundTripIsExact) {
  const Scene scene = every_feature();
  expect_same(parse_scene(write_scene(scene)), scene);
}

TEST(SceneText, WorldsRoundTrip) {
  Scene scene;
  scene.end = 2;
  const Polygon outline{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, first{{1, 1}, {2, 1}, {1, 2}}, second{{5, 5}, {6, 5}, {5, 6}};
  Body ring, parts, arm;
  ring.name = "ring";
  ring.parts = {{outline, {first, second}}};
  parts.name = "parts";
  parts.parts = {{first, {}}, {outline, {second}}};
  arm.name = "arm";
  arm.polygon = second;
  arm.relative_to = "parts";
  arm.motion.pieces = {{{1}, {0, 2}, NoRotation{}, 1, {0.1, 3}, {{4, -0.1}, {0, 0.7}}}, {}};
  scene.bodies = {ring, parts, arm};
  scene.ignore = {{"ring", "*"}, {"arm", "parts"}};
  const Scene again = parse_scene(write_scene(scene));
  EXPECT_EQ(write_scene(again), write_scene(scene));
  EXPECT_EQ(again.ignore, scene.ignore);
  ASSERT_EQ(again.bodies.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const Body &a = again.bodies[i], &b = scene.bodies[i];
    EXPECT_EQ(a.relative_to, b.relative_to);
    EXPECT_EQ(a.polygon, b.polygon);
    ASSERT_EQ(a.parts.size(), b.parts.size());
    for (std::size_t k = 0; k < a.parts.size(); ++k) {
      EXPECT_EQ(a.parts[k].outline, b.parts[k].outline);
      EXPECT_EQ(a.parts[k].holes, b.parts[k].holes);
    }
  }
  const Orbit& orbit = again.bodies[2].motion.pieces[0].orbit;
  EXPECT_EQ(orbit.centre, (Point{4, -0.1}));
  EXPECT_EQ(orbit.angle, (Coefficients{0, 0.7}));
}

TEST(SceneText, IdsOfAnyKindAreHandedThrough) {
  const std::string id = R"({"job":[1.0,12345678901234567890,-0e0,true,null,"a \"b\" é"],"e":{},"f":[]})";
  const std::string spaced = R"({ "job" : [1.0, 12345678901234567890,
      -0e0,true ,null, "a \"b\" \u00e9" ], "e" : { }, "f":[ ] })";
  const std::string body = R"({"name":"P","polygon":[[0,0],[1,0],[0,1]],"id":)";
  for (const std::string& given : {id, spaced, std::string("7"), std::string("\"x\""), std::string("null")}) {
    const Scene scene =
        parse_scene(R"({"format":"taut-scene/1","id":)" + given + R"(,"time":[0,1],"bodies":[)" + body + "[ 1.50 ]}]}");
    EXPECT_EQ(scene.id, given.size() > 10 ? id : given);
    EXPECT_EQ(scene.bodies[0].id, "[1.50]");
    const Scene again = parse_scene(write_scene(scene));
    EXPECT_EQ(again.id, scene.id);
    EXPECT_EQ(again.bodies[0].id, scene.bodies[0].id);
  }
  EXPECT_EQ(every_feature().id, "");
}

TEST(SceneText, HasAnyNumberOfBodies) {
  const std::string head = R"({"format":"taut-scene/1","time":[0,1],"bodies":[)";
  std::string bodies;
  for (std::size_t n = 0; n < 4; ++n) {
    const Scene scene = parse_scene(head + bodies + "]}");
    EXPECT_EQ(scene.bodies.size(), n);
    if (n == 0) {
      EXPECT_THROW(check(scene), InputError);
    } else {
      // They all rest: then every two are tested.
      EXPECT_EQ(check(scene).outcome, n == 1 ? Outcome::untested : Outcome::overlap_at_start);
    }
    bodies +=
        (n == 0 ? "" : ",") + std::string(R"({"name":")") + std::to_string(n) + R"(","polygon":[[0,0],[1,0],[0,1]]})";
  }
}

TEST(SceneText, KeepsTheSignOfZero) {
  Scene scene = every_feature();
  scene.bodies[1].polygon[0] = {-0.0, 0.0};
  const Scene read = parse_scene(write_scene(scene));
  EXPECT_TRUE(std::signbit(read.bodies[1].polygon[0].x));
  EXPECT_FALSE(std::signbit(read.bodies[1].polygon[0].y));
}

TEST(SceneText, NumbersAreShort) {
  Scene scene = every_feature();
  scene.bodies[1].polygon[0] = {0.1, 1e22};
  const std::string text = write_scene(scene);
  EXPECT_NE(text.find("[0.1,1e+22]"), std::string::npos) << text;
}

std::string with_motion(const std::string& motion) {
  return R"({"format":"taut-scene/1","time":[0,1],"bodies":[{"name":"P","polygon":[[0,0],[1,0],[0,1]]},)"
         R"({"name":"Q","polygon":[[0,0],[0,1],[1,0]])" +
         motion + "}]}";
}

TEST(SceneText, MotionMayBeAbsentOrNull) {
  EXPECT_TRUE(parse_scene(with_motion("")).bodies[1].motion.pieces.empty());
  EXPECT_TRUE(parse_scene(with_motion(R"(,"motion":null)")).bodies[1].motion.pieces.empty());
}

TEST(SceneText, OnePieceNeedsNoArray) {
  const auto pieces = parse_scene(with_motion(R"(,"motion":{"y":[0,-0.5],"rotation":null})")).bodies[1].motion.pieces;
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_TRUE(pieces[0].x.empty());
  EXPECT_EQ(pieces[0].y, (Coefficients{0, -0.5}));
  EXPECT_TRUE(std::holds_alternative<NoRotation>(pieces[0].rotation));
  EXPECT_EQ(pieces[0].until, std::numeric_limits<double>::infinity());
}

void expect_same_pieces(const Motion& a, const Motion& b) {
  Scene x, y;
  x.bodies = {{"a", {}, a}};
  y.bodies = {{"a", {}, b}};
  expect_same(x, y);
  EXPECT_EQ(a.sweep, b.sweep);
}

TEST(SceneText, ReadsMotionsAsPeopleWriteThem) {
  const auto read = [](const std::string& text) {
    return parse_scene(with_motion(",\"motion\":" + text)).bodies[1].motion;
  };
  expect_same_pieces(read(R"({"keyframes":[{"t":0,"x":1,"y":2,"angle_deg":30},{"angle_deg":40,"y":1,"x":0,"t":2}]})"),
                     from_keyframes({{0, 1, 2, 30}, {2, 0, 1, 40}}));
  expect_same_pieces(read(R"({"pivot":[5,6],"keyframes":[{"t":3,"y":2}]})"), from_keyframes({{3, 0, 2, 0}}, {5, 6}));
  expect_same_pieces(read(R"({"velocity":[1,-2],"spin_deg":90,"pivot":[0.5,0]})"),
                     from_velocity({1, -2}, 90, {0.5, 0}));
  expect_same_pieces(read(R"({"velocity":[1,-2]})"), from_velocity({1, -2}));
  expect_same_pieces(read(R"({"spin_deg":-3})"), from_velocity({}, -3));
  expect_same_pieces(read(R"({"sweep":{"pivot":[7,8],"from_deg":10,"to_deg":-20}})"),
                     from_sweep({7, 8}, 10, -20, 0, 1));
  expect_same_pieces(read(R"({"sweep":{"from_deg":0,"to_deg":90}})"), from_sweep({}, 0, 90, 0, 1));
  const Motion piece = read(R"({"rotation":{"angle":[1]},"pivot":[3,4]})");
  EXPECT_EQ(piece.pieces.at(0).pivot, (Point{3, 4}));
}

TEST(SceneText, ASchemaMayBeNamed) {
  const std::string text = with_motion("");
  EXPECT_NO_THROW(parse_scene("{\"$schema\":\"taut-scene.schema.json\"," + text.substr(1)));
}

TEST(SceneText, OrderOfVerticesIsKept) {
  EXPECT_EQ(parse_scene(with_motion("")).bodies[1].polygon, (Polygon{{0, 0}, {0, 1}, {1, 0}}));
}

TEST(SceneText, AcceptsSpaceKeysInAnyOrderAndLargeIntegers) {
  const Scene scene = parse_scene(
      "\xEF\xBB\xBF{ \"bodies\" : [ {\"polygon\":[[0,0],[1,0],[0,1]],\"name\":\"P\"} ,\r\n"
      "{\"motion\":[{\"until\":1e0},{}],\"name\":\"Q\",\"polygon\":[[0,0],[18446744073709551617,0],[0,-"
      "9007199254740993]]}],"
      "\"time\":[0,1],\"format\":\"taut-scene/1\"}\n");
  EXPECT_EQ(scene.bodies[1].polygon[1].x, 18446744073709551616.0);
  EXPECT_EQ(scene.bodies[1].polygon[2].y, -9007199254740992.0);
}

TEST(SceneText, DegreeSixteenIsAccepted) {
  const Scene scene = parse_scene(with_motion(R"(,"motion":{"x":[0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1]})"));
  EXPECT_EQ(scene.bodies[1].motion.pieces[0].x.size(), 17u);
}

TEST(SceneText, ALargePolygonIsRead) {
  std::string polygon = "[[0,0]";
  for (int i = 1; i < 100000; ++i) polygon += ",[" + std::to_string(i) + ".5,-" + std::to_string(i) + "e-3]";
  const Scene scene = parse_scene(
      R"({"format":"taut-scene/1","time":[0,1],"bodies":[{"name":"Q","polygon":[]},{"name":"P","polygon":)" + polygon +
      "]}]}");
  ASSERT_EQ(scene.bodies[1].polygon.size(), 100000u);
  EXPECT_EQ(scene.bodies[1].polygon.back(), (Point{99999.5, -99.999}));
}

}  // namespace
}  // namespace taut
