// What is refused: motions that are none, pieces that do not fit, features finer than the displacement.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <utility>

#include "geometry/displacement.hpp"
#include "motion/pieces.hpp"
#include "motion/polynomial_search.hpp"
#include "support/rng.hpp"
#include "taut/check.hpp"
#include "taut/error.hpp"
#include "taut/proof.hpp"
#include "taut/simulation.hpp"
#include "taut/validate.hpp"
#include "unit/sliding_square.hpp"

namespace taut::testing {
using namespace internal;
namespace {

std::string refusal(const Scene& scene) {
  try {
    validate(scene);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

Scene with_motion(std::vector<MotionPiece> pieces) {
  Scene scene = sliding_square(2);
  scene.bodies[1].motion.pieces = std::move(pieces);
  return scene;
}

void expect_refusal(const Scene& scene, const std::string& part) {
  EXPECT_NE(refusal(scene).find(part), std::string::npos) << "\"" << refusal(scene) << "\" lacks \"" << part << "\"";
}

TEST(MotionValidation, RefusesWhatIsNotAMotion) {
  EXPECT_EQ(refusal(sliding_square(2)), "");
  expect_refusal(with_motion({{{0, NAN}, {}, NoRotation{}}}), "b: motion: x[1] is not a finite number");
  expect_refusal(with_motion({{Coefficients(18, 1.0), {}, NoRotation{}}}), "x has degree 17\nhint: the highest degree");
  expect_refusal(with_motion({{{}, {}, DirectionRotation{{-1, 1}, {-2, 2}}}}),
                 "the direction (a, b) vanishes near t = ");
  expect_refusal(with_motion({{{}, {}, DirectionRotation{{}, {}}}}), "vanishes");
  expect_refusal(with_motion({{{}, {}, CosineRotation{{0, 0.5}}}}), "the cosine is beyond 1 in magnitude");
  expect_refusal(with_motion({{{}, {}, CosineRotation{{0, 0.5}}}}), "must stay within [-1, 1]");
  EXPECT_EQ(refusal(with_motion({{{3}, {}, CosineRotation{{0, 0.1}}}})), "");
  expect_refusal(with_motion({{{1e200}, {}, NoRotation{}}}), "outside the range of magnitudes");
  expect_refusal(with_motion({{{}, {}, NoRotation{}, INFINITY, {0, NAN}}}), "pivot[1] is not a finite number");
}

/// A piece that begins after the scene's end is not asked about times at which another one holds.
TEST(MotionValidation, DoesNotLookBeyondTheEnd) {
  const MotionPiece first{{3}, {2}, NoRotation{}, 20}, later{{3}, {2}, CosineRotation{{1.5, -0.02}}};
  EXPECT_EQ(refusal(with_motion({first, later})), "");
  MotionPiece at_the_end = first;
  at_the_end.until = 10;
  expect_refusal(with_motion({at_the_end, later}), "the cosine is beyond 1 in magnitude");
}

TEST(MotionValidation, RefusesPiecesThatDoNotFit) {
  expect_refusal(with_motion({{{3, -1}, {2}, NoRotation{}, 3}, {{1}, {2}, NoRotation{}}}),
                 "b: motion piece 0: the motion jumps by 1 at t = 3");
  expect_refusal(with_motion({{{3}, {2}, NoRotation{}, 3}, {{3}, {2}, NoRotation{}, 3}, {{3}, {2}, NoRotation{}}}),
                 "`until` 3 does not come after");
  expect_refusal(with_motion({{{3}, {2}, NoRotation{}, 3}}), "the motion ends at 3, before the scene does, at 10");
  EXPECT_EQ(refusal(with_motion({{{3, -1}, {2}, NoRotation{}, 3}, {{1e-9, 0}, {2}, NoRotation{}}})), "");
}

/// The Chebyshev polynomial of this degree: it reaches 1 and -1 in turn, all over [-1, 1].
Coefficients chebyshev_polynomial(int degree) {
  Coefficients before{1}, last{0, 1};
  for (int k = 1; k < degree; ++k) {
    Coefficients next(last.size() + 1, 0.0);
    for (std::size_t i = 0; i < last.size(); ++i) next[i + 1] += 2 * last[i];
    for (std::size_t i = 0; i < before.size(); ++i) next[i] -= before[i];
    before = std::exchange(last, std::move(next));
  }
  return last;
}

std::string refusal_of_rotation(const Rotation& rotation, double start, double end) {
  Scene scene = with_motion({{{3}, {}, rotation}});
  scene.start = start;
  scene.end = end;
  return refusal(scene);
}

/// What doubles cannot tell from a cosine beyond 1, and halving would look for in every interval there is.
TEST(MotionValidation, TellsCosinesThatReachOneFromOnesBeyondIt) {
  EXPECT_EQ(refusal_of_rotation(CosineRotation{{-9999, 200, -1}}, 100, 101), "");
  EXPECT_NE(refusal_of_rotation(CosineRotation{{-9999, 200, -1 - 0x1p-36}}, 101, 101.5), "");
  EXPECT_EQ(refusal_of_rotation(CosineRotation{{-99999999, 20000, -1}}, 9999.5, 10001), "");
  EXPECT_EQ(refusal_of_rotation(CosineRotation{{1 + 0x1p-41}}, 0, 1), "");
  EXPECT_NE(refusal_of_rotation(CosineRotation{{-1 - 0x1p-39}}, 0, 1), "");
  EXPECT_NE(refusal_of_rotation(CosineRotation{{1 + 0x1p-40, 0, -1}}, -1, 1), "") << "it just reaches the bound";
  for (const int degree : {2, 11, 12, 16}) {
    EXPECT_EQ(refusal_of_rotation(CosineRotation{chebyshev_polynomial(degree)}, -1, 1), "") << degree;
    EXPECT_NE(refusal_of_rotation(CosineRotation{chebyshev_polynomial(degree)}, -1, 1.0001), "") << degree;
    Coefficients beyond = chebyshev_polynomial(degree);
    for (double& c : beyond) c *= 1 + 0x1p-38;
    EXPECT_NE(refusal_of_rotation(CosineRotation{beyond}, -0.5, 0.99), "") << degree;
  }
}

TEST(MotionValidation, RefusesDirectionsThatVanishAndNoOthers) {
  const Coefficients t{0, 1}, sqrt_two{-2, 0, 1}, multiple{0, -2, 0, 1};
  EXPECT_EQ(refusal_of_rotation(DirectionRotation{t, {1e-15}}, -1, 1), "");
  EXPECT_EQ(refusal_of_rotation(DirectionRotation{t, {1e-100}}, -1, 1), "");
  EXPECT_EQ(refusal_of_rotation(DirectionRotation{t, {1e-100, 1}}, -1.0 / 3, 1), "");
  EXPECT_EQ(refusal_of_rotation(DirectionRotation{sqrt_two, multiple}, 2, 3), "");
  EXPECT_NE(refusal_of_rotation(DirectionRotation{t, {0, 0, 1}}, 0, 1), "") << "at an end";
  EXPECT_NE(refusal_of_rotation(DirectionRotation{t, {0, 0, 1}}, -1.0 / 3, 1), "") << "where nothing is halved";
  EXPECT_NE(refusal_of_rotation(DirectionRotation{sqrt_two, multiple}, 0, 3).find("near t = 1.41421356"),
            std::string::npos);
  EXPECT_NE(refusal_of_rotation(DirectionRotation{{0}, {0}}, 0, 1), "");
  // One root of multiplicity 8, and the same moved by a little.
  Coefficients root{256, 0, -1024, 0, 1792, 0, -1792, 0, 1120, 0, -448, 0, 112, 0, -16, 0, 1};
  Coefficients moved = root;
  moved[1] = 1e-30;
  EXPECT_NE(refusal_of_rotation(DirectionRotation{root, root}, 0, 2), "");
  EXPECT_EQ(refusal_of_rotation(DirectionRotation{root, moved}, 0, 2), "");
}

TEST(MotionValidation, AcceptsNothingThatItCouldNotSearch) {
  EXPECT_EQ(beyond_one(chebyshev_polynomial(16), 0, -1, 1), std::nullopt);
  EXPECT_THROW(beyond_one(chebyshev_polynomial(16), 0, -1, 1, 100), SearchExhausted);
  const Coefficients sqrt_two{-2, 0, 1}, multiple{0, -2, 0, 1};
  EXPECT_NE(common_zero(sqrt_two, multiple, 0, 0, 2), std::nullopt);
  EXPECT_THROW(common_zero(sqrt_two, multiple, 0, 0, 2, 100), SearchExhausted);
}

TEST(MotionValidation, SmallBodiesFarAwayMayJumpByWhatDoublesRound) {
  Scene scene = sliding_square(2);
  for (Body& body : scene.bodies) {
    for (Point& v : body.polygon) v = {v.x * 0x1p-20, v.y * 0x1p-20};
  }
  const auto jump = [&scene](double by) {
    scene.bodies[1].motion.pieces = {{{1e6 + by}, {}, NoRotation{}, 3}, {{1e6}, {}, NoRotation{}}};
    return refusal(scene);
  };
  EXPECT_EQ(jump(0x1p-33), "");
  EXPECT_NE(jump(0x1p-20).find("the motion jumps by"), std::string::npos);
  // Terms that cancel are rounded, too.
  scene.bodies[1].motion.pieces = {{{1e6 - 3e6, 1e6}, {}, NoRotation{}, 3}, {{-2e6 + 0x1p-32, 1e6}, {}, NoRotation{}}};
  EXPECT_EQ(refusal(scene), "");
}

/// As docs/scenes.md has it: up to 2^400, and as near to 0 as doubles are.
TEST(SceneValidation, TimesHaveMagnitudes) {
  Scene scene = sliding_square(2);
  scene.bodies[1].motion = {};
  for (const double end : {5e-324, 1e-200, 0x1p400}) {
    scene.end = end;
    EXPECT_EQ(refusal(scene), "") << end;
    EXPECT_NO_THROW(check(scene)) << end;
  }
  scene.end = 0x1.8p400;
  expect_refusal(scene, "beyond 2^400");
  scene.end = 1;
  scene.start = -1.7e308;
  expect_refusal(scene, "beyond 2^400");
}

TEST(SceneValidation, RefusesBadTimesAndBodies) {
  Scene scene = sliding_square(2);
  scene.end = -1;
  expect_refusal(scene, "time: the time interval ends before it starts");
  scene = sliding_square(2);
  scene.start = INFINITY;
  expect_refusal(scene, "not finite");
  scene = sliding_square(2);
  scene.bodies.push_back(scene.bodies[0]);
  expect_refusal(scene, "bodies: two bodies are called \"a\"");
  scene = sliding_square(2);
  scene.bodies[0].polygon = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};
  expect_refusal(scene, "a: ");
  scene = sliding_square(2);
  scene.bodies[0].polygon[0].x = 1e-110;
  scene.bodies[1].polygon[1].x = 1e100;
  expect_refusal(scene, "differ in magnitude");
}

/// A notch far smaller than the displacement turns inside out: that must be seen, not computed with.
TEST(FineFeatures, SmallerThanTheDisplacementAreRefused) {
  Scene scene = sliding_square(2);
  scene.bodies[0].polygon = {{0, 0}, {1, 0}, {1, 1}, {0.5, 1e-75}, {0.25, 0.5e-75}, {0, 1}};
  try {
    check(scene);
    FAIL() << "accepted";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("a: edges "), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("come closer than the displacement"), std::string::npos) << e.what();
  }
  // A hundred million times larger than the displacement is fine.
  scene.bodies[0].polygon = {{0, 0}, {1, 0}, {1, 1}, {0.5, 1e-52}, {0.25, 0.5e-52}, {0, 1}};
  EXPECT_EQ(check(scene).outcome, Outcome::free);
}

/// Every way to ask refuses it, and names the vertex of the input.
TEST(FineFeatures, CornersTooSharpAreRefused) {
  Scene scene = sliding_square(2);
  scene.bodies[0].polygon = {{0.5, 1e-15}, {0, 1}, {-0.25, 1}, {-0.5, 0.5}, {0, 0}, {1, 0}};
  for (const auto engine : {EngineChoice::kinetic, EngineChoice::spacetime}) {
    CheckOptions options;
    options.engine = engine;
    try {
      check(scene, options);
      FAIL() << "accepted";
    } catch (const InputError& e) {
      EXPECT_EQ(e.place(), "a");
      EXPECT_NE(e.problem().find("the corner at vertex 5"), std::string::npos) << e.what();
      EXPECT_EQ(e.culprits().vertices, (std::vector<VertexRef>{{0, 5}}));
    }
  }
  std::ostringstream log;
  EXPECT_THROW(prove(scene, log), InputError);
  EXPECT_THROW(Simulation(scene, Touch::closed), InputError);
  scene.bodies[0].polygon[0].y = 1e-11;
  EXPECT_EQ(check(scene).outcome, Outcome::free);
}

}  // namespace
}  // namespace taut::testing
