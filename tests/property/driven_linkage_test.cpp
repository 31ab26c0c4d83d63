// Mechanisms whose driven joints have ranges instead of a time: poses over cells against closed forms in long numbers,
// cells against all intervals of overlap, combinations of several drives one by one, and ways.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "joints/linked_pairs.hpp"
#include "support/closed_linkage.hpp"
#include "support/effort.hpp"
#include "taut/check.hpp"
#include "taut/clearance.hpp"
#include "taut/error.hpp"
#include "taut/intervals.hpp"
#include "taut/io.hpp"
#include "taut/path.hpp"
#include "taut/pose.hpp"

namespace taut::testing {
namespace {

/// The only drive goes along its line from the scene's start to its end; the values on the way are the joint's range.
Linkage with_range(const Scene& scene) {
  Linkage linkage;
  linkage.scene = scene;
  const taut::Drive& drive = scene.mechanism->drives[0];
  const auto& [t0, v0, t1, v1] = *drive.pieces[0].line;
  linkage.joints = {taut::Joint{drive.joint, std::min(v0, v1), std::max(v0, v1)}};
  linkage.scene.mechanism->drives.clear();
  return linkage;
}

std::optional<Linkage> assembled_if_regular(const Linkage& linkage) {
  try {
    return assembled(linkage);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// The law of JointModel: for values in the cell, points are where the model says, up to its error.
TEST(DrivenLinkage, PosesAreThoseOfClosedForms) {
  Rng rng(4711);
  int judged = 0;
  double widest = 0;
  for (std::uint64_t n = effort(300); n > 0; --n) {
    const ClosedLinkage made(rng, rng.between(1, 3));
    const auto linkage = assembled_if_regular(with_range(made.scene()));
    if (!linkage) continue;
    const internal::LinkedPairs pairs(*linkage);
    const taut::Joint& joint = linkage->joints[0];
    const auto& [t0, v0, t1, v1] = *made.scene().mechanism->drives[0].pieces[0].line;
    for (int k = 0; k < 4; ++k) {
      const double half = std::min(std::exp2(rng.real(-12, 4)), (joint.hi - joint.lo) / 2);
      const double middle = rng.real(joint.lo + half, joint.hi - half);
      const internal::JointCell cell{{middle}, {half}};
      const double h = rng.chance(0.3) ? rng.sign() : rng.real(-1, 1), value = middle + h * half;
      std::vector<LongPoint> points;
      if (!(made.place(t0 + (value - v0) / (v1 - v0) * (t1 - t0), points) > 0)) continue;
      for (std::size_t m = 0; m < points.size(); ++m) {
        const auto& marker = made.markers()[m];
        const internal::Vector local{marker.at.x * pairs.scale(), marker.at.y * pairs.scale()};
        const internal::JointModel model = pairs.pose(marker.body, cell).place(local);
        const double x = static_cast<double>(points[m].x) * pairs.scale() - (model.value.x + h * model.rate[0].x);
        const double y = static_cast<double>(points[m].y) * pairs.scale() - (model.value.y + h * model.rate[0].y);
        const double off = std::hypot(x, y);
        // The instant was rounded.
        ASSERT_LE(off, model.error + 1e-10) << "marker " << m << " at " << value << " in " << middle << " +- " << half;
        ++judged;
        if (model.error < 0.01 && off > 1e-8) widest = std::max(widest, off / model.error);
      }
    }
  }
  EXPECT_GT(judged, 50);
  // The bound is not idle.
  EXPECT_GT(widest, 0.1);
}

/// Bodies large enough to meet.
Scene with_large_bodies(Rng& rng, const ClosedLinkage& made) {
  Scene scene = made.scene();
  for (Body& body : scene.bodies) {
    const Point at = body.polygon[0];
    const auto corner = [&](double x, double y) { return Point{at.x + rng.real(0, x), at.y + rng.real(0, y)}; };
    body.polygon = {corner(-9, -9), corner(9, -9), corner(0, 9)};
  }
  for (const MechanismJoint& joint : scene.mechanism->joints) scene.ignore.push_back({joint.first, joint.second});
  return scene;
}

/// Of one driven joint, cells are what the engines say about the motion through its range.
TEST(DrivenLinkage, CellsAgreeWithIntervals) {
  Rng rng(99);
  int collide = 0, free = 0;
  for (std::uint64_t n = effort(150); n > 0; --n) {
    const ClosedLinkage made(rng, rng.between(1, 3));
    const Linkage given = with_range(with_large_bodies(rng, made));
    const auto linkage = assembled_if_regular(given);
    if (!linkage) continue;
    const taut::Joint& joint = linkage->joints[0];
    Scene motion = given.scene;
    motion.start = joint.lo;
    motion.end = joint.hi;
    taut::Drive drive{joint.name, {{}}};
    drive.pieces[0].polynomial = {0, 1};
    motion.mechanism->drives = {drive};
    const Intervals all = intervals(assembled(motion));
    if (all.outcome == Outcome::undecided) continue;
    const Envelope answer = envelope(*linkage);
    ASSERT_EQ(answer.outcome == Outcome::untested, all.outcome == Outcome::untested);
    for (const EnvelopeCell& cell : answer.cells) {
      const auto overlaps = [&](const OverlapInterval& o) { return o.from.hi < cell.hi[0] && cell.lo[0] < o.to.lo; };
      const auto covers = [&](const OverlapInterval& o) {
        return o.pair == cell.pair && o.from.lo <= cell.lo[0] && cell.hi[0] <= o.to.hi;
      };
      if (cell.state == CellState::free) {
        ++free;
        EXPECT_TRUE(std::none_of(all.intervals.begin(), all.intervals.end(), overlaps))
            << n << ": free from " << cell.lo[0] << " to " << cell.hi[0];
      } else if (cell.state == CellState::colliding) {
        ++collide;
        EXPECT_TRUE(std::any_of(all.intervals.begin(), all.intervals.end(), covers))
            << n << ": colliding from " << cell.lo[0] << " to " << cell.hi[0];
      }
    }
    // What is left are the ends of intervals.
    EXPECT_LE(answer.undecided, 0.003 * static_cast<double>(1 + 2 * all.intervals.size())) << n;
    if (HasFailure()) return;
  }
  EXPECT_GT(collide, 20);
  EXPECT_GT(free, 20);
}

/// The linkage as a scene in which its drives are held at these values.
Scene held_at(const Linkage& linkage, const JointValues& values) {
  PathProblem problem;
  problem.linkage = linkage;
  return path_scene(problem, {values});
}

/// Three drives, each with loops of its own: combinations one by one, by the engines.
TEST(DrivenLinkage, CombinationsOfDrivesAreCheckedOneByOne) {
  const Linkage linkage = read_linkage("examples/paths/excavator.json");
  ASSERT_EQ(linkage.joints.size(), 3U);
  EnvelopeOptions options;
  options.tolerance = 0.1;
  const Envelope answer = envelope(linkage, options);
  EXPECT_NEAR(answer.free + answer.colliding + answer.undecided, 1, 1e-9);
  EXPECT_GT(answer.free, 0.2);
  EXPECT_GT(answer.colliding, 0.3);
  Rng rng(5);
  int judged = 0;
  for (std::uint64_t n = effort(1000); n > 0; --n) {
    const auto& cell = answer.cells[static_cast<std::size_t>(rng.below(static_cast<int>(answer.cells.size())))];
    if (cell.state == CellState::undecided) continue;
    JointValues values{};
    for (std::size_t k = 0; k < 3; ++k) values[k] = rng.chance(0.2) ? cell.lo[k] : rng.real(cell.lo[k], cell.hi[k]);
    const Scene scene = held_at(linkage, values);
    const Answer one = check(scene);
    EXPECT_EQ(one.outcome, cell.state == CellState::free ? Outcome::free : Outcome::overlap_at_start)
        << values[0] << " " << values[1] << " " << values[2];
    ++judged;
    // Pictures show the same.
    const std::vector<BodyPose> shown = poses_at(posed(linkage, values), 0), exact = poses_at(scene, 0);
    for (std::size_t i = 0; i < shown.size(); ++i) {
      EXPECT_NEAR(shown[i].origin.x, exact[i].origin.x, 1e-9);
      EXPECT_NEAR(shown[i].origin.y, exact[i].origin.y, 1e-9);
      EXPECT_NEAR(shown[i].axis.x, exact[i].axis.x, 1e-12);
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(judged, 10);
}

TEST(DrivenLinkage, WaysOfDrivesAreFree) {
  PathProblem problem = read_path_problem("examples/paths/excavator.json");
  const PathAnswer found = find_path(problem);
  ASSERT_EQ(found.outcome, PathOutcome::path) << found.reason;
  // The straight way is not free, or the example would show nothing.
  EXPECT_EQ(check(path_scene(problem, {found.waypoints.front(), found.waypoints.back()})).outcome, Outcome::contact);
  EXPECT_EQ(check(path_scene(problem, found.waypoints)).outcome, Outcome::free);
  for (std::size_t k = 0; k < 3; ++k) problem.goal[k] = {problem.start[k], problem.start[k]};
  EXPECT_EQ(find_path(problem).outcome, PathOutcome::path);
}

/// A crank and what it must not pass: the block, which it overlaps in one interval of its turn.
std::string crank_problem(const std::string& drive, const std::string& more = "") {
  return R"({"format":"taut-scene/1","bodies":[
    {"name":"base","polygon":[[-5,-9],[45,-9],[45,-6],[-5,-6]]},
    {"name":"crank","polygon":[[0,-1],[10,-1],[10,1],[0,1]],"z":[0,1]},
    {"name":"coupler","polygon":[[9,1],[10,-1],[36,19],[35,21]],"z":[1,2]},
    {"name":"rocker","polygon":[[39,0],[41,0],[36,20],[34,20]],"z":[2,3]},
    {"name":"block","polygon":[[-12,-1],[-8,-1],[-8,1],[-12,1]],"z":[0,1]}],
   "mechanism":{"ground":"base","joints":{
    "A":{"revolute":["base","crank"],"at":[0,0]},
    "B":{"revolute":["crank","coupler"],"at":[10,0]},
    "C":{"revolute":["coupler","rocker"],"at":[35,20]},
    "D":{"revolute":["base","rocker"],"at":[40,0]}},
   "drive":)" +
         drive + "}" + more + "}";
}

TEST(DrivenLinkage, NoWayPastABlock) {
  const auto outcome = [](double goal) {
    return find_path(parse_path_problem(crank_problem(
                         R"({"A":[0,360]})", R"(,"start":{"A":10},"goal":{"A":)" + std::to_string(goal) + "}")))
        .outcome;
  };
  EXPECT_EQ(outcome(100), PathOutcome::path);
  EXPECT_EQ(outcome(350), PathOutcome::none);
}

/// The driven joint's bodies change places, so that its values have the other sign.
Linkage read_backwards(Linkage linkage) {
  taut::Joint& range = linkage.joints[0];
  range = taut::Joint{range.name, -range.hi, -range.lo};
  for (MechanismJoint& joint : linkage.scene.mechanism->joints) {
    if (joint.name == range.name) std::swap(joint.first, joint.second);
  }
  return linkage;
}

TEST(DrivenLinkage, RangesReadTheSameBackwards) {
  Rng rng(77);
  int accepted = 0, refused = 0;
  for (std::uint64_t n = effort(100); n > 0; --n) {
    const ClosedLinkage made(rng, rng.between(1, 2));
    const Linkage given = with_range(with_large_bodies(rng, made));
    const auto linkage = assembled_if_regular(given), other = assembled_if_regular(read_backwards(given));
    ASSERT_EQ(linkage.has_value(), other.has_value()) << n;
    ++(linkage ? accepted : refused);
    if (!linkage) continue;
    EXPECT_NEAR(envelope(*linkage).free, envelope(*other).free, 0.01) << n;
  }
  EXPECT_GT(accepted, static_cast<int>(enough(20)));
  EXPECT_GT(refused, static_cast<int>(enough(20)));
}

/// Two bars of length 5 are straight where the slide between their ends has moved by 4, exactly.
TEST(DrivenLinkage, RefusesADeadPointAtEitherEndOfARange) {
  for (const auto& [to, moves] : {std::pair{4.0, false}, {3.999, true}, {4.001, false}}) {
    Linkage linkage = parse_linkage(R"({"format":"taut-scene/1","bodies":[
      {"name":"base","polygon":[[-9,-9],[20,-9],[20,-8]]},{"name":"a","polygon":[[0,0],[3,4],[0,1]],"z":[1,2]},
      {"name":"b","polygon":[[3,4],[6,0],[6,1]],"z":[2,3]},{"name":"ram","polygon":[[6,0],[7,0],[6,1]],"z":[3,4]}],
     "mechanism":{"ground":"base","joints":{
      "A":{"revolute":["base","a"],"at":[0,0]},"B":{"revolute":["a","b"],"at":[3,4]},
      "C":{"revolute":["b","ram"],"at":[6,0]},"S":{"slide":["base","ram"],"direction":[1,0]}},
     "drive":{"S":[-1,3]}}})");
    // As it was given.
    for (Body& body : linkage.scene.bodies) body.relative_to.clear();
    linkage.motions.clear();
    linkage.joints[0] = taut::Joint{"S", -1, to};
    EXPECT_EQ(assembled_if_regular(linkage).has_value(), moves) << to;
    EXPECT_EQ(assembled_if_regular(read_backwards(linkage)).has_value(), moves) << to;
  }
}

void expect_refused(const std::string& text, const std::string& message) {
  try {
    parse_linkage(text);
    ADD_FAILURE() << "no error: " << message;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
  }
}

TEST(DrivenLinkage, NamesWhatIsWrong) {
  // A double rocker, driven at D, which reaches no full turn.
  expect_refused(crank_problem(R"({"D":[0,120]})"), "the mechanism locks within its range [0, 120], between");
  expect_refused(crank_problem(R"({"D":[-90,0]})"), "mechanism: drive D: it locks on the way");
  expect_refused(crank_problem(R"({"A":{"from_deg":0,"to_deg":90}})"), "mechanism.drive.A: expected");
  expect_refused(crank_problem(R"({"A":[0,90,180]})"), "write \"drive\": {\"A\": [0, 90]}");
  expect_refused(crank_problem(R"({"A":[90,0]})"), "to one that is no less");
  expect_refused(crank_problem("{}"), "no joint is driven");
  expect_refused(crank_problem(R"({"A":[0,90],"D":[0,9]})"), "its mobility is 1");
  expect_refused(crank_problem(R"({"A":[0,90]})", R"(,"joints":{"A":[0,1]})"), "has a joint of this name");
  expect_refused(crank_problem(R"({"A":[0,90]})", R"(,"joints":{"B":[0,1]})"), "has a joint \"B\"");
  std::string moving = crank_problem(R"({"A":[0,90]})", R"(,"joints":{"x":[0,1]})");
  const std::string rocker = R"("name":"rocker",)";
  moving.insert(moving.find(rocker) + rocker.size(), R"("motion":{"slide":{"direction":[1,0],"by":"x"}},)");
  expect_refused(moving, "\"rocker\" is a body of the mechanism, and has a motion of its own");
  // Five bars, and two cranks that move one loop: one range goes backwards.
  expect_refused(R"({"format":"taut-scene/1","bodies":[
    {"name":"base","polygon":[[0,-9],[9,-9],[9,-8]]},{"name":"a","polygon":[[0,0],[1,0],[1,9]]},
    {"name":"b","polygon":[[3,9],[4,9],[4,15]]},{"name":"c","polygon":[[8,9],[9,9],[9,14]]},
    {"name":"d","polygon":[[12,0],[13,0],[13,9]]}],
   "mechanism":{"ground":"base","joints":{
    "A":{"revolute":["base","a"],"at":[0,0]},"B":{"revolute":["a","b"],"at":[1,9]},
    "C":{"revolute":["b","c"],"at":[6,15]},"D":{"revolute":["c","d"],"at":[12,9]},
    "E":{"revolute":["base","d"],"at":[13,0]}},
   "drive":{"A":[0,9],"E":[9,0]}}})",
                 "to one that is no less");
  try {
    const PathProblem problem =
        parse_path_problem(crank_problem(R"({"A":[0,360]})", R"(,"periodic":["A"],"start":{"A":10},"goal":{"A":20})"));
    find_path(problem);
    ADD_FAILURE() << "a drive with a period";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("it drives a mechanism"), std::string::npos) << error.what();
  }
  Linkage bare;
  bare.joints = {taut::Joint{"A", 0, 1}};
  bare.scene = parse_linkage(crank_problem(R"({"A":[0,90]})")).scene;
  EXPECT_THROW(envelope(bare), InputError);
}

