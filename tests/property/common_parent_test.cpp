// A moving parent that all bodies have in common: times and features stay, and every point, normal and nearest point of
// every answer moves with the parent.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <sstream>

#include "support/effort.hpp"
#include "support/small_world.hpp"
#include "support/world_changes.hpp"
#include "taut/clearance.hpp"
#include "taut/intervals.hpp"
#include "taut/motions.hpp"
#include "taut/outline.hpp"
#include "taut/pose.hpp"
#include "taut/proof.hpp"
#include "taut/separate.hpp"
#include "taut/simulation.hpp"

namespace taut::testing {
namespace {

/// What an answer says of one instant: points, and directions.
struct Said {
  TimeInterval time;
  std::vector<Point> points, directions;
  std::string features;
};

std::string named_in_text(const VertexRef& v) { return std::to_string(v.body) + ":" + std::to_string(v.index) + " "; }
std::string named_in_text(const EdgeRef& e) { return std::to_string(e.body) + ":" + std::to_string(e.index) + "- "; }

Said said(const Contact& c) { return {c.time, {c.point}, {c.normal}, named_in_text(c.vertex) + named_in_text(c.edge)}; }
Said said(const NearestPoints& n) {
  return {n.time, {n.points[0], n.points[1]}, {}, named_in_text(n.edges[0]) + named_in_text(n.edges[1])};
}
void add(const std::optional<Contact>& contact, std::vector<Said>& all) {
  if (contact) all.push_back(said(*contact));
}

/// One question, by either engine where that is a choice.
using Asked = std::function<void(const Scene&, const CheckOptions&, std::vector<Said>&)>;

void ask_check(const Scene& scene, const CheckOptions& options, std::vector<Said>& all) {
  const Answer answer = check(scene, options);
  add(answer.contact, all);
  add(answer.touching, all);
  for (const PairAnswer& pair : *answer.pairs) add(pair.contact, all);
  if (answer.overlap_point) all.push_back({{scene.start, scene.start}, {*answer.overlap_point}, {}, ""});
}
void ask_intervals(const Scene& scene, const CheckOptions& options, std::vector<Said>& all) {
  for (const OverlapInterval& found : intervals(scene, options).intervals) {
    add(found.enter, all);
    add(found.exit, all);
  }
}
void ask_clearance(const Scene& scene, const CheckOptions&, std::vector<Said>& all) {
  ClearanceOptions how;
  how.all_pairs = true;
  for (const NearestPoints& found : clearance(scene, how).pairs) {
    if (found.lo > 0) all.push_back(said(found));
  }
}
void ask_margin(const Scene& scene, const CheckOptions& options, std::vector<Said>& all) {
  for (const PairMargin& pair : check_clearance(scene, 0.25, options).pairs) {
    if (pair.nearest && pair.outcome == Outcome::contact) all.push_back(said(*pair.nearest));
  }
}
void ask_simulation(const Scene& scene, const CheckOptions& options, std::vector<Said>& all) {
  Simulation simulation(scene, options.touch);
  simulation.advance_to(scene.end);
  add(simulation.contact(), all);
}
void ask_proof(const Scene& scene, const CheckOptions& options, std::vector<Said>& all) {
  std::stringstream log;
  CheckOptions first = options;
  first.all_pairs = false;
  const Answer proved = prove(scene, log, first);
  add(proved.contact, all);
  if (proved.outcome == Outcome::contact) add(verify(scene, log).contact, all);
}

const std::pair<const char*, Asked> questions_with_places[] = {
    {"check", ask_check},   {"intervals", ask_intervals},   {"clearance", ask_clearance},
    {"margin", ask_margin}, {"simulation", ask_simulation}, {"proof", ask_proof}};

/// What was compared, and how often several features meet at one instant and another one of them was named.
struct Compared {
  int all = 0, other_features = 0;
};

/// Both times are the same instant, rounded.
void expect_moved(const Said& here, const Said& there, const Scene& scene, const std::string& parent, Compared& count) {
  ASSERT_NEAR(here.time.lo, there.time.lo, 1e-9);
  ASSERT_NEAR(here.time.hi, there.time.hi, 1e-9);
  ++count.all;
  if (here.features != there.features) {
    ++count.other_features;
    return;
  }
  ASSERT_EQ(here.points.size(), there.points.size());
  const double t = there.time.lo + (there.time.hi - there.time.lo) / 2;
  BodyPose pose;
  const std::vector<BodyPose> all = poses_at(scene, t);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].name == parent) pose = all[i];
  }
  const auto turned = [&](const Point& p) {
    return Point{pose.axis.x * p.x - pose.axis.y * p.y, pose.axis.y * p.x + pose.axis.x * p.y};
  };
  for (std::size_t i = 0; i < here.points.size(); ++i) {
    const Point at = turned(here.points[i]);
    EXPECT_NEAR(there.points[i].x, pose.origin.x + at.x, 1e-6);
    EXPECT_NEAR(there.points[i].y, pose.origin.y + at.y, 1e-6);
  }
  for (std::size_t i = 0; i < here.directions.size(); ++i) {
    const Point at = turned(here.directions[i]);
    EXPECT_NEAR(there.directions[i].x, at.x, 1e-6);
    EXPECT_NEAR(there.directions[i].y, at.y, 1e-6);
  }
}

