// The judge of answers about worlds finds what is wrong, where answers are made wrong.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "support/effort.hpp"
#include "support/small_world.hpp"
#include "support/world_changes.hpp"
#include "support/world_judge.hpp"
#include "taut/check.hpp"

namespace taut::testing {
namespace {

/// A bar that goes through another one from t = 1 to t = 3, of four.
MadeWorld passing_bars() {
  MadeWorld world;
  MadeBody rests, moves;
  rests.name = "rests";
  rests.parts = {{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}}};
  moves = rests;
  moves.name = "moves";
  moves.keyframes.resize(2);
  moves.keyframes[0].x = -2;
  moves.keyframes[0].y = moves.keyframes[1].y = 0.25;
  moves.keyframes[1].t = 4;
  moves.keyframes[1].x = 2;
  world.bodies = {rests, moves};
  return world;
}

TEST(WorldJudge, KnowsWrongContacts) {
  const MadeWorld world = passing_bars();
  CheckOptions options;
  options.all_pairs = true;
  const PairAnswer right = check(scene_of(world), options).pairs->at(0);
  ASSERT_EQ(right.outcome, Outcome::contact);
  WorldJudge judge(world, 40);
  EXPECT_EQ(judge.pair_fault(right), "");
  PairAnswer late = right, early = right, other = right, at_start = right, free = right;
  late.contact->time = {1.0625, 1.0625};
  EXPECT_NE(judge.pair_fault(late).find("before the contact"), std::string::npos);
  early.contact->time = {0.9375, 0.9375};
  EXPECT_NE(judge.pair_fault(early).find("from the edge"), std::string::npos);
  other.contact->edge.index = (other.contact->edge.index + 2) % 4;
  EXPECT_NE(judge.pair_fault(other).find("from the edge"), std::string::npos);
  at_start.outcome = Outcome::overlap_at_start;
  EXPECT_NE(judge.pair_fault(at_start), "");
  free.outcome = Outcome::free;
  EXPECT_NE(judge.pair_fault(free).find("they overlap before"), std::string::npos);
}

TEST(WorldJudge, KnowsWrongHeadlines) {
  CheckOptions options;
  options.all_pairs = true;
  Answer answer = check(scene_of(passing_bars()), options);
  EXPECT_EQ(earliest_fault(answer, *answer.pairs), "");
  answer.contact->time.lo += 1e-6;
  EXPECT_NE(earliest_fault(answer, *answer.pairs), "");
  answer.outcome = Outcome::free;
  EXPECT_NE(earliest_fault(answer, *answer.pairs), "");
}

TEST(WorldJudge, KnowsWrongIntervalsAndCurves) {
  const MadeWorld world = passing_bars();
  const Scene scene = scene_of(world);
  WorldJudge judge(world, 40);
  std::vector<OverlapInterval> found = intervals(scene).intervals;
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(judge.intervals_fault({0, 1}, found), "");
  EXPECT_NE(judge.intervals_fault({0, 1}, {}), "");
  found[0].to = {2.5, 2.5};
  EXPECT_NE(judge.intervals_fault({0, 1}, found).find("in no interval"), std::string::npos);
  found[0].to = {3.5, 3.5};
  EXPECT_NE(judge.intervals_fault({0, 1}, found).find("a gap"), std::string::npos);

  ProfileOptions options;
  options.instants = 5;
  DistanceCurve curve = distance_profile(scene, options).curves.at(0);
  EXPECT_EQ(judge.curve_fault({0, 1}, curve), "");
  DistanceCurve wrong = curve;
  wrong.instants[0].hi = wrong.instants[0].lo = 0.9;
  EXPECT_NE(judge.curve_fault({0, 1}, wrong), "");
  wrong = curve;
  wrong.stretches[0].hi = 0.95;
  EXPECT_NE(judge.curve_fault({0, 1}, wrong).find("of its stretch"), std::string::npos);
  wrong = curve;
  wrong.largest_lo = wrong.largest_hi = 0.5;
  EXPECT_NE(judge.curve_fault({0, 1}, wrong), "");
  EXPECT_EQ(judge.clearance_fault({0, 1}, 0), "");
  EXPECT_NE(judge.clearance_fault({0, 1}, 0.5), "");
}

/// The worlds of the soak have what they are for.
TEST(LargeWorlds, AreVaried) {
  std::size_t bodies = 0, most = 0, holes = 0, parts = 0, ignored = 0;
  int deepest = 0, cut = 0, seen = 0;
  for (std::uint64_t number = 0; number < 200; ++number) {
    const MadeWorld world = large_world(number).world;
    bodies += world.bodies.size();
    most = std::max(most, world.bodies.size());
    ignored += world.ignore.size();
    for (const MadeBody& body : world.bodies) {
      holes += body.parts[0].holes.size();
      parts += body.parts.size() > 1;
      int depth = 0;
      for (int at = body.parent; at >= 0; at = world.bodies[static_cast<std::size_t>(at)].parent) ++depth;
      deepest = std::max(deepest, depth);
    }
    Rng rng(number);
    cut_at_seams(rng, world, cut);
    seen += seen_from_a_moving_frame(rng, world).has_value();
  }
  EXPECT_GT(bodies, 1500u);
  EXPECT_GT(most, 50u);
  EXPECT_GT(holes, 200u);
  EXPECT_GT(parts, 200u);
  EXPECT_GT(ignored, 100u);
  EXPECT_EQ(deepest, 6);
  EXPECT_GT(cut, 500);
  EXPECT_GT(seen, 50);
}

TEST(SmallWorlds, AreVaried) {
  std::size_t bodies = 0, holes = 0, parts = 0, parents = 0, ignored = 0;
  std::map<std::string, int> seen, ties;
  for (std::uint64_t number = 0; number < 400; ++number) {
    const LargeWorld made = small_world(number);
    ++seen[made.family];
    EXPECT_GE(made.world.bodies.size(), 2u);
    EXPECT_LE(made.world.bodies.size(), 8u);
    bodies += made.world.bodies.size();
    ignored += made.world.ignore.size();
    for (const MadeBody& body : made.world.bodies) {
      holes += body.parts[0].holes.size();
      parts += body.parts.size() > 1;
      parents += body.parent >= 0;
    }
    CheckOptions options;
    options.all_pairs = true;
    const Answer answer = check(scene_of(made.world), options);
    std::set<double> times;
    for (const PairAnswer& pair : *answer.pairs) {
      if (pair.contact) ties[made.family] += !times.insert(std::round(0x1p40 * pair.contact->time.lo)).second;
    }
  }
  EXPECT_EQ(seen.size(), 7u);
  EXPECT_LT(bodies, 2000u);
  EXPECT_GT(holes, 100u);
  EXPECT_GT(parts, 100u);
  EXPECT_GT(parents, 200u);
  EXPECT_GT(ignored, 200u);
  EXPECT_GT(ties["tied"], 10);
}

}  // namespace
}  // namespace taut::testing
