// Pieces whose polynomials count time from an origin. The laws: a motion is the same function of time in powers of the
// time since any origin; and a scene that is moved in time together with the origins has the answer of the scene
// before, moved likewise.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <sstream>

#include "motion/pieces.hpp"
#include "motion/pose.hpp"
#include "support/moved_in_time.hpp"
#include "support/rng.hpp"
#include "taut/check.hpp"
#include "taut/clearance.hpp"
#include "taut/error.hpp"
#include "taut/intervals.hpp"
#include "taut/io.hpp"
#include "taut/motions.hpp"
#include "taut/pose.hpp"
#include "taut/proof.hpp"

namespace taut::testing {
using namespace internal;
namespace {

constexpr double unix_seconds = 1790000000;

double ulp(double x) { return std::nextafter(std::fabs(x), INFINITY) - std::fabs(x); }

std::vector<Keyframe> random_keyframes(Rng& rng, double epoch) {
  std::vector<Keyframe> keyframes;
  double t = epoch;
  for (int k = 2 + rng.below(6); k > 0; --k) {
    Keyframe key;
    key.t = t;
    key.x = rng.real(-10, 10);
    key.y = rng.chance(0.2) ? 3 : rng.real(-10, 10);
    key.angle_deg = rng.chance(0.3) ? 90 * rng.below(9) : rng.real(-400, 400);
    keyframes.push_back(key);
    t += rng.chance(0.5) ? 0.02 + 1e-6 * rng.below(1000) : rng.real(0.001, 5);
  }
  return keyframes;
}

void expect_pose(const BodyPose& pose, const Keyframe& key) {
  EXPECT_NEAR(pose.origin.x, key.x, ulp(key.x)) << key.t;
  EXPECT_NEAR(pose.origin.y, key.y, ulp(key.y)) << key.t;
  const long double angle = key.angle_deg * (3.14159265358979323846264338327950288L / 180);
  const double rounding = 0x1p-52 * (1 + std::fabs(key.angle_deg) / 57);
  EXPECT_NEAR(pose.axis.x, static_cast<double>(std::cos(angle)), rounding) << key.t;
  EXPECT_NEAR(pose.axis.y, static_cast<double>(std::sin(angle)), rounding) << key.t;
}

TEST(Origins, PosesAtKeyframesAreThoseWrittenWheneverTimeBegins) {
  Rng rng(1);
  for (int round = 0; round < 200; ++round) {
    for (const double epoch : {0.0, 1e6, unix_seconds, -unix_seconds}) {
      const std::vector<Keyframe> keyframes = random_keyframes(rng, epoch);
      const Motion motion = from_keyframes(keyframes);
      for (const Keyframe& key : keyframes) expect_pose(pose_at(motion, key.t), key);
      // At its end a piece is where the next one begins, up to the rounding of its slope.
      for (std::size_t k = 1; k < keyframes.size(); ++k) {
        const Keyframe &from = keyframes[k - 1], &to = keyframes[k];
        const Pose<Real320> end = pose(motion.pieces[k], Ball<Real320>::exact(to.t));
        const double x = RealTraits<Real320>::to_double(end.ox.v.mid), y = RealTraits<Real320>::to_double(end.oy.v.mid);
        EXPECT_NEAR(x, to.x, 0x1p-53 * std::fabs(to.x - from.x) + ulp(to.x));
        EXPECT_NEAR(y, to.y, 0x1p-53 * std::fabs(to.y - from.y) + ulp(to.y));
      }
    }
  }
}

TEST(Origins, WaysAroundACentreCountFromTheirKeyframes) {
  const std::vector<Keyframe> keyframes{{unix_seconds, 3, 0.1, 20},
                                        {unix_seconds + 1.5, 0, 0, 0, Way::turn, {1, 1}, 45},
                                        {unix_seconds + 2.75, 0, 0, 0, Way::arc, {0, 2}, -70}};
  std::vector<Keyframe> at_zero = keyframes;
  for (Keyframe& key : at_zero) key.t -= unix_seconds;
  const Motion late = from_keyframes(keyframes), early = from_keyframes(at_zero);
  for (double t = 0; t <= 3; t += 0.0625) {
    const BodyPose a = pose_at(late, unix_seconds + t), b = pose_at(early, t);
    EXPECT_EQ(a.origin, b.origin);
    EXPECT_EQ(a.axis, b.axis);
  }
}

TEST(Origins, AnglesOfSweepsAreThoseWritten) {
  const Motion sweep = from_sweep({1, 2}, 10, 35, unix_seconds, unix_seconds + 3);
  const auto angle = angle_at(sweep, {unix_seconds, unix_seconds + 3});
  ASSERT_TRUE(angle);
  EXPECT_NEAR(angle->lo, 10, 4e-15);
  EXPECT_NEAR(angle->hi, 35, 8e-15);
}

/// May two instants be one, where one of them is later by `shift`?
void expect_same_time(const TimeInterval& a, const TimeInterval& b, double shift) {
  const double room = 2 * ulp(shift) + 0x1p-50;
  EXPECT_LE(a.lo, b.hi - shift + room);
  EXPECT_GE(a.hi, b.lo - shift - room);
  EXPECT_LE(b.hi - b.lo, a.hi - a.lo + room + ulp(b.hi));
}

void expect_same_answer(const Answer& a, const Answer& b, double shift) {
  ASSERT_EQ(a.outcome, b.outcome);
  ASSERT_EQ(a.contact.has_value(), b.contact.has_value());
  if (!a.contact) return;
  expect_same_time(a.contact->time, b.contact->time, shift);
  EXPECT_EQ(a.contact->vertex.index, b.contact->vertex.index);
  EXPECT_EQ(a.contact->edge.index, b.contact->edge.index);
}

/// All there is to ask: the same in both scenes, but for the times.
void expect_same_answers(const Scene& a, const Scene& b, double shift) {
  for (const EngineChoice engine : {EngineChoice::kinetic, EngineChoice::spacetime}) {
    for (const Touch touch : {Touch::open, Touch::closed}) {
      CheckOptions options;
      options.engine = engine;
      options.touch = touch;
      expect_same_answer(check(a, options), check(b, options), shift);
      std::ostringstream log;
      const Answer proved = prove(b, log, options);
      expect_same_answer(check(a, options), proved, shift);
      if (proved.outcome == Outcome::overlap_at_start) continue;
      std::istringstream read(log.str());
      EXPECT_NO_THROW(verify(b, read));
    }
  }
  const Clearance near = clearance(a), far = clearance(b);
  ASSERT_EQ(near.outcome, far.outcome);
  ASSERT_EQ(near.nearest.has_value(), far.nearest.has_value());
  if (near.nearest) {
    EXPECT_NEAR(near.nearest->lo, far.nearest->lo, 2e-9 * near.nearest->hi + 1e-11);
  }
  const Intervals first = intervals(a), second = intervals(b);
  ASSERT_EQ(first.outcome, second.outcome);
  ASSERT_EQ(first.intervals.size(), second.intervals.size());
  for (std::size_t k = 0; k < first.intervals.size(); ++k) {
    expect_same_time(first.intervals[k].from, second.intervals[k].from, shift);
    expect_same_time(first.intervals[k].to, second.intervals[k].to, shift);
  }
}

/// Two bodies that both move, so that their pieces may have different origins; with a joint.
std::vector<Scene> moving_scenes() {
  std::vector<Scene> scenes = small_scenes();
  for (Scene& scene : scenes) {
    MotionPiece &own = scene.bodies[1].motion.pieces[0], other;
    other.x = {0, 0.25};
    own.x.resize(std::max<std::size_t>(own.x.size(), 2));
    own.x[1] += 0.25;
    MotionPiece before = other, after = other;
    before.until = 2;
    scene.bodies[0].motion.pieces = {before, after};
    if (own.rotation.index() == 1) scene.bodies[0].motion.pieces[1].rotation = AngleRotation{{-0.25, 0.125}};
  }
  return scenes;
}

TEST(Origins, AMotionIsTheSameAboutEveryOrigin) {
  std::vector<Scene> scenes = small_scenes();
  for (const Scene& scene : moving_scenes()) scenes.push_back(scene);
  for (const Scene& scene : scenes) {
    for (const std::array<double, 2>& origins : {std::array{1.0, 1.0}, std::array{0.0, 3.0}, std::array{2.0, -64.0}}) {
      Scene moved = scene;
      for (std::size_t b = 0; b < 2; ++b) {
        for (MotionPiece& piece : moved.bodies[b].motion.pieces) piece = about_origin(piece, origins[b]);
      }
      SCOPED_TRACE(write_scene(moved));
      expect_same_answers(scene, moved, 0);
    }
  }
}

TEST(Origins, AnswersMoveWithTheSceneAndItsOrigins) {
  for (const Scene& scene : moving_scenes()) {
    Scene about = scene;
    for (Body& body : about.bodies) {
      for (MotionPiece& piece : body.motion.pieces) piece = about_origin(piece, &body == &about.bodies[0] ? 0.5 : 1);
    }
    for (const double shift : {unix_seconds, -unix_seconds}) {
      SCOPED_TRACE(write_scene(later(about, shift)));
      expect_same_answers(scene, later(about, shift), shift);
    }
  }
}

/// The law for pieces whose polynomials have coefficients of all bits: the same bits of times that differ.
TEST(Origins, KeyframesHaveTheAnswersOfThoseAtTimeZero) {
  Rng rng(3);
  for (int round = 0; round < 12; ++round) {
    Scene early = small_scenes()[0];
    for (Body& body : early.bodies) {
      std::vector<Keyframe> keyframes;
      const bool second = &body == &early.bodies[1];
      for (int k = 0; k <= 4; ++k) {
        keyframes.push_back({k + (second ? 0.25 : 0), rng.real(-3, 3), (second ? 3 - k * rng.real(0, 1) : 0), 0});
        if (round % 2) keyframes.back().angle_deg = second ? rng.real(-400, 400) : rng.real(-8, 8);
      }
      body.motion = from_keyframes(keyframes);
    }
    SCOPED_TRACE(write_scene(early));
    expect_same_answers(early, later(early, unix_seconds), unix_seconds);
  }
}

TEST(Origins, UnitsOfTimeTakeThemAlong) {
  for (const Scene& scene : moving_scenes()) {
    Scene about = scene, slow;
    for (Body& body : about.bodies) {
      for (MotionPiece& piece : body.motion.pieces) piece = about_origin(piece, &body == &about.bodies[0] ? 0.5 : 1);
    }
    slow = about;
    slow.end *= 4;
    for (Body& body : slow.bodies) {
      for (MotionPiece& piece : body.motion.pieces) {
        piece.origin *= 4;
        piece.until *= 4;
        const auto slower = [](Coefficients& c) {
          for (std::size_t k = 0; k < c.size(); ++k) c[k] = std::ldexp(c[k], -2 * static_cast<int>(k));
        };
        slower(piece.x);
        slower(piece.y);
        for_each_polynomial(piece.rotation, slower);
      }
    }
    const Answer a = check(about), b = check(slow);
    ASSERT_EQ(a.outcome, b.outcome);
    if (!a.contact) continue;
    EXPECT_LE(4 * a.contact->time.lo, b.contact->time.hi);
    EXPECT_GE(4 * a.contact->time.hi, b.contact->time.lo);
  }
}

const char* const scene_with_origin = R"({"format":"taut-scene/1","time":[1790000000,1790000004],"bodies":[
 {"name":"P","polygon":[[0,0],[1,0],[0,1]]},
 {"name":"Q","polygon":[[0,0],[1,0],[0,1]],"motion":{"x":[3,-1],"origin":1790000000}}]})";