TEST(CommonParent, EveryPointOfEveryAnswerIsInTheWorldsFrame) {
  Compared count;
  for (std::uint64_t number = 1; number < effort(150); ++number) {
    const MadeWorld world = small_world(number).world;
    // Of two bodies the pair is asked about even at rest; of more it is not.
    if (world.bodies.size() == 2) continue;
    Rng rng(number);
    const MadeWorld moved = carried_as_a_whole(rng, world);
    const Scene scene = scene_of(world), carried = scene_of(moved);
    for (const Touch touch : {Touch::open, Touch::closed}) {
      for (const EngineChoice engine : {EngineChoice::kinetic, EngineChoice::spacetime}) {
        CheckOptions options;
        options.touch = touch;
        options.engine = engine;
        options.all_pairs = true;
        for (const auto& [name, ask] : questions_with_places) {
          SCOPED_TRACE("world " + std::to_string(number) + ", " + name + ", " + to_string(touch));
          std::vector<Said> here, there;
          ask(scene, options, here);
          ask(carried, options, there);
          ASSERT_EQ(here.size(), there.size());
          for (std::size_t i = 0; i < here.size(); ++i) expect_moved(here[i], there[i], carried, "carrier", count);
          if (::testing::Test::HasFailure()) return;
        }
      }
    }
  }
  EXPECT_GT(count.all, static_cast<int>(enough(1000)));
  EXPECT_LT(count.other_features, count.all / 50);
}

/// A body and what it carries have their first chain in common: two bodies, with straight edges and with arcs.
TEST(CommonParent, ABodyAndWhatItCarriesMeetInTheWorldsFrame) {
  Scene scene;
  scene.end = 4;
  MotionPiece away;
  away.x = {100};
  scene.bodies = {{"p", {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, Motion{{away}}},
                  {"b", {{4, -1}, {6, -1}, {6, 1}, {4, 1}}, from_velocity({-1, 0})}};
  scene.bodies[1].relative_to = "p";
  Scene round = scene;
  round.bodies[1].polygon.clear();
  round.bodies[1].curves = parse_path("M 4 0 A 1 1 0 0 0 6 0 A 1 1 0 0 0 4 0 Z");
  for (const Scene& asked : {scene, round}) {
    const Answer answer = check(asked);
    ASSERT_EQ(answer.outcome, Outcome::contact);
    EXPECT_NEAR(answer.contact->point.x, 101, 1e-6);
    ASSERT_TRUE(intervals(asked).intervals.at(0).enter);
    EXPECT_NEAR(intervals(asked).intervals[0].enter->point.x, 101, 1e-6);
    const MarginAnswer margin = check_clearance(asked, 1);
    EXPECT_NEAR(margin.first->nearest->points[0].x, 101, 1e-6);
    EXPECT_NEAR(margin.first->nearest->points[1].x, 102, 1e-6);
    Scene earlier = asked;
    earlier.end = 2;
    const Clearance nearest = clearance(earlier);
    EXPECT_NEAR(nearest.nearest->points[0].x, 101, 1e-6);
    EXPECT_NEAR(nearest.nearest->points[1].x, 102, 1e-6);
  }
}

}  // namespace
}  // namespace taut::testing
