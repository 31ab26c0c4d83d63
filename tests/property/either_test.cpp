// Both engines in turn, beside each engine alone: in work, which is counted, and so the same on every machine. How well
// the count tells time is what `./dev cliffs` prints.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/budget.hpp"
#include "check/run.hpp"
#include "search/portfolio_solver.hpp"
#include "soak/soak_scene.hpp"
#include "support/effort.hpp"
#include "support/made_world.hpp"
#include "support/rng.hpp"
#include "support/same_answer.hpp"
#include "taut/check.hpp"
#include "taut/error.hpp"
#include "taut/shape.hpp"

namespace taut::testing {
using namespace internal;
namespace {

struct Worked {
  Answer answer;
  double work = 0;
};

Worked work_of(const SoakScene& s, EngineChoice engine) {
  CheckOptions options;
  options.engine = engine;
  options.touch = s.touch;
  options.tell_touching = false;
  const std::uint64_t before = work_spent();
  Worked w;
  w.answer = check(s.scene, options);
  w.work = static_cast<double>(work_spent() - before);
  return w;
}

void expect_like(const Answer& a, const Answer& b) {
  ASSERT_EQ(a.outcome, b.outcome);
  if (!a.contact) return;
  EXPECT_LE(a.contact->time.lo, b.contact->time.hi);
  EXPECT_LE(b.contact->time.lo, a.contact->time.hi);
}

TEST(Either, CostsLittleMoreThanTheBetterEngine) {
  const std::uint64_t count = effort(1500);
  std::uint64_t asked = 0, steep = 0;
  double all = 0, better_all = 0;
  for (std::uint64_t number = 0; number < count; ++number) {
    const SoakScene s = number % 2 == 0 ? soak_contact_scene(number) : soak_scene(number);
    const std::size_t vertices = s.scene.bodies[0].polygon.size() + s.scene.bodies[1].polygon.size();
    if (vertices > 300) continue;
    try {
      const Worked kinetic = work_of(s, EngineChoice::kinetic), spacetime = work_of(s, EngineChoice::spacetime);
      const Worked both = work_of(s, EngineChoice::either);
      expect_like(both.answer, kinetic.answer);
      expect_like(both.answer, spacetime.answer);
      // What each begins with is spent before there are turns.
      const double better = std::min(kinetic.work, spacetime.work) + 1000 + 20 * static_cast<double>(vertices);
      ++asked;
      all += both.work;
      better_all += better;
      steep += both.work > 2.5 * better;
      EXPECT_LE(both.work, kinetic.work + spacetime.work + 1.5 * better) << "scene " << number;
    } catch (const InputError&) {
      // Some injections spoil a scene.
    }
  }
  EXPECT_GT(asked, count / 2);
  EXPECT_LT(static_cast<double>(steep), 0.05 * static_cast<double>(asked));
  EXPECT_LT(all, 2 * better_all);
}

/// By turns of which each is longer than the one before, and the first ones far too short for anything.
Answer by_turns(Run& run, std::uint64_t turn) {
  int turns = 0;
  while (!run.work(turn)) {
    if (++turns > 400) {
      ADD_FAILURE() << "no end after " << turns << " turns";
      break;
    }
    turn += turn / 8 + 1;
  }
  return run.answer();
}

/// A run that is left in the middle of whatever it was at, and taken up again, comes to the same end by the same events
/// as one that is not.
TEST(Either, ShortTurnsComeToTheSameEnd) {
  for (std::uint64_t number = 0; number < effort(250); ++number) {
    const SoakScene s = number % 3 == 0 ? soak_scene(number) : soak_contact_scene(number);
    CheckOptions options;
    options.touch = s.touch;
    options.tell_touching = false;
    SCOPED_TRACE("scene " + std::to_string(number));
    const std::uint64_t first_turn = 1 + number % 97;
    try {
      expect_same_answer(by_turns(*begin_spacetime(s.scene, options), first_turn), run_spacetime(s.scene, options));
      expect_same_answer(by_turns(*begin_kinetic(s.scene, options), first_turn), run_kinetic(s.scene, options));
    } catch (const InputError&) {
      // Some injections spoil a scene.
    }
  }
}

/// Who is first, and what it says, does not depend on what was prepared beforehand, or made for an earlier question.
TEST(Either, AnswersDoNotDependOnWhatIsKept) {
  std::uint64_t by_kinetic = 0, by_spacetime = 0;
  for (std::uint64_t number = 0; number < effort(600); ++number) {
    const SoakScene bare = number % 3 == 0 ? soak_scene(number) : soak_contact_scene(number);
    SoakScene kept = bare;
    SCOPED_TRACE("scene " + std::to_string(number));
    try {
      for (Body& body : kept.scene.bodies) body.prepared = prepare(std::exchange(body.polygon, {}), body.name);
      const Worked expected = work_of(bare, EngineChoice::either);
      // Bare shapes; prepared ones for the first time; those that have all that either engine makes of them.
      for (const bool known : {false, true}) {
        if (known) check(kept.scene, CheckOptions{.touch = bare.touch, .engine = EngineChoice::both});
        const Worked found = work_of(kept, EngineChoice::either);
        expect_same_answer(found.answer, expected.answer);
        EXPECT_EQ(found.answer.engine, expected.answer.engine);
        EXPECT_EQ(found.work, expected.work);
      }
      ++(expected.answer.engine == EngineName::kinetic ? by_kinetic : by_spacetime);
    } catch (const InputError&) {
      // Some injections spoil a scene.
    }
  }
  EXPECT_GT(by_kinetic, enough(20));
  EXPECT_GT(by_spacetime, enough(20));
}

/// What windows bring is added up, whichever engine decides each. Turns begin early here, so that each of the two
/// decides many.
TEST(Either, AddsUpWindowsThatEitherEngineDecides) {
  int contacts = 0, by_kinetic = 0;
  for (std::uint64_t seed = 0; seed < effort(400); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const Scene scene = scene_of(random_world(seed));
    const WorldPlan plan(scene);
    EventBudget budget(UINT64_MAX);
    const bool inwards = seed % 2 == 0;
    const auto alone = windowed_pair(EngineChoice::spacetime, plan, 0, 1, inwards, budget),
               turns = pair_in_turns(plan, 0, 1, inwards, budget, rng.below(600));
    alone->ask_start();
    turns->ask_start();
    ASSERT_EQ(turns->result().outcome, alone->result().outcome);
    std::vector<double> cuts{scene.start, scene.end};
    for (int k = rng.between(1, 6); k > 0; --k) cuts.push_back(rng.real(scene.start, scene.end));
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      alone->ask(cuts[k], cuts[k + 1]);
      turns->ask(cuts[k], cuts[k + 1]);
    }
    const PairResult &a = alone->result(), &b = turns->result();
    ASSERT_STREQ(to_string(b.outcome), to_string(a.outcome));
    by_kinetic += b.engine == EngineName::kinetic;
    if (!a.contact) continue;
    ++contacts;
    EXPECT_LE(a.contact->time.lo, b.contact->time.hi);
    EXPECT_LE(b.contact->time.lo, a.contact->time.hi);
    EXPECT_TRUE(turns->instant().has_value() || !b.found);
  }
  EXPECT_GT(std::min(contacts, by_kinetic), static_cast<int>(enough(40)));
}

}  // namespace
}  // namespace taut::testing
