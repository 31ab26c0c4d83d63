// Bodies that slide along each other, by the spacetime engine: right, and without a look at all pairs of edges.
#include <gtest/gtest.h>

#include "numeric/budget.hpp"
#include "taut/check.hpp"

namespace taut::testing {
using namespace internal;
namespace {

/// A bar with so many teeth that are flat at the top, turned so that the teeth look along (-4, 3); `up` is 1 for teeth
/// that look that way and -1 for the other body. Coordinates are integers. Tooth number `higher` is higher by `by`.
Polygon flat_teeth(int teeth, int up, int higher, double by) {
  Polygon p;
  const auto add = [&p](double along, double across) { p.push_back({3 * along - 4 * across, 4 * along + 3 * across}); };
  for (int i = 0; i < teeth; ++i) {
    const double top = i == higher ? up * by : 0;
    add(8 * i, top);
    add(8 * i + 4, top);
    add(8 * i + 5, -up * 8);
    add(8 * i + 7, -up * 8);
  }
  add(8 * teeth, -up * 40);
  add(0, -up * 40);
  if (up > 0) return {p.rbegin(), p.rend()};
  return p;
}

/// Q slides along the direction (3, 4), `gap` from P.
Scene flat_teeth_scene(int teeth, double gap, int higher, double by) {
  Scene scene;
  scene.start = 0;
  scene.end = 10;
  MotionPiece way;
  way.x = {-4 * gap - 120, 24};
  way.y = {3 * gap - 160, 32};
  scene.bodies = {{"P", flat_teeth(teeth, 1, higher, by), {}}, {"Q", flat_teeth(teeth, -1, -1, 0), {{way}}}};
  return scene;
}

Answer answer_of(const Scene& scene, EngineChoice engine, std::uint64_t& work) {
  CheckOptions options;
  options.engine = engine;
  const std::uint64_t before = work_spent();
  Answer answer = check(scene, options);
  work = work_spent() - before;
  return answer;
}

/// Pair by pair of edges it would be some 17,000 units a tooth, as each meets ten others on the way.
TEST(FlatSides, FacesThatSlideInTouchAreNotAMatterOfAllPairsOfEdges) {
  for (const int teeth : {32, 64, 128}) {
    for (const double gap : {0.0, 0x1p-45}) {
      std::uint64_t work = 0;
      EXPECT_EQ(answer_of(flat_teeth_scene(teeth, gap, -1, 0), EngineChoice::spacetime, work).outcome, Outcome::free);
      EXPECT_LE(work, 600u * static_cast<unsigned>(teeth)) << teeth << " teeth, " << gap << " apart";
    }
  }
}

TEST(FlatSides, AToothThatIsTheLeastHigherIsFound) {
  for (const double by : {0x1p-30, 0x1p-38, 0x1p-3}) {
    for (const int higher : {0, 7, 15}) {
      const Scene scene = flat_teeth_scene(16, 0, higher, by);
      std::uint64_t work = 0;
      const Answer kinetic = answer_of(scene, EngineChoice::kinetic, work);
      const Answer spacetime = answer_of(scene, EngineChoice::spacetime, work);
      ASSERT_EQ(kinetic.outcome, spacetime.outcome) << higher << " " << by;
      ASSERT_EQ(kinetic.contact.has_value(), spacetime.contact.has_value());
      if (!kinetic.contact) continue;
      EXPECT_LE(kinetic.contact->time.lo, spacetime.contact->time.hi);
      EXPECT_LE(spacetime.contact->time.lo, kinetic.contact->time.hi);
    }
  }
  // A gap that is wider than the tooth is high.
  std::uint64_t work = 0;
  EXPECT_EQ(answer_of(flat_teeth_scene(16, 0x1p-29, 7, 0x1p-30), EngineChoice::spacetime, work).outcome, Outcome::free);
  EXPECT_NE(answer_of(flat_teeth_scene(16, 0x1p-31, 7, 0x1p-30), EngineChoice::spacetime, work).outcome, Outcome::free);
}

}  // namespace
}  // namespace taut::testing
