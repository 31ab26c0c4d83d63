// Rotations given by a cosine, cut where it reaches 1 or -1.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "motion/cosine_pieces.hpp"
#include "motion/pieces.hpp"
#include "motion/pose.hpp"
#include "taut/check.hpp"
#include "unit/sliding_square.hpp"

namespace taut::testing {
using namespace internal;
namespace {

CosineRotation cosine(const Coefficients& a) { return {a}; }

std::vector<MotionPiece> cut(const Coefficients& a, double from, double to) {
  MotionPiece piece;
  piece.rotation = cosine(a);
  return cut_at_extremes(piece, from, to);
}

TEST(CosinePieces, EndWhereTheCosineIsOne) {
  // 1 - (t - 1)^2 / 2, and 1 - (t - 1.5)^4 / 128, whose guesses are best in the third derivative.
  for (const auto& [a, at] :
       {std::pair(Coefficients{0.5, 1, -0.5}, 1.0),
        std::pair(Coefficients{0.96044921875, 0.10546875, -0.10546875, 0.046875, -0.0078125}, 1.5)}) {
    const std::vector<MotionPiece> pieces = cut(a, 0, 2);
    ASSERT_EQ(pieces.size(), 2U);
    EXPECT_EQ(pieces[0].until, at);
    EXPECT_TRUE(same_motion(pieces[0], pieces[1]));
  }
  EXPECT_EQ(cut({1, -1}, 0, 1).size(), 1U);
  EXPECT_EQ(cut({1, 0, -1}, 0, 1).size(), 1U);
}

TEST(CosinePieces, RestWhereTheCosineIsBeyondOne) {
  EXPECT_TRUE(std::holds_alternative<DirectionRotation>(cut({1}, 0, 1)[0].rotation));
  EXPECT_TRUE(std::holds_alternative<DirectionRotation>(cut({-1}, 0, 1)[0].rotation));
  EXPECT_TRUE(std::holds_alternative<CosineRotation>(cut({0.5}, 0, 1)[0].rotation));
  const std::vector<MotionPiece> pieces = cut({1 + 0x1p-52, -1}, 0, 1);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0].until, 0x1p-52);
  EXPECT_TRUE(std::holds_alternative<DirectionRotation>(pieces[0].rotation));
  EXPECT_TRUE(std::holds_alternative<CosineRotation>(pieces[1].rotation));
}

/// The Chebyshev polynomial of degree 4 is -1 at sqrt(1/2), which is no double.
TEST(CosinePieces, RestBesideATouchBetweenDoubles) {
  const std::vector<MotionPiece> pieces = cut({1, 0, -8, 0, 8}, 0, 1);
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_LT(pieces[0].until, std::sqrt(0.5));
  EXPECT_GT(pieces[1].until, std::sqrt(0.5));
  EXPECT_LT(pieces[1].until - pieces[0].until, 0x1p-51);
  EXPECT_TRUE(std::holds_alternative<DirectionRotation>(pieces[1].rotation));
  Scene scene = sliding_square(2);
  scene.end = 1;
  for (Point& v : scene.bodies[0].polygon) v.x -= 30;
  scene.bodies[1].motion.pieces.resize(1);
  scene.bodies[1].motion.pieces[0] = {};
  scene.bodies[1].motion.pieces[0].rotation = cosine({1, 0, -8, 0, 8});
  CheckOptions options;
  options.engine = EngineChoice::spacetime;
  EXPECT_EQ(check(scene, options).outcome, Outcome::free);
}

/// T_degree, by its recurrence.
Coefficients chebyshev(int degree) {
  Coefficients before{1}, now{0, 1};
  for (int k = 1; k < degree; ++k) {
    Coefficients next(now.size() + 1);
    for (std::size_t i = 0; i < now.size(); ++i) next[i + 1] = 2 * now[i];
    for (std::size_t i = 0; i < before.size(); ++i) next[i] -= before[i];
    before = std::exchange(now, next);
  }
  return now;
}

/// In doubles, derivatives of such degrees are zero a thousand doubles beside the instants at which the cosine touches
/// 1 or -1, cos(k pi / degree); where these were not found, there were 290,000 windows beside one of them.
TEST(CosinePieces, RestBesideTouchesAtHighDegrees) {
  const double pi = std::acos(-1);
  for (const int degree : {8, 12, max_degree}) {
    const std::vector<MotionPiece> pieces = cut(chebyshev(degree), 0, 1);
    std::size_t cuts = 0;
    for (int k = degree / 2 - 1; k > 0; --k) {
      SCOPED_TRACE("degree " + std::to_string(degree) + ", extreme " + std::to_string(k));
      const double extreme = std::cos(k * pi / degree);
      ASSERT_LT(cuts, pieces.size());
      EXPECT_NEAR(pieces[cuts].until, extreme, 0x1p-50);
      if (std::fabs(extreme - 0.5) < 0x1p-40) {
        EXPECT_EQ(pieces[cuts++].until, 0.5);
        continue;
      }
      EXPECT_NEAR(pieces[cuts + 1].until, extreme, 0x1p-50);
      EXPECT_TRUE(std::holds_alternative<DirectionRotation>(pieces[cuts + 1].rotation));
      cuts += 2;
    }
    EXPECT_EQ(pieces.size(), cuts + 1);
  }
}

}  // namespace
}  // namespace taut::testing
