// What searches near contacts of high order cost: work is the same on every machine.
#include <gtest/gtest.h>

#include <sstream>

#include "base/interruption.hpp"
#include "taut/check.hpp"
#include "taut/io.hpp"
#include "taut/proof.hpp"

namespace taut {
namespace {

/// The larger one of both ways of touching.
std::uint64_t work_of(const Scene& scene, EngineChoice engine) {
  std::uint64_t most = 0;
  for (const Touch touch : {Touch::open, Touch::closed}) {
    CheckOptions options;
    options.engine = engine;
    options.touch = touch;
    options.max_seconds = 20;
    const std::uint64_t before = work_spent();
    EXPECT_NE(check(scene, options).outcome, Outcome::undecided);
    most = std::max(most, work_spent() - before);
  }
  return most;
}

/// 1.2 thousand million where the sign that a Taylor polynomial's last term hides is looked for in shorter and shorter
/// stretches by the same polynomial.
TEST(WorkOfSearches, BesideAnInfiniteSpeed) {
  const Scene scene = read_scene("tests/corpus/contact_of_order_six_beside_an_infinite_speed.json");
  EXPECT_LT(work_of(scene, EngineChoice::kinetic), 2'000'000u);
  EXPECT_LT(work_of(scene, EngineChoice::spacetime), 4'000'000u);
}

/// 550,000 where steps in doubles are left only when they are far shorter.
TEST(WorkOfSearches, NearAContactOfOrderSix) {
  const Scene scene = read_scene("tests/corpus/needles_that_pass_in_order_six.json");
  EXPECT_LT(work_of(scene, EngineChoice::kinetic), 100'000u);
}

/// Without the cuts where it touches 1, 48 seconds.
TEST(WorkOfSearches, OfACosineThatTouchesOneBetweenDoubles) {
  const Scene scene = read_scene("tests/corpus/cosine_that_touches_one_between_doubles.json");
  EXPECT_LT(work_of(scene, EngineChoice::kinetic), 20'000'000u);
  EXPECT_LT(work_of(scene, EngineChoice::spacetime), 2'000'000u);
}

/// Bounded in powers of the time itself, the cosine leaves stretches as short as the square of their distance from that
/// instant.
TEST(WorkOfSearches, OfACosineThatNearlyReachesOne) {
  const Scene scene = read_scene("tests/corpus/cosine_that_nearly_reaches_one.json");
  EXPECT_LT(work_of(scene, EngineChoice::kinetic), 1'000'000u);
  EXPECT_LT(work_of(scene, EngineChoice::spacetime), 200'000u);
}

/// Polynomials that reach beyond the places, in the complex plane, at which the motion is singular tell nothing.
TEST(WorkOfSearches, OfTiesBesideACosineThatNearlyReachesOne) {
  const Scene scene = read_scene("tests/corpus/ties_beside_a_cosine_that_nearly_reaches_one.json");
  EXPECT_LT(work_of(scene, EngineChoice::kinetic), 300'000u);
  EXPECT_LT(work_of(scene, EngineChoice::spacetime), 2'000'000u);
}

/// Halved as long as margins are more than doubles round elsewhere, windows end a unit in the last place long.
TEST(WorkOfSearches, OfALogBesideACosineThatNearlyReachesOne) {
  const Scene scene = read_scene("tests/corpus/ties_beside_a_cosine_that_nearly_reaches_one.json");
  CheckOptions options;
  options.engine = EngineChoice::spacetime;
  options.max_seconds = 20;
  const std::uint64_t before = work_spent();
  std::stringstream log;
  EXPECT_EQ(prove(scene, log, options).outcome, Outcome::free);
  EXPECT_LT(work_spent() - before, 3'000'000u);
  EXPECT_LT(log.str().size(), 2000u);
}

}  // namespace
}  // namespace taut
