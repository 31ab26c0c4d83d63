// A question about prepared shapes takes memory for what it looks at, not for how large they are.
#include "heap.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdint>
#include <stdexcept>
#include <string>

#include "compare/cases.hpp"
#include "families.hpp"
#include "taut/io.hpp"
#include "taut/shape.hpp"

namespace taut::bench {
namespace {

/// Bytes that a second question has at most at any time, beyond what there was before it.
std::size_t heap_of_second(const Family& family, int vertices, EngineChoice engine) {
  Case asked = family.make(vertices);
  for (Body& body : asked.scene.bodies) {
    body.prepared = prepare(body.polygon, body.name);
    body.polygon.clear();
  }
  CheckOptions options;
  options.engine = engine;
  check(asked.scene, options);  // what the shapes keep is made when first needed
  const std::size_t before = heap_use().live;
  reset_heap_peak();
  EXPECT_EQ(check(asked.scene, options).outcome, asked.outcome);
  return heap_use().peak - before;
}

TEST(Heap, OfAQuestionDoesNotGrowWithPreparedShapes) {
  const Family& far = families().back();
  ASSERT_STREQ(far.name, "far");
  const std::size_t small = heap_of_second(far, 256, EngineChoice::spacetime);
  const std::size_t large = heap_of_second(far, 8192, EngineChoice::spacetime);
  EXPECT_GT(small, 0U);
  EXPECT_LT(large, 2 * small + 16384) << "of small shapes: " << small;
}

TEST(Heap, AThreadKeepsTheRoomForModelsOfMotions) {
  const Family& gears = families().front();
  ASSERT_STREQ(gears.name, "gears");
  // That room alone is as much.
  EXPECT_LT(heap_of_second(gears, 64, EngineChoice::kinetic), 600'000U);
}

Scene prepared(Scene scene) {
  for (Body& body : scene.bodies) {
    body.prepared = prepare(body.polygon, body.name);
    body.polygon.clear();
  }
  return scene;
}

Scene contest_scene(const std::string& family, int n) {
  for (const ContestFamily& f : contest_families()) {
    if (f.name == family) return f.make(n).scene;
  }
  throw std::runtime_error("no family " + family);
}

struct CostOfQuestions {
  std::uint64_t allocations = 0;
  long faults = 0;
};

/// Of so many questions, after a few others.
CostOfQuestions cost_of(const Scene& scene, EngineChoice engine, int times) {
  CheckOptions options;
  options.engine = engine;
  for (int k = 0; k < 5; ++k) check(scene, options);
  rusage before{}, after{};
  getrusage(RUSAGE_SELF, &before);
  const std::uint64_t allocations = heap_use().allocations;
  for (int k = 0; k < times; ++k) check(scene, options);
  getrusage(RUSAGE_SELF, &after);
  return {heap_use().allocations - allocations, after.ru_minflt - before.ru_minflt};
}

TEST(Heap, ASmallQuestionAllocatesLittle) {
  for (const char* family : {"octagons", "stars"}) {
    const Scene scene = prepared(contest_scene(family, 8));
    EXPECT_LE(cost_of(scene, EngineChoice::kinetic, 1).allocations, 75U) << family;
    EXPECT_LE(cost_of(scene, EngineChoice::spacetime, 1).allocations, 45U) << family;
    EXPECT_LE(cost_of(scene, EngineChoice::either, 1).allocations, 45U) << family;
  }
}

TEST(Heap, QuestionsThatComeAgainTakeNoPagesFromTheSystem) {
  for (const char* path : {"examples/lid.json", "examples/worlds/arm.json"}) {
    const Scene scene = read_scene(path);
    for (const EngineChoice engine : {EngineChoice::kinetic, EngineChoice::spacetime, EngineChoice::either}) {
      // What else the process does may take a page now and then.
      EXPECT_LT(cost_of(scene, engine, 100).faults, 50) << path << ", " << to_string(engine);
    }
  }
}

}  // namespace
}  // namespace taut::bench
