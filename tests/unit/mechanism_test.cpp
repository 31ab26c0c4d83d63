// Mechanisms from JSON, and their errors.
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "motion/joint_value.hpp"
#include "scene/mechanism.hpp"
#include "taut/check.hpp"
#include "taut/error.hpp"
#include "taut/intervals.hpp"
#include "taut/io.hpp"
#include "taut/mechanism_motion.hpp"
#include "taut/pose.hpp"
#include "taut/simulation.hpp"

namespace taut::testing {
namespace {

/// Four bars with a crank of length 10, and what is to be changed of them.
std::string four_bar(const std::string& from = "", const std::string& to = "") {
  std::string text = R"({"format":"taut-scene/1","time":[0,1],"bodies":[
    {"name":"base","polygon":[[-5,-9],[45,-9],[45,-6],[-5,-6]],"z":[-1,0]},
    {"name":"crank","polygon":[[0,-1],[10,-1],[10,1],[0,1]],"z":[0,1]},
    {"name":"coupler","polygon":[[9,1],[10,-1],[36,19],[35,21]],"z":[1,2]},
    {"name":"rocker","polygon":[[39,0],[41,0],[36,20],[34,20]],"z":[2,3]}],
   "mechanism":{"ground":"base","joints":{
    "A":{"revolute":["base","crank"],"at":[0,0]},
    "B":{"revolute":["crank","coupler"],"at":[10,0]},
    "C":{"revolute":["coupler","rocker"],"at":[35,20]},
    "D":{"revolute":["base","rocker"],"at":[40,0]}},
   "drive":{"A":{"from_deg":0,"to_deg":360}}}})";
  if (from.empty()) return text;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return text.replace(at, from.size(), to);
}

void expect_error(const std::string& from, const std::string& to, const std::string& message) {
  try {
    parse_scene(four_bar(from, to));
    ADD_FAILURE() << "no error: " << message;
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find(message), std::string::npos) << e.what();
  }
}

TEST(MechanismFile, NamesWhatIsWrong) {
  expect_error(R"({"from_deg":0,"to_deg":360})", R"({"deg":[]})", "it has no coefficients");
  expect_error(R"("ground":"base")", R"("ground":"bass")", "scene:6:16: mechanism");
  expect_error(R"("ground":"base")", R"("ground":"bass")", "there is no body \"bass\"");
  expect_error(R"(["base","crank"])", R"(["base","crunk"])", "there is no body \"crunk\"");
  expect_error(R"(["base","crank"])", R"(["crank","crank"])", "to itself");
  expect_error(R"("drive":{"A")", R"("drive":{"a")", "there is no joint \"a\"");
  expect_error(R"("to_deg":360)", R"("to":360)", "unknown key");
  expect_error(R"(["base","crank"],"at":[0,0])", R"(["base","crank"],"at":[0,0],"direction":[1,0])",
               "no \"direction\"");
  expect_error(R"({"revolute":["crank","coupler"],"at":[10,0]})", R"({"slide":["crank","coupler"],"direction":[0,0]})",
               "no length");
  expect_error(R"("name":"crank",)", R"("name":"crank","motion":{"velocity":[1,0]},)", "a motion of its own");
  expect_error(R"("name":"rocker",)", R"("name":"rocker","relative_to":"base",)", "`relative_to` of its own");
  expect_error(R"({"A":{"from_deg":0,"to_deg":360}})", R"({"A":[{"t":0,"deg":0},{"t":0.5,"deg":90}]})", "do not cover");
  expect_error(R"({"A":{"from_deg":0,"to_deg":360}})", R"({"A":[{"t":0,"deg":0},{"t":0,"deg":90}]})", "not later");
  expect_error(R"("to_deg":360)", R"("to_deg":1e9)", "too long");
  expect_error(R"("drive":)", R"("couple":[{"joint":"D","to":"A","plus":3}],"drive":)", "this must be 0");
  expect_error(R"("drive":)", R"("couple":[{"joint":"A","to":"D"}],"drive":)", "driven and coupled");
}

