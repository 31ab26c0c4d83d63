// Frames of the relative motion, and sine and cosine, against an evaluation in 2000 bits that shares nothing with them.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "motion/motion_segment.hpp"
#include "numeric/trig.hpp"
#include "support/effort.hpp"
#include "support/exact_motion.hpp"
#include "support/exact_roots.hpp"
#include "support/rng.hpp"
#include "support/sum_of_doubles.hpp"

namespace taut::testing {
using namespace internal;
namespace {

using exact::BodyMotion;
using exact::Narrow;
using exact::Precision;
using exact::Rational;
using exact::Wide;
using Wides = exact::Series<Wide, 2>;

template <class Real>
bool encloses(const Ball<Real>& ball, const Wide& x) {
  const Rational mid = sum_of_doubles<Rational>(ball.mid), rad(ball.rad);
  return !Wide::of(mid + rad).before(x) && !x.before(Wide::of(mid - rad));
}

Coefficients random_coefficients(Rng& rng, int degree, double size) {
  Coefficients c;
  for (int k = 0; k <= degree; ++k) c.push_back(rng.chance(0.2) ? rng.between(-2, 2) : rng.real(-size, size));
  return c;
}

/// Well defined on [0, 1].
Rotation any_rotation(Rng& rng) {
  switch (rng.below(5)) {
    case 0:
      return NoRotation{};
    case 1:
      return AngleRotation{random_coefficients(rng, rng.below(4), 4)};
    case 2:
      return HalfAngleRotation{random_coefficients(rng, rng.below(4), 3)};
    case 3: {
      DirectionRotation r{random_coefficients(rng, rng.below(3), 1), random_coefficients(rng, rng.below(3), 1)};
      r.a[0] = rng.sign() * 4;
      return r;
    }
    default:
      return CosineRotation{{rng.real(-0.3, 0.3), rng.real(-0.3, 0.3), rng.real(-0.3, 0.3)}};
  }
}

MotionPiece any_piece(Rng& rng) {
  MotionPiece piece{random_coefficients(rng, rng.below(6), 3), random_coefficients(rng, rng.below(6), 3),
                    any_rotation(rng)};
  if (rng.chance(0.5)) piece.pivot = {rng.real(-5, 5), double(rng.between(-5, 5))};
  if (rng.chance(0.5)) piece.origin = rng.chance(0.5) ? 0.5 : rng.unit();
  return piece;
}

struct Complex {
  Wides x, y;
};
Complex times_conjugate(const Complex& a, const Complex& b) { return {a.x * b.x + a.y * b.y, a.x * b.y - a.y * b.x}; }

/// The body's point, and its axis x, at t.
void place(const BodyMotion& body, const Wide& t, const Point& v, Complex& point, Complex& axis) {
  const exact::Pose<Wide, 2> pose = body.pose<Wide, 2>(t);
  // 1 / below, as a series.
  Wides inverse;
  inverse.c[0] = Wide(1.0) / pose.below.c[0];
  inverse.c[1] = Wide(0.0) - inverse.c[0] * inverse.c[0] * pose.below.c[1];
  inverse.c[2] = Wide(0.0) - inverse.c[0] * (inverse.c[0] * pose.below.c[2] + inverse.c[1] * pose.below.c[1]);
  axis = {pose.x * inverse, pose.y * inverse};
  const Wide x = Wide(v.x) - Wide(body.pivot_point().x), y = Wide(v.y) - Wide(body.pivot_point().y);
  point = {pose.ox + (x * axis.x - y * axis.y), pose.oy + (y * axis.x + x * axis.y)};
}

/// A vertex as the segment sees it.
template <class Real>
std::array<Ball<Real>, 2> seen(const MotionSegment& segment, bool of_p, const Point& v) {
  std::array<Ball<Real>, 2> at{Ball<Real>::exact(v.x), Ball<Real>::exact(v.y)};
  add_offset(segment, of_p, at[0], at[1]);
  return at;
}

template <class Real, class Part>
void expect_part(const std::array<Ball<Real>, 2>& got, const Complex& want, const Part& part) {
  EXPECT_TRUE(encloses(got[0], part(want.x)));
  EXPECT_TRUE(encloses(got[1], part(want.y)));
}

/// conj(x) (q - p) in both frames, with both derivatives: by the segment's functions and by definition.
template <class Real>
void expect_frame(const MotionSegment& segment, double t, const Point& p, const Point& q, const Complex& in_p,
                  const Complex& in_q) {
  const Frame<Real> f = frame(segment, Ball<Real>::exact(t));
  const auto vp = seen<Real>(segment, true, p), vq = seen<Real>(segment, false, q);
  const auto combined = [&](const auto& of) {
    const auto &a = f.for_pp, &b = f.for_qq;
    const std::array<Ball<Real>, 2> first{of(a[1]) + of(a[3]) * vq[0] - of(a[4]) * vq[1] - of(a[0]) * vp[0],
                                          of(a[2]) + of(a[3]) * vq[1] + of(a[4]) * vq[0] - of(a[0]) * vp[1]};
    const std::array<Ball<Real>, 2> second{of(b[1]) + of(b[0]) * vq[0] - of(b[3]) * vp[0] - of(b[4]) * vp[1],
                                           of(b[2]) + of(b[0]) * vq[1] - of(b[3]) * vp[1] + of(b[4]) * vp[0]};
    return std::pair(first, second);
  };
  const auto compare = [&](const auto& of, const auto& part) {
    const auto [first, second] = combined(of);
    expect_part<Real>(first, in_p, part);
    expect_part<Real>(second, in_q, part);
  };
  compare([](const Jet<Real>& j) { return j.v; }, [](const Wides& s) { return s.c[0]; });
  compare([](const Jet<Real>& j) { return j.d; }, [](const Wides& s) { return s.c[1]; });
  compare([](const Jet<Real>& j) { return j.dd; }, [](const Wides& s) { return s.c[2] + s.c[2]; });
}

void expect_segment(const MotionSegment& segment, const std::array<BodyMotion, 2>& bodies, double t, const Point& p,
                    const Point& q) {
  Complex at_p, at_q, x_p, x_q;
  place(bodies[0], Wide(t), p, at_p, x_p);
  place(bodies[1], Wide(t), q, at_q, x_q);
  const Complex way{at_q.x - at_p.x, at_q.y - at_p.y};
  const Complex in_p = times_conjugate(x_p, way), in_q = times_conjugate(x_q, way);
  expect_frame<double>(segment, t, p, q, in_p, in_q);
  expect_frame<Real320>(segment, t, p, q, in_p, in_q);
  expect_frame<Real960>(segment, t, p, q, in_p, in_q);
}

TEST(MotionFrames, ContainTheExactValues) {
  const Precision precision(2000);
  for (std::uint64_t seed = 0; seed < effort(2000); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed + 77);
    const MotionPiece p = any_piece(rng);
    MotionPiece q = any_piece(rng);
    if (rng.chance(0.1)) q.rotation = p.rotation;
    const exact::Poly time{Rational(0), Rational(1)};
    const auto a = BodyMotion::of(p, time, 0, 1), b = BodyMotion::of(q, time, 0, 1);
    ASSERT_TRUE(a && b);
    const double t = rng.chance(0.2) ? rng.below(3) / 2.0 : rng.unit();
    const Point u{rng.real(-3, 3), rng.real(-3, 3)}, v{rng.real(-3, 3), rng.real(-3, 3)};
    expect_segment(MotionSegment::motion(p, q, 0, 1), {*a, *b}, t, u, v);
    if (HasFailure()) return;
  }
}

TEST(MotionFrames, OfBridgesContainTheExactValues) {
  const Precision precision(2000);
  for (std::uint64_t seed = 0; seed < effort(500); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed + 7777);
    const MotionPiece p = any_piece(rng), q = any_piece(rng), p_next = any_piece(rng);
    const double joint = rng.unit();
    const std::array<BodyMotion, 2> bodies{BodyMotion::bridge(p, p_next, joint), BodyMotion::bridge(q, q, joint)};
    const Point u{rng.real(-3, 3), rng.real(-3, 3)}, v{rng.real(-3, 3), rng.real(-3, 3)};
    expect_segment(MotionSegment::bridging(p, q, p_next, q, joint), bodies, rng.unit(), u, v);
    if (HasFailure()) return;
  }
}

