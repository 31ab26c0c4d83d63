// The spacetime engine and the uncertified yardstick, on the same cases and in the same run.
#include <algorithm>
#include <cmath>
#include <exception>
#include <vector>

#include "bench.hpp"
#include "families.hpp"
#include "motion/motion_segment.hpp"
#include "motion/motion_segments.hpp"
#include "motion/pieces.hpp"
#include "scene/body_pair.hpp"
#include "spacetime/first_contact.hpp"
#include "yardstick.hpp"

namespace taut::bench {
using namespace internal;
namespace {

using spacetime::SpacetimeResult;

/// What is wrong with an answer, a contact within [lo, hi] or none; empty if nothing.
std::string fault(const Case& expected, bool contact, double lo, double hi) {
  if (!contact) return expected.outcome == Outcome::free ? "" : "no contact";
  if (expected.outcome == Outcome::free) return "a contact";
  const double t = expected.contact_time, slack = 1e-12 * std::fabs(t);
  return lo - slack <= t && t <= hi + slack ? "" : "contact at the wrong time";
}

/// A case in the engine's terms.
struct Certified {
  const Case& wanted;
  BodyPair bodies;
  PairGeometry geometry;
  MotionSegments segments;
  SpacetimeResult result;

  explicit Certified(const Case& c)
      : wanted(c),
        bodies(pair_of(c.scene)),
        geometry(displaced_pair(bodies, Offset::inward)),
        segments(segments_of(bodies, c.scene.start, c.scene.end)) {}
  double seconds() {
    const Stopwatch watch;
    const spacetime::Hierarchy p = spacetime::hierarchy_of_p(geometry), q = spacetime::hierarchy_of_q(geometry);
    result = spacetime::first_contact(geometry, {p, q}, segments);
    return watch.seconds();
  }
  std::string fault() const {
    if (result.outcome == SpacetimeResult::undecided) return result.reason;
    const MotionSegment& segment = segments[result.segment];
    return bench::fault(wanted, result.outcome == SpacetimeResult::contact, segment.time(result.lo),
                        segment.time(result.found.hi));
  }
};

struct Uncertified {
  const Case& wanted;
  YardstickAnswer answer;

  double seconds() {
    const Stopwatch watch;
    answer = yardstick(wanted.scene);
    return watch.seconds();
  }
  std::string fault() const { return bench::fault(wanted, answer.contact, answer.time, answer.time); }
};

double median(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

/// Both engines in turn: what the machine does meanwhile slows down both.
void certified(benchmark::State& state, const Case& c) {
  Certified engine(c);
  Uncertified rival{c, {}};
  std::vector<double> ours, theirs;
  for (auto _ : state) {
    theirs.push_back(rival.seconds());
    ours.push_back(engine.seconds());
    state.SetIterationTime(ours.back());
    for (const std::string& wrong : {engine.fault(), rival.fault()}) {
      if (!wrong.empty()) fail(state, wrong);
    }
  }
  state.counters["pairs"] = static_cast<double>(engine.result.pairs);
  state.counters["precise"] = static_cast<double>(engine.result.stages.beyond_doubles());
  state.counters["ratio"] = median(ours) / median(theirs);
  state.counters["roots"] = static_cast<double>(engine.result.roots);
}

void uncertified(benchmark::State& state, const Case& c) {
  Uncertified rival{c, {}};
  for (auto _ : state) {
    state.SetIterationTime(rival.seconds());
    if (const std::string wrong = rival.fault(); !wrong.empty()) fail(state, wrong);
  }
}

void add(const char* engine, void (*action)(benchmark::State&, const Case&), const Family& family, int n, bool quick) {
  const auto guarded = [action, make = family.make, n](benchmark::State& state) {
    try {
      action(state, make(n));
    } catch (const std::exception& error) {
      fail(state, error.what());
    }
  };
  const std::string name = std::string(engine) + "/" + family.name + "/" + std::to_string(n);
  auto* added = benchmark::RegisterBenchmark(name.c_str(), guarded);
  added->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(quick ? 3 : 15);
}

}  // namespace

void register_spacetime(bool quick) {
  for (const Family& family : families()) {
    for (const int n : {64, 256, 1024, 4096}) {
      add("spacetime", certified, family, n, quick);
      add("yardstick", uncertified, family, n, quick);
    }
  }
}

}  // namespace taut::bench
