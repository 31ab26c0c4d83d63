// Logs about paths: written, checked, damaged, and given to problems that have a way.
#include <gtest/gtest.h>

#include <sstream>

#include "proof/log_text.hpp"
#include "support/effort.hpp"
#include "support/rng.hpp"
#include "taut/error.hpp"
#include "taut/path_proof.hpp"

namespace taut {
namespace {

using testing::checksum_size;
using testing::effort;
using testing::Rng;
using testing::sealed;

Polygon box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

JointMotion freely(std::optional<int> x, std::optional<int> y, std::optional<int> deg) {
  JointMotion motion;
  motion.kind = FreeMotion{x, y, deg, {0.25, 0}};
  return motion;
}

/// A bar that may turn, in a room with a door of that width.
PathProblem door(double width) {
  PathProblem problem;
  problem.linkage.joints = {{"x", -3, 3}, {"y", -2, 2}, {"turn", 0, 360}};
  Body wall{"wall", {}, {}};
  // One of the outlines runs clockwise: edges are numbered as they are written.
  Polygon below = box(-0.1, -9, 0.1, -width / 2);
  std::reverse(below.begin(), below.end());
  wall.parts = {{box(-0.1, width / 2, 0.1, 9), {}}, {below, {}}};
  problem.linkage.scene.bodies = {{"bar", box(-1, -0.5, 1, 0.5), {}}, wall};
  problem.linkage.motions = {freely(0, 1, 2), std::nullopt};
  problem.periodic[2] = true;
  problem.start = {-2, 0.25, 100};
  problem.goal[0] = {1.5, 3};
  return problem;
}

/// A part in a box, with an opening of that width above it.
PathProblem container(double width) {
  PathProblem problem;
  problem.linkage.joints = {{"x", -4, 4}, {"y", -4, 4}, {"turn", -180, 180}};
  problem.linkage.scene.bodies = {{"part", box(-0.5, -0.3, 0.5, 0.3), {}},
                                  {"container",
                                   {{-1, -1},
                                    {1, -1},
                                    {1, 1},
                                    {width / 2, 1},
                                    {width / 2, 0.9},
                                    {0.9, 0.9},
                                    {0.9, -0.9},
                                    {-0.9, -0.9},
                                    {-0.9, 0.9},
                                    {-width / 2, 0.9},
                                    {-width / 2, 1},
                                    {-1, 1}},
                                   {}}};
  problem.linkage.motions = {freely(0, 1, 2), std::nullopt};
  problem.periodic[2] = true;
  problem.goal_outside = true;
  return problem;
}

/// An arm of two links between posts.
PathProblem arm(double post) {
  PathProblem problem;
  problem.linkage.joints = {{"shoulder", -170, 170}, {"elbow", -150, 150}};
  problem.linkage.scene.bodies = {{"upper", box(-0.1, -0.1, 1.1, 0.1), {}},
                                  {"lower", box(0.9, -0.1, 2, 0.1), {}},
                                  {"post", box(-0.1, post, 0.1, post + 0.5), {}}};
  problem.linkage.scene.bodies[1].relative_to = "upper";
  problem.linkage.scene.ignore = {{"upper", "lower"}};
  problem.linkage.motions = {JointMotion{Revolute{{0, 0}}, 0}, JointMotion{Revolute{{1, 0}}, 1}, std::nullopt};
  problem.start = {20, 0};
  problem.goal[0] = {160, 160};
  return problem;
}

/// A lid over the door, and a bar with a knob. The lid closes the door for the knob alone: on the bar's layer, the door
/// is wide. Without a common layer, `above`, nothing does.
PathProblem layered(bool above) {
  PathProblem problem = door(1.3);
  std::vector<Body>& bodies = problem.linkage.scene.bodies;
  bodies[0] = {"bar", {}, {}};
  bodies[0].parts = {{box(-1, -0.5, 1, 0.5), {}, Layers{0, 1}}, {box(-0.3, -0.3, 0.3, 0.3), {}, Layers{1, 2}}};
  bodies[1].z = {0, 1};
  Body lid{"lid", {}, {}};
  lid.parts = {{box(-0.1, -9, 0.1, 9), {}}};
  lid.z = above ? Layers{2, 3} : Layers{1, 1.5};
  bodies.push_back(lid);
  problem.linkage.motions.push_back(std::nullopt);
  return problem;
}

/// The bar without its turn, and a door that is as wide as it is, or wider.
PathProblem slot(double width) {
  PathProblem problem = door(width);
  problem.linkage.joints.pop_back();
  problem.periodic = {};
  problem.linkage.motions[0] = freely(0, 1, {});
  problem.start = {-2, 0.25, 0};
  problem.goal[0] = {2, 2};
  problem.goal[1] = {0, 0};
  return problem;
}

/// The goal is at a wall, or at that distance from it.
PathProblem against_a_wall(double distance) {
  PathProblem problem = slot(2);
  problem.goal[0] = {1.125, 1.125};
  problem.goal[1] = {-0.5, 0.5};
  problem.linkage.scene.bodies.push_back({"stop", box(2.125 + distance, -4, 3, 4), {}});
  problem.linkage.motions.emplace_back();
  return problem;
}

/// What is free narrows to a wedge, whose tip is at the goal, (1, 1/3): a number that no log can hold.
PathProblem wedge() {
  PathProblem problem;
  problem.linkage.joints = {{"x", -4, 4}, {"y", -4, 4}};
  problem.linkage.scene.bodies = {{"square", box(-0.25, -0.25, 0.25, 0.25), {}},
                                  {"below", {{-5.75, -20}, {6.25, -20}, {6.25, 1.75}, {-5.75, -2.25}}, {}},
                                  {"above", {{-5.75, 5.25}, {6.25, -2.75}, {6.25, 20}, {-5.75, 20}}, {}}};
  problem.linkage.motions = {freely(0, 1, {}), std::nullopt, std::nullopt};
  problem.start = {-2, 0.5};
  problem.goal[0] = {1, 2};
  return problem;
}

/// A part that two joints slide across each other, in a box with an opening of that width.
PathProblem slid_out(double width) {
  PathProblem problem = container(width);
  problem.linkage.joints = {{"along", -4, 4}, {"across", -4, 4}};
  problem.periodic = {};
  problem.linkage.motions[0] = freely(0, 1, {});
  return problem;
}

/// One joint slides a bar in a slanted direction past a stop, or beside it.
PathProblem stopped(double width) {
  PathProblem problem;
  problem.linkage.joints = {{"way", -3, 3}};
  problem.linkage.scene.bodies = {{"bar", box(-0.5, -0.25, 0.5, 0.25), {}},
                                  {"stop", box(width, -0.25, width + 0.5, 4), {}}};
  problem.linkage.motions = {JointMotion{Slide{{1, 0.125}}, 0, 1, 0.25}, std::nullopt};
  problem.start = {-2};
  problem.goal[0] = {2, 3};
  return problem;
}

/// A crank that turns on past a post, or not; and a rocker that follows it.
PathProblem four_bar(double post) {
  PathProblem problem;
  Scene& scene = problem.linkage.scene;
  scene.bodies = {{"ground", box(-1, -5, 5, -4), {}},
                  {"crank", box(-0.125, -0.125, 0.125, 1.125), {}},
                  {"coupler", {{0, 0.875}, {4, 1.875}, {4, 2.125}, {0, 1.125}}, {}},
                  {"rocker", box(3.875, -0.125, 4.125, 2.125), {}},
                  {"post", box(-0.125, post, 0.125, post + 0.25), {}}};
  const std::vector<Layers> layers = {{0, 1}, {1, 2}, {2, 3}, {1, 2}, {1, 2}};
  for (std::size_t i = 0; i < layers.size(); ++i) scene.bodies[i].z = layers[i];
  const auto pin = [](const char* name, const char* first, const char* second, Point at) {
    return MechanismJoint{name, MechanismJoint::Kind::revolute, first, second, at};
  };
  scene.mechanism = Mechanism{"ground",
                              {pin("A", "ground", "crank", {0, 0}), pin("B", "crank", "coupler", {0, 1}),
                               pin("C", "coupler", "rocker", {4, 2}), pin("D", "ground", "rocker", {4, 0})},
                              {},
                              {}};
  problem.linkage.joints = {{"A", -170, 200}};
  problem.linkage = assembled(std::move(problem.linkage));
  problem.goal[0] = {200, 200};
  return problem;
}

struct Case {
  const char* name;
  PathProblem none, way;  ///< alike, but for a number
  double clearance = 0;
  Touch touch = Touch::open;
  bool barrier = false;  ///< the log is one
};

std::vector<Case> cases() {
  return {{"door", door(0.95), door(1.1), 0},
          {"door with a clearance", door(1.15), door(1.3), 0.1},
          {"container", container(0.55), container(0.7), 0},
          {"layers", layered(false), layered(true), 0},
          {"layers with a clearance", layered(false), layered(true), 0.1},
          {"arm", arm(0.5), arm(1.6), 0},
          {"four-bar", four_bar(-1.25), four_bar(-2), 0},
          {"slot", slot(0.95), slot(1), 0, Touch::open, true},
          {"slot that fits exactly", slot(1), slot(1.0625), 0, Touch::closed, true},
          {"against a wall", against_a_wall(0), against_a_wall(0.125), 0, Touch::closed, true},
          {"slid out", slid_out(0.95), slid_out(1), 0, Touch::open, true},
          {"stopped", stopped(0.75), stopped(3.25), 0, Touch::open, true}};
}

std::string proof_of(const PathProblem& problem, double clearance, Touch touch = Touch::open) {
  PathOptions options;
  options.clearance = clearance;
  options.touch = touch;
  std::ostringstream log;
  const PathAnswer answer = prove_path(problem, log, options);
  EXPECT_EQ(answer.outcome, PathOutcome::none) << answer.reason;
  return log.str();
}

VerifiedPath verified(const PathProblem& problem, const std::string& log) {
  std::istringstream in(log);
  return verify_path(problem, in);
}

bool is_refused(const PathProblem& problem, const std::string& log) {
  try {
    verified(problem, log);
    return false;
  } catch (const ProofError&) {
    return true;
  }
}

constexpr std::size_t fingerprint_at = 8, nodes_at = 8 + 32 + 8;

TEST(PathLog, ProvesThatThereIsNoWay) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const std::string log = proof_of(c.none, c.clearance, c.touch);
    std::istringstream in(log);
    EXPECT_TRUE(is_path_log(in));
    const VerifiedPath v = verify_path(c.none, in);
    EXPECT_EQ(v.clearance, c.clearance);
    EXPECT_EQ(v.touch, c.touch);
    EXPECT_EQ(v.barrier > 0, c.barrier);
    EXPECT_EQ(v.colliding > 0, !c.barrier);
    EXPECT_EQ(v.reached > 0, !c.barrier);
    EXPECT_LE(v.colliding + v.reached, v.cells);
    EXPECT_EQ(v.fingerprint, path_fingerprint(c.none));
    EXPECT_TRUE(is_refused(c.way, log));
  }
}

