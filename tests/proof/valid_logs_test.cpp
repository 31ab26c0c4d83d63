// What prove() writes, verify() accepts, and it proves what check() says.
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "generators/generators.hpp"
#include "log_text.hpp"
#include "support/effort.hpp"
#include "support/random_scenes.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut::testing {
namespace {

struct Counts {
  int free = 0, contact = 0, at_start = 0;
  std::uint64_t events = 0, bytes = 0;
};

void expect_proved(const Scene& scene, Touch touch, Counts& counts) {
  const Proved proved = prove_in_memory(scene, touch);
  const Answer& answer = proved.answer;
  if (answer.outcome == Outcome::overlap_at_start) return;
  std::istringstream in(proved.log);
  const Verified v = verify(scene, in);
  ASSERT_EQ(v.outcome, answer.outcome);
  ASSERT_EQ(v.touch, touch);
  ASSERT_EQ(v.events, answer.events);
  ASSERT_EQ(v.fingerprint, scene_fingerprint(scene, touch));
  counts.events += v.events;
  if (v.outcome == Outcome::free) {
    ++counts.free;
    ASSERT_EQ(v.free_until, scene.end);
    return;
  }
  ++(v.contact->time.hi == scene.start ? counts.at_start : counts.contact);
  ASSERT_EQ(v.contact->time.lo, answer.contact->time.lo);
  ASSERT_EQ(v.contact->time.hi, answer.contact->time.hi);
  ASSERT_EQ(v.free_until, answer.free_until);
  if (v.contact->time.hi == scene.start) return;
  ASSERT_EQ(v.contact->vertex.body, answer.contact->vertex.body);
  ASSERT_EQ(v.contact->vertex.index, answer.contact->vertex.index);
  ASSERT_EQ(v.contact->edge.index, answer.contact->edge.index);
}

void expect_folder_proved(const std::filesystem::path& folder, Counts& counts) {
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".json" || entry.path().stem().extension() == ".answer") continue;
    SCOPED_TRACE(entry.path().string());
    const Scene scene = read_scene(entry.path().string());
    for (const Touch touch : {Touch::open, Touch::closed}) {
      ASSERT_NO_FATAL_FAILURE(expect_proved(scene, touch, counts));
    }
  }
}

TEST(ValidLogs, Examples) {
  Counts counts;
  expect_folder_proved("examples", counts);
  EXPECT_GT(counts.free + counts.contact, 20);
}

TEST(ValidLogs, Corpus) {
  Counts counts;
  expect_folder_proved("tests/corpus", counts);
}

TEST(ValidLogs, CertifiedScenes) {
  if (!std::filesystem::exists("../shared/scenes")) {
    GTEST_SKIP() << "the scenes with certified answers are not here (../shared/scenes)";
  }
  Counts counts;
  expect_folder_proved("../shared/scenes", counts);
  EXPECT_GE(counts.free + counts.contact + counts.at_start, 300);
  EXPECT_GT(counts.at_start, 10);
}

TEST(ValidLogs, RandomScenes) {
  Counts counts;
  for (const bool grid : {false, true}) {
    SceneOptions options;
    options.grid = grid;
    for (const Family family : all_families) {
      for (std::uint64_t seed = 0; seed < effort(60); ++seed) {
        SCOPED_TRACE(std::string(to_string(family)) + " seed " + std::to_string(seed) + (grid ? " grid" : ""));
        const Scene scene = random_scene(9000 + seed, family, options);
        ASSERT_NO_FATAL_FAILURE(expect_proved(scene, seed % 3 == 2 ? Touch::closed : Touch::open, counts));
      }
    }
  }
  EXPECT_GT(counts.free, static_cast<int>(enough(200)));
  EXPECT_GT(counts.contact, static_cast<int>(enough(200)));
}

/// 13 bytes an event, and nothing else that grows.
TEST(ValidLogs, AreShort) {
  const Scene scene = gen::make_rotor({});
  const Proved proved = prove_in_memory(scene, Touch::open);
  const auto vertices = scene.bodies[0].polygon.size() + scene.bodies[1].polygon.size();
  EXPECT_LE(proved.log.size(), 40 * proved.answer.events);
  EXPECT_LE(proved.log.size(), 13 * proved.answer.events + 80 * vertices + 200);
}

TEST(ValidLogs, AnInterruptedRunProvesWhatItHasDone) {
  gen::GearOptions gears;
  gears.hit = true;
  const Scene scene = gen::make_gears(gears);
  const Answer whole = prove_in_memory(scene, Touch::open).answer;
  double before = scene.start;
  for (std::uint64_t events = 0; events < whole.events; events += 7) {
    const Proved part = prove_in_memory(scene, Touch::open, events);
    std::istringstream in(part.log);
    const Verified v = verify(scene, in);
    ASSERT_EQ(v.outcome, Outcome::undecided);
    ASSERT_EQ(v.events, events);
    // The verifier's own enclosure of the last event may begin a little earlier.
    ASSERT_LE(v.free_until, part.answer.free_until);
    ASSERT_GE(v.free_until, part.answer.free_until - 1e-9);
    ASSERT_GE(v.free_until, before - 1e-9);
    before = v.free_until;
  }
  EXPECT_LE(before, whole.contact->time.hi);
}

TEST(ValidLogs, AnotherVersionIsRefusedWithAdvice) {
  const Scene scene = read_scene("examples/lid.json");
  std::string log = prove_in_memory(scene, Touch::open).log;
  log[7] = '1';
  std::istringstream in(log);
  try {
    verify(scene, in);
    FAIL() << "a log of version 1 was accepted";
  } catch (const ProofError& error) {
    EXPECT_NE(std::string(error.what()).find("prove again"), std::string::npos) << error.what();
  }
}

class EventCounter final : public Tracer {
 public:
  void on_event(const TraceEvent& event) override { numbers.push_back(event.number); }
  std::vector<std::uint64_t> numbers;
};

/// Whoever traces a run that is proved sees all of its events. A tracer had been forgotten there.
TEST(ValidLogs, AreTracedWhileTheyAreWritten) {
  const Scene scene = gen::make_gears({});
  EventCounter tracer;
  CheckOptions options;
  options.engine = EngineChoice::kinetic;
  options.tracer = &tracer;
  std::ostringstream log;
  const Answer answer = prove(scene, log, options);
  ASSERT_EQ(answer.outcome, Outcome::free);
  ASSERT_GT(answer.events, 100u);
  ASSERT_EQ(tracer.numbers.size(), answer.events);
  EXPECT_EQ(tracer.numbers.back(), answer.events);
  Scene three = scene;
  three.bodies.push_back({"third", {{90, 0}, {91, 0}, {90, 1}}, {}});
  EXPECT_THROW(prove(three, log, options), InputError);
}

}  // namespace
}  // namespace taut::testing
