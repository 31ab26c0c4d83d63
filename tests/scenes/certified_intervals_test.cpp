// Intervals of overlap and free ranges against certified answers, made by brute force over all vertices and edges.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "taut/error.hpp"
#include "taut/intervals.hpp"
#include "taut/io.hpp"
#include "taut/motions.hpp"

namespace taut {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Pair = std::set<std::string>;

json read(const fs::path& path) {
  std::ifstream file(path);
  return json::parse(file);
}

void expect_meets(const TimeInterval& got, const json& want, double tolerance) {
  EXPECT_LE(got.lo, got.hi);
  EXPECT_LE(got.lo, want[1].get<double>() + tolerance);
  EXPECT_GE(got.hi, want[0].get<double>() - tolerance);
}

std::map<Pair, std::vector<OverlapInterval>> by_pair(const Scene& scene, const Intervals& answer) {
  std::map<Pair, std::vector<OverlapInterval>> sorted;
  for (const OverlapInterval& o : answer.intervals) {
    const auto name = [&](int k) {
      return scene.bodies[static_cast<std::size_t>(o.pair[static_cast<std::size_t>(k)])].name;
    };
    sorted[{name(0), name(1)}].push_back(o);
  }
  return sorted;
}

void compare(const Scene& scene, const json& want, double tolerance, Touch touch) {
  CheckOptions options;
  options.touch = touch;
  const Intervals answer = intervals(scene, options);
  EXPECT_TRUE(answer.undecided.empty());
  std::map<Pair, std::vector<json>> wanted;
  for (const json& o : want) wanted[o["pair"].get<Pair>()].push_back(o);
  auto got = by_pair(scene, answer);
  ASSERT_EQ(got.size(), wanted.size());
  for (auto& [pair, list] : wanted) {
    std::sort(list.begin(), list.end(), [](const json& a, const json& b) { return a["from"] < b["from"]; });
    ASSERT_EQ(got[pair].size(), list.size()) << *pair.begin();
    for (std::size_t i = 0; i < list.size(); ++i) {
      expect_meets(got[pair][i].from, list[i]["from"], tolerance);
      expect_meets(got[pair][i].to, list[i]["to"], tolerance);
    }
  }
}

/// Calls `test` with each scene and its answer.
template <class Test>
int for_each_world(const Test& test) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator("../shared/worlds")) {
    const std::string file = entry.path().string(), suffix = ".answer.json";
    if (file.size() < suffix.size() || file.substr(file.size() - suffix.size()) != suffix) continue;
    SCOPED_TRACE(file);
    test(read_scene(file.substr(0, file.size() - suffix.size()) + ".json"), read(entry.path()));
    ++count;
  }
  return count;
}

TEST(CertifiedWorlds, IntervalsInBothTouchModes) {
  if (!fs::exists("../shared/worlds")) GTEST_SKIP() << "the worlds with certified answers are not here";
  int compared = 0;
  for_each_world([&](const Scene& scene, const json& answer) {
    if (!answer.contains("intervals")) return;
    const json& want = answer["intervals"];
    compare(scene, want["intervals"], want["tolerance"], Touch::open);
    if (!want["closed"].is_null()) compare(scene, want["closed"], want["closed_tolerance"], Touch::closed);
    ++compared;
  });
  EXPECT_GE(compared, 80);
}

TEST(CertifiedWorlds, Ranges) {
  if (!fs::exists("../shared/worlds")) GTEST_SKIP() << "the worlds with certified answers are not here";
  int compared = 0;
  for_each_world([&](const Scene& scene, const json& answer) {
    if (!answer.contains("range")) return;
    for (const json& want : answer["range"]) {
      const Range got = range(scene, want["at"]);
      ASSERT_EQ(got.outcome, Outcome::free) << got.reason;
      const auto expect_end = [&](const std::optional<TimeInterval>& end, const json& wanted) {
        ASSERT_EQ(end.has_value(), !wanted.is_null());
        if (end) expect_meets(*end, wanted, want["tolerance"]);
      };
      expect_end(got.from, want["range"]["from"]);
      expect_end(got.to, want["range"]["to"]);
      ++compared;
    }
  });
  EXPECT_GE(compared, 42);
}

