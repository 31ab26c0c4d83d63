// Kinetic runs: the start (validation, displacement, static construction, first schedule) and the loop of events, each
// for itself; and changes of plan.
#include <cmath>
#include <exception>
#include <memory>

#include "bench.hpp"
#include "families.hpp"
#include "generators/shapes.hpp"
#include "heap.hpp"
#include "numeric/errors.hpp"
#include "session/world_simulation.hpp"
#include "taut/simulation.hpp"

namespace taut::bench {
using namespace internal;
namespace {

std::size_t vertices(const Scene& scene) { return scene.bodies[0].polygon.size() + scene.bodies[1].polygon.size(); }

/// What is wrong with the answer; empty if nothing.
std::string fault(const Case& expected, const WorldSimulation& simulation) {
  if (simulation.answer().outcome == Outcome::overlap_at_start) return "overlap at the start";
  if (expected.outcome == Outcome::free) {
    return simulation.finished() ? "" : "not free to the end";
  }
  if (!simulation.answer().contact) return "no contact";
  const double t = expected.contact_time, slack = 1e-12 * std::fabs(t);
  const TimeInterval found = simulation.answer().contact->time;
  return found.lo - slack <= t && t <= found.hi + slack ? "" : "contact at the wrong time";
}

void start(benchmark::State& state, const Case& c) {
  const auto n = static_cast<double>(vertices(c.scene));
  double certificates = 0, bytes = 0, peak = 0, seconds = 0;
  for (auto _ : state) {
    reset_heap_peak();
    const HeapUse before = heap_use();
    const Stopwatch watch;
    const WorldSimulation simulation(c.scene, Touch::open, UINT64_MAX);
    const double lap = watch.seconds();
    state.SetIterationTime(lap);
    seconds += lap;
    peak = static_cast<double>(heap_use().peak - before.live);
    bytes = static_cast<double>(simulation.single_pair()->engines()->engine(0).bytes());
    certificates = static_cast<double>(simulation.single_pair()->engines()->engine(0).initial_certificates());
    if (simulation.answer().outcome == Outcome::overlap_at_start) fail(state, "overlap at the start");
  }
  state.counters["certs"] = certificates;
  state.counters["B/vertex"] = bytes / n;
  state.counters["peakB/vertex"] = peak / n;
  state.counters["us/vertex"] = 1e6 * seconds / static_cast<double>(state.iterations()) / n;
}

/// Totals over all iterations of one benchmark.
struct Totals {
  double seconds = 0;
  std::uint64_t events = 0, allocations = 0, precise = 0;
  std::size_t certificates = 0;

