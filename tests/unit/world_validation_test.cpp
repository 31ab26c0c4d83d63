// What no world may have, each fault with its place.
#include <gtest/gtest.h>

#include <string>

#include "taut/check.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/proof.hpp"
#include "taut/separator.hpp"
#include "taut/simulation.hpp"

namespace taut::testing {
namespace {

const Polygon ten{{0, 0}, {10, 0}, {10, 10}, {0, 10}};

Polygon square_of(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

Body plain_body(const std::string& name) {
  Body body;
  body.name = name;
  body.polygon = square_of(20, 20, 1);
  return body;
}

/// A body "plate" of one part, and others that are as they should be.
Scene world_with_holes(const std::vector<Polygon>& holes) {
  Scene scene;
  scene.end = 1;
  Body plate;
  plate.name = "plate";
  plate.parts = {{ten, holes}};
  scene.bodies = {plain_body("a"), plate, plain_body("b")};
  return scene;
}

InputError fault_of(const Scene& scene) {
  try {
    check(scene);
  } catch (const InputError& error) {
    EXPECT_NE(error.hint(), "");
    return error;
  }
  ADD_FAILURE() << "the scene was taken";
  return {"", "", ""};
}

void expect_fault(const Scene& scene, const std::string& place, const std::string& problem) {
  const InputError error = fault_of(scene);
  EXPECT_EQ(error.place(), place);
  EXPECT_NE(error.problem().find(problem), std::string::npos) << error.problem();
}

TEST(WorldValidation, CulpritsTellTheirPartAndRing) {
  // The second hole of the second part crosses itself.
  Scene scene = world_with_holes({});
  scene.bodies[1].parts.push_back({square_of(30, 0, 10), {square_of(31, 1, 2), {{35, 1}, {37, 3}, {37, 1}, {35, 3}}}});
  const Culprits crossed = fault_of(scene).culprits();
  ASSERT_EQ(crossed.edges.size(), 2U);
  for (const EdgeRef& edge : crossed.edges) {
    EXPECT_EQ(edge.body, 1);
    EXPECT_EQ(edge.part, 1);
    EXPECT_EQ(edge.ring, 2);
  }
  // A hole meets the outline: one edge of each.
  const Culprits met = fault_of(world_with_holes({square_of(1, 1, 2), square_of(8, 5, 5)})).culprits();
  ASSERT_EQ(met.edges.size(), 2U);
  EXPECT_EQ(met.edges[0].ring, 0);
  EXPECT_EQ(met.edges[1].ring, 2);
  EXPECT_EQ(met.edges[0].body, 1);
}

TEST(WorldValidation, HolesLieInside) {
  EXPECT_NO_THROW(check(world_with_holes({square_of(1, 1, 2), square_of(5, 5, 2)})));
  expect_fault(world_with_holes({square_of(1, 1, 2), square_of(12, 1, 2)}), "plate: hole 2", "outside of the outline");
  expect_fault(world_with_holes({square_of(-5, -5, 40)}), "plate: hole 1", "outside of the outline");
  expect_fault(world_with_holes({square_of(1, 1, 6), square_of(2, 2, 1)}), "plate: hole 2", "inside hole 1");
  expect_fault(world_with_holes({square_of(2, 2, 1), square_of(1, 1, 6)}), "plate: hole 1", "inside hole 2");
}

TEST(WorldValidation, HolesTouchNothing) {
  // A corner on an edge, an edge along an edge, a corner on a corner, a crossing, and the outline itself.
  expect_fault(world_with_holes({{{0, 5}, {2, 4}, {2, 6}}}), "plate", "of the outline meets edge");
  expect_fault(world_with_holes({square_of(0, 4, 2)}), "plate", "of the outline meets edge");
  expect_fault(world_with_holes({square_of(0, 0, 2)}), "plate", "of the outline meets edge");
  expect_fault(world_with_holes({square_of(8, 4, 4)}), "plate", "of the outline meets edge");
  expect_fault(world_with_holes({ten}), "plate", "of the outline meets edge");
  expect_fault(world_with_holes({square_of(1, 1, 2), square_of(3, 3, 2)}), "plate", "of hole 1 meets edge");
  expect_fault(world_with_holes({square_of(1, 1, 2), square_of(1, 1, 2)}), "plate", "of hole 1 meets edge");
  const InputError crossing = fault_of(world_with_holes({square_of(8, 4, 4)}));
  ASSERT_EQ(crossing.culprits().edges.size(), 2U);
  EXPECT_EQ(crossing.culprits().edges[0].body, 1);
  EXPECT_EQ(crossing.culprits().edges[0].ring, 0);
  EXPECT_EQ(crossing.culprits().edges[1].ring, 1);
}

TEST(WorldValidation, EveryRingIsAPolygon) {
  expect_fault(world_with_holes({{{1, 1}, {2, 2}}}), "plate: hole 1", "at least 3 vertices");
  expect_fault(world_with_holes({square_of(1, 1, 1), {{5, 5}, {7, 7}, {7, 5}, {5, 7}}}), "plate: hole 2", "");
  Scene scene = world_with_holes({});
  scene.bodies[1].parts.push_back({square_of(30, 0, 5), {{{31, 1}, {32, 1}}}});
  expect_fault(scene, "plate: part 1: hole 1", "at least 3 vertices");
  scene.bodies[1].parts[1] = {square_of(30, 0, 5), {square_of(40, 0, 1)}};
  expect_fault(scene, "plate: part 1: hole 1", "outside of the outline");
  scene.bodies[1].parts[1] = {{{0, 0}, {1, 1}}, {}};
  expect_fault(scene, "plate: part 1", "at least 3 vertices");
}

TEST(WorldValidation, PolygonOrParts) {
  Scene scene = world_with_holes({});
  scene.bodies[1].polygon = ten;
  expect_fault(scene, "plate", "a polygon and parts");
  scene.bodies[1].polygon.clear();
  scene.bodies[1].parts.clear();
  expect_fault(scene, "plate", "at least 3 vertices");
}

TEST(WorldValidation, NamesDiffer) {
  Scene scene = world_with_holes({});
  scene.bodies[2].name = "a";
  expect_fault(scene, "bodies", "two bodies are called \"a\"");
  scene.bodies[2].name = "*";
  expect_fault(scene, "bodies", "called \"*\"");
}

TEST(WorldValidation, ParentsExistAndEnd) {
  Scene scene = world_with_holes({});
  scene.bodies[2].relative_to = "nobody";
  expect_fault(scene, "b", "no body \"nobody\"");
  scene.bodies[2].relative_to = "b";
  expect_fault(scene, "b", "relative to itself");
  scene.bodies[2].relative_to = "plate";
  scene.bodies[1].relative_to = "b";
  expect_fault(scene, "plate", "relative to itself");
  // Who hangs on a cycle without being in it.
  scene.bodies[0].relative_to = "b";
  EXPECT_NE(fault_of(scene).problem(), "");
}

TEST(WorldValidation, ChainsAreShort) {
  Scene scene;
  scene.end = 1;
  for (int i = 0; i <= max_depth + 1; ++i) {
    Body body = plain_body("b" + std::to_string(i));
    if (i > 0) body.relative_to = scene.bodies.back().name;
    scene.bodies.push_back(body);
  }
  expect_fault(scene, "b17", "more than 16 bodies");
  scene.bodies.pop_back();
  EXPECT_EQ(check(scene).outcome, Outcome::overlap_at_start);
}

TEST(WorldValidation, IgnoredBodiesExist) {
  Scene scene = world_with_holes({});
  scene.ignore = {{"a", "plate"}, {"plate", "lid"}};
  expect_fault(scene, "ignore[1]", "no body \"lid\"");
  scene.ignore = {{"plate", "plate"}};
  expect_fault(scene, "ignore[0]", "it pairs \"plate\" with itself");
  scene.ignore = {{"a", "*"}, {"*", "*"}};
  const Answer answer = check(scene);
  EXPECT_EQ(answer.coverage.ignored, 3U);
  EXPECT_EQ(answer.outcome, Outcome::untested);
}

TEST(WorldValidation, AnAnswerNeedsABody) {
  Scene scene;
  scene.end = 1;
  expect_fault(scene, "bodies", "no bodies");
}

/// What takes two plain bodies says so.
TEST(WorldValidation, OthersRefuseWorlds) {
  Scene scene = world_with_holes({square_of(1, 1, 1)});
  EXPECT_THROW(Simulation(scene).tiling(), InputError);
  EXPECT_THROW(separator(scene, 0), InputError);
  scene.bodies.pop_back();
  EXPECT_THROW(Simulation(scene).halfedges(), InputError);
  EXPECT_THROW(separator(scene, 0), InputError);
}

InputError fault_of_text(const std::string& bodies, const std::string& more = "") {
  try {
    parse_scene(R"({"format":"taut-scene/1","time":[0,1],"bodies":[)" + bodies + "]" + more + "}");
  } catch (const InputError& error) {
    return error;
  }
  ADD_FAILURE() << "the text was taken: " << bodies << more;
  return {"", "", ""};
}

TEST(WorldValidation, TextIsRefusedWhereItIsWrong) {
  const std::string square = "[[0,0],[1,0],[1,1]]";
  const InputError both = fault_of_text(R"({"name":"a","polygon":)" + square + R"(,"parts":[)" + square + "]}");
  EXPECT_NE(both.problem().find("both \"polygon\" and \"parts\""), std::string::npos);
  EXPECT_NE(both.place().find("bodies[0]"), std::string::npos) << both.place();
  const InputError none = fault_of_text(R"({"name":"a","parts":[]})");
  EXPECT_NE(none.place().find("bodies[0].parts"), std::string::npos) << none.place();
  const InputError neither = fault_of_text(R"({"name":"a"})");
  EXPECT_NE(neither.problem().find("polygon"), std::string::npos) << neither.problem();
  const std::string a = R"({"name":"a","polygon":)" + square + "}";
  EXPECT_NE(fault_of_text(a + "," + a).problem().find("two bodies are called \"a\""), std::string::npos);
  EXPECT_NE(fault_of_text(a, R"(,"ignore":[["a"]])").problem().find("expected two names"), std::string::npos);
  const InputError orbit =
      fault_of_text(R"({"name":"a","polygon":)" + square + R"(,"motion":{"orbit":{"center":[1],"angle":[0,1]}}})");
  EXPECT_NE(orbit.place().find("orbit.center"), std::string::npos) << orbit.place();
}

}  // namespace
}  // namespace taut::testing
