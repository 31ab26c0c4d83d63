// An answer says what its log proves, wherever limits end a run: the verifier says the same of it.
#include <gtest/gtest.h>

#include <optional>
#include <sstream>
#include <string>

#include "support/effort.hpp"
#include "support/random_scenes.hpp"
#include "support/small_world.hpp"
#include "taut/proof.hpp"

namespace taut::testing {
namespace {

struct LimitedCounts {
  int decided = 0, undecided = 0;
};

/// The outcome and the time that the log proves; none if there is no log.
std::optional<Verified> verified_log(const Scene& scene, const std::string& log) {
  if (log.empty()) return std::nullopt;
  std::istringstream in(log);
  return verify(scene, in);
}

void expect_what_the_log_proves(const Scene& scene, EngineChoice engine, Touch touch, std::uint64_t events,
                                LimitedCounts& counts) {
  CheckOptions how;
  how.engine = engine;
  how.touch = touch;
  how.max_events = events;
  std::ostringstream log;
  const Answer answer = prove(scene, log, how);
  if (answer.outcome == Outcome::overlap_at_start || answer.outcome == Outcome::untested) return;
  const std::optional<Verified> verified =
      verified_log(scene, answer.outcome != Outcome::undecided || answer.free_until > scene.start ? log.str() : "");
  if (answer.outcome == Outcome::undecided) {
    ++counts.undecided;
    ASSERT_EQ(verified ? verified->free_until : scene.start, answer.free_until);
    if (verified) {
      ASSERT_EQ(verified->outcome, Outcome::undecided);
    }
    return;
  }
  ++counts.decided;
  ASSERT_TRUE(verified);
  ASSERT_EQ(verified->outcome, answer.outcome);
  if (!answer.contact) return;
  ASSERT_EQ(verified->contact->time.lo, answer.contact->time.lo);
  ASSERT_EQ(verified->contact->time.hi, answer.contact->time.hi);
  ASSERT_EQ(verified->free_until, answer.free_until);
  ASSERT_EQ(verified->contact->vertex, answer.contact->vertex);
  ASSERT_EQ(verified->contact->edge, answer.contact->edge);
}

TEST(UndecidedLogs, OfTwoBodiesProveTheAnswer) {
  LimitedCounts counts;
  for (const Family family : all_families) {
    for (std::uint64_t seed = 0; seed < effort(40); ++seed) {
      SCOPED_TRACE(std::string(to_string(family)) + " seed " + std::to_string(seed));
      SceneOptions options;
      options.grid = seed % 2 == 1;
      const Scene scene = random_scene(9700 + seed, family, options);
      for (const EngineChoice engine : {EngineChoice::kinetic, EngineChoice::both}) {
        for (const std::uint64_t events : {0, 1, 4}) {
          const Touch touch = seed % 3 == 2 ? Touch::closed : Touch::open;
          ASSERT_NO_FATAL_FAILURE(expect_what_the_log_proves(scene, engine, touch, events, counts));
        }
      }
    }
  }
  EXPECT_GT(counts.undecided, static_cast<int>(enough(100)));
  EXPECT_GT(counts.decided, static_cast<int>(enough(100)));
}

TEST(UndecidedLogs, OfWorldsProveTheAnswer) {
  LimitedCounts counts;
  for (std::uint64_t number = 1; number < 1 + effort(400); ++number) {
    SCOPED_TRACE("world " + std::to_string(number));
    const Scene scene = scene_of(small_world(number).world);
    for (const EngineChoice engine : {EngineChoice::kinetic, EngineChoice::both}) {
      for (const std::uint64_t events : {0, 2}) {
        ASSERT_NO_FATAL_FAILURE(expect_what_the_log_proves(scene, engine, Touch::open, events, counts));
      }
    }
  }
  EXPECT_GT(counts.undecided, static_cast<int>(enough(50)));
  EXPECT_GT(counts.decided, static_cast<int>(enough(100)));
}

/// Where one engine gives up, the other one has to search all windows of a pair before the answer is `free`.
TEST(UndecidedLogs, BothEnginesSayWhatOneSays) {
  for (std::uint64_t number = 1; number < 1 + effort(400); ++number) {
    SCOPED_TRACE("world " + std::to_string(number));
    const Scene scene = scene_of(small_world(number).world);
    CheckOptions limited, alone;
    limited.engine = EngineChoice::both;
    limited.max_events = number % 3;
    alone.engine = EngineChoice::spacetime;
    const Answer both = check(scene, limited), one = check(scene, alone);
    if (both.outcome == Outcome::undecided) continue;
    ASSERT_EQ(both.outcome, one.outcome);
  }
}

}  // namespace
}  // namespace taut::testing
