// Bodies on layers against their parts: two bodies meet when two parts do that have a layer in common.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <set>

#include "support/consistency.hpp"
#include "support/effort.hpp"
#include "support/every_pair.hpp"
#include "support/large_world.hpp"
#include "support/layered.hpp"
#include "support/made_world.hpp"
#include "support/small_world.hpp"
#include "taut/clearance.hpp"
#include "taut/error.hpp"
#include "taut/intervals.hpp"
#include "taut/separate.hpp"

namespace taut::testing {
namespace {

std::vector<Part> parts_of(const Body& body) {
  if (!body.parts.empty()) return body.parts;
  return {{body.polygon, {}, std::nullopt}};
}

/// By definition, of two intervals of heights.
bool share_height(const Layers& a, const Layers& b) { return a.lo < b.hi && b.lo < a.hi; }

/// The scene in which two bodies are one part each, without layers, and everything else is ignored.
Scene with_parts(Scene scene, std::size_t a, const Part& of_a, std::size_t b, const Part& of_b) {
  scene.ignore.clear();
  scene.at_rest = AtRest::test;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    Body& body = scene.bodies[k];
    body.z = {};
    for (Part& part : body.parts) part.z.reset();
    if (k != a && k != b) {
      scene.ignore.push_back({body.name, "*"});
      continue;
    }
    const Part& part = k == a ? of_a : of_b;
    body.polygon.clear();
    body.parts = {{part.outline, part.holes, std::nullopt}};
  }
  return scene;
}

/// What the answers of all parts that share a layer say about two bodies; nothing if there are none.
struct Expected {
  bool overlap_at_start = false;
  std::optional<TimeInterval> contact;
  double least = INFINITY;  ///< at least the least distance, nearly
  double until = 0;         ///< free until then, at least
};

std::optional<Expected> by_parts(const Scene& scene, std::size_t a, std::size_t b, const CheckOptions& options) {
  std::optional<Expected> all;
  for (const Part& of_a : parts_of(scene.bodies[a])) {
    for (const Part& of_b : parts_of(scene.bodies[b])) {
      if (!share_height(of_a.z.value_or(scene.bodies[a].z), of_b.z.value_or(scene.bodies[b].z))) continue;
      if (!all) all.emplace().until = scene.end;
      const Scene one = with_parts(scene, a, of_a, b, of_b);
      const Answer answer = check(one, options);
      const Clearance distance = clearance(one);
      all->least = std::min(all->least, distance.nearest ? distance.nearest->hi : 0);
      all->until = std::min(all->until, answer.free_until);
      if (answer.outcome == Outcome::overlap_at_start) all->overlap_at_start = true;
      if (!answer.contact) continue;
      if (!all->contact) all->contact = answer.contact->time;
      all->contact->lo = std::min(all->contact->lo, answer.contact->time.lo);
      all->contact->hi = std::min(all->contact->hi, answer.contact->time.hi);
    }
  }
  return all;
}

void expect_as_parts(const PairAnswer& pair, const Expected& parts) {
  if (parts.overlap_at_start) {
    EXPECT_EQ(pair.outcome, Outcome::overlap_at_start);
  } else if (parts.contact) {
    ASSERT_EQ(pair.outcome, Outcome::contact);
    EXPECT_LE(pair.contact->time.lo, parts.contact->hi);
    EXPECT_GE(pair.contact->time.hi, parts.contact->lo);
  } else {
    EXPECT_EQ(pair.outcome, Outcome::free);
  }
}

/// Scenes are drawn so that most have parts.
Scene layered_scene(std::uint64_t seed) {
  Scene scene = on_layers(scene_of(small_world(seed).world), seed);
  scene.at_rest = AtRest::test;
  return scene;
}

class LayersOfWorlds : public ::testing::TestWithParam<Touch> {};

TEST_P(LayersOfWorlds, MeetAsTheirPartsDo) {
  int contacts = 0, on_other_layers = 0;
  for (std::uint64_t seed = 1; seed < effort(150); ++seed) {
    SCOPED_TRACE("world " + std::to_string(seed));
    const Scene scene = layered_scene(seed);
    CheckOptions options;
    options.touch = GetParam();
    options.all_pairs = true;
    const Answer answer = check(scene, options);
    std::set<std::array<BodyId, 2>> asked;
    for (const PairAnswer& pair : every_pair(scene, answer)) {
      const auto [a, b] = pair.bodies;
      const auto parts = by_parts(scene, static_cast<std::size_t>(a), static_cast<std::size_t>(b), options);
      if (!parts) {
        EXPECT_EQ(pair.outcome, Outcome::free);
        continue;
      }
      EXPECT_TRUE(asked.insert(pair.bodies).second) << "a pair is listed twice";
      expect_as_parts(pair, *parts);
      contacts += pair.outcome == Outcome::contact;
    }
    on_other_layers += static_cast<int>(answer.coverage.layers);
    if (HasFailure()) return;
  }
  EXPECT_GT(contacts, 0);
  EXPECT_GT(on_other_layers, 0);
}

INSTANTIATE_TEST_SUITE_P(Both, LayersOfWorlds, ::testing::Values(Touch::open, Touch::closed));

TEST(Layers, OfAnswersAreConsistent) {
  for (std::uint64_t seed = 1; seed < effort(150); ++seed) {
    SCOPED_TRACE("world " + std::to_string(seed));
    const Scene scene = layered_scene(seed);
    if (check(scene).coverage.is_empty()) continue;
    for (const Touch touch : {Touch::open, Touch::closed}) EXPECT_EQ(inconsistency(scene, touch, 10), "");
    if (HasFailure()) return;
  }
}

TEST(Layers, DistancesAreThoseOfPartsOnCommonLayers) {
  for (std::uint64_t seed = 1; seed < effort(80); ++seed) {
    SCOPED_TRACE("world " + std::to_string(seed));
    const Scene scene = layered_scene(seed);
    ClearanceOptions all;
    all.all_pairs = true;
    const Clearance answer = clearance(scene, all);
    for (const NearestPoints& pair : answer.pairs) {
      const auto parts =
          by_parts(scene, static_cast<std::size_t>(pair.pair[0]), static_cast<std::size_t>(pair.pair[1]), {});
      ASSERT_TRUE(parts);
      EXPECT_LE(pair.lo, parts->least);
      EXPECT_NEAR(pair.hi, parts->least, 1e-8 * (1 + parts->least));
    }
    if (HasFailure()) return;
  }
}

/// Each pair is counted once: ignored, else of one group, else without a common layer.
TEST(Layers, AreCountedByDefinition) {
  for (std::uint64_t seed = 1; seed < effort(400); ++seed) {
    SCOPED_TRACE("world " + std::to_string(seed));
    Scene scene = on_layers(scene_of(small_world(seed).world), seed);
    // As if all bodies were on all layers.
    Scene flat = scene;
    for (Body& body : flat.bodies) {
      body.z = {};
      for (Part& part : body.parts) part.z.reset();
    }
    flat.at_rest = scene.at_rest = AtRest::test;
    const auto without_common = [&](std::size_t a, std::size_t b) {
      for (const Part& p : parts_of(scene.bodies[a])) {
        for (const Part& q : parts_of(scene.bodies[b])) {
          if (share_height(p.z.value_or(scene.bodies[a].z), q.z.value_or(scene.bodies[b].z))) return false;
        }
      }
      return true;
    };
    const auto is_ignored = [&](std::size_t a, std::size_t b) {
      return std::any_of(scene.ignore.begin(), scene.ignore.end(), [&](const auto& pair) {
        const auto is = [](const std::string& word, const Body& body) { return word == "*" || word == body.name; };
        const Body &p = scene.bodies[a], &q = scene.bodies[b];
        return (is(pair[0], p) && is(pair[1], q)) || (is(pair[0], q) && is(pair[1], p));
      });
    };
    std::uint64_t layers = 0;
    for (std::size_t a = 0; a < scene.bodies.size(); ++a) {
      for (std::size_t b = a + 1; b < scene.bodies.size(); ++b) layers += without_common(a, b) && !is_ignored(a, b);
    }
    const Coverage found = check(scene).coverage, all = check(flat).coverage;
    EXPECT_EQ(found.layers, layers);
    EXPECT_EQ(found.pairs, all.pairs);
    EXPECT_EQ(found.ignored, all.ignored);
    EXPECT_EQ(found.pairs, found.tested + found.apart + found.untested());
    if (HasFailure()) return;
  }
}

/// Plates that lie flush on each other slide on each other, touching or not.
TEST(Layers, FlushPlatesDoNotMeet) {
  const Polygon plate{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  Scene scene;
  scene.end = 1;
  scene.bodies = {{"low", plate, {}}, {"high", plate, {}}};
  scene.bodies[0].z = {0, 3};
  scene.bodies[1].z = {3, 6};
  for (const Touch touch : {Touch::open, Touch::closed}) {
    CheckOptions options;
    options.touch = touch;
    const Answer answer = check(scene, options);
    EXPECT_EQ(answer.outcome, Outcome::untested);
    EXPECT_EQ(answer.coverage.layers, 1U);
    EXPECT_EQ(
        answer.reason,
        "nothing was tested: the only pair is on different layers; give bodies a layer in common, by their \"z\"");
  }
  scene.bodies[1].z = {2.5, 6};
  EXPECT_EQ(check(scene).outcome, Outcome::overlap_at_start);
  scene.bodies[1].z = {6, 2.5};
  EXPECT_THROW(check(scene), InputError);
}

/// A seam between parts on neighbouring layers does not open for what is on both.
TEST(Layers, ShrunkBodiesKeepTheirSeams) {
  Scene scene;
  scene.end = 1;
  scene.bodies = {{"bar", {}, {}}, {"thin", {{-0.01, 2}, {0.01, 2}, {0.01, 3}, {-0.01, 3}}, {}}};
  scene.bodies[0].parts = {{{{-4, 0}, {0, 0}, {0, 1}, {-4, 1}}, {}, Layers{0, 3}},
                           {{{0, 0}, {4, 0}, {4, 1}, {0, 1}}, {}, Layers{0, 3}},
                           {{{-1, 0}, {1, 0}, {1, 1}, {-1, 1}}, {}, Layers{3, 5}}};
  scene.bodies[1].z = {1, 2};
  scene.bodies[1].motion.pieces.push_back({});
  scene.bodies[1].motion.pieces[0].y = {0, -3};
  CheckOptions options;
  options.fit = 0.004;
  const Answer answer = check(scene, options);
  ASSERT_EQ(answer.outcome, Outcome::contact);
  EXPECT_NEAR(answer.contact->time.lo, 1 / 3.0, 0.01);
  EXPECT_LE(answer.contact->edge.part, 1);
}

TEST(Layers, BodiesGoPastEachOtherOnTheirLayers) {
  const Polygon bar{{0, 0}, {4, 0}, {4, 1}, {0, 1}};
  Scene scene;
  scene.bodies = {{"low", bar, {}}, {"step", {}, {}}};
  scene.bodies[0].z = {0, 1};
  // Under it there is nothing to the left, and a block to the right.
  scene.bodies[1].parts = {{{{-3, 0}, {-1, 0}, {-1, 1}, {-3, 1}}, {}, Layers{1, 2}},
                           {{{6, 0}, {7, 0}, {7, 1}, {6, 1}}, {}, Layers{0, 2}}};
  const Separation answer = separate(scene);
  ASSERT_EQ(answer.bodies.size(), 1U);
  // Only the block is in the way: all directions but some to the left.
  ASSERT_EQ(answer.bodies[0].free.size(), 1U);
  const DirectionArc& arc = answer.bodies[0].free[0];
  EXPECT_NEAR(arc.from.lo, std::atan2(-1, -2) * 180 / M_PI + 360, 1e-9);
  EXPECT_NEAR(arc.to.lo, std::atan2(1, -2) * 180 / M_PI, 1e-9);
  ASSERT_TRUE(arc.from_vertices);
  EXPECT_EQ(arc.from_vertices->at(0).part, 1);
}

}  // namespace
}  // namespace taut::testing
