// What small questions cost besides their answer: memory that is taken and given back for each of them, and the first
// one of a thread.
//
// One row for each scene and engine, prepared shapes or not. The time of a question asked again and again; calls of
// operator new and page faults of one such question; how much longer the first question of a new thread takes.
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "compare/cases.hpp"
#include "compare/timing.hpp"
#include "heap.hpp"
#include "taut/check.hpp"
#include "taut/io.hpp"
#include "taut/shape.hpp"

namespace taut::bench {
namespace {

std::int64_t page_faults() {
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  return use.ru_minflt;
}

struct Cost {
  double seconds = 0, fresh = 0;
  double allocations = 0, faults = 0;
};

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

/// By the wall clock: a page fault is the system's work.
template <class Work>
double seconds_of(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

template <class Work>
Cost cost_of(const Work& work) {
  constexpr int times = 200;
  for (int k = 0; k < 20; ++k) work();
  Cost cost;
  const std::int64_t faults = page_faults();
  const std::uint64_t allocations = heap_use().allocations;
  std::vector<double> seconds(times);
  for (double& s : seconds) s = seconds_of(work);
  cost.allocations = static_cast<double>(heap_use().allocations - allocations) / times;
  cost.faults = static_cast<double>(page_faults() - faults) / times;
  cost.seconds = median(seconds);
  std::vector<double> fresh(50);
  for (double& s : fresh) std::thread([&] { s = seconds_of(work); }).join();
  cost.fresh = median(fresh) - cost.seconds;
  return cost;
}

Scene prepared(Scene scene) {
  for (Body& body : scene.bodies) {
    if (!body.parts.empty()) continue;
    body.prepared = prepare(body.polygon, body.name);
    body.polygon.clear();
  }
  return scene;
}

void print_rows(const std::string& name, const Scene& scene) {
  for (const EngineChoice engine : {EngineChoice::kinetic, EngineChoice::spacetime, EngineChoice::either}) {
    CheckOptions options;
    options.engine = engine;
    const Cost cost = cost_of([&] { check(scene, options); });
    fmt::print("| {} | {} | {} | {:.1f} | {:.2f} | {} |\n", name, to_string(engine), seconds_text(cost.seconds),
               cost.allocations, cost.faults, seconds_text(std::max(0.0, cost.fresh)));
  }
}

int run(int argc, char** argv) {
  fmt::print(
      "{}\n\n| scene | engine | time | allocations | page faults | more on a new thread |\n|---|---|--:|--:|--:|--:|\n",
      machine_text());
  for (const ContestFamily& family : contest_families()) {
    const std::string name = family.name;
    if (name == "octagons" || name == "stars") print_rows(name + " 8", prepared(family.make(8).scene));
  }
  for (int i = 1; i < argc; ++i) {
    const Scene scene = read_scene(argv[i]);
    print_rows(std::string(argv[i]) + ", prepared", prepared(scene));
    print_rows(argv[i], scene);
  }
  return 0;
}

}  // namespace
}  // namespace taut::bench

int main(int argc, char** argv) { return taut::bench::run(argc, argv); }
