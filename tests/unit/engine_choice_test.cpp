// Two engines behind one function: what counts as a disagreement, and how runs are stopped.
#include <gtest/gtest.h>

#include <atomic>

#include "generators/generators.hpp"
#include "solver/portfolio_solver.hpp"
#include "solver/run.hpp"
#include "taut/check.hpp"

namespace taut {
using namespace internal;
namespace {

Answer free_answer(double end = 10) {
  Answer a;
  a.outcome = Outcome::free;
  a.free_until = end;
  return a;
}

Answer contact_answer(double lo, double hi, int vertex = 3) {
  Answer a;
  a.outcome = Outcome::contact;
  a.free_until = lo;
  a.contact = Contact{{lo, hi}, {0, vertex}, {1, 5}, {}, {}};
  return a;
}

Answer undecided_answer(double until) {
  Answer a;
  a.free_until = until;
  a.reason = "a limit";
  return a;
}

TEST(Agreed, WhatBothSay) {
  EXPECT_EQ(agreed(free_answer(), free_answer()).outcome, Outcome::free);
  const Answer both = agreed(contact_answer(1, 1.5), contact_answer(1.25, 2));
  EXPECT_EQ(both.outcome, Outcome::contact);
  EXPECT_TRUE(both.compared);
  EXPECT_EQ(both.contact->time.lo, 1.25);
  EXPECT_EQ(both.contact->time.hi, 1.5);
  EXPECT_EQ(both.free_until, 1.25);
}

TEST(Agreed, OneMayGiveUp) {
  EXPECT_EQ(agreed(undecided_answer(3), free_answer()).outcome, Outcome::free);
  EXPECT_EQ(agreed(contact_answer(4, 4), undecided_answer(3)).outcome, Outcome::contact);
  const Answer neither = agreed(undecided_answer(3), undecided_answer(4));
  EXPECT_EQ(neither.outcome, Outcome::undecided);
  EXPECT_EQ(neither.free_until, 4);
}

TEST(Agreed, ContradictionsAreThrown) {
  EXPECT_THROW(agreed(free_answer(), contact_answer(1, 1)), EngineDisagreement);
  EXPECT_THROW(agreed(contact_answer(1, 1.25), contact_answer(1.5, 2)), EngineDisagreement);
  EXPECT_THROW(agreed(contact_answer(1, 1.5, 3), contact_answer(1, 1.5, 4)), EngineDisagreement);
  Answer overlap;
  overlap.outcome = Outcome::overlap_at_start;
  EXPECT_THROW(agreed(overlap, free_answer()), EngineDisagreement);
  // An engine that gave up has still proved something.
  EXPECT_THROW(agreed(undecided_answer(5), contact_answer(4, 4.5)), EngineDisagreement);
  try {
    agreed(free_answer(), contact_answer(1, 1));
  } catch (const EngineDisagreement& error) {
    EXPECT_EQ(error.kinetic().outcome, Outcome::free);
    EXPECT_EQ(error.spacetime().outcome, Outcome::contact);
  }
}

/// Bodies that touch at the start may do so in several places.
TEST(Agreed, FeaturesAtTheStartMayDiffer) {
  EXPECT_EQ(agreed(contact_answer(0, 0, 1), contact_answer(0, 0, 2)).outcome, Outcome::contact);
}

TEST(Stop, EveryEngineSaysHowFarItCame) {
  const Scene scene = gen::make_rotor({});
  const std::atomic<bool> stop{true};
  for (const EngineChoice engine :
       {EngineChoice::kinetic, EngineChoice::spacetime, EngineChoice::both, EngineChoice::either}) {
    CheckOptions options;
    options.engine = engine;
    options.limits.stop = &stop;
    const Answer stopped = check(scene, options);
    EXPECT_EQ(stopped.outcome, Outcome::undecided);
    EXPECT_EQ(stopped.reason, "interrupted");
    EXPECT_GE(stopped.free_until, scene.start);
    EXPECT_LT(stopped.free_until, scene.end);
  }
}

/// The limit of events: what is proved grows with it, and is never beyond the contact.
TEST(Stop, ProvedTimesGrowUpToTheContact) {
  gen::GearOptions gears;
  gears.hit = true;
  const Scene scene = gen::make_gears(gears);
  CheckOptions kinetic;
  kinetic.engine = EngineChoice::kinetic;
  const Answer whole = check(scene, kinetic);
  ASSERT_EQ(whole.outcome, Outcome::contact);
  double before = scene.start;
  for (std::uint64_t events = 0; events < whole.events; events += 17) {
    CheckOptions options;
    options.max_events = events;
    const Answer part = check(scene, options);
    ASSERT_EQ(part.outcome, Outcome::undecided);
    EXPECT_GE(part.free_until, before);
    EXPECT_LE(part.free_until, whole.contact->time.hi);
    before = part.free_until;
  }
  EXPECT_GT(before, scene.start);
}

Answer asked(const Scene& scene, EngineChoice engine) {
  CheckOptions options;
  options.engine = engine;
  return check(scene, options);
}

/// Each engine has motions on which it is far ahead: then the answer is its own.
TEST(Either, IsTheEngineThatIsDoneFirst) {
  gen::DipOptions dips;
  dips.sides = 1024;
  dips.dips = 8;
  const Answer dip = asked(gen::make_dips(dips), EngineChoice::either);
  EXPECT_EQ(dip.outcome, Outcome::free);
  EXPECT_EQ(dip.engine, EngineName::spacetime);
  gen::CombOptions combs;
  combs.teeth = 128;
  combs.swings = 16;
  Scene slots = gen::make_combs(combs);
  slots.end = 1;  // before they are pulled out
  const Answer slide = asked(slots, EngineChoice::either);
  EXPECT_EQ(slide.outcome, Outcome::free);
  EXPECT_EQ(slide.engine, EngineName::kinetic);
}

/// However often the turn changes, the answer is the one that the engine gives by itself.
TEST(Either, SaysWhatThatEngineSaysByItself) {
  for (const bool hit : {false, true}) {
    gen::GearOptions gears;
    gears.hit = hit;
    gears.teeth_1 = 96;
    gears.teeth_2 = 97;
    const Scene scene = gen::make_gears(gears);
    const Answer either = asked(scene, EngineChoice::either);
    const bool kinetic = either.engine == EngineName::kinetic;
    const Answer alone = asked(scene, kinetic ? EngineChoice::kinetic : EngineChoice::spacetime);
    EXPECT_EQ(either.outcome, hit ? Outcome::contact : Outcome::free);
    EXPECT_EQ(either.outcome, alone.outcome);
    EXPECT_EQ(either.events, alone.events);
    ASSERT_EQ(either.contact.has_value(), hit);
    if (!hit) continue;
    EXPECT_EQ(either.contact->time.lo, alone.contact->time.lo);
    EXPECT_EQ(either.contact->time.hi, alone.contact->time.hi);
    EXPECT_EQ(either.contact->vertex.index, alone.contact->vertex.index);
  }
}

/// Searches that are left and taken up again.
TEST(Either, ManyShortSlicesAreOneLongOne) {
  const Scene scene = gen::make_gears({});
  const Instance instance(scene);
  for (const EngineChoice engine : {EngineChoice::kinetic, EngineChoice::spacetime}) {
    EventBudget budget(UINT64_MAX);
    const auto whole = pair_solver({engine}, instance, 0, 1, Offset::inward, budget),
               parts = pair_solver({engine}, instance, 0, 1, Offset::inward, budget);
    whole->ask(scene.start, scene.end);
    int slices = 1;
    for (std::uint64_t effort = 1; !parts->work(scene.start, scene.end, effort); effort = effort * 3 / 2 + 1) ++slices;
    EXPECT_GT(slices, 3);
    EXPECT_EQ(parts->result().outcome, whole->result().outcome);
    EXPECT_EQ(parts->counts().events, whole->counts().events);
    EXPECT_EQ(parts->result().free_until, whole->result().free_until);
  }
}

/// Engines agree only about what both decided. A limit of events had stopped one, and "two engines agree" was said.
TEST(BothEngines, AgreeOnlyAboutWhatBothDecided) {
  Scene scene = gen::make_gears({.hit = true});
  CheckOptions options;
  options.engine = EngineChoice::both;
  EXPECT_TRUE(check(scene, options).compared);
  options.max_events = 0;
  const Answer answer = check(scene, options);
  EXPECT_EQ(answer.outcome, Outcome::contact);
  EXPECT_FALSE(answer.compared);
}

}  // namespace
}  // namespace taut