TEST(Origins, AreReadAndWritten) {
  const Scene scene = parse_scene(scene_with_origin);
  const MotionPiece& piece = scene.bodies[1].motion.pieces[0];
  EXPECT_EQ(piece.origin, unix_seconds);
  const Scene again = parse_scene(write_scene(scene));
  EXPECT_EQ(again.bodies[1].motion.pieces[0].origin, piece.origin);
  EXPECT_EQ(again.bodies[1].motion.pieces[0].x, piece.x);
  EXPECT_EQ(scene_fingerprint(scene, Touch::open), scene_fingerprint(again, Touch::open));
  const Answer answer = check(scene);
  ASSERT_EQ(answer.outcome, Outcome::contact);
  expect_same_time({2, 2}, answer.contact->time, unix_seconds);
}

TEST(Origins, AreHashedWhereTheyMatter) {
  Scene scene = parse_scene(scene_with_origin);
  const Fingerprint given = scene_fingerprint(scene, Touch::open);
  MotionPiece& piece = scene.bodies[1].motion.pieces[0];
  piece.origin += 1;
  EXPECT_NE(scene_fingerprint(scene, Touch::open), given);
  piece.x = {5};
  const Fingerprint rests = scene_fingerprint(scene, Touch::open);
  piece.origin = 0;
  EXPECT_EQ(scene_fingerprint(scene, Touch::open), rests);
}