TEST(MechanismFile, CountsWhatIsDriven) {
  expect_error(R"({"A":{"from_deg":0,"to_deg":360}})", R"({})", "its mobility is 1");
  expect_error(R"({"A":{"from_deg":0,"to_deg":360}})",
               R"({"A":{"from_deg":0,"to_deg":9},"D":{"from_deg":0,"to_deg":9}})", "its mobility is 1");
  expect_error(R"("drive":)", R"("couple":[{"joint":"D","to":"B"}],"drive":)", "its mobility is 0");
  // With both of its pins at one place, the coupler is no link: another drive is no help.
  expect_error(R"(["coupler","rocker"],"at":[35,20])", R"(["coupler","rocker"],"at":[10,0])",
               "hint: link \"coupler\" has no length, as its joints \"B\" and \"C\" are at one place");
  // Without C, coupler and rocker swing freely.
  expect_error(R"("C":{"revolute":["coupler","rocker"],"at":[35,20]},)", "", "its mobility is 3");
}

TEST(MechanismFile, RefusesToStartAtADeadPoint) {
  try {
    parse_scene(R"({"format":"taut-scene/1","time":[0,1],"bodies":[
      {"name":"base","polygon":[[-5,-9],[45,-9],[45,-6],[-5,-6]]},{"name":"a","polygon":[[0,0],[1,0],[0,1]],"z":[1,2]},
      {"name":"b","polygon":[[0,0],[1,0],[0,1]],"z":[2,3]},{"name":"c","polygon":[[0,0],[1,0],[0,1]],"z":[3,4]}],
      "mechanism":{"ground":"base","joints":{"A":{"revolute":["base","a"],"at":[0,0]},"B":{"revolute":["a","b"],"at":[3,4]},
       "C":{"revolute":["b","c"],"at":[6,8]},"S":{"slide":["base","c"],"direction":[3,4]}},
      "drive":{"S":{"from":0,"to":-1}}}})");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("dead point"), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("\"B\""), std::string::npos) << e.what();
  }
}

TEST(MechanismFile, IsWrittenAsItIsRead) {
  for (const std::string& text : {four_bar(),
                                  four_bar(R"({"A":{"from_deg":0,"to_deg":360}})",
                                           R"({"A":[{"t":-1,"deg":5},{"t":0.25,"deg":40},{"t":3,"deg":0}]})"),
                                  four_bar(R"({"A":{"from_deg":0,"to_deg":360}})", R"({"A":{"deg":[0,20,-7]}})")}) {
    const Scene scene = parse_scene(text), again = parse_scene(write_scene(scene));
    EXPECT_EQ(write_scene(scene), write_scene(again));
    for (const double t : {0.0, 0.2, 0.25, 0.7, 1.0}) {
      const auto a = poses_at(scene, t), b = poses_at(again, t);
      for (std::size_t k = 0; k < a.size(); ++k) {
        EXPECT_EQ(a[k].origin, b[k].origin) << t;
        EXPECT_EQ(a[k].axis, b[k].axis) << t;
      }
    }
  }
}

