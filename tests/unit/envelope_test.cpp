// Combinations of joint values: models of poses, closed forms, random linkages against single combinations.
#include "taut/envelope.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "joints/pose_model.hpp"
#include "support/effort.hpp"
#include "support/made_world.hpp"
#include "support/rng.hpp"
#include "taut/check.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut {
using namespace internal;
namespace {

using testing::effort;
using testing::Rng;
using Values = std::array<double, max_joints>;

JointMotion random_motion(Rng& rng, int joints) {
  JointMotion motion;
  if (rng.chance(0.7)) {
    motion.kind = Revolute{{rng.real(-1, 1), rng.real(-1, 1)}};
  } else if (rng.chance(0.5)) {
    motion.kind = Slide{{rng.real(-0.02, 0.02), rng.real(-0.02, 0.02)}};
  } else {
    const auto some = [&] { return rng.chance(0.7) ? std::optional(rng.below(joints)) : std::nullopt; };
    motion.kind = FreeMotion{some(), some(), rng.below(joints), {rng.real(-1, 1), rng.real(-1, 1)}};
    return motion;
  }
  motion.joint = rng.below(joints);
  motion.times = rng.chance(0.5) ? 1 : rng.real(-2, 2);
  motion.plus = rng.chance(0.5) ? 0 : rng.real(-40, 40);
  return motion;
}

/// Where a point is, by the definition of the motions, in long double.
struct ExactPoint {
  long double x, y;

  void follow(const JointMotion& motion, const Values& values) {
    if (const auto* free = std::get_if<FreeMotion>(&motion.kind)) {
      follow(JointMotion{Revolute{free->pivot}, *free->deg}, values);
      if (free->x) x += values[static_cast<std::size_t>(*free->x)];
      if (free->y) y += values[static_cast<std::size_t>(*free->y)];
      return;
    }
    const long double value = values[static_cast<std::size_t>(motion.joint)];
    if (const auto* revolute = std::get_if<Revolute>(&motion.kind)) {
      const JointAngle angle = joint_angle_of(motion);
      const long double a = angle.slope * value + angle.offset, c = std::cos(a), s = std::sin(a);
      const long double dx = x - revolute->pivot.x, dy = y - revolute->pivot.y;
      x = revolute->pivot.x + c * dx - s * dy;
      y = revolute->pivot.y + s * dx + c * dy;
    } else {
      const long double way = motion.times * value + motion.plus;
      x += way * std::get<Slide>(motion.kind).direction.x;
      y += way * std::get<Slide>(motion.kind).direction.y;
    }
  }
};

/// The law of JointModel, on chains of one to four motions.
TEST(PoseModel, ContainsThePoses) {
  Rng rng(1);
  double widest = 0;
  for (std::uint64_t n = effort(20000); n > 0; --n) {
    JointCell cell;
    for (std::size_t k = 0; k < max_joints; ++k) {
      cell.middle[k] = rng.real(-180, 180);
      cell.half[k] = std::exp2(rng.real(-20, 5));
    }
    std::vector<JointMotion> chain;
    for (int k = rng.between(1, 4); k > 0; --k) chain.push_back(random_motion(rng, max_joints));
    PoseModel pose;
    for (const JointMotion& motion : chain) pose = pose_of(motion, cell, 1).of(pose);
    const Vector local{rng.real(-1, 1), rng.real(-1, 1)};
    const bool back = rng.chance(0.3);
    const JointModel model = (back ? pose.inverse().of(pose) : pose).place(local);
    Values h{}, values{};
    for (std::size_t k = 0; k < max_joints; ++k) {
      h[k] = rng.chance(0.3) ? rng.sign() : rng.real(-1, 1);
      values[k] = cell.middle[k] + h[k] * cell.half[k];
    }
    ExactPoint exact{local.x, local.y};
    if (!back) {
      for (const JointMotion& motion : chain) exact.follow(motion, values);
    }
    long double x = model.value.x, y = model.value.y;
    for (std::size_t k = 0; k < max_joints; ++k) {
      x += static_cast<long double>(model.rate[k].x) * h[k];
      y += static_cast<long double>(model.rate[k].y) * h[k];
    }
    const double off = static_cast<double>(std::hypot(x - exact.x, y - exact.y));
    ASSERT_LE(off, model.error + 1e-17 * model.reach());
    if (model.error < 0.1) widest = std::max(widest, off / (model.error + 1e-300));
  }
  // The bound is not idle.
  EXPECT_GT(widest, 0.3);
}

Linkage sliding_square(double lo, double hi) {
  Linkage linkage;
  linkage.joints = {{"x", lo, hi}};
  linkage.scene.bodies = {{"wall", {{4, -1}, {5, -1}, {5, 3}, {4, 3}}, {}},
                          {"box", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}}};
  linkage.motions = {std::nullopt, JointMotion{Slide{{1, 0}}, 0}};
  return linkage;
}

