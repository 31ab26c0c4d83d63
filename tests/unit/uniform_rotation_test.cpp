// Bodies that turn evenly: models in closed form hold what models promise, and turns cost the same whether
// they are few or many.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "motion/taylor_model_cache.hpp"
#include "motion/uniform_rotation.hpp"
#include "numeric/budget.hpp"
#include "numeric/trig.hpp"
#include "support/effort.hpp"
#include "support/rng.hpp"
#include "taut/check.hpp"

namespace taut::testing {
using namespace internal;
namespace {

bool holds(const Ball<double>& narrow, const Ball<Real960>& wide) {
  const double slack = 0x1p-60 * (1 + std::fabs(narrow.mid));
  return RealTraits<Real960>::magnitude(wide.mid - Real960(narrow.mid)) <= narrow.rad + slack;
}

TEST(SinCosOfSum, AreThoseOf960Bits) {
  Rng rng(71);
  for (std::uint64_t i = 0; i < effort(20000); ++i) {
    const double hi = rng.chance(0.1) ? 0 : rng.sign() * std::ldexp(rng.real(0.5, 1), rng.between(-30, 40));
    const double lo = rng.sign() * std::ldexp(rng.real(0.5, 1), -11 - rng.below(40));
    const SinCos<double> got = sin_cos_of_sum(hi, lo);
    const SinCos<Real960> want = sin_cos(Ball<Real960>::exact(hi) + Ball<Real960>::exact(lo));
    ASSERT_TRUE(holds(got.sin, want.sin)) << hi << " + " << lo;
    ASSERT_TRUE(holds(got.cos, want.cos)) << hi << " + " << lo;
  }
}

/// From a thousandth of a radian to a hundred thousand turns.
Coefficients uniform_angle(Rng& rng, double length) {
  const double turn = rng.chance(0.5) ? rng.real(70, 7e5) : std::ldexp(rng.real(0.5, 1), rng.between(-10, 6));
  return {rng.real(-4, 4), rng.sign() * turn / length};
}

/// One body turns, or both, perhaps alike; one is drawn along, perhaps.
MotionSegment random_segment(Rng& rng) {
  MotionPiece p, q;
  const double start = rng.chance(0.5) ? 0 : rng.real(-1e6, 1e6),
               length = std::ldexp(rng.real(1, 2), rng.between(-4, 9));
  const int kind = rng.below(4);
  if (kind != 0) p.rotation = AngleRotation{uniform_angle(rng, length)};
  if (kind != 1) q.rotation = kind == 3 ? p.rotation : Rotation(AngleRotation{uniform_angle(rng, length)});
  for (MotionPiece* piece : {&p, &q}) {
    for (Coefficients* c : {&piece->x, &piece->y}) {
      *c = {rng.real(-3, 3)};
      if (rng.chance(0.3)) c->push_back(rng.real(-1, 1) / length);
    }
    if (rng.chance(0.3)) piece->pivot = {rng.real(-1, 1), rng.real(-1, 1)};
    if (rng.chance(0.3)) piece->origin = start + length * rng.real(-1, 1);
  }
  for (int k = 2; k < 10 && rng.chance(0.3); ++k) q.y.push_back(0.5 / std::pow(1e6 + length, k));
  return MotionSegment::motion(p, q, start, start + length);
}

/// The six functions of a model.
std::array<Jet<Real960>, 6> functions_at(const MotionSegment& segment, double t) {
  const internal::Frame<Real960> f = frame(segment, Ball<Real960>::exact(t));
  return {f.for_pp[1], f.for_pp[2], f.for_qq[1], f.for_qq[2], f.for_pp[3], f.for_pp[4]};
}

void expect_within(const Ball<Real960>& truth, double value, double error, const char* what) {
  EXPECT_LE(abs(truth.mid - Real960(value)), Real960(error)) << what;
}

/// The polynomials, their derivatives, and the bounds of the second and third derivatives.
void expect_laws(const MotionSegment& segment, const FrameModel& m, double t) {
  const std::array<Jet<Real960>, 6> truth = functions_at(segment, t);
  double value[6], slope[6], values[4], slopes[4], seconds[4];
  m.evaluate(t, value, slope);
  for (std::size_t i = 0; i < 6; ++i) {
    expect_within(truth[i].v, value[i], m.error[i], "value");
    expect_within(truth[i].d, slope[i], m.error_d[i], "slope");
    expect_within(truth[i].dd, m.second[i], m.second_rad[i], "bend");
    EXPECT_LE(RealTraits<Real960>::magnitude(truth[i].v.mid), m.size[i] * (1 + 0x1p-20) + m.error[i]);
  }
  for (const int first : {0, 2}) {
    m.evaluate(t, first, values, slopes, seconds);
    for (int k = 0; k < 4; ++k) {
      const int i = k < 2 ? first + k : 2 + k;
      expect_within(truth[static_cast<std::size_t>(i)].dd, seconds[k], m.error_dd[i], "second derivative");
    }
  }
}

/// By the mean value theorem a difference of second derivatives is a third one somewhere between.
void expect_third(const MotionSegment& segment, const FrameThird& third, int first, double a, double b) {
  const std::array<Jet<Real960>, 6> at_a = functions_at(segment, a), at_b = functions_at(segment, b);
  for (int k = 0; k < 4; ++k) {
    const auto i = static_cast<std::size_t>(k < 2 ? first + k : 2 + k);
    const double change = RealTraits<Real960>::magnitude(at_b[i].dd.mid - at_a[i].dd.mid);
    EXPECT_LE(change, third.most[k] * (b - a) * (1 + 0x1p-20) + 0x1p-300);
  }
}

TEST(UniformRotation, ModelsEncloseTheFrame) {
  Rng rng(72);
  std::uint64_t sharp = 0;
  for (std::uint64_t i = 0; i < effort(300) && !HasFailure(); ++i) {
    const MotionSegment segment = random_segment(rng);
    const auto even = UniformRotation::of(segment);
    ASSERT_TRUE(even);
    for (int k = 0; k < 8; ++k) {
      // As long as cells are, and as whole levels of them above.
      const double length = (segment.end - segment.start) * std::ldexp(1.0, -rng.between(3, 24));
      const double start = segment.start + (segment.end - length - segment.start) * rng.real(0, 1),
                   end = start + length;
      const auto m = even->model(segment, start, end);
      if (!m) continue;  // angles beyond 2^39
      sharp += m->sharp();
      for (int n = 0; n < 4; ++n) expect_laws(segment, *m, start + (end - start) * rng.real(0, 1));
      expect_laws(segment, *m, start);
      for (const bool pp : {true, false}) {
        const FrameThird third = even->third(segment, pp, start, end);
        expect_third(segment, third, pp ? 0 : 2, start + (end - start) / 4, end);
        expect_third(segment, third_of(*m, pp ? 0 : 2), pp ? 0 : 2, start, start + (end - start) / 2);
      }
    }
  }
  EXPECT_GT(sharp, effort(300));
}

Real960 number_of(const Fixed& x) {
  Real960 sum = 0;
  x.each_part([&sum](double part) { sum += Real960(part); });
  return sum;
}

/// What the coefficients make of an instant, |h| <= 1, give or take their errors and the rest.
void expect_expansion(const UniformRotation::Expansion& e, double h, const std::array<Jet<Real960>, 6>& truth) {
  for (std::size_t i = 0; i < 6; ++i) {
    Real960 sum = 0;
    double error = 0, power = 1;
    for (std::size_t k = e.c[i].size(); k-- > 0;) sum = sum * Real960(h) + number_of(e.c[i][k].mid());
    for (const FixedBall& c : e.c[i]) {
      error += c.rad() * power;
      power *= std::fabs(h);
    }
    error = (error + e.rest[i]) * (1 + 0x1p-40);
    if (!(error < INFINITY && e.over[i].d.rad < INFINITY)) continue;
    EXPECT_LE(abs(truth[i].v.mid - sum), Real960(error + truth[i].v.rad)) << "value";
    expect_within(truth[i].v, e.over[i].v.mid, e.over[i].v.rad, "value over the radius");
    expect_within(truth[i].d, e.over[i].d.mid, e.over[i].d.rad, "slope over the radius");
  }
}

TEST(UniformRotation, ExpansionsEncloseTheFrame) {
  Rng rng(73);
  std::uint64_t sharp = 0, rounds = 0;
  for (std::uint64_t i = 0; i < effort(400) && !HasFailure(); ++i) {
    const MotionSegment segment = random_segment(rng);
    const auto even = UniformRotation::of(segment);
    ASSERT_TRUE(even);
    const double m = segment.start + (segment.end - segment.start) * rng.real(0, 1);
    const int exponent = std::ilogb(segment.end - segment.start) - rng.between(10, 40);
    const double radius = std::ldexp(1.0, exponent);
    const UniformRotation::Expansion e = even->expansion(segment, m, exponent);
    EXPECT_LE(*std::max_element(e.rest.begin(), e.rest.end()), even->rest_within(segment, m, exponent) * (1 + 0x1p-40));
    for (const double share : {-1.0, 0.0, rng.real(-1, 1), 1.0}) {
      const double t = m + share * radius;
      if (std::fabs(t - m) <= radius) expect_expansion(e, (t - m) / radius, functions_at(segment, t));
    }
    ++rounds;
    sharp += e.c[4][0].rad() < 0x1p-300 && e.over[4].d.rad < 1e-3 * (1 + std::fabs(e.over[4].d.mid));
  }
  EXPECT_GT(sharp, rounds / 4);
}

TEST(UniformRotation, OtherLegsHaveNone) {
  const auto of = [](const Rotation& rotation) {
    MotionPiece piece;
    piece.rotation = rotation;
    return UniformRotation::of(MotionSegment::motion(MotionPiece{}, piece, 0, 1));
  };
  EXPECT_TRUE(of(AngleRotation{{0, 100}}));
  EXPECT_TRUE(of(AngleRotation{{0, -0x1p-20}}));
  EXPECT_FALSE(of(AngleRotation{{1}}));
  EXPECT_FALSE(of(AngleRotation{{0, 100, 1}}));
  EXPECT_FALSE(of(NoRotation{}));
  MotionPiece piece;
  piece.rotation = AngleRotation{{0, 100}};
  piece.x = Coefficients(10, 0.5);
  EXPECT_TRUE(UniformRotation::of(MotionSegment::motion(MotionPiece{}, piece, 0, 1)));
  piece.x = Coefficients(11, 0.5);
  EXPECT_FALSE(UniformRotation::of(MotionSegment::motion(MotionPiece{}, piece, 0, 1)));
}

/// A triangle that turns beside a square, or two that turn unevenly fast.
Scene turning_scene(double turns, double start, bool both) {
  Scene scene;
  scene.start = start;
  scene.end = start + turns;
  const Polygon triangle{{0.9, 0}, {-0.5, 0.7}, {-0.5, -0.7}};
  Motion motion, other;
  MotionPiece piece;
  piece.rotation = AngleRotation{{0, 6.283185307179586}};
  motion.pieces = {piece};
  if (both) {
    piece.x = {2.2};
    piece.rotation = AngleRotation{{0, -4.8}};
    other.pieces = {piece};
    scene.bodies = {{"a", triangle, other}, {"b", triangle, motion}};
  } else {
    scene.bodies = {{"a", {{1.2, -1}, {3.2, -1}, {3.2, 1}, {1.2, 1}}, {}}, {"b", triangle, motion}};
  }
  return scene;
}

std::uint64_t work_for(const Scene& scene, EngineChoice engine) {
  CheckOptions options;
  options.engine = engine;
  const std::uint64_t before = work_spent();
  EXPECT_EQ(check(scene, options).outcome, Outcome::free);
  return work_spent() - before;
}

TEST(UniformRotation, ATurnCostsNoMoreAmongManyOnes) {
  for (const EngineChoice engine : {EngineChoice::kinetic, EngineChoice::spacetime}) {
    for (const bool both : {false, true}) {
      const std::uint64_t one = work_for(turning_scene(1, 0, both), engine);
      EXPECT_LT(work_for(turning_scene(2000, 0, both), engine), 2000 * one);
      EXPECT_LT(work_for(turning_scene(2000, 1e6, both), engine), 2000 * one);
    }
  }
}

}  // namespace
}  // namespace taut::testing