/// A crank and a coupler of length 5, whose slider passes the crank's pivot where the crank is square to the slide.
TEST(MechanismFile, SeesTheChangePointOfASlider) {
  const auto scene = [](const std::string& crank, const std::string& slide, const std::string& end, double degrees) {
    return parse_scene(R"({"format":"taut-scene/1","time":[0,1],"bodies":[
      {"name":"base","polygon":[[-9,-9],[20,-9],[20,-8]]},{"name":"a","polygon":[[0,0],[3,4],[0,1]],"z":[1,2]},
      {"name":"b","polygon":[[3,4],[6,0],[6,1]],"z":[2,3]},{"name":"c","polygon":[[6,0],[7,0],[6,1]],"z":[3,4]}],
     "mechanism":{"ground":"base","joints":{
      "A":{"revolute":)" +
                       crank + R"(,"at":[0,0]},"B":{"revolute":["a","b"],"at":[3,4]},
      "C":{"revolute":["b","c"],"at":)" +
                       end + R"(},"S":{"slide":)" + slide + R"(,"direction":[-2,0]}},
     "drive":{"A":{"from_deg":0,"to_deg":)" +
                       std::to_string(degrees) + "}}}}");
  };
  const double turn = 90 - std::atan2(4, 3) * 180 / std::acos(-1);
  for (const char* slide : {R"(["base","c"])", R"(["c","base"])"}) {
    for (const bool backwards : {false, true}) {
      const Scene locked =
          backwards ? scene(R"(["a","base"])", slide, "[6,0]", -60) : scene(R"(["base","a"])", slide, "[6,0]", 60);
      ASSERT_TRUE(locked.lock);
      EXPECT_EQ(locked.lock->kind, MechanismLock::Kind::change_point);
      EXPECT_NEAR(locked.lock->time[0], turn / 60, 1e-12);
      EXPECT_NEAR(locked.lock->time[1], turn / 60, 1e-12);
    }
  }
  // Where the coupler is shorter, or the slide passes beside the pivot, it is none.
  for (const char* end : {"[5.875,0]", "[6,0.0625]"}) {
    const Scene other = scene(R"(["base","a"])", R"(["base","c"])", end, 60);
    EXPECT_TRUE(!other.lock || other.lock->kind == MechanismLock::Kind::dead_point) << end;
  }
}

/// Five bars, and a motor at each end: the pin between the two others is where two circles meet.
TEST(MechanismFile, FollowsTwoMotors) {
  const Scene scene = parse_scene(R"({"format":"taut-scene/1","time":[0,1],"bodies":[
    {"name":"base","polygon":[[-9,-9],[0,-9],[0,-8]]},
    {"name":"a","polygon":[[0,0],[3,4],[0,1]],"z":[1,2]},{"name":"b","polygon":[[3,4],[6,12],[5,12]],"z":[2,3]},
    {"name":"c","polygon":[[6,12],[15,4],[14,4]],"z":[3,4]},{"name":"d","polygon":[[12,0],[15,4],[13,0]],"z":[4,5]}],
   "mechanism":{"ground":"base","joints":{
    "A":{"revolute":["base","a"],"at":[0,0]},"B":{"revolute":["a","b"],"at":[3,4]},
    "C":{"revolute":["b","c"],"at":[6,12]},"D":{"revolute":["d","c"],"at":[15,4]},
    "E":{"revolute":["base","d"],"at":[12,0]}},
   "drive":{"A":{"from_deg":0,"to_deg":70},"E":{"from_deg":0,"to_deg":-50}}}})");
  EXPECT_FALSE(scene.lock);
  EXPECT_EQ(check(scene).outcome, Outcome::free);
  for (const double t : {0.0, 0.25, 0.5, 1.0}) {
    const auto turned = [](double x, double y, double degrees) {
      const double w = degrees * std::acos(-1) / 180;
      return Point{x * std::cos(w) - y * std::sin(w), x * std::sin(w) + y * std::cos(w)};
    };
    const Point b = turned(3, 4, 70 * t), arm = turned(3, 4, -50 * t), d{12 + arm.x, arm.y};
    // C is off B by the square root of 73, off D by that of 145, and on the left of the way from D to B.
    const Point way{b.x - d.x, b.y - d.y};
    const double square = way.x * way.x + way.y * way.y, along = (square + 145 - 73) / (2 * square);
    const double up = -std::sqrt(145 / square - along * along);
    const Point c{d.x + along * way.x - up * way.y, d.y + along * way.y + up * way.x};
    const BodyPose pose = poses_at(scene, t)[2];
    EXPECT_NEAR(pose.origin.x + pose.axis.x * 6 - pose.axis.y * 12, c.x, 1e-12) << t;
    EXPECT_NEAR(pose.origin.y + pose.axis.y * 6 + pose.axis.x * 12, c.y, 1e-12) << t;
  }
}

TEST(MechanismFile, KeepsTheTimeOfASceneThatLocks) {
  std::string text = four_bar(R"({"A":{"from_deg":0,"to_deg":360}})", R"({"D":{"from_deg":0,"to_deg":120}})");
  // The base below the rocker, on its layer.
  text.replace(text.find("\"z\":[-1,0]"), 10, "\"z\":[2,3]");
  const Scene scene = parse_scene(text);
  ASSERT_TRUE(scene.lock);
  EXPECT_LT(scene.end, 1);
  EXPECT_EQ(scene.lock->kind, MechanismLock::Kind::dead_point);
  const Scene again = parse_scene(write_scene(scene));
  EXPECT_EQ(again.end, scene.end);
  EXPECT_EQ(again.lock->time, scene.lock->time);
  const Answer answer = check(scene);
  EXPECT_EQ(answer.outcome, Outcome::locked);
  EXPECT_EQ(answer.free_until, scene.end);
  Simulation simulation(scene);
  EXPECT_EQ(simulation.advance_to(1), SimulationState::locked);
  EXPECT_EQ(simulation.time(), scene.end);
}