/// A square that goes to and fro over another one, whose overlaps are known in closed form.
Scene there_and_back(int times) {
  std::vector<Keyframe> keyframes;
  for (int k = 0; k <= 2 * times; ++k) keyframes.push_back({static_cast<double>(k), k % 2 == 0 ? 4.0 : 0.0});
  Scene scene;
  scene.end = 2 * times;
  const Polygon square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  scene.bodies = {{"rests", square, {}}, {"moves", square, from_keyframes(keyframes)}};
  scene.bodies[1].polygon = {{0, 0.25}, {1, 0.25}, {1, 0.75}, {0, 0.75}};
  return scene;
}

TEST(Intervals, AsManyAsThereAreToAndFro) {
  const int times = 500;
  const Intervals found = intervals(there_and_back(times));
  ASSERT_EQ(found.intervals.size(), static_cast<std::size_t>(times));
  for (int k = 0; k < times; ++k) {
    const OverlapInterval& o = found.intervals[static_cast<std::size_t>(k)];
    // The way of length 4 takes a unit of time; the squares overlap on the last quarter of it, and on the way back.
    expect_meets(o.from, json{2 * k + 0.75, 2 * k + 0.75}, 1e-12);
    expect_meets(o.to, json{2 * k + 1.25, 2 * k + 1.25}, 1e-12);
    ASSERT_TRUE(o.enter && o.exit);
  }
}

TEST(Intervals, BeginWithTheFirstContactAndMirrorInTime) {
  const Scene scene = there_and_back(3);
  const Intervals found = intervals(scene);
  const Answer first = check(scene);
  ASSERT_TRUE(first.contact);
  expect_meets(found.intervals[0].from, json{first.contact->time.lo, first.contact->time.hi}, 0);
  const Range free = range(scene, 1.5);
  ASSERT_TRUE(free.from && free.to);
  EXPECT_EQ(free.from->lo, found.intervals[0].to.lo);
  EXPECT_EQ(free.to->hi, found.intervals[1].from.hi);
  EXPECT_FALSE(range(scene, 0).from);
  EXPECT_THROW(range(scene, 1), InputError);
  EXPECT_THROW(range(scene, -1), InputError);
}

/// Where bodies do no more than touch: none, and the only one if touching counts.
OverlapInterval only_by_touching(const Scene& scene) {
  EXPECT_TRUE(intervals(scene).intervals.empty());
  CheckOptions closed;
  closed.touch = Touch::closed;
  const Intervals found = intervals(scene, closed);
  EXPECT_EQ(found.intervals.size(), 1u);
  return found.intervals.empty() ? OverlapInterval{} : found.intervals[0];
}

TEST(Intervals, TouchingIsNoneWhenOpenAndAnInstantWhenClosed) {
  Scene scene = there_and_back(1);
  // It turns back where the faces touch.
  scene.bodies[1].motion = from_keyframes({{0, 4}, {1, 1}, {2, 4}});
  const OverlapInterval found = only_by_touching(scene);
  expect_meets(found.from, json{1, 1}, 1e-12);
  expect_meets(found.to, json{1, 1}, 1e-12);
}

/// Enclosures of what happens at the very end are rounded to beyond it.
TEST(Intervals, OfCornersThatMeetAsAnInfiniteSpeedIsReached) {
  const OverlapInterval found = only_by_touching(read_scene("tests/corpus/touch_as_an_infinite_speed_is_reached.json"));
  expect_meets(found.from, json{1, 1}, 1e-12);
  EXPECT_EQ(found.to.hi, 1);
}

}  // namespace
}  // namespace taut