TEST(Origins, OfABodyAtRestDoNotMatter) {
  const Motion still = from_keyframes({{5, 0, 0, 0}, {6, 0, 0, 0}, {9, 0, 0, 0}});
  for (const MotionPiece& piece : still.pieces) EXPECT_EQ(piece.origin, 0);
  MotionPiece here, there;
  here.x = there.x = {3};
  there.origin = 7;
  EXPECT_TRUE(same_motion(here, there));
  here.x = there.x = {3, 1};
  EXPECT_FALSE(same_motion(here, there));
}

TEST(Origins, MustBeFinite) {
  for (const double bad : {static_cast<double>(NAN), static_cast<double>(INFINITY), -static_cast<double>(INFINITY)}) {
    Scene scene = parse_scene(scene_with_origin);
    scene.bodies[1].motion.pieces[0].origin = bad;
    try {
      check(scene);
      ADD_FAILURE() << bad << " was accepted";
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find("origin is not a finite number"), std::string::npos) << e.what();
    }
  }
  const std::string text = scene_with_origin;
  for (const char* const bad : {"NaN", "1e999", "\"now\"", "null"}) {
    std::string changed = text;
    changed.replace(changed.find("\"origin\":1790000000") + 9, 10, bad);
    EXPECT_THROW(parse_scene(changed), InputError) << bad;
  }
}

TEST(Origins, RobotsThatLogUnixTimeGetTheClearanceOfTheSameMotionAtZero) {
  const std::filesystem::path folder = "../shared/reports";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the reported scenes are not here (../shared/reports)";
  const Clearance late = clearance(read_scene((folder / "epoch_seconds.json").string()));
  const Clearance early = clearance(read_scene((folder / "epoch_from_zero.json").string()));
  EXPECT_NEAR(late.nearest->lo, early.nearest->lo, 1e-9);
  EXPECT_NEAR(late.nearest->hi, early.nearest->hi, 1e-9);
}

}  // namespace
}  // namespace taut::testing