/// Polygons stand for the curves, and the lock is said of the bodies themselves.
TEST(MechanismFile, LocksWithCurves) {
  std::string text = four_bar(R"({"A":{"from_deg":0,"to_deg":360}})", R"({"D":{"from_deg":0,"to_deg":120}})");
  const std::string base = R"("polygon":[[-5,-9],[45,-9],[45,-6],[-5,-6]],"z":[-1,0])";
  text.replace(text.find(base), base.size(), R"("polygon":{"path":"M-5 -9 H45 V-6 A25 1 0 0 1 -5 -6 Z"},"z":[2,3])");
  const Scene scene = parse_scene(text);
  ASSERT_TRUE(scene.lock);
  const Answer answer = check(scene);
  EXPECT_EQ(answer.outcome, Outcome::locked) << answer.reason;
  EXPECT_EQ(answer.free_until, scene.end);
}

/// In the drawn pose all bodies are where they are drawn.
TEST(MechanismFile, BeginsAsDrawn) {
  for (const BodyPose& pose : poses_at(parse_scene(four_bar()), 0)) {
    EXPECT_NEAR(pose.origin.x, 0, 1e-13);
    EXPECT_NEAR(pose.origin.y, 0, 1e-13);
    EXPECT_NEAR(pose.axis.y, 0, 1e-15);
  }
}

TEST(MechanismFile, RefusesQuestionsBeforeItIsAssembled) {
  Scene scene = parse_scene(four_bar());
  for (Body& body : scene.bodies) {
    body.motion = {};
    body.relative_to.clear();
  }
  scene.assembly = nullptr;
  EXPECT_THROW(check(scene), InputError);
  EXPECT_EQ(check(assembled(scene)).outcome, check(parse_scene(four_bar())).outcome);
}

/// A toggle that is driven by its ram: two links of length sqrt(544), in line where the ram is at 6.64761515876...
Scene toggle(double start, double end, const std::vector<std::array<double, 2>>& keyframes) {
  Scene scene = parse_scene(R"({"format":"taut-scene/1","time":[0,1],"bodies":[
    {"name":"frame","polygon":[[-14,44],[14,44],[14,50],[-14,50]],"z":[0,2]},
    {"name":"upper","polygon":[[-1,40],[11,19],[13,21],[1,41]],"z":[2,4]},
    {"name":"lower","polygon":[[-1,0],[1,0],[13,20],[11,21]],"z":[4,6]},
    {"name":"ram","polygon":[[-8,-20],[8,-20],[8,2],[-8,2]],"z":[2,4]}],
   "mechanism":{"ground":"frame","joints":{
    "A":{"revolute":["frame","upper"],"at":[0,40]},
    "B":{"revolute":["upper","lower"],"at":[12,20]},
    "C":{"revolute":["lower","ram"],"at":[0,0]},
    "S":{"slide":["frame","ram"],"direction":[0,-1]}},
   "drive":{"S":{"from":0,"to":0}}}})");
  Scene out;
  out.start = start;
  out.end = end;
  out.bodies = scene.bodies;
  for (Body& body : out.bodies) {
    body.motion = {};
    body.relative_to.clear();
  }
  out.mechanism = scene.mechanism;
  taut::Drive& drive = out.mechanism->drives.front();
  drive.pieces.clear();
  for (std::size_t k = 1; k < keyframes.size(); ++k) {
    taut::Drive::Piece piece;
    piece.line = {keyframes[k - 1][0], keyframes[k - 1][1], keyframes[k][0], keyframes[k][1]};
    if (k + 1 < keyframes.size()) piece.until = keyframes[k][0];
    drive.pieces.push_back(piece);
  }
  return assembled(std::move(out));
}
const double in_line_at = 2 * std::sqrt(544.0) - 40;

TEST(MechanismLock, IsFoundAtTimesFarFrom0) {
  for (const double from : {1e6, 1.7e9, 1e12}) {
    const Scene scene = toggle(from, from + 1, {{from, 0}, {from + 1, 10}});
    ASSERT_TRUE(scene.lock) << from;
    EXPECT_LE(scene.lock->time[0], from + in_line_at / 10) << from;
    EXPECT_GE(scene.lock->time[1], from + in_line_at / 10) << from;
  }
}

TEST(MechanismLock, IsNotBehindTheTurnOfADrive) {
  // The links come nearly in line, and go back.
  for (const double gap : {4e-13, 2e-12, 1e-11}) {
    const Scene scene = toggle(0, 2, {{0, 0}, {1, in_line_at - gap}, {2, 0}});
    EXPECT_TRUE(!scene.lock || scene.lock->kind == MechanismLock::Kind::undecided) << gap;
  }
}

