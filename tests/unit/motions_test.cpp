// Motions in degrees and by keyframes: what they compile to, and how nearly.
#include "taut/motions.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <numbers>

#include "motion/pieces.hpp"
#include "numeric/trig.hpp"
#include "support/rng.hpp"
#include "taut/error.hpp"
#include "taut/validate.hpp"

namespace taut::testing {
using namespace internal;
namespace {

using Quotient = boost::multiprecision::cpp_rational;

const Polygon unit_square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
const Polygon far_square{{50, 0}, {51, 0}, {51, 1}, {50, 1}};

/// Is `x` the double nearest to `exact`?
template <class Exact>
bool nearest(double x, const Exact& exact) {
  const auto distance = [&exact](double y) { return Exact(abs(Exact(y) - exact)); };
  return distance(x) <= distance(std::nextafter(x, INFINITY)) && distance(x) <= distance(std::nextafter(x, -INFINITY));
}

RealMax exact_radians(double degrees) { return degrees * pi<RealMax>() / 180; }

TEST(Radians, AreTheNearestDouble) {
  Rng rng(1);
  EXPECT_EQ(radians(0), 0);
  EXPECT_EQ(radians(180), std::numbers::pi);
  EXPECT_EQ(radians(-90), -std::numbers::pi / 2);
  EXPECT_EQ(radians(1), 0.017453292519943295);
  for (int i = 0; i < 3000; ++i) {
    const double degrees = i < 1000 ? i - 500 : rng.sign() * std::exp2(rng.real(-30, 30));
    EXPECT_TRUE(nearest(radians(degrees), exact_radians(degrees))) << degrees;
  }
}

std::vector<Keyframe> random_keyframes(Rng& rng) {
  std::vector<Keyframe> keyframes;
  double t = rng.real(-100, 100);
  const auto number = [&rng] { return rng.chance(0.3) ? rng.between(-5, 5) / 2.0 : rng.real(-1000, 1000); };
  for (int k = rng.between(1, 6); k > 0; --k, t += rng.chance(0.3) ? 0.5 : rng.real(0.001, 50))
    keyframes.push_back({t, number(), number(), number()});
  return keyframes;
}

template <class Exact>
Exact value(const Coefficients& c, const Exact& t) {
  Exact sum = 0;
  for (std::size_t k = c.size(); k-- > 0;) sum = sum * t + Exact(c[k]);
  return sum;
}

/// The bounds of the header: 2^-53 |b - a| at the later keyframe, and at both 2^-53 of an angle.
template <class Exact>
void expect_through(const Coefficients& line, const Exact& length, const Exact& a, const Exact& b, bool angle) {
  EXPECT_LE(line.size(), 2u);
  const Exact of_start = angle ? Exact(abs(a) * Exact(0x1p-53)) : Exact(0);
  EXPECT_LE(abs(Exact(value<Exact>(line, Exact(0)) - a)), of_start);
  EXPECT_LE(abs(Exact(value<Exact>(line, length) - b)), Exact(of_start + abs(Exact(b - a)) * Exact(0x1p-53)));
}

TEST(Keyframes, AreMetAsNearlyAsStated) {
  Rng rng(2);
  for (int i = 0; i < 2000; ++i) {
    const std::vector<Keyframe> keyframes = random_keyframes(rng);
    const Motion motion = from_keyframes(keyframes);
    ASSERT_EQ(motion.pieces.size(), keyframes.size() == 1 ? 1 : keyframes.size() + 1);
    for (std::size_t k = 0; k + 1 < keyframes.size(); ++k) {
      const Keyframe &a = keyframes[k], &b = keyframes[k + 1];
      const MotionPiece& piece = motion.pieces[k + 1];
      EXPECT_EQ(piece.until, b.t);
      EXPECT_EQ(piece.origin, varies(piece) ? a.t : 0);
      const Quotient length = Quotient(b.t) - Quotient(a.t), slope = (Quotient(b.x) - Quotient(a.x)) / length;
      expect_through(piece.x, length, Quotient(a.x), Quotient(b.x), false);
      expect_through(piece.y, length, Quotient(a.y), Quotient(b.y), false);
      if (slope != 0) {
        EXPECT_TRUE(nearest(piece.x.at(1), slope));
      }
      if (const auto* r = std::get_if<AngleRotation>(&piece.rotation)) {
        expect_through(r->angle, RealMax(RealMax(b.t) - RealMax(a.t)), exact_radians(a.angle_deg),
                       exact_radians(b.angle_deg), true);
      }
    }
  }
}

TEST(Keyframes, JoinWellEnoughForValidation) {
  Rng rng(3);
  for (int i = 0; i < 300; ++i) {
    Scene scene{
        -300, 500, {{"a", unit_square, from_keyframes(random_keyframes(rng), {0.1, 0.2})}, {"b", far_square, {}}}};
    EXPECT_NO_THROW(validate(scene));
  }
}

TEST(Keyframes, RestBeforeAndAfter) {
  const Motion motion = from_keyframes({{1, 2, 3, 90}, {2, 4, 3, 90}}, {7, 8});
  ASSERT_EQ(motion.pieces.size(), 3u);
  EXPECT_EQ(motion.pieces[0].x, Coefficients{2});
  EXPECT_EQ(motion.pieces[0].until, 1);
  EXPECT_EQ(motion.pieces[1].x, (Coefficients{2, 2}));
  EXPECT_EQ(motion.pieces[1].origin, 1);
  EXPECT_EQ(motion.pieces[1].y, Coefficients{3});
  EXPECT_EQ(motion.pieces[1].until, 2);
  EXPECT_EQ(motion.pieces[2].x, Coefficients{4});
  EXPECT_EQ(motion.pieces[2].until, INFINITY);
  for (const MotionPiece& piece : motion.pieces) {
    EXPECT_EQ(piece.pivot, (Point{7, 8}));
    ASSERT_TRUE(std::holds_alternative<DirectionRotation>(piece.rotation));
    EXPECT_EQ(std::get<DirectionRotation>(piece.rotation).a, Coefficients{0});
    EXPECT_EQ(std::get<DirectionRotation>(piece.rotation).b, Coefficients{1});
  }
}

TEST(Keyframes, HoldQuarterTurnsExactly) {
  const double cosines[] = {1, 0, -1, 0}, sines[] = {0, 1, 0, -1};
  for (int quarter = -9; quarter <= 9; ++quarter) {
    const Rotation rotation = from_keyframes({{0, 0, 0, 90.0 * quarter}}).pieces.at(0).rotation;
    const int k = ((quarter % 4) + 4) % 4;
    EXPECT_EQ(std::holds_alternative<NoRotation>(rotation), k == 0);
    if (k == 0) continue;
    EXPECT_EQ(std::get<DirectionRotation>(rotation).a.at(0), cosines[k]);
    EXPECT_EQ(std::get<DirectionRotation>(rotation).b.at(0), sines[k]);
  }
  const Rotation other = from_keyframes({{0, 0, 0, 45}}).pieces.at(0).rotation;
  EXPECT_EQ(std::get<AngleRotation>(other).angle, Coefficients{std::numbers::pi / 4});
}

TEST(Keyframes, AnglesAreNotWrapped) {
  const auto turn = [](double from, double to) {
    return std::get<AngleRotation>(from_keyframes({{0, 0, 0, from}, {1, 0, 0, to}}).pieces.at(1).rotation).angle.at(1);
  };
  EXPECT_EQ(turn(350, 370), radians(20));
  EXPECT_EQ(turn(350, 10), radians(-340));
  EXPECT_EQ(turn(0, 720), radians(720));
}

TEST(Keyframes, ThatAreNoMotionAreRefused) {
  EXPECT_THROW(from_keyframes({}), InputError);
  EXPECT_THROW(from_keyframes({{0, 0, 0, 0}, {0, 1, 0, 0}}), InputError);
  EXPECT_THROW(from_keyframes({{1, 0, 0, 0}, {0, 1, 0, 0}}), InputError);
  EXPECT_THROW(from_keyframes({{NAN, 0, 0, 0}}), InputError);
  EXPECT_THROW(from_keyframes({{0, INFINITY, 0, 0}}), InputError);
  EXPECT_THROW(from_keyframes({{0, 0, 0, 0}}, {NAN, 0}), InputError);
}

TEST(Velocity, IsExactButForTheSpin) {
  const Motion motion = from_velocity({0.1, 0}, 30, {5, 6});
  ASSERT_EQ(motion.pieces.size(), 1u);
  EXPECT_EQ(motion.pieces[0].x, (Coefficients{0, 0.1}));
  EXPECT_TRUE(motion.pieces[0].y.empty());
  EXPECT_EQ(std::get<AngleRotation>(motion.pieces[0].rotation).angle, (Coefficients{0, radians(30)}));
  EXPECT_EQ(motion.pieces[0].pivot, (Point{5, 6}));
  EXPECT_TRUE(std::holds_alternative<NoRotation>(from_velocity({1, 1}).pieces.at(0).rotation));
  EXPECT_THROW(from_velocity({NAN, 0}), InputError);
}

TEST(Sweep, MapsTheTimeToTheAngle) {
  const Motion whole = from_sweep({1, 2}, 0, 110, 0, 110);
  EXPECT_EQ(std::get<AngleRotation>(whole.pieces.at(0).rotation).angle, (Coefficients{0, radians(1)}));
  const Motion shifted = from_sweep({1, 2}, 10, 40, 2, 5);
  EXPECT_EQ(std::get<AngleRotation>(shifted.pieces.at(0).rotation).angle, (Coefficients{radians(10), radians(10)}));
  EXPECT_EQ(shifted.pieces.at(0).origin, 2);
  EXPECT_TRUE(shifted.sweep);
  for (const double t : {2.0, 3.3, 5.0}) {
    const auto angle = angle_at(shifted, {t, t});
    ASSERT_TRUE(angle);
    EXPECT_LE(angle->lo, 10 * t - 10 + 1e-14 * t);
    EXPECT_GE(angle->hi, 10 * t - 10 - 1e-14 * t);
    EXPECT_LT(angle->hi - angle->lo, 1e-13);
  }
  EXPECT_EQ(angle_at(whole, {0, 0}).value().hi, 0);
  // A falling angle is enclosed as well.
  const auto falling = angle_at(from_sweep({}, 90, 0, 0, 1), {0.25, 0.5});
  ASSERT_TRUE(falling);
  EXPECT_NEAR(falling->lo, 45, 1e-12);
  EXPECT_NEAR(falling->hi, 67.5, 1e-12);
  EXPECT_FALSE(angle_at(from_velocity({}, 30), {0, 1}));
  EXPECT_THROW(from_sweep({}, 0, 90, 1, 1), InputError);
  EXPECT_THROW(from_sweep({}, 0, NAN, 0, 1), InputError);
}

/// The cosine of 60 degrees is one half: where that makes a coordinate zero, no rest of some 2^-960 is left of it,
/// which validation would refuse.
TEST(Keyframes, ArcsBySixthsOfATurnEndWhereTheyShould) {
  for (const double deg : {60.0, -60.0, 300.0, 420.0}) {
    const Motion motion = from_keyframes({{0, 0.5, 0}, {1, 0, 0, 0, Way::arc, {-0.5, 0}, deg}});
    EXPECT_EQ(motion.pieces.back().x, Coefficients{}) << deg;
    EXPECT_NEAR(std::fabs(motion.pieces.back().y.at(0)), std::sqrt(0.75), 1e-15);
  }
  const Motion down = from_keyframes({{0, 0, 1}, {1, 0, 0, 0, Way::turn, {0, 0.5}, 120}}, {0, 0.25});
  EXPECT_EQ(down.pieces.back().y.at(0), -0.125);
}

/// A door 0.3 above the floor, hung at a point that no double is. It lies on the block beside it; closed, it touches
/// it.
TEST(Sweep, APivotRoundsNothing) {
  const Polygon block{{0.1, 0}, {2.1, 0}, {2.1, 0.3}, {0.1, 0.3}}, door{{0.1, 0.3}, {2.1, 0.3}, {2.1, 0.4}, {0.1, 0.4}};
  const Scene scene{0, 90, {{"block", block, {}}, {"door", door, from_sweep({0.7, 0.1}, 0, 90, 0, 90)}}};
  const Answer open = check(scene);
  ASSERT_TRUE(open.contact) << to_string(open.outcome);
  // The corner (0.1, 0.3) is 0.2 above the pivot: turning takes it down at once.
  EXPECT_LT(open.contact->time.hi, 1e-20);
  CheckOptions closed;
  closed.touch = Touch::closed;
  EXPECT_EQ(check(scene, closed).contact.value().time.hi, 0);
  Scene up = scene;
  up.bodies[1].motion = from_sweep({0.1, 0.3}, 0, 90, 0, 90);
  EXPECT_STREQ(to_string(check(up).outcome), "free");
}

}  // namespace
}  // namespace taut::testing
