// Two engines that share no idea, one answer.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "motion/motion_segment.hpp"
#include "motion/motion_segments.hpp"
#include "motion/pieces.hpp"
#include "spacetime/first_contact.hpp"
#include "support/effort.hpp"
#include "support/random_scenes.hpp"
#include "taut/check.hpp"
#include "taut/io.hpp"

namespace taut::testing {
using namespace internal;
namespace {

using spacetime::SpacetimeResult;

struct Counts {
  int free = 0, contact = 0, overlap = 0, other_pair = 0;
};

template <class Ref>
bool same(const Ref& f, int body, int index) {
  return f.body == body && f.index == index;
}

/// The enclosures overlap, or nearly; and where they are those of one pair, it is the same pair.
void compare_contacts(const BodyPair& bodies, const PairGeometry& g, const MotionSegment& segment,
                      const SpacetimeResult& second, const Contact& first, Counts& counts) {
  const double lo = segment.time(second.lo), hi = segment.time(second.found.hi);
  const double scale = std::max(1.0, std::fabs(hi));
  EXPECT_LE(lo, first.time.hi + 1e-12 * scale);
  EXPECT_GE(hi, first.time.lo - 1e-12 * scale);
  EXPECT_LE(hi - lo, 1e-11 * scale);
  const FeatureMap features(bodies, g, Offset::inward);
  const bool agree =
      first.vertex == features.vertex(second.found.vertex) && first.edge == features.edge(second.found.edge);
  if (!agree) ++counts.other_pair;
  EXPECT_TRUE(agree) << "vertex " << second.found.vertex.value << " edge " << second.found.edge.value;
}

void compare(const Scene& scene, Touch touch, Counts& counts) {
  CheckOptions options;
  options.touch = touch;
  const Answer first = check(scene, options);
  const BodyPair bodies = pair_of(scene);
  const PairGeometry geometry = displaced_pair(bodies, offset_for(touch));
  const MotionSegments segments = segments_of(bodies, scene.start, scene.end);
  if (spacetime::overlapping(geometry, segments[0], scene.start)) {
    ++counts.overlap;
    const bool at_start = first.contact && first.contact->time.hi == scene.start;
    EXPECT_TRUE(first.outcome == Outcome::overlap_at_start || (touch == Touch::closed && at_start));
    return;
  }
  const spacetime::Hierarchy p = spacetime::hierarchy_of_p(geometry), q = spacetime::hierarchy_of_q(geometry);
  const SpacetimeResult second = spacetime::first_contact(geometry, {p, q}, segments);
  if (first.outcome == Outcome::free) {
    ++counts.free;
    EXPECT_EQ(second.outcome, SpacetimeResult::free);
    return;
  }
  ASSERT_EQ(first.outcome, Outcome::contact);
  ++counts.contact;
  ASSERT_EQ(second.outcome, SpacetimeResult::contact) << "kinetic: contact at " << first.contact->time.lo;
  compare_contacts(bodies, geometry, segments[second.segment], second, *first.contact, counts);
}

TEST(SpacetimeKinetic, RandomScenesOfAllFamilies) {
  for (const bool grid : {false, true}) {
    Counts counts;
    for (const Family family : all_families) {
      for (std::uint64_t seed = 0; seed < effort(20); ++seed) {
        SCOPED_TRACE(std::string(to_string(family)) + " seed " + std::to_string(seed) + (grid ? " grid" : ""));
        SceneOptions options;
        options.grid = grid;
        const Scene scene = random_scene(5000 + seed, family, options);
        for (const Touch touch : {Touch::open, Touch::closed}) compare(scene, touch, counts);
        if (HasFatalFailure()) return;
      }
    }
    EXPECT_GT(counts.free, static_cast<int>(enough(40)));
    EXPECT_GT(counts.contact, static_cast<int>(enough(60)));
    EXPECT_EQ(counts.other_pair, 0);
  }
}

/// Uncertified programs of this kind go wrong where coordinates are large and gaps small.
TEST(SpacetimeKinetic, FarFromTheOrigin) {
  Counts counts;
  for (const Family family : all_families) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      SCOPED_TRACE(std::string(to_string(family)) + " seed " + std::to_string(seed));
      SceneOptions options;
      options.kinds = {MotionKind::linear, MotionKind::polynomial, MotionKind::angle};
      Scene scene = random_scene(7000 + seed, family, options);
      for (Body& body : scene.bodies) {
        if (body.motion.pieces.empty()) body.motion.pieces.emplace_back();
        for (MotionPiece& piece : body.motion.pieces) {
          piece.x.resize(std::max<std::size_t>(piece.x.size(), 1));
          piece.y.resize(std::max<std::size_t>(piece.y.size(), 1));
          piece.x[0] += 1e7;
          piece.y[0] -= 3e7;
        }
      }
      for (const Touch touch : {Touch::open, Touch::closed}) compare(scene, touch, counts);
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_GT(counts.contact, 15);
}

TEST(SpacetimeKinetic, CertifiedScenes) {
  const std::filesystem::path folder = "../shared/scenes";
  if (!std::filesystem::exists(folder)) {
    GTEST_SKIP() << "the scenes with certified answers are not here (../shared/scenes)";
  }
  Counts counts;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".json" || entry.path().stem().extension() == ".answer") continue;
    SCOPED_TRACE(entry.path().string());
    const Scene scene = read_scene(entry.path().string());
    for (const Touch touch : {Touch::open, Touch::closed}) compare(scene, touch, counts);
  }
  EXPECT_GT(counts.free + counts.contact, 250);
}

TEST(SpacetimeKinetic, Corpus) {
  Counts counts;
  for (const auto& entry : std::filesystem::directory_iterator("tests/corpus")) {
    if (entry.path().extension() != ".json" || entry.path().stem().extension() == ".answer") continue;
    SCOPED_TRACE(entry.path().string());
    const Scene scene = read_scene(entry.path().string());
    for (const Touch touch : {Touch::open, Touch::closed}) compare(scene, touch, counts);
  }
  EXPECT_GE(counts.free + counts.contact + counts.overlap, 10);
}

}  // namespace
}  // namespace taut::testing
