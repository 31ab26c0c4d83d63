// Following the planar map through its events, and where bodies are drawn.
#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

#include "generators/generators.hpp"
#include "support/random_scenes.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/pose.hpp"
#include "taut/simulation.hpp"
#include "taut/validate.hpp"

namespace taut {
namespace {

/// A copy of the map that is told of changed half-edges only, as a viewer is.
class Follower : public Tracer {
 public:
  void start(const Simulation& simulation) {
    simulation_ = &simulation;
    map_ = simulation.halfedges();
  }

  void on_event(const TraceEvent&) override {
    const std::vector<int> changed = simulation_->changed_halfedges();
    most_ = std::max(most_, changed.size());
    for (const int h : changed) {
      if (static_cast<std::size_t>(h) >= map_.size()) map_.resize((static_cast<std::size_t>(h) | 1u) + 1);
      map_[static_cast<std::size_t>(h)] = simulation_->halfedge(h);
    }
    ++events_;
    if (!(map_ == simulation_->halfedges())) ++wrong_;
  }

  std::size_t most() const { return most_; }
  int events() const { return events_; }
  int wrong() const { return wrong_; }

 private:
  const Simulation* simulation_ = nullptr;
  std::vector<TilingHalfedge> map_;
  std::size_t most_ = 0;
  int events_ = 0, wrong_ = 0;
};

Follower follow(const Scene& scene) {
  Follower follower;
  Simulation simulation(scene, Touch::open, &follower);
  follower.start(simulation);
  simulation.advance_to(scene.end);
  return follower;
}

TEST(ChangedHalfedges, AreAllThatAnEventChanges) {
  int events = 0;
  std::size_t most = 0;
  for (const testing::Family family : testing::all_families) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      const Follower seen = follow(testing::random_scene(seed, family));
      EXPECT_EQ(seen.wrong(), 0) << testing::to_string(family) << " " << seed;
      events += seen.events();
      most = std::max(most, seen.most());
    }
  }
  EXPECT_GT(events, 300);
  EXPECT_LE(most, 14u);
}

TEST(ChangedHalfedges, AreAllThatAnEventChangesInExamples) {
  for (const char* name : {"combs", "gears_thick_tooth", "jigsaw", "lock", "spiral"}) {
    const Follower seen = follow(read_scene(std::string("examples/") + name + ".json"));
    EXPECT_EQ(seen.wrong(), 0) << name;
    EXPECT_GT(seen.events(), 20) << name;
  }
}

TEST(Halfedges, AreTheTilingsEdgesAndFaces) {
  const Scene scene = read_scene("examples/combs.json");
  Simulation simulation(scene);
  EXPECT_TRUE(simulation.changed_halfedges().empty());
  simulation.advance_to((scene.start + scene.end) / 2);
  const std::vector<TilingHalfedge> map = simulation.halfedges();
  const Tiling tiling = simulation.tiling();
  std::size_t used = 0;
  for (std::size_t h = 0; h < map.size(); ++h) {
    if (map[h].origin < 0) continue;
    ++used;
    const TilingHalfedge& next = map[static_cast<std::size_t>(map[h].next)];
    EXPECT_EQ(next.origin, map[h ^ 1u].origin);
    EXPECT_EQ(next.kind, map[h].kind);
    if (map[h].kind == FaceKind::node) {
      EXPECT_EQ(next.depth, map[h].depth);
    }
  }
  EXPECT_EQ(used, 2 * tiling.edges.size());
  EXPECT_EQ(simulation.halfedge(-1).origin, -1);
  EXPECT_EQ(simulation.halfedge(1 << 20).origin, -1);
}

TEST(PoseAt, IsWhereTheTilingHasItsVertices) {
  for (const char* name : {"combs", "gears", "jigsaw", "lid", "maze", "rotor", "spiral"}) {
    const Scene scene = read_scene(std::string("examples/") + name + ".json");
    Simulation simulation(scene);
    for (const double share : {0.0, 0.3, 0.9}) {
      simulation.advance_to(scene.start + share * (scene.end - scene.start));
      const Tiling tiling = simulation.tiling();
      for (const TilingVertex& v : tiling.vertices) {
        const Body& body = scene.bodies[static_cast<std::size_t>(v.vertex.body)];
        const Point local = body.polygon[static_cast<std::size_t>(v.vertex.index)];
        const BodyPose pose = pose_at(body.motion, tiling.time);
        const double x = pose.origin.x + pose.axis.x * local.x - pose.axis.y * local.y;
        const double y = pose.origin.y + pose.axis.y * local.x + pose.axis.x * local.y;
        ASSERT_NEAR(x, v.position.x, 1e-12 * (1 + std::fabs(x))) << name;
        ASSERT_NEAR(y, v.position.y, 1e-12 * (1 + std::fabs(y))) << name;
      }
    }
  }
}