/// A scene of one instant at which a mechanism is not as drawn: distances once were searched for without end there.
TEST(DrivenLinkage, DistancesOfHeldDrives) {
  const Linkage linkage = read_linkage("examples/paths/excavator.json");
  for (const JointValues& values : {JointValues{-2.5, -20, 4}, JointValues{4, 15, -2}}) {
    const Scene exact = held_at(linkage, values);
    const NearestPoints nearest = clearance(exact).nearest.value();
    const double shown = clearance(posed(linkage, values)).nearest.value().hi;
    EXPECT_NEAR(nearest.hi, shown, 1e-6 * shown);
    EXPECT_LE(nearest.lo, shown * (1 + 1e-9));
    EXPECT_EQ(check_clearance(exact, 0.99 * shown).outcome, Outcome::free);
    EXPECT_EQ(check_clearance(exact, 1.01 * shown).outcome, Outcome::closer_at_start);
  }
  PathOptions apart;
  apart.clearance = 0.5;
  const PathProblem problem = read_path_problem("examples/paths/excavator.json");
  const PathAnswer found = find_path(problem, apart);
  ASSERT_EQ(found.outcome, PathOutcome::path) << found.reason;
  EXPECT_EQ(check_clearance(path_scene(problem, found.waypoints), 0.5).outcome, Outcome::free);
}