template <class Real>
void expect_trig(double x, const Wide& sine, const Wide& cosine) {
  const SinCos<Real> got = sin_cos(Ball<Real>::exact(x));
  EXPECT_TRUE(encloses(got.sin, sine)) << x;
  EXPECT_TRUE(encloses(got.cos, cosine)) << x;
  // And closely, unless the argument is huge.
  if (std::fabs(x) < 1000) {
    EXPECT_LE(got.sin.rad, 0x1p-30) << x;
  }
}

TEST(Trig, ContainsTheExactValues) {
  const Precision precision(2000);
  Rng rng(5);
  for (std::uint64_t k = 0; k < effort(3000); ++k) {
    double x = rng.sign() * std::exp2(rng.real(-60, 20));
    // Next to a multiple of a quarter turn, where one of the two is tiny.
    if (rng.chance(0.3)) x = std::nextafter(1.5707963267948966 * rng.between(-1000, 1000), rng.sign() * 1e300);
    if (rng.chance(0.1)) x = rng.between(-50, 50);
    Wide sine, cosine;
    sin_cos(Wide(x), sine, cosine);
    expect_trig<double>(x, sine, cosine);
    expect_trig<Real320>(x, sine, cosine);
    expect_trig<Real960>(x, sine, cosine);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace taut::testing
