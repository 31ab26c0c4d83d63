// The static construction of two coastlines: the tiling alone, and all of a session's start.
#include <exception>
#include <string>

#include "bench.hpp"
#include "coastline.hpp"
#include "heap.hpp"
#include "motion/motion_segment.hpp"
#include "motion/motion_segments.hpp"
#include "motion/pieces.hpp"
#include "numeric/errors.hpp"
#include "scene/placement.hpp"
#include "session/world_simulation.hpp"
#include "tiling/planar_map.hpp"
#include "tiling/root_faces.hpp"

namespace taut::bench {
using namespace internal;
namespace {

/// The headland reaches into the bay, and the bridge over its flank goes from one body to the other.
constexpr RootState expected_root = RootState::bridged;

void report(benchmark::State& state, std::size_t vertices, double seconds, std::size_t held, std::size_t peak) {
  const auto n = static_cast<double>(vertices);
  state.counters["B/vertex"] = static_cast<double>(held) / n;
  state.counters["peakB/vertex"] = static_cast<double>(peak) / n;
  state.counters["us/vertex"] = 1e6 * seconds / static_cast<double>(state.iterations()) / n;
}

/// build_tiling on a placement that is there already.
void tiling(benchmark::State& state, std::size_t vertices) {
  const Scene scene = bay(vertices);
  const BodyPair bodies = pair_of(scene);
  const PairGeometry geometry = displaced_pair(bodies, Offset::inward);
  const MotionSegments segments = segments_of(bodies, scene.start, scene.end);
  const Placement placement(geometry, segments.front(), scene.start);
  double seconds = 0;
  std::size_t held = 0, peak = 0;
  bool first = true;
  for (auto _ : state) {
    reset_heap_peak();
    const HeapUse before = heap_use();
    const Stopwatch watch;
    const StaticTiling result = build_tiling(placement);
    const double lap = watch.seconds();
    state.SetIterationTime(lap);
    seconds += lap;
    held = result.map.bytes();
    peak = heap_use().peak - before.live;
    if (result.overlap) {
      fail(state, "overlap");
    } else if (result.root != expected_root) {
      fail(state, std::string("the root is ") + to_string(result.root));
    } else if (first && vertices <= 10000) {
      if (const std::string wrong = find_fault(result.map, placement); !wrong.empty()) fail(state, wrong);
    }
    first = false;
  }
  report(state, vertices, seconds, held, peak);
}

/// Validation, displacement, tiling, first schedule.
void session(benchmark::State& state, std::size_t vertices) {
  const Scene scene = bay(vertices);
  double seconds = 0;
  std::size_t held = 0, peak = 0, certificates = 0;
  for (auto _ : state) {
    reset_heap_peak();
    const HeapUse before = heap_use();
    const Stopwatch watch;
    const WorldSimulation s(scene, Touch::open, UINT64_MAX);
    const double lap = watch.seconds();
    state.SetIterationTime(lap);
    seconds += lap;
    peak = heap_use().peak - before.live;
    if (s.over()) {
      fail(state, "not apart at the start");
      continue;
    }
    const Engine& engine = s.single_pair()->engines()->engine(0);
    held = engine.bytes();
    certificates = engine.initial_certificates();
    if (engine.initial_root() != expected_root)
      fail(state, std::string("the root is ") + to_string(engine.initial_root()));
  }
  report(state, vertices, seconds, held, peak);
  state.counters["certs"] = static_cast<double>(certificates);
}

void add(const char* what, void (*action)(benchmark::State&, std::size_t), bool quick) {
  for (const std::size_t n : {1000u, 10000u, 100000u, 1000000u}) {
    const auto guarded = [action, n](benchmark::State& state) {
      try {
        action(state, n);
      } catch (const Undecidable& limit) {
        fail(state, limit.what);
      } catch (const std::exception& error) {
        fail(state, error.what());
      }
    };
    const std::string name = std::string("static/") + what + "/" + std::to_string(n);
    auto* added = benchmark::RegisterBenchmark(name.c_str(), guarded);
    added->UseManualTime()->Unit(benchmark::kMillisecond);
    if (n >= 100000) added->Iterations(quick ? 1 : 3);
  }
}

}  // namespace

void register_static(bool quick) {
  add("tiling", tiling, quick);
  add("session", session, quick);
}

}  // namespace taut::bench
