// Beside an infinite speed pairs are asked once about all of the time that is left: what is told of each stretch is
// what a search of that stretch alone finds.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "certificate/search_from_end.hpp"
#include "motion/motion_segments.hpp"
#include "numeric/budget.hpp"
#include "scene/body_pair.hpp"
#include "spacetime/crossing.hpp"
#include "taut/intervals.hpp"
#include "taut/io.hpp"

namespace taut::internal::spacetime {
namespace {

struct Seen {
  int stretches = 0, crossings = 0;
};

/// Stretches that become shorter towards the end of the segment, or longer from its start.
std::vector<double> stretches(const MotionSegment& segment, bool at_end) {
  std::vector<double> cuts;
  for (double d = 0x1p-30; d <= 1; d *= 64) {
    const double away = reach_of_end(segment) * d;
    cuts.push_back(at_end ? segment.end - away : segment.start + away);
  }
  cuts.insert(cuts.begin(), at_end ? segment.end : segment.start);
  // The last one leaves the neighbourhood, or enters it.
  cuts.push_back(segment.start + (segment.end - segment.start) / 2);
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

void compare(const PairGeometry& geometry, const MotionSegment& segment, bool at_end, CrossingDirections directions,
             Seen& seen) {
  PreciseCrossings alone(geometry, segment, directions), precise(geometry, segment, directions);
  CrossingsNearEnd kept(segment, directions, precise);
  const std::vector<double> cuts = stretches(segment, at_end);
  const auto np = static_cast<std::uint32_t>(geometry.np), all = static_cast<std::uint32_t>(geometry.size());
  for (std::uint32_t v = 0; v < all; ++v) {
    for (std::uint32_t e = v < np ? np : 0; e < (v < np ? all : np); ++e) {
      const VertexEdge pair{VertexId(v), VertexId(e)};
      for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const auto expected = alone.first(pair, cuts[i], cuts[i + 1]);
        const auto found = kept.first(pair, cuts[i], cuts[i + 1]);
        ++seen.stretches;
        ASSERT_EQ(found.has_value(), expected.has_value()) << v << " " << e << " after " << cuts[i];
        if (!found) continue;
        ++seen.crossings;
        EXPECT_EQ(found->out, expected->out);
        EXPECT_LE(found->lo, expected->hi);
        EXPECT_LE(expected->lo, found->hi);
      }
    }
  }
}

void compare(const Scene& scene, Seen& seen) {
  const BodyPair bodies = pair_of(scene);
  const PairGeometry geometry = displaced_pair(bodies, Offset::outward);
  for (const MotionSegment& segment : segments_of(bodies, scene.start, scene.end)) {
    for (const bool at_end : {false, true}) {
      if (segment.bridge || !segment.singular_at(at_end ? segment.end : segment.start)) continue;
      for (const CrossingDirections directions : {CrossingDirections::into, CrossingDirections::both})
        compare(geometry, segment, at_end, directions, seen);
    }
  }
}

/// What turns like this begins and ends with infinite speed, and its corners pass the floor's surface, and each other's
/// heights, soon after and shortly before.
TEST(CrossingsNearEnd, TellOfEachStretchWhatASearchOfItDoes) {
  Seen seen;
  for (const char* motion :
       {R"("x":[5],"rotation":{"cosine":[-1,2]})", R"("x":[5,0.5],"y":[0,-0.125],"rotation":{"cosine":[1,0,-2]})"}) {
    compare(parse_scene(R"({"format":"taut-scene/1","time":[0,1],"bodies":[
      {"name":"floor","polygon":[[0,-3],[10,-3],[10,0],[6,0],[5.75,-0.25],[5.5,0],[0,0]]},
      {"name":"wheel","polygon":[[3,-0.0625],[2.5,0.03125],[-3,0.25],[-2,-0.03125],[-0.5,-1],[1,-0.0078125]],
       "motion":{)" + std::string(motion) +
                        "}}]}"),
            seen);
  }
  EXPECT_GT(seen.stretches, 1000);
  EXPECT_GT(seen.crossings, 20);
}

/// Where corners meet at the very end.
TEST(CrossingsNearEnd, TellOfContactsAtTheEnd) {
  Seen seen;
  for (const char* name :
       {"infinite_speed_at_both_ends", "root_before_the_start_of_a_leg", "touch_as_an_infinite_speed_is_reached"}) {
    SCOPED_TRACE(name);
    compare(read_scene("tests/corpus/" + std::string(name) + ".json"), seen);
  }
  EXPECT_GT(seen.stretches, 300);
}

/// In time, intervals with an infinite speed in them tell no slope, and enclosures were halved two hundred times until
/// it lay outside. In the distance's root a few steps do.
TEST(RootsBesideAnEnd, AreSharpenedInFewSteps) {
  const Scene scene = read_scene("tests/corpus/roots_beside_an_infinite_speed.json");
  const BodyPair bodies = pair_of(scene);
  const PairGeometry geometry = displaced_pair(bodies, Offset::outward);
  int sharpened = 0;
  for (const MotionSegment& segment : segments_of(bodies, scene.start, scene.end)) {
    if (segment.bridge || !segment.singular_at(segment.start)) continue;
    PreciseCrossings crossings(geometry, segment, CrossingDirections::both);
    const auto np = static_cast<std::uint32_t>(geometry.np), all = static_cast<std::uint32_t>(geometry.size());
    for (std::uint32_t v = 0; v < all; ++v) {
      for (std::uint32_t e = v < np ? np : 0; e < (v < np ? all : np); ++e) {
        const VertexEdge pair{VertexId(v), VertexId(e)};
        const auto found = crossings.first(pair, segment.start, segment.start + reach_of_end(segment));
        if (!found) continue;
        const PreciseTriple triple(segment, geometry, pair.line(geometry));
        const int before = found->out ? 1 : -1;
        // From the end on, as a search in doubles may have it.
        const PreciseTime rough = PreciseTime::between(segment.start, found->hi);
        PreciseTime sharp = rough;
        const std::uint64_t work = work_spent();
        ASSERT_TRUE(triple.refine(before, sharp, Stage::precise));
        EXPECT_LT(work_spent() - work, 10000u);
        EXPECT_LE(rough.lo(), sharp.lo());
        EXPECT_LE(sharp.hi(), rough.hi());
        EXPECT_TRUE(sharp.hi() - sharp.lo() < sharp.hi() * 0x1p-100);
        const auto at = [](const RealMax& t) { return PreciseTime{t, t, Stage::precise}; };
        EXPECT_NE(triple.sign_at(at(sharp.lo()), last_stage), -before);
        EXPECT_NE(triple.sign_at(at(sharp.hi()), last_stage), before);
        ++sharpened;
      }
    }
  }
  EXPECT_GT(sharpened, 3);
}

/// A corner dips through an edge and out of it again, all in the last double of the motion: 2^30 is 1.2e-7 after the
/// one before, and the corner turns by 4.9e-4 then. In the root of the distance both roots are far apart.
Scene dip_in_the_last_double() {
  return parse_scene(R"({"format":"taut-scene/1","time":[1073741823,1073741824],"bodies":[
    {"name":"P","polygon":[[1.000215023,-1],[3,-1],[3,1],[0.999785023,1]]},
    {"name":"Q","polygon":[[1,0],[-1,0.1],[-1,-0.1]],"motion":{"rotation":{"cosine":[-1073741823,1]}}}]})");
}

TEST(CrossingsNearEnd, TwoInOneDoubleStayApart) {
  const Scene scene = dip_in_the_last_double();
  const BodyPair bodies = pair_of(scene);
  const PairGeometry geometry = displaced_pair(bodies, Offset::outward);
  const MotionSegments segments = segments_of(bodies, scene.start, scene.end);
  const MotionSegment& segment = segments[segments.size() - 1];
  int pairs = 0;
  for (std::uint32_t e = 0; e < geometry.np; ++e) {
    for (std::uint32_t v = geometry.np; v < geometry.size(); ++v) {
      PreciseCrossings crossings(geometry, segment, CrossingDirections::both);
      const VertexEdge pair{VertexId(v), VertexId(e)};
      const auto in = crossings.first(pair, segment.start, segment.end);
      if (!in || in->lo < std::nextafter(segment.end, 0)) continue;
      ++pairs;
      EXPECT_FALSE(in->out);
      // By hand: y = 2.3e-4 when it goes in, t = 2^30 - y^2 / 2.
      ASSERT_TRUE(in->precise);
      const double before_end = RealTraits<RealMax>::magnitude(RealMax(RealMax(segment.end) - in->precise->hi()));
      EXPECT_NEAR(before_end, 2.645e-8, 1e-11);
    }
  }
  EXPECT_EQ(pairs, 1);
}

TEST(Intervals, OfADipInTheLastDoubleEnd) {
  const Scene scene = dip_in_the_last_double();
  for (const Touch touch : {Touch::open, Touch::closed}) {
    CheckOptions options;
    options.touch = touch;
    const Intervals found = intervals(scene, options);
    ASSERT_EQ(found.intervals.size(), 1u);
    EXPECT_EQ(found.intervals[0].from.hi, scene.end);
    EXPECT_TRUE(found.intervals[0].exit) << "they are apart at the end";
  }
}

/// A hammer sinks through an anvil until its base lies in the anvil's: two corners leave it just then, and the rest is
/// still inside.
TEST(Intervals, GoOnWhereACornerLeavesAtTheEnd) {
  CheckOptions options;
  options.touch = Touch::closed;
  const Scene scene = read_scene("examples/hello.json");
  const Intervals found = intervals(scene, options);
  ASSERT_EQ(found.intervals.size(), 1u);
  EXPECT_EQ(found.intervals[0].to.lo, scene.end);
  EXPECT_FALSE(found.intervals[0].exit);
}

}  // namespace
}  // namespace taut::internal::spacetime
