// Scenes with certified answers (brute force over all vertex-edge pairs in ball arithmetic). They lie beside the
// repository; where they do not, the test is skipped. tests/corpus has scenes of the project's own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "support/audit.hpp"
#include "taut/check.hpp"
#include "taut/io.hpp"

namespace taut::testing {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

json read_json(const fs::path& path) {
  std::ifstream in(path);
  return json::parse(in);
}

bool has_feature(const json& want, const Scene& scene, const Contact& contact) {
  json features = want.contains("features") ? want["features"] : json::array({want["feature"]});
  const auto name = [&](const auto& f) { return scene.bodies[static_cast<std::size_t>(f.body)].name; };
  return std::any_of(features.begin(), features.end(), [&](const json& f) {
    return f["vertex"][0] == name(contact.vertex) && f["vertex"][1] == contact.vertex.index &&
           f["edge"][0] == name(contact.edge) && f["edge"][1] == contact.edge.index;
  });
}

/// The tolerances of the answers' own description.
void compare(const Scene& scene, const json& want, const Answer& got, bool generic, bool closed) {
  ASSERT_EQ(to_string(got.outcome), want["outcome"].get<std::string>()) << got.reason;
  if (got.outcome != Outcome::contact) return;
  const double lo = want["t"][0], hi = want["t"][1], span = scene.end - scene.start;
  double tolerance = generic ? 1e-12 * std::max(std::fabs(lo), std::fabs(hi)) + 1e-15 : 1e-9 * span;
  if (closed && !generic) tolerance = std::max(tolerance, 1e-7 * span);
  const TimeInterval t = got.contact->time;
  EXPECT_LE(t.lo, hi + tolerance);
  EXPECT_GE(t.hi, lo - tolerance);
  const double narrow = std::max(1e-11 * std::max(std::fabs(t.lo), std::fabs(t.hi)), 1e-14 * span);
  EXPECT_LE(t.hi - t.lo, got.contact->grazing ? tolerance : narrow);
  if (generic) {
    EXPECT_TRUE(has_feature(want, scene, *got.contact)) << "vertex " << got.contact->vertex.index;
  }
}

TEST(CertifiedScenes, AllAnswersInBothTouchModes) {
  const fs::path folder = "../shared/scenes";
  if (!fs::exists(folder)) GTEST_SKIP() << "the scenes with certified answers are not here (../shared/scenes)";
  int answers = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string file = entry.path().string(), suffix = ".answer.json";
    if (file.size() < suffix.size() || file.substr(file.size() - suffix.size()) != suffix) continue;
    SCOPED_TRACE(file);
    const json want = read_json(entry.path());
    const Scene scene = read_scene(file.substr(0, file.size() - suffix.size()) + ".json");
    const bool generic = want.value("generic", false);
    CheckOptions closed;
    closed.touch = Touch::closed;
    compare(scene, want, check(scene), generic, false);
    compare(scene, want["closed"], check(scene, closed), generic, true);
    answers += 2;
  }
  EXPECT_GE(answers, 310);
}

/// Our own: each file says in `note` what it once broke and why, and what is right.
TEST(Corpus, AnswersAndMaps) {
  AuditCounts counts;
  int scenes = 0;
  for (const auto& entry : fs::directory_iterator("tests/corpus")) {
    if (entry.path().extension() != ".json" || entry.path().stem().extension() == ".answer") continue;
    SCOPED_TRACE(entry.path().string());
    const json want = read_json(entry.path().parent_path() / (entry.path().stem().string() + ".answer.json"));
    const Scene scene = read_scene(entry.path().string());
    for (const Touch touch : {Touch::open, Touch::closed}) {
      const AuditResult result = audit(scene, touch, counts);
      ASSERT_EQ(result.fault, "");
      const json& expected = want[to_string(touch)];
      EXPECT_EQ(to_string(result.outcome), expected["outcome"].get<std::string>());
      if (result.contact) {
        EXPECT_NEAR(result.contact->time.lo, expected["t"].get<double>(), 1e-9);
      }
    }
    ++scenes;
  }
  EXPECT_GE(scenes, 5);
}

}  // namespace
}  // namespace taut::testing
