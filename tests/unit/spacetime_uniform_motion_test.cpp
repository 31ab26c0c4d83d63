// The law of stretches for even motions: against the poses themselves, in long doubles.
#include "spacetime/uniform_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "spacetime/at_pose.hpp"
#include "support/effort.hpp"
#include "support/rng.hpp"

namespace taut::internal::spacetime {
namespace {

using testing::Rng;
using Long = std::complex<long double>;

struct LongPose {
  Long o = 0, x = 1;
};

long double linear(const Coefficients& c, long double t) {
  return static_cast<long double>(coefficient(c, 0)) + static_cast<long double>(coefficient(c, 1)) * t;
}

LongPose long_pose(const std::vector<MotionPiece>& chain, long double time) {
  LongPose pose;
  for (const MotionPiece& piece : chain) {
    const long double t = time - piece.origin;
    const auto* rotation = std::get_if<AngleRotation>(&piece.rotation);
    const Long x = rotation ? std::polar(1.0L, linear(rotation->angle, t)) : Long(1);
    const Long c = rotation ? Long(piece.pivot.x, piece.pivot.y) : Long(0);
    const Long o = Long(linear(piece.x, t), linear(piece.y, t)) + c - x * c;
    pose = {pose.o + pose.x * o, pose.x * x};
  }
  return pose;
}

MotionPiece random_uniform_piece(Rng& rng) {
  MotionPiece piece;
  if (rng.chance(0.8)) piece.x = {rng.real(-1, 1), rng.real(-1, 1)};
  if (rng.chance(0.8)) piece.y = {rng.real(-1, 1), rng.real(-1, 1)};
  if (rng.chance(0.8)) piece.rotation = AngleRotation{{rng.real(-4, 4), rng.real(-3, 3)}};
  if (rng.chance(0.5)) piece.pivot = {rng.real(-0.5, 0.5), rng.real(-0.5, 0.5)};
  if (rng.chance(0.5)) piece.origin = rng.real(-1, 1);
  return piece;
}

Vector point_of(const Path& p, double h) { return {p.x.a + h * (p.x.b + h * p.x.c), p.y.a + h * (p.y.b + h * p.y.c)}; }

/// Where a carriage puts v at the time h from the middle.
Vector carried(const RelativePose& c, Vector v, double h) { return point_of(c.place(v, {}), h); }

double apart_by(Vector approximate, Long truth) {
  return static_cast<double>(std::abs(Long(approximate.x, approximate.y) - truth));
}

TEST(EvenMotions, StretchesKeepTheirLaw) {
  double loosest = 0;
  for (std::uint64_t seed = 0; seed < testing::effort(4000); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    std::vector<MotionPiece> p, q;
    for (int k = rng.between(0, 2); k > 0; --k) p.push_back(random_uniform_piece(rng));
    for (int k = rng.between(1, 3); k > 0; --k) q.push_back(random_uniform_piece(rng));
    const double reach = rng.real(0.01, 0.5), start = rng.real(-1, 1), end = start + std::exp2(-rng.real(0, 30));
    UniformStretch even = UniformMotion(p, q, reach).stretch(start, end);
    const double middle = start + (end - start) / 2;
    for (int i = 0; i < 6; ++i) {
      const double t = i == 0 ? start : i == 1 ? end : rng.real(start, end), h = t - middle;
      const LongPose of_p = long_pose(p, t), of_q = long_pose(q, t);
      const Long turn = std::conj(of_p.x) * of_q.x, way = std::conj(of_p.x) * (of_q.o - of_p.o);
      const double angle = rng.real(0, 7), far = rng.unit() * reach;
      const Vector v{far * std::cos(angle), far * std::sin(angle)};
      const Stretch& all = even.everywhere();
      const double off = apart_by(carried(all.in_p, v, h), way + turn * Long(v.x, v.y));
      EXPECT_LE(off, all.in_p.error);
      EXPECT_LT(all.in_p.error, 1 + 3000 * std::pow(end - start, 3));
      // Points of P within a disc.
      const Vector centre{rng.real(-1, 1), rng.real(-1, 1)};
      const double radius = rng.real(0, 0.5);
      const Vector a{centre.x + radius * 0.6, centre.y - radius * 0.8};
      const Stretch& near = even.near(centre, radius);
      const double off_q = apart_by(carried(near.in_q, a, h), std::conj(turn) * (Long(a.x, a.y) - way));
      EXPECT_LE(off_q, near.in_q.error);
      if (end - start < 1e-6) loosest = std::max(loosest, near.in_q.error);
    }
  }
  // What is left on short stretches is rounding.
  EXPECT_LT(loosest, 1e-11);
}

/// Edges that cross, or do not, in doubles: what is certain is so by a determinant in long doubles.
TEST(EvenMotions, EdgesThatCross) {
  int yes = 0, no = 0;
  for (std::uint64_t seed = 0; seed < testing::effort(20000); ++seed) {
    Rng rng(seed);
    std::vector<DisplacedPoint> p, q;
    for (int k = 0; k < 3; ++k) {
      p.push_back({rng.real(-1, 1), rng.real(-1, 1), 0, 0});
      q.push_back({rng.real(-0.5, 0.5), rng.real(-0.5, 0.5), 0, 0});
    }
    const std::vector<MotionPiece> motion{random_uniform_piece(rng)};
    const double t = rng.real(-1, 1);
    const PairGeometry g(p, q);
    UniformStretch even = UniformMotion({}, motion, 0.8).stretch(t, t);
    const EdgesCross cross = edges_cross(QAtPose::of(even.everywhere()), g, VertexId(0u), VertexId(3u));
    const LongPose pose = long_pose(motion, t);
    const Long a(p[0].x, p[0].y), b(p[1].x, p[1].y);
    const Long c = pose.o + pose.x * Long(q[0].x, q[0].y), d = pose.o + pose.x * Long(q[1].x, q[1].y);
    const auto turn = [](const Long& u, const Long& v, const Long& w) { return std::imag(std::conj(v - u) * (w - u)); };
    const bool truth = turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
    if (cross == EdgesCross::unknown) continue;
    EXPECT_EQ(cross == EdgesCross::yes, truth) << seed;
    ++(truth ? yes : no);
  }
  EXPECT_GE(yes, static_cast<int>(testing::enough(500)));
  EXPECT_GE(no, static_cast<int>(testing::enough(10000)));
}

}  // namespace
}  // namespace taut::internal::spacetime
