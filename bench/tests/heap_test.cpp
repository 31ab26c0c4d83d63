// A question about prepared shapes takes memory for what it looks at, not for how large they are.
#include "heap.hpp"

#include <gtest/gtest.h>

#include "families.hpp"
#include "taut/shape.hpp"

namespace taut::bench {
namespace {

/// Bytes that a second question has at most at any time, beyond what there was before it.
std::size_t heap_of_far_approach(int vertices) {
  Case far = families().back().make(vertices);
  for (Body& body : far.scene.bodies) {
    body.prepared = prepare(body.polygon, body.name);
    body.polygon.clear();
  }
  CheckOptions options;
  options.engine = EngineChoice::spacetime;
  check(far.scene, options);  // what the shapes keep is made when first needed
  const std::size_t before = heap_use().live;
  reset_heap_peak();
  EXPECT_EQ(check(far.scene, options).outcome, Outcome::contact);
  return heap_use().peak - before;
}

TEST(Heap, OfAQuestionDoesNotGrowWithPreparedShapes) {
  ASSERT_STREQ(families().back().name, "far");
  const std::size_t small = heap_of_far_approach(256), large = heap_of_far_approach(8192);
  EXPECT_GT(small, 0U);
  EXPECT_LT(large, 2 * small + 16384) << "of small shapes: " << small;
}

}  // namespace
}  // namespace taut::bench
