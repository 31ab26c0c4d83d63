// Whatever the scene, a limit ends the work soon: every long loop passes interruption points.
#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <functional>
#include <sstream>

#include "generators/generators.hpp"
#include "numeric/budget.hpp"
#include "solver/run.hpp"
#include "support/effort.hpp"
#include "support/tiling_run.hpp"
#include "taut/check.hpp"
#include "taut/error.hpp"
#include "taut/proof.hpp"
#include "taut/separator.hpp"
#include "taut/simulation.hpp"
#include "taut/validate.hpp"

namespace taut {
using namespace internal;
namespace {

/// Of the work, and of the processor time that it may take until it has stopped: another program may slow it down, and
/// what is made of a scene before anything long begins is linear in its size.
constexpr double limit_seconds = 0.02, soon_seconds = 1.5;

double processor_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void expect_soon(const char* what, const std::function<void()>& work) {
  const double start = processor_seconds();
  try {
    const Budget scope(Limits{limit_seconds});
    work();
  } catch (const Interrupted&) {
  } catch (const InputError& error) {
    ADD_FAILURE() << what << ": " << error.what();
  } catch (const ProofError&) {
  } catch (const UndecidedError&) {
  }
  const double factor = testing::watched ? 10 : 1;
  EXPECT_LT(processor_seconds() - start, factor * soon_seconds) << what;
}

const Polygon small_square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

Scene with_motion(Motion motion, double start, double end) {
  Scene scene;
  scene.bodies = {{"p", small_square, {}}, {"q", small_square, std::move(motion)}};
  scene.start = start;
  scene.end = end;
  return scene;
}

Scene turning(Rotation rotation, double start, double end) {
  return with_motion({{{{100}, {}, std::move(rotation)}}}, start, end);
}

/// Of degree 16: 1 or -1 at 17 instants of [-1, 1].
const Coefficients chebyshev{1, 0, -128, 0, 2688, 0, -21504, 0, 84480, 0, -180224, 0, 212992, 0, -131072, 0, 32768};

/// Each piece is searched for a cosine beyond 1, at high precision.
Scene many_cosines() {
  Motion motion;
  for (int i = 1; i <= 1000; ++i) motion.pieces.push_back({{100}, {}, CosineRotation{chebyshev}, 0.9 * i / 1000});
  motion.pieces.back().until = INFINITY;
  return with_motion(std::move(motion), -0.9, 0.9);
}

/// A root of multiplicity 8, nearly.
Scene direction_that_nearly_vanishes() {
  Coefficients root{256, 0, -1024, 0, 1792, 0, -1792, 0, 1120, 0, -448, 0, 112, 0, -16, 0, 1}, moved = root;
  moved[1] = 1e-30;
  return turning(DirectionRotation{root, moved}, 0, 2);
}

Scene many_pieces() {
  Motion motion;
  for (int i = 1; i <= 20000; ++i)
    motion.pieces.push_back({{5.0}, {(i % 7) * 1e-7}, NoRotation{}, static_cast<double>(i)});
  return with_motion(std::move(motion), 0, 20000);
}

/// Both sides of the way into a cavity are long convex chains, of n edges, and the other body stands beside the way:
/// the bridge at the start goes from lip to lip.
Scene cavity_of(int n) {
  const double gap = 1.616, deep = 12.43, shift = 4.03;
  Polygon p;
  const auto add_side = [&](double side, int k) {
    const double a = (80 - 160.0 * k / n) * 3.14159265358979 / 180;
    p.push_back({side * (gap + 10 - 10 * std::cos(a)), 10 * std::sin(a) + side * shift});
  };
  for (int k = 0; k <= n; ++k) add_side(-1, k);
  const double x = p.back().x, low = p.back().y - 1;
  p.insert(p.end(), {{x - deep, low}, {x - deep, low - 8}, {deep - x, low - 8}, {deep - x, low}});
  for (int k = n; k >= 0; --k) add_side(1, k);
  p.insert(p.end(), {{60, 40}, {60, -60}, {-60, -60}, {-60, 40}});
  Scene scene = with_motion({{{{0}, {0, 0.1}, AngleRotation{{0, 1e-3}}}}}, 0, 1);
  scene.bodies[0].polygon = p;
  scene.bodies[1].polygon.clear();
  for (const double a : {0.3, 2.394, 4.489})
    scene.bodies[1].polygon.push_back({10.08 + 4 * std::cos(a), -10.2 + 4 * std::sin(a)});
  return scene;
}
Scene cavity() { return cavity_of(100000); }

/// The start and the question pass some ten thousand points: the bridge is looked for along the chains, not among
/// pairs of their vertices, of which there are 16 million.
TEST(InterruptionOfTheBridge, IsNotNeededWithinALittleWork) {
  const Scene scene = cavity_of(4000);
  const Budget scope(std::uint64_t{200000});
  EXPECT_NO_THROW(testing::TilingRun{scene});
}

struct Hostile {
  const char* name;
  Scene (*make)();
};

Scene spiral() {
  gen::SpiralOptions options;
  options.side_points = 30000;
  options.turns = 100;
  return gen::make_spiral(options);
}
Scene maze() {
  gen::MazeOptions options;
  options.passes = 20000;
  return gen::make_maze(options);
}
Scene gears() {
  gen::GearOptions options;
  options.flank_points = 400;
  options.turns = 1000;
  return gen::make_gears(options);
}
Scene rotor() {
  gen::RotorOptions options;
  options.teeth = 3000;
  options.chain_edges = 6000;
  options.turns = 100;
  return gen::make_rotor(options);
}

std::vector<Hostile> hostile_scenes() {
  return {{"a cosine that reaches 1 within",
           [] {
             return turning(CosineRotation{{-9999, 200, -1}}, 100, 101);
           }},
          {"a cosine that reaches 1 all over", [] { return turning(CosineRotation{chebyshev}, -1, 1); }},
          {"many cosines", many_cosines},
          {"a direction that turns at once",
           [] {
             return turning(DirectionRotation{{0, 1}, {1e-15}}, -1, 1);
           }},
          {"a direction that turns faster",
           [] {
             return turning(DirectionRotation{{0, 1}, {1e-100}}, -1, 1);
           }},
          {"a direction that nearly vanishes", direction_that_nearly_vanishes},
          {"many turns",
           [] {
             return turning(AngleRotation{{0, 1e9}}, 0, 1);
           }},
          {"a long time",
           [] {
             return turning(AngleRotation{{0, 1}}, -1e15, 1e15);
           }},
          {"high degree",
           [] {
             return turning(AngleRotation{{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16}}, -3, 3);
           }},
          {"many pieces", many_pieces},
          {"a cavity", cavity},
          {"a spiral", spiral},
          {"a maze", maze},
          {"gears", gears},
          {"a rotor", rotor}};
}

class Interruption : public ::testing::TestWithParam<Hostile> {
 protected:
  const Scene& scene() const { return scene_; }

