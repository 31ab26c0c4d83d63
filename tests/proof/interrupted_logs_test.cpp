// Proofs of runs that are stopped anywhere: they prove what was done, and nothing in them is half done.
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "generators/generators.hpp"
#include "taut/proof.hpp"

namespace taut {
namespace {

void expect_valid(const Scene& scene, const Answer& answer, const std::string& log) {
  ASSERT_EQ(answer.outcome, Outcome::undecided);
  if (!(answer.free_until > scene.start)) return;
  std::istringstream in(log);
  const Verified verified = verify(scene, in);
  EXPECT_EQ(verified.outcome, Outcome::undecided);
  EXPECT_EQ(verified.free_until, answer.free_until);
}

// The clock may end a run in the middle of an event's record, whose instant is refined while it is written. That
// happened in one of ten runs of this scene.
TEST(InterruptedLogs, OfTilingsAreValid) {
  gen::RotorOptions options;
  options.teeth = 2000;
  options.chain_edges = 3992;
  const Scene scene = gen::make_rotor(options);
  for (int k = 0; k < 25; ++k) {
    CheckOptions how;
    how.engine = EngineChoice::kinetic;
    how.limits.max_seconds = 0.05 + 0.004 * k;
    std::ostringstream log;
    const Answer answer = prove(scene, log, how);
    ASSERT_NO_FATAL_FAILURE(expect_valid(scene, answer, log.str()));
  }
}

}  // namespace
}  // namespace taut