TEST(Envelope, OfASlideInClosedForm) {
  // They overlap for x between 3 and 5.
  const Envelope answer = envelope(sliding_square(0, 8));
  EXPECT_EQ(answer.outcome, Outcome::contact);
  ASSERT_TRUE(answer.witness);
  EXPECT_GT(answer.witness->values[0], 3);
  EXPECT_LT(answer.witness->values[0], 5);
  EXPECT_LE(answer.colliding, 0.25);
  EXPECT_LE(answer.free, 0.75);
  EXPECT_LE(answer.undecided, 8e-3);
  EXPECT_NEAR(answer.free + answer.colliding + answer.undecided, 1, 1e-12);
  EXPECT_EQ(envelope(sliding_square(0, 2.9999)).outcome, Outcome::free);
  EXPECT_EQ(envelope(sliding_square(0, 2.9999)).free, 1);
  // Touching at the end is not told from colliding; nothing collides, and that is not said.
  const Envelope touches = envelope(sliding_square(0, 3));
  EXPECT_EQ(touches.outcome, Outcome::undecided);
  EXPECT_GT(touches.free, 0.99);
}

TEST(Envelope, OfABarOnAPivot) {
  // From the origin to (2, 0), 2 h high; it meets the wall x >= 1 when its lower right corner is as far.
  Linkage linkage;
  linkage.joints = {{"turn", 0, 90}};
  linkage.scene.bodies = {{"wall", {{1, -3}, {2, -3}, {2, 3}, {1, 3}}, {}},
                          {"bar", {{-0.1, -0.1}, {2, -0.1}, {2, 0.1}, {-0.1, 0.1}}, {}}};
  linkage.motions = {std::nullopt, JointMotion{Revolute{{0, 0}}, 0}};
  EnvelopeOptions options;
  options.tolerance = 1e-6;
  const Envelope answer = envelope(linkage, options);
  // The corner (2, -0.1) is at the angle atan(-0.1 / 2) and the distance sqrt(4.01).
  const double angle = (std::acos(1 / std::sqrt(4.01)) + std::atan(0.05)) * 180 / M_PI;
  EXPECT_LE(answer.colliding, angle / 90);
  EXPECT_GE(answer.colliding, angle / 90 - 4e-6);
  EXPECT_LE(answer.free, 1 - angle / 90);
  EXPECT_GE(answer.free, 1 - angle / 90 - 4e-6);
}