TEST(PathLog, IsWrittenForNoWayOnly) {
  std::ostringstream log;
  EXPECT_EQ(prove_path(door(1.1), log).outcome, PathOutcome::path);
  EXPECT_EQ(log.str(), "");
  const PathProblem against = wedge();
  PathOptions closed;
  closed.touch = Touch::closed;
  closed.tolerance = 0.01;
  EXPECT_EQ(find_path(against, closed).outcome, PathOutcome::none);
  const PathAnswer open = prove_path(against, log, closed);
  EXPECT_EQ(open.outcome, PathOutcome::undecided);
  EXPECT_NE(open.reason.find("there is no way"), std::string::npos) << open.reason;
  EXPECT_FALSE(open.tight);
  EXPECT_EQ(log.str(), "");
}

TEST(PathLog, IsAboutItsProblem) {
  const PathProblem problem = door(0.95);
  const std::string log = proof_of(problem, 0);
  const auto changed = [&](auto change) {
    PathProblem other = problem;
    change(other);
    return other;
  };
  for (const PathProblem& other : {changed([](PathProblem& p) { p.start[0] = -2.5; }), changed([](PathProblem& p) {
                                     p.goal[0] = {1.25, 3};
                                   }),
                                   changed([](PathProblem& p) {
                                     p.goal[1] = {0, 0};
                                   }),
                                   changed([](PathProblem& p) { p.periodic[2] = false; }),
                                   changed([](PathProblem& p) { p.linkage.joints[1].hi = 2.5; }),
                                   changed([](PathProblem& p) { p.linkage.scene.bodies[0].polygon[0].x = -0.75; }),
                                   changed([](PathProblem& p) { p.linkage.motions[0] = freely(1, 0, 2); })}) {
    EXPECT_NE(path_fingerprint(other), path_fingerprint(problem));
    EXPECT_TRUE(is_refused(other, log));
  }
  EXPECT_EQ(path_fingerprint(changed([](PathProblem& p) { p.linkage.joints[0].name = "left"; })),
            path_fingerprint(problem));
}