TEST(MechanismLock, AtTheBeginningIsAnError) {
  for (const double gap : {0.0, 1e-13, 1e-12, 1e-11, 1e-10}) {
    for (const double to : {0.0, 10.0})
      EXPECT_THROW(toggle(0, 1, {{0, in_line_at - gap}, {1, to}}), InputError) << gap << " " << to;
  }
  EXPECT_THROW(toggle(0, 1e-300, {{0, 0}, {1e-300, 5}}), InputError);
}

TEST(MechanismLock, AtAKeyframeEndsTheMotionThere) {
  const Scene scene = toggle(0, 2, {{0, 0}, {1, in_line_at - 1e-8}, {2, 1e15}});
  ASSERT_TRUE(scene.lock);
  EXPECT_EQ(scene.end, 1);
  EXPECT_EQ(check(scene).outcome, Outcome::undecided);
}

TEST(MechanismFile, HasJointsOfUsualSize) {
  expect_error(R"("at":[35,20])", R"("at":[1e200,20])", "between 2^-400 and 2^400");
  expect_error(R"({"revolute":["crank","coupler"],"at":[10,0]})",
               R"({"slide":["crank","coupler"],"direction":[0,1e300]})", "between 2^-400 and 2^400");
}

TEST(MechanismFile, HasATimeInOrder) { expect_error(R"("time":[0,1])", R"("time":[1,0])", "ends before it starts"); }

/// A slide that is back at 0 at the end of a turn, and joints that rest.
TEST(MechanismMotion, FindsRangesOfSlidesThatReturn) {
  const std::string text = R"({"format":"taut-scene/1","time":[0,360],"bodies":[
    {"name":"base","polygon":[[-5,-9],[60,-9],[60,-8],[-5,-8]]},{"name":"crank","polygon":[[0,-1],[10,-1],[10,1]]},
    {"name":"rod","polygon":[[10,-1],[40,-1],[40,1]]},{"name":"piston","polygon":[[38,-3],[44,-3],[44,3]]}],
   "mechanism":{"ground":"base","joints":{
    "A":{"revolute":["base","crank"],"at":[0,0]},"B":{"revolute":["crank","rod"],"at":[10,0]},
    "C":{"revolute":["rod","piston"],"at":[40,0]},"S":{"slide":["base","piston"],"direction":[1,0]}},
   "drive":{"A":{"deg":[0,1]}}}})";
  const MechanismMotion turn = mechanism_motion(parse_scene(text));
  EXPECT_NEAR(turn.joints[3].least.lo, -20, 1e-6);
  EXPECT_NEAR(turn.joints[3].greatest.hi, 0, 1e-6);
  std::string resting = text;
  const std::string drive = R"("deg":[0,1])";
  resting.replace(resting.find(drive), drive.size(), R"("deg":[0])");
  for (const JointRange& joint : mechanism_motion(parse_scene(resting)).joints) {
    EXPECT_NEAR(joint.least.lo, 0, 1e-9);
    EXPECT_NEAR(joint.greatest.hi, 0, 1e-9);
  }
}

/// The rocker's pin is the crank's: the three links turn as one body, and no joint between them moves.
TEST(MechanismMotion, OfALoopThatTurnsAsAWhole) {
  const MechanismMotion turns = mechanism_motion(parse_scene(R"({"format":"taut-scene/1","time":[0,1],"bodies":[
    {"name":"base","polygon":[[-1,-50],[1,-50],[1,-49]]},{"name":"crank","polygon":[[0,0],[10,-1],[10,1]]},
    {"name":"coupler","polygon":[[10,0],[20,15],[14,12]]},{"name":"rocker","polygon":[[0,0],[20,14],[20,15]]}],
   "mechanism":{"ground":"base","joints":{
    "A":{"revolute":["base","crank"],"at":[0,0]},"B":{"revolute":["crank","coupler"],"at":[10,0]},
    "C":{"revolute":["coupler","rocker"],"at":[20,15]},"D":{"revolute":["base","rocker"],"at":[0,0]}},
   "drive":{"A":{"from_deg":0,"to_deg":400}}}})"));
  EXPECT_EQ(turns.outcome, MechanismMotion::Outcome::moves);
  EXPECT_NEAR(turns.joints[3].greatest.lo, 400, 1e-6);
  for (const std::size_t still : {1u, 2u}) {
    EXPECT_NEAR(turns.joints[still].least.lo, 0, 1e-8);
    EXPECT_NEAR(turns.joints[still].greatest.hi, 0, 1e-8);
  }
  const double angle = std::acos(425 / (25 * std::sqrt(325.0))) * 180 / 3.14159265358979323846;
  ASSERT_EQ(turns.transmission.size(), 1u);
  EXPECT_NEAR(turns.transmission[0].least.lo, angle, 1e-6);
  EXPECT_NEAR(turns.transmission[0].greatest.hi, angle, 1e-6);
}