  void report(benchmark::State& state) const {
    const auto rounds = static_cast<double>(state.iterations());
    const auto all = static_cast<double>(events);
    state.counters["allocs"] = static_cast<double>(allocations) / rounds;
    state.counters["certs"] = static_cast<double>(certificates);
    state.counters["events"] = all / rounds;
    state.counters["events/s"] = all / seconds;
    state.counters["precise"] = static_cast<double>(precise) / rounds;
    state.counters["us/event"] = events > 0 ? 1e6 * seconds / all : 0;
  }
};

/// Buffers that belong to the thread grow when first used.
void warm_up(const Case& c) {
  WorldSimulation simulation(c.scene, Touch::open, UINT64_MAX);
  simulation.advance(c.scene.end);
}

constexpr std::uint64_t allocations_of_run = 10;
/// Of two segments.
constexpr std::uint64_t allocations_of_piece = 32;

void events(benchmark::State& state, const Case& c) {
  Totals totals;
  warm_up(c);
  for (auto _ : state) {
    WorldSimulation simulation(c.scene, Touch::open, UINT64_MAX);
    const std::uint64_t beyond = simulation.single_pair()->engines()->engine(0).stages().beyond_doubles();
    const std::uint64_t allocations = heap_use().allocations;
    const Stopwatch watch;
    simulation.advance(c.scene.end);
    const double lap = watch.seconds();
    state.SetIterationTime(lap);
    totals.seconds += lap;
    totals.allocations += heap_use().allocations - allocations;
    const Engine& engine = simulation.single_pair()->engines()->engine(0);
    totals.events += engine.events();
    totals.certificates = engine.max_certificates();
    totals.precise += engine.stages().beyond_doubles() - beyond;
    if (const std::string wrong = fault(c, simulation); !wrong.empty()) fail(state, wrong);
  }
  totals.report(state);
  // A few times a run: the answer, and room for models around the first singular instant. Segments are constructed
  // where the engine reaches them, two for each piece of a motion. No event allocates.
  const std::size_t pieces = c.scene.bodies[0].motion.pieces.size() + c.scene.bodies[1].motion.pieces.size();
  const std::uint64_t most = allocations_of_run + (pieces > 2 ? allocations_of_piece * pieces : 0);
  if (totals.allocations > most * static_cast<std::uint64_t>(state.iterations()))
    fail(state, "the event loop allocates");
}

/// A comb wanders in the slots of another one; a new velocity each unit of time.
void plan_changes(benchmark::State& state, int n) {
  const int changes = 200;
  const Scene scene = resting_combs(n, changes);
  Totals totals;
  for (auto _ : state) {
    gen::Random random(5);
    Simulation simulation(scene);
    Point at{0, 0};
    double seconds = 0;
    for (int k = 0; k < changes; ++k) {
      const Point to{random.uniform(-0.08, 0.08), random.uniform(-0.3, 0.3)}, speed{to.x - at.x, to.y - at.y};
      const Motion motion{{gen::translation({at.x - speed.x * k, speed.x}, {at.y - speed.y * k, speed.y})}};
      at = to;
      const std::uint64_t allocations = heap_use().allocations;
      const Stopwatch watch;
      simulation.set_motion(1, motion);
      simulation.advance_to(k + 1);
      seconds += watch.seconds();
      totals.allocations += heap_use().allocations - allocations;
    }
    state.SetIterationTime(seconds);
    totals.seconds += seconds;
    totals.events += simulation.events();
    totals.certificates = simulation.certificates_max();
    if (simulation.state() != SimulationState::finished) fail(state, "not free to the end");
  }
  totals.report(state);
  for (const char* name : {"events/s", "precise", "us/event"}) state.counters.erase(name);
  state.counters["us/change"] = 1e6 * totals.seconds / static_cast<double>(state.iterations()) / changes;
}

template <class Action>
benchmark::internal::Benchmark* add(const std::string& name, const Action& action) {
  const auto guarded = [action](benchmark::State& state) {
    try {
      action(state);
    } catch (const Undecidable& limit) {
      fail(state, limit.what);
    } catch (const std::exception& error) {
      fail(state, error.what());
    }
  };
  return benchmark::RegisterBenchmark(name.c_str(), guarded)->UseManualTime()->Unit(benchmark::kMillisecond);
}

/// Enough to be steady; few where one run takes long. Untimed starts make Google's own choice too slow.
int rounds(int n, bool quick) {
  const int full = n <= 64 ? 40 : (n <= 256 ? 20 : (n <= 1024 ? 10 : 5));
  return quick ? (full + 7) / 8 : full;
}

}  // namespace

void register_kinetic(bool quick) {
  const int sizes[] = {64, 256, 1024, 4096};
  for (const Family& family : families()) {
    for (const int n : sizes) {
      const std::string name = std::string(family.name) + "/start/" + std::to_string(n);
      add(name, [make = family.make, n](benchmark::State& state) { start(state, make(n)); });
    }
    for (const int n : sizes) {
      const std::string name = std::string(family.name) + "/events/" + std::to_string(n);
      add(name, [make = family.make, n](benchmark::State& state) {
        events(state, make(n));
      })->Iterations(rounds(n, quick));
    }
  }
  for (const int n : sizes) {
    add("plans/200/" + std::to_string(n), [n](benchmark::State& state) {
      plan_changes(state, n);
    })->Iterations(std::max(1, rounds(n, quick) / 2));
  }
}

}  // namespace taut::bench
