// A question about prepared shapes takes memory for what it looks at, not for how large they are.
#include "heap.hpp"

#include <gtest/gtest.h>

#include "families.hpp"
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

}  // namespace
}  // namespace taut::bench
