// Both engines in turn, beside each engine alone: in work, which is counted, and so the same on every machine. How well
// the count tells time is what `./dev cliffs` prints.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "numeric/budget.hpp"
#include "soak/soak_scene.hpp"
#include "solver/portfolio_solver.hpp"
#include "solver/run.hpp"
#include "support/effort.hpp"
#include "support/made_world.hpp"
#include "support/rng.hpp"
#include "support/same_answer.hpp"
#include "taut/check.hpp"
#include "taut/error.hpp"
#include "taut/shape.hpp"
#include "taut/validate.hpp"

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
  // Few scenes say little about a share.
  EXPECT_LT(static_cast<double>(steep), 0.05 * static_cast<double>(asked) + 2);
  EXPECT_LT(all, 2 * better_all);
}

/// By slices of which each is longer than the one before, and the first ones far too short for anything.
PairResult by_slices(const Instance& instance, EngineChoice engine, Offset offset, std::uint64_t slice) {
  EventBudget budget(UINT64_MAX);
  const auto solver = pair_solver({engine}, instance, 0, 1, offset, budget);
  solver->ask_start();
  int slices = 0;
  while (!solver->work(instance.start(), instance.end(), slice)) {
    if (++slices > 400) {
      ADD_FAILURE() << "no end after " << slices << " slices";
      break;
    }
    slice += slice / 8 + 1;
  }
  return solver->result();
}

/// A search that is left and taken up again comes to the same end as one that is not.
TEST(Either, ShortSlicesComeToTheSameEnd) {
  for (std::uint64_t number = 0; number < effort(250); ++number) {
    const SoakScene s = number % 3 == 0 ? soak_scene(number) : soak_contact_scene(number);
    SCOPED_TRACE("scene " + std::to_string(number));
    try {
      validate(s.scene);
      const Instance instance(s.scene);
      for (const EngineChoice engine : {EngineChoice::kinetic, EngineChoice::spacetime}) {
        const PairResult at_once = by_slices(instance, engine, offset_for(s.touch), UINT64_MAX);
        const PairResult result = by_slices(instance, engine, offset_for(s.touch), 1 + number % 97);
        ASSERT_EQ(result.outcome, at_once.outcome) << to_string(engine);
        EXPECT_EQ(result.free_until, at_once.free_until);
        ASSERT_EQ(result.contact.has_value(), at_once.contact.has_value());
        if (result.contact) {
          EXPECT_EQ(result.contact->time.hi, at_once.contact->time.hi);
        }
      }
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
    const Instance instance(scene);
    EventBudget budget(UINT64_MAX);
    const Offset offset = seed % 2 == 0 ? Offset::inward : Offset::outward;
    const auto alone = pair_solver({EngineChoice::spacetime}, instance, 0, 1, offset, budget),
               turns = pair_solver({EngineChoice::either, static_cast<std::uint64_t>(rng.below(600))}, instance, 0, 1,
                                   offset, budget);
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
