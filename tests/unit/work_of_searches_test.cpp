// What searches near contacts of high order cost: work is the same on every machine.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <sstream>
#include <string>

#include "numeric/budget.hpp"
#include "solver/portfolio_solver.hpp"
#include "taut/check.hpp"
#include "taut/intervals.hpp"
#include "taut/io.hpp"
#include "taut/proof.hpp"

namespace taut {
using namespace internal;
namespace {

/// The larger one of both ways of touching.
std::uint64_t work_of(const Scene& scene, EngineChoice engine) {
  std::uint64_t most = 0;
  for (const Touch touch : {Touch::open, Touch::closed}) {
    CheckOptions options;
    options.engine = engine;
    options.touch = touch;
    options.limits.max_seconds = 20;
    const std::uint64_t before = work_spent();
    EXPECT_NE(check(scene, options).outcome, Outcome::undecided);
    most = std::max(most, work_spent() - before);
  }
  return most;
}

struct Limits {
  const char* scene;
  std::uint64_t kinetic, spacetime;
};
class WorkOfSearches : public ::testing::TestWithParam<Limits> {};

TEST_P(WorkOfSearches, IsWithinLimits) {
  const Scene scene = read_scene(std::string("tests/corpus/") + GetParam().scene + ".json");
  EXPECT_LT(work_of(scene, EngineChoice::kinetic), GetParam().kinetic);
  EXPECT_LT(work_of(scene, EngineChoice::spacetime), GetParam().spacetime);
}

INSTANTIATE_TEST_SUITE_P(
    Hard, WorkOfSearches,
    ::testing::Values(
        // 1.2 thousand million where the sign that a Taylor polynomial's last term hides is looked for in shorter and
        // shorter stretches by the same polynomial.
        Limits{"contact_of_order_six_beside_an_infinite_speed", 2'000'000, 4'000'000},
        // 550,000 where steps in doubles are left only when they are far shorter.
        Limits{"needles_that_pass_in_order_six", 100'000, 300'000},
        // Without the cuts where it touches 1, 48 seconds.
        Limits{"cosine_that_touches_one_between_doubles", 20'000'000, 2'000'000},
        // Bounded in powers of the time itself, the cosine leaves stretches as short as the square of their distance
        // from that instant.
        Limits{"cosine_that_nearly_reaches_one", 1'000'000, 200'000},
        // A search for the first root in ever shorter stretches, from where a bend alone tells.
        Limits{"corners_that_leave_along_edges", 30'000, 30'000},
        // Halved down to where the displacement tells, each of many searches takes 160 steps.
        Limits{"touches_of_many_corners_at_one_instant", 60'000, 120'000},
        // Polynomials that reach beyond the places, in the complex plane, at which the motion is singular tell nothing.
        Limits{"ties_beside_a_cosine_that_nearly_reaches_one", 300'000, 2'000'000},
        // Two roots beside a turn, refined in 960 bits: 6,800 by the kinetic engine.
        Limits{"needle_that_turns_on_its_tip", 3'000, 20'000}),
    [](const auto& test) { return std::string(test.param.scene); });

std::uint64_t work_in_slices(const Scene& scene, EngineChoice engine, std::uint64_t first) {
  const std::uint64_t before = work_spent();
  const Instance instance(scene);
  EventBudget budget(UINT64_MAX);
  const auto solver = pair_solver({engine}, instance, 0, 1, Offset::inward, budget);
  for (std::uint64_t effort = first; !solver->work(scene.start, scene.end, effort);) effort += effort / 8;
  return work_spent() - before;
}

/// In slices, as two engines share a question, it costs little more: what a slice ends is gone on with.
TEST(SearchesInSlices, AreNotDoneAnewInEach) {
  for (const char* name : {"touches_of_many_corners_at_one_instant", "six_fold_tangency", "slivers_touch_and_part",
                           "needles_that_pass_in_order_six", "fourth_order_touch_while_turning"}) {
    const Scene scene = read_scene(std::string("tests/corpus/") + name + ".json");
    for (const EngineChoice engine : {EngineChoice::kinetic, EngineChoice::spacetime}) {
      const std::uint64_t at_once = work_in_slices(scene, engine, UINT64_MAX);
      EXPECT_LT(work_in_slices(scene, engine, 640), at_once + at_once / 2 + 2000) << name << " " << to_string(engine);
    }
  }
}

/// Halved as long as margins are more than doubles round elsewhere, windows end a unit in the last place long.
TEST(WorkOfALog, BesideACosineThatNearlyReachesOne) {
  const Scene scene = read_scene("tests/corpus/ties_beside_a_cosine_that_nearly_reaches_one.json");
  CheckOptions options;
  options.engine = EngineChoice::spacetime;
  options.limits.max_seconds = 20;
  const std::uint64_t before = work_spent();
  std::stringstream log;
  EXPECT_EQ(prove(scene, log, options).outcome, Outcome::free);
  EXPECT_LT(work_spent() - before, 3'000'000u);
  EXPECT_LT(log.str().size(), 2000u);
}

/// Polygons along curves become finer around the ends of overlaps. 750,000 where they are asked each time about a
/// window in which they also overlap, and where instants of crossings in there are narrowed down.
TEST(WorkOfIntervals, OfTwoDiscs) {
  const std::string disc = R"({"path":"M0.5 0 A0.5 0.5 0 0 1 -0.5 0 A0.5 0.5 0 0 1 0.5 0 Z"})";
  const Scene scene = parse_scene(R"({"format":"taut-scene/1","time":[0,8],"bodies":[{"name":"a","polygon":)" + disc +
                                  R"(},{"name":"b","polygon":)" + disc + R"(,"motion":{"keyframes":[
      {"t":0,"x":2,"y":0.125},{"t":2,"x":-2,"y":0.25},{"t":4,"x":2,"y":0.25},{"t":6,"x":0.25,"y":-2},
      {"t":8,"x":0.25,"y":2}]}}]})");
  const std::uint64_t before = work_spent();
  EXPECT_EQ(intervals(scene).intervals.size(), 3u);
  EXPECT_LT(work_spent() - before, 400'000u);
}

}  // namespace
}  // namespace taut