/// Damaged bytes, exchanged and repeated stretches, numbers in place of others: with the right checksum.
std::string damaged(const std::string& log, Rng& rng) {
  std::string bytes = log.substr(0, log.size() - checksum_size);
  const auto place = [&] {
    return nodes_at + static_cast<std::size_t>(rng.below(static_cast<int>(bytes.size() - nodes_at)));
  };
  switch (rng.below(5)) {
    case 0:
      bytes[place()] = static_cast<char>(rng.below(256));
      break;
    case 1:
      bytes[place()] = static_cast<char>(rng.below(6));
      break;
    case 2:
      bytes.erase(place(), static_cast<std::size_t>(rng.between(1, 40)));
      break;
    case 3: {
      const std::string piece = bytes.substr(place(), static_cast<std::size_t>(rng.between(1, 200)));
      bytes.insert(place(), piece);
      break;
    }
    default:
      // A node that says nothing, or that two edges cross.
      for (int n = rng.between(1, 3); n > 0; --n) bytes[place()] = static_cast<char>(rng.between(1, 2));
  }
  return sealed(bytes);
}

TEST(PathLog, DamagedLogsAreRefusedOrStillTrue) {
  Rng rng(5);
  int refused = 0, accepted = 0;
  for (const Case& c : cases()) {
    const std::string log = proof_of(c.none, c.clearance, c.touch);
    for (std::uint64_t n = effort(2500); n > 0; --n) ++(is_refused(c.none, damaged(log, rng)) ? refused : accepted);
  }
  // What is accepted proves what is true: there is no way.
  EXPECT_GT(refused, 2 * accepted);
}