TEST(PoseAt, ABodyWithoutMotionRestsAndALaterPieceTakesOverAtTheJoint) {
  EXPECT_EQ(pose_at({}, 7).origin, (Point{0, 0}));
  EXPECT_EQ(pose_at({}, 7).axis, (Point{1, 0}));
  const Motion motion{{{{0, 1}, {}, NoRotation{}, 2}, {{5}, {1}, HalfAngleRotation{{1}}}}};
  EXPECT_EQ(pose_at(motion, 1.5).origin, (Point{1.5, 0}));
  EXPECT_EQ(pose_at(motion, 2).origin, (Point{5, 1}));
  EXPECT_EQ(pose_at(motion, 2).axis, (Point{0, 1}));
}

TEST(PoseAt, ACosineBesideOneIsToldToAllDigits) {
  // The Chebyshev polynomial of degree 16 beside the square root of 1/2, where it touches 1: its terms add up to 2e5,
  // and doubles would say 1e-5. The sine there was computed by other means, with 400 bits.
  const Motion motion{
      {{{},
        {},
        CosineRotation{{1, 0, -128, 0, 2688, 0, -21504, 0, 84480, 0, -180224, 0, 212992, 0, -131072, 0, 32768}}}}};
  EXPECT_EQ(pose_at(motion, 0.7071067811865476).axis.x, 1);
  EXPECT_NEAR(pose_at(motion, 0.7071067811865476).axis.y, 1.0937293852259077e-15, 1e-28);
}

Culprits culprits_of(const Polygon& polygon) {
  try {
    validate_polygon(polygon, "P");
  } catch (const InputError& error) {
    return error.within("file.json").culprits();
  }
  return {};
}

/// A vertex is no edge, and one base tells all errors from those of others.
static_assert(!std::is_convertible_v<VertexRef, EdgeRef> && !std::is_convertible_v<EdgeRef, VertexRef>);
static_assert(!std::is_constructible_v<VertexRef, EdgeRef> && !std::is_constructible_v<EdgeRef, VertexRef>);
static_assert(std::is_base_of_v<std::exception, Error> && std::is_base_of_v<Error, InternalError>);
static_assert(std::is_base_of_v<Error, InputError> && std::is_base_of_v<Error, UndecidedError>);
static_assert(std::is_base_of_v<Error, UnusableError> && std::is_base_of_v<Error, ProofError>);
static_assert(std::is_base_of_v<InternalError, StructureError> && std::is_base_of_v<InternalError, EngineDisagreement>);

TEST(Culprits, KnowTheirBody) {
  Scene scene;
  scene.end = 1;
  scene.bodies = {{"a", {{0, 0}, {1, 0}, {0, 1}}, {}}, {"b", {{5, 0}, {7, 0}, {5, 0}, {6, 1}}, {}}};
  try {
    validate(scene);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.culprits().vertices, (std::vector<VertexRef>{{1, 0}, {1, 2}}));
  }
}

TEST(Culprits, NameWhatIsAtFault) {
  const Culprits bow = culprits_of({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
  EXPECT_EQ(bow.edges, (std::vector<EdgeRef>{{0, 0}, {0, 2}}));
  EXPECT_TRUE(bow.vertices.empty());
  const Culprits twice = culprits_of({{0, 0}, {2, 0}, {2, 2}, {0, 0}});
  EXPECT_EQ(twice.vertices, (std::vector<VertexRef>{{0, 0}, {0, 3}}));
  const Culprits touch = culprits_of({{0, 0}, {4, 0}, {4, 3}, {2, 0}, {0, 3}});
  EXPECT_EQ(touch.vertices, (std::vector<VertexRef>{{0, 3}}));
  const Culprits spike = culprits_of({{0, 0}, {4, 0}, {6, 0}, {5, 0}, {4, 3}});
  EXPECT_EQ(spike.vertices.size(), 1u);
  EXPECT_EQ(spike.edges.size(), 2u);
  EXPECT_TRUE(culprits_of({{0, 0}, {1, 0}, {0, 1}}).edges.empty());
}

}  // namespace
}  // namespace taut
