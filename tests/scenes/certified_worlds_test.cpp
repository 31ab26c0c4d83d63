// Worlds with certified answers (all vertex-edge pairs of all parts of all pairs of bodies in ball arithmetic). They
// lie beside the repository; where they do not, the test is skipped.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "support/every_pair.hpp"
#include "taut/check.hpp"
#include "taut/io.hpp"

namespace taut::testing {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

using Feature = std::tuple<std::string, int, int, int>;
using NamePair = std::set<std::string>;

std::string body_name(const Scene& scene, BodyId id) { return scene.bodies[static_cast<std::size_t>(id)].name; }

template <typename Ref>
Feature feature_got(const Scene& scene, const Ref& ref) {
  return {body_name(scene, ref.body), ref.part, ref.ring, ref.index};
}

Feature feature_wanted(const json& f) { return {f["body"], f.value("part", 0), f.value("ring", 0), f["index"]}; }

NamePair pair_got(const Scene& scene, const std::array<BodyId, 2>& pair) {
  return {body_name(scene, pair[0]), body_name(scene, pair[1])};
}

NamePair pair_wanted(const json& pair) { return {pair[0].get<std::string>(), pair[1].get<std::string>()}; }

void compare_world_contact(const Scene& scene, const json& want, Outcome outcome,
                           const std::optional<Contact>& contact) {
  ASSERT_EQ(to_string(outcome), want["outcome"].get<std::string>());
  ASSERT_EQ(contact.has_value(), outcome == Outcome::contact);
  if (!contact) return;
  const double tolerance = want["tolerance"];
  EXPECT_LE(contact->time.lo, contact->time.hi);
  EXPECT_LE(contact->time.lo, want["t"][1].get<double>() + tolerance);
  EXPECT_GE(contact->time.hi, want["t"][0].get<double>() - tolerance);
  EXPECT_LE(contact->time.hi - contact->time.lo, 1e-9 * (scene.end - scene.start));
  if (!want.value("generic", false) || !want.contains("features")) return;
  const Feature vertex = feature_got(scene, contact->vertex), edge = feature_got(scene, contact->edge);
  const json& features = want["features"];
  EXPECT_TRUE(std::any_of(
      features.begin(), features.end(),
      [&](const json& f) { return feature_wanted(f["vertex"]) == vertex && feature_wanted(f["edge"]) == edge; }))
      << "vertex " << contact->vertex.index << " of " << std::get<0>(vertex) << ", edge " << contact->edge.index
      << " of " << std::get<0>(edge);
}

/// The pair that comes first, and no other one, is named; so are those that come with it.
void compare_earliest_pair(const Scene& scene, const json& want, const Answer& got) {
  if (got.outcome == Outcome::free || scene.bodies.size() == 2) return;
  ASSERT_TRUE(got.pair);
  std::set<NamePair> right{pair_wanted(want["pair"])};
  for (const json& pair : want["also"]) right.insert(pair_wanted(pair));
  EXPECT_EQ(right.count(pair_got(scene, *got.pair)), 1U);
  EXPECT_LT((*got.pair)[0], (*got.pair)[1]);
  for (const PairAnswer& pair : got.also) {
    EXPECT_EQ(right.count(pair_got(scene, pair.bodies)), 1U);
    EXPECT_LT(*got.pair, pair.bodies) << "the headline is the first in the order of the file";
  }
}

void compare_coverage(const Scene& scene, const json& want, const Answer& got, bool all) {
  const Coverage& c = got.coverage;
  EXPECT_EQ(c.pairs, scene.bodies.size() * (scene.bodies.size() - 1) / 2);
  EXPECT_EQ(c.pairs, c.untested() + c.apart + c.tested);
  if (scene.bodies.size() == 2) return;
  EXPECT_EQ(c.pairs, want["pairs"].get<std::uint64_t>());
  // What is both ignored and of one group counts as ignored.
  EXPECT_EQ(c.ignored, want["ignored"].get<std::uint64_t>() + want["both"].get<std::uint64_t>());
  EXPECT_EQ(c.at_rest + c.moving_alike, want["at_rest"].get<std::uint64_t>());
  if (all) {
    EXPECT_EQ(c.apart + c.tested, want["asked"].get<std::uint64_t>());
  }
}

void compare_all_pairs(const Scene& scene, const json& want, const Answer& got) {
  ASSERT_TRUE(got.pairs);
  const std::vector<PairAnswer> all = every_pair(scene, got);
  std::map<NamePair, const PairAnswer*> by_name;
  for (const PairAnswer& pair : all) by_name[pair_got(scene, pair.bodies)] = &pair;
  EXPECT_EQ(by_name.size(), all.size());
  EXPECT_EQ(want.size(), all.size());
  EXPECT_EQ(got.pairs->size(), got.coverage.tested);
  for (const json& pair : want) {
    SCOPED_TRACE(pair["bodies"].dump());
    const auto found = by_name.find(pair_wanted(pair["bodies"]));
    ASSERT_NE(found, by_name.end());
    compare_world_contact(scene, pair, found->second->outcome, found->second->contact);
  }
}

TEST(CertifiedWorlds, AllAnswersInBothTouchModes) {
  const fs::path folder = "../shared/worlds";
  if (!fs::exists(folder)) GTEST_SKIP() << "the worlds with certified answers are not here (../shared/worlds)";
  int worlds = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string file = entry.path().string(), suffix = ".answer.json";
    if (file.size() < suffix.size() || file.substr(file.size() - suffix.size()) != suffix) continue;
    std::ifstream in(entry.path());
    const json want = json::parse(in);
    if (!want.contains("check")) continue;
    const std::string scene_file = file.substr(0, file.size() - suffix.size()) + ".json";
    const Scene scene = read_scene(scene_file);
    for (const Touch touch : {Touch::open, Touch::closed}) {
      for (const EngineChoice engine : {EngineChoice::usual, EngineChoice::spacetime, EngineChoice::kinetic}) {
        for (const bool all : {false, true}) {
          SCOPED_TRACE(scene_file + ", " + to_string(touch) + (all ? ", all pairs" : "") + ", engine " +
                       std::to_string(static_cast<int>(engine)));
          CheckOptions options;
          options.touch = touch;
          options.engine = engine;
          options.all_pairs = all;
          const Answer got = check(scene, options);
          const json& headline = want["check"][to_string(touch)];
          compare_world_contact(scene, headline, got.outcome, got.contact);
          compare_earliest_pair(scene, headline, got);
          compare_coverage(scene, want["check"]["coverage"], got, all);
          EXPECT_EQ(got.pairs.has_value(), all);
          if (all) compare_all_pairs(scene, want["check"]["pairs"][to_string(touch)], got);
        }
      }
    }
    ++worlds;
  }
  EXPECT_GE(worlds, 80);
}

}  // namespace
}  // namespace taut::testing