/// Corners of all bodies are on the pins, of which two join three bodies, and every loop is closed at one of them.
const char* const corners_on_pins = R"({"format":"taut-scene/1","time":[0,1],"bodies":[
    {"name":"base","polygon":[[0,0],[40,0],[20,-10]]},{"name":"crank","polygon":[[0,0],[10,0],[5,3]]},
    {"name":"coupler","polygon":[[10,0],[35,20],[15,15]]},{"name":"rod","polygon":[[10,0],[15,-20],[20,-18]]},
    {"name":"foot","polygon":[[15,-20],[40,0],[35,-20]]},{"name":"rocker","polygon":[[35,20],[40,0],[45,12]]}],
   "mechanism":{"ground":"base","joints":{
    "A":{"revolute":["base","crank"],"at":[0,0]},"B":{"revolute":["crank","coupler","rod"],"at":[10,0]},
    "C":{"revolute":["coupler","rocker"],"at":[35,20]},"D":{"revolute":["base","rocker","foot"],"at":[40,0]},
    "E":{"revolute":["rod","foot"],"at":[15,-20]}},
   "drive":{"A":{"from_deg":0,"to_deg":360}}}})";

TEST(MechanismIdentities, HoldForCornersOnPins) {
  const Intervals answer = intervals(parse_scene(corners_on_pins));
  EXPECT_EQ(answer.outcome, Outcome::contact) << answer.reason;
  EXPECT_EQ(answer.coverage.tested, 14u);
  // With their common corner on the pin: from the pictures of all poses, the coupler and the rocker never overlap.
  for (const OverlapInterval& interval : answer.intervals) EXPECT_NE(interval.pair, (std::array<BodyId, 2>{2, 5}));
}

/// In the drawn pose, which edge is along which is known exactly, not only that it nearly is.
TEST(MechanismIdentities, HoldInTheDrawnPose) {
  std::string text = corners_on_pins;
  // The rocker's edge from the pin D upwards is along the foot's.
  const std::string foot = "[[15,-20],[40,0],[35,-20]]";
  text.replace(text.find(foot), foot.size(), "[[15,-20],[40,0],[38,8]]");
  const Intervals answer = intervals(parse_scene(text));
  EXPECT_EQ(answer.outcome, Outcome::contact) << answer.reason;
}

/// Far from the origin, as drawings of plants are.
TEST(MechanismLock, IsFoundFarFromTheOrigin) {
  const auto moved = [](double by) {
    Scene scene = toggle(0, 1, {{0, 0}, {1, 10}});
    scene.assembly.reset();
    scene.lock.reset();
    scene.end = 1;
    for (Body& body : scene.bodies) {
      body.motion = {};
      body.relative_to.clear();
      for (Point& p : body.polygon) p = {p.x + by, p.y - by};
    }
    for (MechanismJoint& joint : scene.mechanism->joints) joint.at = {joint.at.x + by, joint.at.y - by};
    return assembled(scene);
  };
  const Scene here = moved(0);
  ASSERT_TRUE(here.lock);
  for (const double by : {0x1p20, 0x1p40}) {
    const Scene there = moved(by);
    ASSERT_TRUE(there.lock) << by;
    EXPECT_EQ(there.lock->kind, MechanismLock::Kind::dead_point) << by;
    EXPECT_EQ(there.lock->time, here.lock->time) << by;
    EXPECT_EQ(there.end, here.end) << by;
  }
}

TEST(MechanismMotion, IsKnownBetweenTheDoublesOfTimesFarFrom0) {
  using namespace internal;
  const Scene scene = parse_scene(four_bar(R"("time":[0,1])", R"("time":[1700000000,1700000001])"));
  const JointFunctions& functions = *scene.assembly->functions;
  const Ball<Real960> t(Real960(1700000000.5) + Real960(0x1p-24), 0.0);
  for (std::size_t k = 0; k < functions.equations().joints.size(); ++k) {
    const auto value = joint_value<Series<Real960, 0>>(functions, k, 0, t);
    EXPECT_LT(value.c[0].rad, 1e-200) << k;
  }
}

}  // namespace
}  // namespace taut::testing