/// The nodes of a log are given to a problem that differs by a number, and has a way: whatever is done to them, no log
/// may be accepted.
TEST(PathLog, NoLogIsAcceptedWhereThereIsAWay) {
  Rng rng(6);
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    PathOptions options;
    options.clearance = c.clearance;
    options.touch = c.touch;
    ASSERT_EQ(find_path(c.way, options).outcome, PathOutcome::path);
    std::string log = proof_of(c.none, c.clearance, c.touch);
    const Fingerprint fingerprint = path_fingerprint(c.way);
    std::copy(fingerprint.begin(), fingerprint.end(), log.begin() + fingerprint_at);
    EXPECT_TRUE(is_refused(c.way, sealed(log.substr(0, log.size() - checksum_size))));
    for (std::uint64_t n = effort(2500); n > 0; --n) ASSERT_TRUE(is_refused(c.way, damaged(log, rng)));
    // Whoever claims a clearance that is larger than the problem's proves less.
    EXPECT_TRUE(is_refused(c.way, log));
  }
}

TEST(PathLog, LogsThatAreCutOffAreRefused) {
  const PathProblem problem = door(0.95);
  const std::string log = proof_of(problem, 0);
  for (std::size_t n = 0; n < log.size(); n += std::max<std::size_t>(1, log.size() / 500))
    EXPECT_TRUE(is_refused(problem, log.substr(0, n)));
  EXPECT_TRUE(is_refused(problem, log + "x"));
  std::string wrong = log;
  wrong[wrong.size() / 2] = static_cast<char>(wrong[wrong.size() / 2] ^ 1);
  EXPECT_TRUE(is_refused(problem, wrong));
}

}  // namespace
}  // namespace taut
