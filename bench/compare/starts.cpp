#include "compare/starts.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "compare/cases.hpp"
#include "compare/timing.hpp"
#include "taut/io.hpp"
#include "taut/pose.hpp"
#include "taut/shape.hpp"
#include "taut/warm_check.hpp"

namespace taut::bench {
namespace {

constexpr int places = 32;

/// Questions about an instant each, at places along the scene's own motion that lie so far apart, to and fro: nearly
/// nothing but starts.
std::vector<Scene> questions(const Contest& contest, double step) {
  Scene scene = contest.scene;
  for (Body& body : scene.bodies) {
    body.prepared = prepare(body.polygon, body.name);
    body.polygon.clear();
  }
  std::vector<Scene> all;
  const double length = scene.end - scene.start;
  for (int k = 0; k < places; ++k) {
    const int way = k < places / 2 ? k : places - k;
    all.push_back(scene);
    all.back().start = scene.start + length * (0.013 + step * way);
    all.back().end = all.back().start + 1e-9 * length;
  }
  return all;
}

/// The numbers of one row; nothing if an answer differs.
struct StartRow {
  double built, warm, share;
};

bool measure(const std::vector<Scene>& scenes, double seconds, StartRow& row) {
  CheckOptions options;
  options.engine = EngineChoice::kinetic;
  WarmCheck warm(options);
  Timing built_time, warm_time;
  const Stopwatch whole;
  bool right = true;
  std::uint64_t asked = 0;
  for (int round = 0; round < 3 || (whole.seconds() < seconds && round < 101); ++round) {
    built_time.measure([&] {
      for (const Scene& scene : scenes) check(scene, options);
    });
    warm_time.measure([&] {
      for (const Scene& scene : scenes) warm.check(scene);
      asked += scenes.size();
    });
  }
  row = {built_time.median() / places, warm_time.median() / places,
         static_cast<double>(warm.warm_starts()) / static_cast<double>(asked)};
  for (const Scene& scene : scenes) {
    const Touch touch = Touch::open;
    right = right && answer_json(scene, warm.check(scene), touch) == answer_json(scene, check(scene, options), touch);
  }
  return right;
}

}  // namespace

bool compare_starts(double seconds) {
  fmt::print("{}\n\n", machine_text());
  fmt::print(
      "| family | n | step | built | near the last one | ratio | near, of all "
      "|\n|---|---:|---:|---:|---:|---:|---:|\n");
  bool right = true;
  for (const ContestFamily& family : chosen_families({"gears", "combs", "dips", "bay", "spiral"})) {
    const Contest contest = family.make(4096);
    for (const double step : {1e-6, 1e-4, 1e-3}) {
      StartRow row{};
      const bool same = measure(questions(contest, step), seconds, row);
      right = right && same;
      fmt::print("| {} | {} | {:.0e} | {} | {} | {:.2g} | {:.0f} % |{}\n", family.name, contest.n, step,
                 seconds_text(row.built), seconds_text(row.warm), row.built / row.warm, 100 * row.share,
                 same ? "" : " WRONG");
      std::fflush(stdout);
    }
  }
  return right;
}

}  // namespace taut::bench