 private:
  const Scene scene_ = GetParam().make();
};

TEST_P(Interruption, OfValidation) {
  expect_soon("validate", [&] { validate(scene()); });
}

TEST_P(Interruption, OfTheEngines) {
  for (const EngineChoice engine : {EngineChoice::kinetic, EngineChoice::spacetime, EngineChoice::either}) {
    for (const Touch touch : {Touch::open, Touch::closed}) {
      CheckOptions options;
      options.engine = engine;
      options.touch = touch;
      expect_soon(to_string(engine), [&] { check(scene(), options); });
    }
  }
}

TEST_P(Interruption, ByAFlag) {
  const std::atomic<bool> stop{true};
  CheckOptions options;
  options.limits.stop = &stop;
  const double start = processor_seconds();
  for (const EngineChoice engine : {EngineChoice::kinetic, EngineChoice::spacetime}) {
    options.engine = engine;
    check(scene(), options);
  }
  const double factor = testing::watched ? 10 : 1;
  EXPECT_LT(processor_seconds() - start, factor * soon_seconds);
}

TEST_P(Interruption, OfSimulations) {
  expect_soon("advance_to", [&] { Simulation(scene()).advance_to(scene().end); });
}

TEST_P(Interruption, OfSeparators) {
  expect_soon("separator", [&] { separator(scene(), scene().start); });
}

TEST_P(Interruption, OfProofs) {
  CheckOptions options;
  options.limits.max_seconds = 0.5;
  std::ostringstream log;
  const double start = processor_seconds();
  prove(scene(), log, options);
  // One limit for all of it: the engines, one after the other, and the log.
  const double factor = testing::watched ? 10 : 1;
  EXPECT_LT(processor_seconds() - start, options.limits.max_seconds + factor * soon_seconds);
  const std::string text = log.str();
  expect_soon("verify", [&] {
    std::istringstream in(text);
    verify(scene(), in);
  });
}

/// A limit that is reached before any search makes an answer, too. It had been thrown through.
TEST(InterruptionOfBothEngines, BeforeAnySearch) {
  for (const Hostile& hostile : hostile_scenes()) {
    if (std::string(hostile.name) != "a cavity") continue;
    const Scene scene = hostile.make();
    const Budget past(Limits{0});
    const Answer answer = run_engines(scene, {});
    EXPECT_EQ(answer.outcome, Outcome::undecided);
    EXPECT_EQ(answer.reason, "the time limit was reached");
    EXPECT_EQ(answer.free_until, scene.start);
  }
}

INSTANTIATE_TEST_SUITE_P(Hostile, Interruption, ::testing::ValuesIn(hostile_scenes()), [](const auto& given) {
  std::string name = given.param.name;
  for (char& c : name) c = c == ' ' ? '_' : c;
  return name;
});

}  // namespace
}  // namespace taut