/// Both jaws follow one joint, from either side.
TEST(Envelope, OfCoupledJoints) {
  Linkage linkage;
  linkage.joints = {{"grip", 0, 3}, {"turn", -180, 180}};
  const Polygon jaw{{-0.5, -1}, {0.5, -1}, {0.5, 1}, {-0.5, 1}};
  linkage.scene.bodies = {{"hand", {{-5, -3}, {5, -3}, {5, -2}, {-5, -2}}, {}}, {"left", jaw, {}}, {"right", jaw, {}}};
  linkage.scene.bodies[1].relative_to = linkage.scene.bodies[2].relative_to = "hand";
  linkage.motions = {JointMotion{Revolute{{1, 1}}, 1}, JointMotion{Slide{{1, 0}}, 0, 1, -3},
                     JointMotion{Slide{{1, 0}}, 0, -1, 3}};
  // They meet when the middles are 1 apart, at 2.5, however the hand is turned.
  const Envelope answer = envelope(linkage);
  EXPECT_EQ(answer.outcome, Outcome::contact);
  EXPECT_NEAR(answer.colliding, 0.5 / 3, 5e-3);
  EXPECT_NEAR(answer.free, 2.5 / 3, 1e-3);
  // The hand's turn has no effect, and is never divided.
  for (const EnvelopeCell& cell : answer.cells) EXPECT_EQ(cell.hi[1] - cell.lo[1], 360);
  linkage.joints[0].hi = 2.49;
  EXPECT_EQ(envelope(linkage).outcome, Outcome::free);
}

/// A joint whose effect is 0 to first order at the middle: what it turns is turned back by what hangs on it, or comes
/// nearest just there.
TEST(Envelope, DividesJointsThatCancelAtTheMiddle) {
  const Polygon square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, separated{{2, -1}, {4, -1}, {4, 1}, {2, 1}};
  Linkage linkage;
  linkage.joints = {{"x", -180, 180}};
  linkage.scene.bodies = {{"p", {{49, 49}, {51, 49}, {51, 51}, {49, 51}}, {}}, {"a", square, {}}, {"b", separated, {}}};
  linkage.scene.bodies[2].relative_to = "p";
  linkage.scene.ignore = {{"p", "*"}};
  linkage.motions = {JointMotion{Revolute{{0, 0}}, 0, 1, 0}, std::nullopt, JointMotion{Revolute{{0, 0}}, 0, -1, 0}};
  EnvelopeOptions options;
  options.tolerance = 0.01;
  // It does not move at all.
  Envelope answer = envelope(linkage, options);
  EXPECT_EQ(answer.outcome, Outcome::free);
  EXPECT_EQ(answer.undecided, 0);
  EXPECT_LE(answer.cells.size(), 64u);
  // Turned back about another pivot, it goes on a circle, away from the square on both sides.
  linkage.motions[2] = JointMotion{Revolute{{20, 0}}, 0, -1, 0};
  answer = envelope(linkage, options);
  EXPECT_EQ(answer.outcome, Outcome::free);
  // A pendulum that hangs straight down at the middle, where it is nearest, besides a joint that has no part in that.
  linkage.joints = {{"swing", -60, 60}, {"lift", -1, 1}};
  linkage.scene.bodies = {{"floor", {{-9, -1}, {9, -1}, {9, 0}, {-9, 0}}, {}},
                          {"bob", {{-1, 2}, {1, 2}, {1, 4}, {-1, 4}}, {}}};
  linkage.scene.ignore.clear();
  linkage.motions = {JointMotion{Slide{{0, 1}}, 1}, JointMotion{Revolute{{0, 12}}, 0}};
  answer = envelope(linkage, options);
  EXPECT_EQ(answer.outcome, Outcome::free);
  EXPECT_EQ(answer.undecided, 0);
}

TEST(Envelope, WithoutPairsIsUntested) {
  Linkage linkage = sliding_square(0, 8);
  linkage.scene.ignore = {{"wall", "*"}};
  const Envelope none = envelope(linkage);
  EXPECT_EQ(none.outcome, Outcome::untested);
  EXPECT_EQ(none.coverage.ignored, 1U);
  EXPECT_NE(none.reason, "");
  // Where no joint moves anything against anything else, all are tested.
  linkage.scene.ignore.clear();
  linkage.motions.clear();
  const Envelope rests = envelope(linkage);
  EXPECT_EQ(rests.free, 1);
  EXPECT_EQ(rests.outcome, Outcome::free);
  EXPECT_EQ(rests.coverage.tested, 1U);
}