/// A joint whose range is one value is held there.
TEST(DrivenLinkage, AHeldJoint) {
  const Linkage linkage = parse_linkage(crank_problem(R"({"A":[180,180]})"));
  EXPECT_EQ(envelope(linkage).outcome, Outcome::contact);
  EXPECT_EQ(envelope(parse_linkage(crank_problem(R"({"A":[90,90]})"))).outcome, Outcome::free);
}

/// A block slides towards a four-bar that is always in its way. Over most of the drive's range nothing is known of
/// where the bars are, so that it does not help to divide what the block does.
TEST(DrivenLinkage, IsDividedByTheJointThatLoopsAreUncertainOf) {
  const PathProblem problem = parse_path_problem(R"({"format":"taut-scene/1","joints":{"s":[0,12]},"bodies":[
    {"name":"ground","polygon":[[-9,-9],[-8,-9],[-8,-8]]},
    {"name":"crank","polygon":[[0.064,-0.275],[2.075,2.964],[1.736,3.175],[-0.275,-0.064]],"z":[0,1]},
    {"name":"coupler","polygon":[[1.691,2.639],[6.461,4.591],[6.309,4.961],[1.539,3.009]],"z":[1,2]},
    {"name":"rocker","polygon":[[6.191,-0.208],[6.408,4.891],[6.009,4.908],[5.792,-0.191]],"z":[0,1]},
    {"name":"block","polygon":[[-5,0.4],[-4,0.4],[-4,2.4],[-5,2.4]],
     "motion":{"slide":{"direction":[1,0],"by":"s"}}}],
   "mechanism":{"ground":"ground","joints":{
     "A":{"revolute":["ground","crank"],"at":[0,0]},"B":{"revolute":["crank","coupler"],"at":[1.8,2.9]},
     "C":{"revolute":["coupler","rocker"],"at":[6.2,4.7]},"D":{"revolute":["ground","rocker"],"at":[6,0]}},
    "drive":{"D":[-1,87]}},
   "start":{"s":0,"D":0},"goal":{"s":12}})");
  PathOptions options;
  options.max_cells = 1000;
  const PathAnswer answer = find_path(problem, options);
  EXPECT_EQ(answer.outcome, PathOutcome::none) << answer.reason;
}

}  // namespace
}  // namespace taut::testing
