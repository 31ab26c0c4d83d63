// Motions far from time 0. The law: a scene that is moved in time by a power of two, where no coefficient rounds, has
// the answer of the scene before, moved likewise, and costs about as much.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "motion/far_pieces.hpp"
#include "motion/local_time.hpp"
#include "motion/motion_segment.hpp"
#include "numeric/budget.hpp"
#include "support/moved_in_time.hpp"
#include "support/rng.hpp"
#include "taut/check.hpp"
#include "taut/proof.hpp"

namespace taut::testing {
using namespace internal;
namespace {

/// Few bits, so that powers of the shift times it are exact.
double few_bits(Rng& rng) { return std::ldexp(static_cast<double>(rng.below(17)) - 8, -3); }

Coefficients short_polynomial(Rng& rng, int n) {
  Coefficients c;
  for (int i = 0; i < n; ++i) c.push_back(few_bits(rng));
  return c;
}

MotionPiece short_piece(Rng& rng) {
  MotionPiece piece;
  piece.x = short_polynomial(rng, 1 + rng.below(3));
  piece.y = short_polynomial(rng, 1 + rng.below(3));
  switch (rng.below(6)) {
    case 0:
      break;
    case 1:
      piece.rotation = DirectionRotation{{2, 0.125}, short_polynomial(rng, 2)};
      break;
    case 2:
      piece.rotation = HalfAngleRotation{short_polynomial(rng, 2)};
      break;
    case 3:
      piece.rotation = CosineRotation{{0.125, few_bits(rng) / 32}};
      break;
    default:
      piece.rotation = AngleRotation{short_polynomial(rng, 3)};
  }
  if (rng.below(2)) piece.pivot = {few_bits(rng), few_bits(rng)};
  if (rng.below(4) == 0) piece.orbit = {{few_bits(rng), few_bits(rng)}, short_polynomial(rng, 2)};
  return piece;
}

template <class Real>
bool balls_meet(const Ball<Real>& a, const Ball<Real>& b) {
  return a.lower() <= b.upper() && b.lower() <= a.upper();
}

TEST(FarTimes, PolynomialsAboutAnInstantAreExactBeforeTheyAreRounded) {
  Rng rng(1);
  for (int round = 0; round < 300; ++round) {
    Coefficients c;
    for (int n = 1 + rng.below(17); n > 0; --n) c.push_back(rng.real(-1, 1) * std::ldexp(1, rng.below(40) - 20));
    const double about = rng.real(1, 2) * std::ldexp(1, rng.below(40)), h = rng.real(-1, 1);
    const LocalPolynomials local(about);
    Dyadic given, moved;
    const Dyadic t = Dyadic::exact(about) + Dyadic::exact(h);
    const DyadicPolynomial exact = local.exact(c, 0);
    for (std::size_t k = c.size(); k-- > 0;) given = given * t + Dyadic::exact(c[k]);
    for (std::size_t k = exact.size(); k-- > 0;) moved = moved * Dyadic::exact(h) + exact[k];
    EXPECT_EQ(given, moved);
    const auto near = local.of<double>(c, 0);
    ASSERT_EQ(near.size(), exact.size());
    for (std::size_t k = 0; k < near.size(); ++k) {
      const Dyadic away = exact[k] - Dyadic::exact(near[k].mid);
      const Dyadic distance = away.sign() < 0 ? -away : away;
      EXPECT_LE((distance - Dyadic::exact(near[k].rad)).sign(), 0);
      EXPECT_LE(near[k].rad, 0x1p-51 * std::fabs(near[k].mid) + 0x1p-900);
    }
  }
}

TEST(FarTimes, FramesAreThoseOfTheMotionAtTimeZeroAndAsNarrow) {
  Rng rng(2);
  int seen = 0;
  for (int round = 0; round < 400; ++round) {
    const double shift = std::ldexp(1, 12 + rng.below(9)), h = rng.real(0, 1);
    const MotionPiece p = short_piece(rng), q = short_piece(rng);
    const MotionSegment near = MotionSegment::motion(p, q, 0, 1);
    const MotionSegment far = MotionSegment::motion(moved_in_time(p, shift), moved_in_time(q, shift), shift, shift + 1);
    ASSERT_FALSE(near.far());
    // Lines and even turns lose no more there than doubles can spare.
    const int power = std::max(highest_power(p), highest_power(q));
    ASSERT_EQ(far.far(), is_far_for(power, shift, shift + 1));
    if (!far.far()) continue;
    ++seen;
    const double t = shift + h, since = t - shift;
    const Frame<double> a = unshifted_frame(near, Ball<double>::exact(since));
    const Frame<double> b = unshifted_frame(far, Ball<double>::exact(t));
    const bool cosine =
        std::holds_alternative<CosineRotation>(p.rotation) || std::holds_alternative<CosineRotation>(q.rotation);
    for (std::size_t i = 0; i < 5; ++i) {
      for (const auto& [x, y] : {std::pair(a.for_pp[i], b.for_pp[i]), std::pair(a.for_qq[i], b.for_qq[i])}) {
        EXPECT_TRUE(balls_meet(x.v, y.v) && balls_meet(x.d, y.d) && balls_meet(x.dd, y.dd)) << round << " " << i;
        EXPECT_TRUE(cosine || y.v.rad <= 16 * x.v.rad + 0x1p-44) << round << " " << i;
      }
    }
    if (near.shift_p || near.shift_q) continue;
    const auto c = frame(near, Ball<Real320>::exact(since)), d = frame(far, Ball<Real320>::exact(t));
    for (std::size_t i = 0; i < 5; ++i) EXPECT_TRUE(balls_meet(c.for_pp[i].v, d.for_pp[i].v)) << round << " " << i;
  }
  EXPECT_GT(seen, 100);
}

TEST(FarTimes, AnswersMoveWithTheScene) {
  for (const Scene& near : small_scenes()) {
    for (const EngineChoice engine : {EngineChoice::kinetic, EngineChoice::spacetime}) {
      for (const Touch touch : {Touch::open, Touch::closed}) {
        CheckOptions options;
        options.engine = engine;
        options.touch = touch;
        const std::uint64_t start = work_spent();
        const Answer here = check(near, options);
        const std::uint64_t cost = work_spent() - start;
        for (const double shift : {0x1p10, 0x1p20, -0x1p20}) {
          const std::uint64_t before = work_spent();
          const Answer there = check(moved_in_time(near, shift), options);
          EXPECT_LE(work_spent() - before, 3 * cost + 200);
          ASSERT_EQ(here.outcome, there.outcome);
          ASSERT_EQ(here.contact.has_value(), there.contact.has_value());
          if (!here.contact) continue;
          const double ulps = 4 * std::fabs(shift) * 0x1p-52;
          EXPECT_LE(here.contact->time.lo, there.contact->time.hi - shift + 0x1p-50);
          EXPECT_GE(here.contact->time.hi, there.contact->time.lo - shift - 0x1p-50);
          EXPECT_LE(there.contact->time.hi - there.contact->time.lo, ulps);
          EXPECT_EQ(here.contact->vertex.index, there.contact->vertex.index);
          EXPECT_EQ(here.contact->edge.index, there.contact->edge.index);
        }
      }
    }
  }
}

TEST(FarTimes, ProofsOfScenesFarFromZeroAreVerifiedAndAsShort) {
  for (const Scene& near : small_scenes()) {
    for (const EngineChoice engine : {EngineChoice::kinetic, EngineChoice::spacetime}) {
      CheckOptions options;
      options.engine = engine;
      std::ostringstream here, there;
      prove(near, here, options);
      const Scene far = moved_in_time(near, 0x1p20);
      prove(far, there, options);
      EXPECT_LE(there.str().size(), 3 * here.str().size() + 100);
      std::istringstream log(there.str());
      EXPECT_NO_THROW(verify(far, log));
    }
  }
}

}  // namespace
}  // namespace taut::testing