/// Two that no joint moves against each other, and one that a joint moves.
TEST(Envelope, FixedBodiesAreTestedOnRequest) {
  Linkage linkage = sliding_square(0, 8);
  linkage.joints[0].hi = 0.5;
  Body bracket = linkage.scene.bodies[0];
  bracket.name = "bracket";
  linkage.scene.bodies.push_back(bracket);
  const Envelope skipped = envelope(linkage);
  EXPECT_EQ(skipped.outcome, Outcome::free);
  EXPECT_EQ(skipped.coverage.at_rest, 1U);
  EXPECT_EQ(skipped.coverage.tested, 2U);
  linkage.scene.at_rest = AtRest::test;
  const Envelope tested = envelope(linkage);
  EXPECT_EQ(tested.outcome, Outcome::contact);
  EXPECT_EQ(tested.coverage.untested(), 0U);
  ASSERT_TRUE(tested.witness);
  EXPECT_EQ(tested.witness->pair, (std::array<BodyId, 2>{0, 2}));
}

/// A ring around a body that turns in it: apart, though neither is beside the other.
TEST(Envelope, InsideAHole) {
  Linkage linkage;
  linkage.joints = {{"turn", 0, 360}, {"x", -1, 1}};
  Part ring{{{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}, {{{-3, -3}, {3, -3}, {3, 3}, {-3, 3}}}};
  Body frame{"frame", {}, {}};
  frame.parts = {ring};
  linkage.scene.bodies = {frame,
                          {"slide", {{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}}, {}},
                          {"rotor", {{-1, -0.2}, {1, -0.2}, {1, 0.2}, {-1, 0.2}}, {}}};
  linkage.scene.bodies[2].relative_to = "slide";
  linkage.scene.ignore = {{"slide", "rotor"}};
  linkage.motions = {std::nullopt, JointMotion{Slide{{1, 0}}, 1}, JointMotion{Revolute{{0, 0}}, 0}};
  EXPECT_EQ(envelope(linkage).outcome, Outcome::free);
  linkage.joints[1] = {"x", -3, 3};
  EXPECT_EQ(envelope(linkage).outcome, Outcome::contact);
  // In the material all around: nothing crosses, and it collides.
  linkage.scene.bodies[0].parts[0].holes.clear();
  linkage.joints[1] = {"x", -1, 1};
  EXPECT_EQ(envelope(linkage).colliding, 1);
}

/// Arms, gates and holes of random shapes; each cell is right about combinations drawn from it, which check() judges at
/// rest.
class RandomLinkage {
 public:
  explicit RandomLinkage(std::uint64_t seed) : rng_(seed) {
    linkage_.joints.resize(static_cast<std::size_t>(rng_.between(1, 2)));
    for (std::size_t k = 0; k < linkage_.joints.size(); ++k) {
      const double lo = rng_.real(-120, 60);
      linkage_.joints[k] = {"joint " + std::to_string(k), lo, lo + rng_.real(5, 150)};
    }
    const Scene shapes = testing::scene_of(testing::random_world(seed));
    linkage_.scene.bodies.assign(shapes.bodies.begin(),
                                 shapes.bodies.begin() + std::min<std::ptrdiff_t>(4, std::ssize(shapes.bodies)));
    linkage_.motions.resize(linkage_.scene.bodies.size());
    for (std::size_t i = 0; i < linkage_.scene.bodies.size(); ++i) {
      Body& body = linkage_.scene.bodies[i];
      body.motion = {};
      body.relative_to = i > 0 && rng_.chance(0.5) ? linkage_.scene.bodies[i - 1].name : "";
      if (rng_.chance(0.8)) linkage_.motions[i] = random_motion(rng_, static_cast<int>(linkage_.joints.size()));
    }
  }
  const Linkage& linkage() const { return linkage_; }
  Rng& rng() { return rng_; }

 private:
  Rng rng_;
  Linkage linkage_;
};

bool overlaps_at(const Linkage& linkage, const Values& values, Touch touch) {
  CheckOptions options;
  options.touch = touch;
  options.engine = EngineChoice::spacetime;
  const Answer answer = check(posed(linkage, values), options);
  EXPECT_NE(answer.outcome, Outcome::undecided);
  return answer.outcome != Outcome::free;
}

TEST(Envelope, OfRandomLinkages) {
  int free = 0, colliding = 0;
  for (std::uint64_t seed = 5000; seed < 5000 + effort(400); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomLinkage random(seed);
    const Linkage& linkage = random.linkage();
    try {
      validate(linkage);
    } catch (const InputError&) {
      continue;
    }
    EnvelopeOptions options;
    options.tolerance = 0.02;
    const Envelope answer = envelope(linkage, options);
    ASSERT_NEAR(answer.free + answer.colliding + answer.undecided, 1, 1e-9);
    if (answer.witness) {
      EXPECT_TRUE(overlaps_at(linkage, answer.witness->values, Touch::open));
    }
    for (int draw = 0; draw < 12 && !answer.cells.empty(); ++draw) {
      const EnvelopeCell& cell = random.rng().pick(answer.cells);
      Values values{};
      for (std::size_t k = 0; k < linkage.joints.size(); ++k) {
        values[k] = random.rng().chance(0.3) ? cell.lo[k] : random.rng().real(cell.lo[k], cell.hi[k]);
      }
      if (cell.state == CellState::free) {
        ++free;
        EXPECT_FALSE(overlaps_at(linkage, values, Touch::closed));
      } else if (cell.state == CellState::colliding) {
        ++colliding;
        EXPECT_TRUE(overlaps_at(linkage, values, Touch::open));
      }
    }
  }
  EXPECT_GE(free, static_cast<int>(testing::enough(20)));
  EXPECT_GE(colliding, static_cast<int>(testing::enough(20)));
}

TEST(Envelope, ALimitLeavesACoarserAnswer) {
  Linkage linkage = sliding_square(0, 8);
  linkage.joints.push_back({"turn", -90, 90});
  linkage.motions[0] = JointMotion{Revolute{{4.5, 1}}, 1};
  const std::atomic<bool> stop{true};
  EnvelopeOptions options;
  options.tolerance = 1e-5;
  options.limits.stop = &stop;
  const Envelope answer = envelope(linkage, options);
  EXPECT_EQ(answer.reason, "interrupted");
  EXPECT_GT(answer.undecided, 0);
  EXPECT_NEAR(answer.free + answer.colliding + answer.undecided, 1, 1e-9);
}

/// The message of the InputError that asking about it throws.
std::string refusal(const Linkage& linkage, double tolerance = 1e-3) {
  EnvelopeOptions options;
  options.tolerance = tolerance;
  try {
    envelope(linkage, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Envelope, RefusesWhatMakesNoSense) {
  const Linkage good = sliding_square(0, 8);
  Linkage bad = good;
  bad.joints.clear();
  EXPECT_NE(refusal(bad).find("joints"), std::string::npos);
  bad = good;
  bad.joints.assign(4, {"x", 0, 1});
  EXPECT_NE(refusal(bad).find("joints"), std::string::npos);
  bad = good;
  bad.joints[0].hi = -1;
  EXPECT_NE(refusal(bad).find("joints.x"), std::string::npos);
  bad = good;
  bad.joints.push_back(bad.joints[0]);
  EXPECT_NE(refusal(bad).find("joints.x"), std::string::npos);
  bad = good;
  bad.motions[1]->joint = 1;
  EXPECT_NE(refusal(bad).find("bodies[1].motion.by"), std::string::npos);
  bad = good;
  bad.motions[1]->times = NAN;
  EXPECT_NE(refusal(bad).find("bodies[1].motion"), std::string::npos);
  bad = good;
  bad.motions[1]->kind = Slide{{0, 0}};
  EXPECT_NE(refusal(bad).find("direction"), std::string::npos);
  bad = good;
  bad.scene.bodies[1].polygon = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};
  EXPECT_NE(refusal(bad).find("box"), std::string::npos);
  bad = good;
  bad.scene.bodies[1].relative_to = "nobody";
  EXPECT_NE(refusal(bad), "");
  EXPECT_NE(refusal(good, 0), "");
  EXPECT_NE(refusal(good, NAN), "");
}

TEST(Envelope, AsJsonAndPicture) {
  const Linkage linkage =
      parse_linkage(R"({"format": "taut-scene/1", "id": 7, "joints": {"x": [0, 8], "turn": [-10, 10]},
    "bodies": [{"name": "wall", "polygon": [[4, -1], [5, -1], [5, 3], [4, 3]],
                "motion": {"revolute": {"pivot": [4, 1], "by": "turn", "times": 0.5, "plus": 1}}},
               {"name": "box", "polygon": [[0, 0], [1, 0], [1, 1], [0, 1]],
                "motion": {"slide": {"direction": [1, 0], "by": "x"}}}]})");
  ASSERT_EQ(linkage.joints.size(), 2u);
  ASSERT_TRUE(linkage.motions[0]);
  EXPECT_EQ(linkage.motions[0]->times, 0.5);
  EXPECT_EQ(linkage.motions[0]->plus, 1);
  EXPECT_EQ(linkage.motions[0]->joint, 1);
  const Envelope answer = envelope(linkage);
  const std::string text = envelope_json(linkage, answer, 1e-3, true);
  EXPECT_EQ(text.find("{\"id\":7,\"outcome\":\"contact\",\"joints\":[{\"name\":\"x\",\"range\":[0,8]}"), 0u);
  EXPECT_NE(text.find("\"cells\":[{\"state\":"), std::string::npos);
  const std::string picture = envelope_svg(linkage, answer);
  for (const char* part : {"class=\"free\"", "class=\"colliding\"", "class=\"witness\"", ">turn (deg)<", ">x<"})
    EXPECT_NE(picture.find(part), std::string::npos) << part;
}

TEST(Envelope, TextsThatAreWrong) {
  const auto message = [](const std::string& joints, const std::string& motion) {
    try {
      parse_linkage("{\"format\":\"taut-scene/1\",\"joints\":" + joints +
                    ",\"bodies\":[{\"name\":\"a\",\"polygon\":[[0,0],[1,0],[0,1]],\"motion\":" + motion + "}]}");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string joints = R"({"lift": [0, 60]})", good = R"({"revolute": {"pivot": [0, 0], "by": "lift"}})";
  EXPECT_EQ(message(joints, good), "");
  EXPECT_EQ(message(joints, "null"), "");
  EXPECT_NE(message("[]", good).find("joints"), std::string::npos);
  EXPECT_NE(message(R"({"lift": [0]})", good).find("joints.lift"), std::string::npos);
  EXPECT_NE(message(joints, R"({"revolute": {"pivot": [0, 0], "by": "lfit"}})").find("lift"), std::string::npos);
  EXPECT_NE(message(joints, R"({"revolute": {"pivot": [0], "by": "lift"}})").find("pivot"), std::string::npos);
  EXPECT_NE(message(joints, R"({"turn": {}})"), "");
  EXPECT_NE(message(joints, "{}"), "");
  EXPECT_NE(message(joints, R"({"velocity": [1, 0]})"), "");
  // Other questions say where such a scene belongs.
  try {
    parse_scene("{\"format\":\"taut-scene/1\",\"joints\":{\"a\":[0,1]},\"bodies\":[]}");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("joints"), std::string::npos);
    EXPECT_NE(error.hint().find("taut envelope"), std::string::npos);
  }
}

}  // namespace
}  // namespace taut
