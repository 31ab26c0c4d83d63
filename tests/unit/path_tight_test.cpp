// The features that an undecided answer names where it is too tight, by all vertices and all edges.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "support/made_path.hpp"
#include "taut/path.hpp"

namespace taut {
namespace {

using testing::freely;

Polygon room_block(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

/// A square of side 1 that turns, and a wall between two rooms, with a slot that is just as wide.
PathProblem rooms() {
  PathProblem problem;
  problem.linkage.joints = {{"x", 0, 8}, {"y", 0, 4}, {"turn", 0, 360}};
  Body walls{"walls", {}, {}};
  for (const Polygon& outline : {room_block(-1, -1, 9, 0), room_block(-1, 4, 9, 5), room_block(-1, 0, 0, 4),
                                 room_block(8, 0, 9, 4), room_block(3, 0, 5, 1), room_block(3, 2, 5, 4)})
    walls.parts.push_back({outline, {}});
  problem.linkage.scene.bodies = {{"mover", room_block(-0.5, -0.5, 0.5, 0.5), {}}, walls};
  problem.linkage.motions = {freely(0, 1, 2), std::nullopt};
  problem.periodic[2] = true;
  problem.start = {1.5, 2, 30};
  problem.goal[0] = {6.5, 6.5};
  problem.goal[1] = {2, 2};
  return problem;
}

/// The rings of a body at these joint values: of x, y and turn, or at rest.
std::vector<std::tuple<int, int, Polygon>> placed_rings(const PathProblem& problem, BodyId id,
                                                        const JointValues& values) {
  const Body& body = problem.linkage.scene.bodies[static_cast<std::size_t>(id)];
  const double angle = values[2] * (std::acos(-1.0) / 180), c = std::cos(angle), s = std::sin(angle);
  const auto placed = [&](Polygon ring) {
    for (Point& p : ring) {
      if (problem.linkage.motions[static_cast<std::size_t>(id)])
        p = {c * p.x - s * p.y + values[0], s * p.x + c * p.y + values[1]};
    }
    return ring;
  };
  if (body.parts.empty()) return {{0, 0, placed(body.polygon)}};
  std::vector<std::tuple<int, int, Polygon>> all;
  for (std::size_t part = 0; part < body.parts.size(); ++part) {
    all.emplace_back(static_cast<int>(part), 0, placed(body.parts[part].outline));
    for (std::size_t hole = 0; hole < body.parts[part].holes.size(); ++hole)
      all.emplace_back(static_cast<int>(part), static_cast<int>(hole) + 1, placed(body.parts[part].holes[hole]));
  }
  return all;
}

double distance_from_edge(const Point& at, const Point& from, const Point& to) {
  const double ex = to.x - from.x, ey = to.y - from.y;
  const double s = std::clamp(((at.x - from.x) * ex + (at.y - from.y) * ey) / (ex * ex + ey * ey), 0.0, 1.0);
  return std::hypot(at.x - from.x - s * ex, at.y - from.y - s * ey);
}

/// Of all vertices of each body and all edges of the other one, none are nearer at the tight place than the first ones
/// named, and these are as far apart as is said.
void expect_nearest(const PathProblem& problem, const TightPlace& tight) {
  ASSERT_FALSE(tight.features.empty());
  const TightFeatures& first = tight.features.front();
  double least = INFINITY, named = INFINITY;
  for (const BodyId own : tight.pair) {
    const BodyId other = tight.pair[0] + tight.pair[1] - own;
    for (const auto& [part, ring, vertices] : placed_rings(problem, own, tight.values)) {
      for (const auto& [other_part, other_ring, edges] : placed_rings(problem, other, tight.values)) {
        for (std::size_t v = 0; v < vertices.size(); ++v) {
          for (std::size_t e = 0; e < edges.size(); ++e) {
            const double distance = distance_from_edge(vertices[v], edges[e], edges[(e + 1) % edges.size()]);
            least = std::min(least, distance);
            if (first.vertex == VertexRef{own, static_cast<int>(v), part, ring, {}} &&
                first.edge == EdgeRef{other, static_cast<int>(e), other_part, other_ring, {}})
              named = distance;
          }
        }
      }
    }
  }
  EXPECT_NEAR(named, least, 1e-9);
  EXPECT_NEAR(named, first.distance, 1e-9);
}

TEST(PathTight, NamesTheNearestFeaturesOfATightPlace) {
  for (const double tolerance : {0.5, 0.05, 0.01, 0.003}) {
    PathOptions options;
    options.tolerance = tolerance;
    const PathAnswer answer = find_path(rooms(), options);
    ASSERT_TRUE(answer.tight);
    expect_nearest(rooms(), *answer.tight);
  }
}

TEST(PathTight, NamesPartsAndHolesAtATightPlace) {
  // Two rooms and a slot between them are one hole of the second part; it runs either way.
  PathProblem problem = rooms();
  Body& frame = problem.linkage.scene.bodies[1];
  frame.parts = {{{{20, 0}, {21, 0}, {21, 1}}, {}}, {{{-4, -4}, {12, -4}, {12, 6}, {-4, 6}}, {}}};
  Polygon hole = {{-3, 3},  {3, 3},  {3, 2}, {5, 2}, {5, 3},  {11, 3},
                  {11, -3}, {5, -3}, {5, 1}, {3, 1}, {3, -3}, {-3, -3}};
  for (int turn = 0; turn < 2; ++turn) {
    frame.parts[1].holes = {hole};
    PathOptions options;
    options.tolerance = 0.01;
    const PathAnswer answer = find_path(problem, options);
    ASSERT_TRUE(answer.tight) << to_string(answer.outcome) << answer.reason;
    expect_nearest(problem, *answer.tight);
    EXPECT_EQ(answer.tight->features.size(), 2U);
    std::reverse(hole.begin(), hole.end());
  }
}

}  // namespace
}  // namespace taut
