// Which stages tell what: counted by the same struct in both engines.
#include <gtest/gtest.h>

#include "certificate/precise_triple.hpp"
#include "numeric/stages.hpp"
#include "scene/body_pair.hpp"
#include "support/tiling_run.hpp"
#include "taut/check.hpp"
#include "taut/io.hpp"

namespace taut::testing {
using namespace internal;
namespace {

/// A square that passes above another one, so far above it.
Scene passing(const std::string& height) {
  return parse_scene(R"({"format":"taut-scene/1","time":[0,4],"bodies":[
    {"name":"floor","polygon":[[0,0],[8,0],[8,1],[0,1]]},
    {"name":"box","polygon":[[-3,0],[-2,0],[-2,1],[-3,1]],"motion":{"x":[0,3],"y":[)" +
                     height + "]}}]}");
}

StageCounts stages_of(const Scene& scene, Touch touch) {
  testing::TilingRun run(scene, touch);
  while (!run.finished()) run.step(scene.end);
  return run.engine().stages();
}

TEST(StageCounts, DoublesDoWhereNothingIsInLine) {
  const Scene scene = parse_scene(R"({"format":"taut-scene/1","time":[0,4],"bodies":[
    {"name":"floor","polygon":[[0,0],[8.1,0.3],[7.2,1.1],[0.5,0.8]]},
    {"name":"box","polygon":[[-3,0.1],[-2,-0.05],[-2.3,1.2]],"motion":{"x":[0,3],"y":[2.5,0.07]}}]})");
  const StageCounts far = stages_of(scene, Touch::open);
  EXPECT_GT(far[Stage::doubles], 0u);
  EXPECT_EQ(far.beyond_doubles(), 0u);
}

TEST(StageCounts, TheDisplacementTellsWhereBodiesSlide) {
  EXPECT_GT(stages_of(passing("1"), Touch::open).beyond_doubles(), 0u);
}

/// At an infinite speed doubles have the displacement in them, and may tell by that alone: each engine asks again.
TEST(StageCounts, EachEngineSaysThatBodiesTouchAtAnInfiniteSpeed) {
  const Scene scene = read_scene("tests/corpus/touches_at_an_infinite_speed.json");
  for (const EngineChoice engine : {EngineChoice::kinetic, EngineChoice::spacetime, EngineChoice::either}) {
    CheckOptions options;
    options.engine = engine;
    const Answer answer = check(scene, options);
    EXPECT_EQ(answer.outcome, Outcome::free);
    ASSERT_TRUE(answer.touching) << to_string(engine);
    EXPECT_NEAR(answer.touching->time.hi, 1, 1e-12);
  }
}

TEST(StageCounts, APrecisionThatTellsIsCountedAsItself) {
  const Scene scene = passing("1");
  const BodyPair bodies = pair_of(scene);
  const PairGeometry geometry = displaced_pair(bodies, Offset::inward);
  MotionSegment segment = MotionSegment::motion(bodies.motions[0][0][0], bodies.motions[1][0][0], 0, 4);
  FrameMemory memory;
  memory.reset(segment);
  const PreciseTriple function(
      segment, geometry, CertificateFunction::of(geometry, VertexId(0u), VertexId(1u), VertexId(geometry.np)), &memory);
  EXPECT_NE(function.sign_at(PreciseTime::between(1, 1), Stage::precise), 0);
  EXPECT_EQ(memory.stages[Stage::exact], 1u);
  const RealMax one = 1.0;
  EXPECT_NE(function.sign_at(PreciseTime(one, one, stage_of_precision(1)), stage_of_precision(1)), 0);
  EXPECT_EQ(memory.stages[stage_of_precision(1)], 1u);
  EXPECT_EQ(memory.stages.beyond_doubles(), 2u);
}

TEST(StageCounts, CountsAdd) {
  StageCounts a, b;
  a.add(Stage::fixed);
  b.add(Stage::fixed);
  b.add(Stage::doubles);
  a += b;
  EXPECT_EQ(a[Stage::fixed], 2u);
  EXPECT_EQ(a[Stage::doubles], 1u);
  EXPECT_EQ(a.beyond_doubles(), 2u);
}

}  // namespace
}  // namespace taut::testing
