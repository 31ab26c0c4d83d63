// Random scenes without end: the kinetic engine, the spacetime engine and the verified proof must agree on each, and
// none may be undecided. `./dev soak --minutes N` builds and runs it.
#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <map>
#include <mutex>
#include <sstream>
#include <thread>

#include "check/proof_writer.hpp"
#include "soak_scene.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/proof.hpp"

namespace taut::testing {
namespace {

struct Tally {
  std::uint64_t scenes = 0, free = 0, contact = 0, at_start = 0, invalid = 0, events = 0, proofs = 0;

  void add(const Tally& o) {
    scenes += o.scenes;
    free += o.free;
    contact += o.contact;
    at_start += o.at_start;
    invalid += o.invalid;
    events += o.events;
    proofs += o.proofs;
  }
};

struct Totals {
  std::map<std::string, Tally> by_family, by_injection;
  StageCounts stages;
  std::vector<std::string> findings;
};

/// A writer that also counts which stage answered.
class CountingWriter : public ProofWriter {
 public:
  using ProofWriter::ProofWriter;
  void ended(const Session& session, const Answer& answer) override {
    stages = session.engine().stages();
    ProofWriter::ended(session, answer);
  }
  StageCounts stages;
};

/// What a proof says must be what the engines say.
std::string refutation(const Answer& answer, const Verified& v) {
  if (v.outcome != answer.outcome) return "the proof has another outcome";
  if (v.events != answer.events) return "the proof has another number of events";
  if (!answer.contact) return {};
  const bool apart = v.contact->time.hi < answer.contact->time.lo || answer.contact->time.hi < v.contact->time.lo;
  return apart ? "the proof has another time of contact" : std::string();
}

/// Empty if all agree.
std::string examine(const SoakScene& s, Tally& tally, StageCounts& stages) {
  ++tally.scenes;
  CheckOptions options;
  options.touch = s.touch;
  std::ostringstream log;
  CountingWriter writer(s.scene, s.touch, log);
  try {
    const Answer kinetic = run_kinetic(s.scene, options, &writer);
    const Answer answer = agreed(kinetic, run_spacetime(s.scene, options));
    stages.fast += writer.stages.fast;
    stages.level1 += writer.stages.level1;
    stages.precise += writer.stages.precise;
    stages.compared += writer.stages.compared;
    tally.events += kinetic.events;
    if (kinetic.outcome == Outcome::undecided) return "undecided: " + kinetic.reason;
    if (answer.outcome == Outcome::overlap_at_start) {
      ++tally.at_start;
      return {};
    }
    ++(answer.outcome == Outcome::free ? tally.free : tally.contact);
    std::istringstream in(log.str());
    const std::string wrong = refutation(kinetic, verify(s.scene, in));
    tally.proofs += wrong.empty();
    return wrong;
  } catch (const InputError&) {
    ++tally.invalid;
    return {};
  } catch (const std::exception& error) {
    return error.what();
  }
}

class Soak {
 public:
  Soak(std::uint64_t first, double minutes, std::string folder)
      : next_(first),
        folder_(std::move(folder)),
        end_(Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(60 * minutes))) {}

  void work() {
    Totals mine;
    while (Clock::now() < end_) {
      const std::uint64_t number = next_++;
      const SoakScene s = soak_scene(number);
      Tally tally;
      const std::string wrong = examine(s, tally, mine.stages);
      mine.by_family[s.family].add(tally);
      mine.by_injection[to_string(s.injection)].add(tally);
      if (!wrong.empty()) note(number, s, wrong);
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const auto& [name, tally] : mine.by_family) totals_.by_family[name].add(tally);
    for (const auto& [name, tally] : mine.by_injection) totals_.by_injection[name].add(tally);
    totals_.stages.fast += mine.stages.fast;
    totals_.stages.level1 += mine.stages.level1;
    totals_.stages.precise += mine.stages.precise;
    totals_.stages.compared += mine.stages.compared;
  }

  /// 0 if nothing was found.
  int report() const {
    Tally all;
    for (const auto& [name, tally] : totals_.by_family) all.add(tally);
    table("family", totals_.by_family);
    table("injection", totals_.by_injection);
    fmt::print(
        "steps decided in doubles: {}; by first order in the displacement: {}; searches and comparisons in\n"
        "multi-precision: {} and {}\n",
        totals_.stages.fast, totals_.stages.level1, totals_.stages.precise, totals_.stages.compared);
    fmt::print("{} scenes, {} findings; the next scene is {}\n", all.scenes, totals_.findings.size(), next_.load());
    for (const std::string& finding : totals_.findings) fmt::print("  {}\n", finding);
    return totals_.findings.empty() ? 0 : 1;
  }

 private:
  using Clock = std::chrono::steady_clock;

  void note(std::uint64_t number, const SoakScene& s, const std::string& wrong) {
    const std::string file = fmt::format("{}/{}.json", folder_, number);
    const std::lock_guard<std::mutex> lock(mutex_);
    totals_.findings.push_back(
        fmt::format("{}, {}, {}, touch {}: {}", file, s.family, to_string(s.injection), to_string(s.touch), wrong));
    fmt::print(stderr, "{}\n", totals_.findings.back());
    write_file(file, write_scene(s.scene));
  }

  static void table(const char* what, const std::map<std::string, Tally>& rows) {
    fmt::print("| {} | scenes | free | contact | overlap at the start | invalid | proofs verified | events |\n", what);
    fmt::print("|---|---|---|---|---|---|---|---|\n");
    Tally all;
    const auto row = [](const std::string& name, const Tally& t) {
      fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} |\n", name, t.scenes, t.free, t.contact, t.at_start,
                 t.invalid, t.proofs, t.events);
    };
    for (const auto& [name, tally] : rows) {
      row(name, tally);
      all.add(tally);
    }
    row("all", all);
    fmt::print("\n");
  }

  std::atomic<std::uint64_t> next_;
  std::string folder_;
  Clock::time_point end_;
  std::mutex mutex_;
  Totals totals_;
};

}  // namespace
}  // namespace taut::testing

int main(int argc, char** argv) {
  double minutes = 1;
  std::uint64_t first = 0;
  unsigned jobs = 2;
  std::string folder = ".";
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string name = argv[i];
    if (name == "--minutes") minutes = std::atof(argv[i + 1]);
    if (name == "--first") first = std::strtoull(argv[i + 1], nullptr, 10);
    if (name == "--jobs") jobs = static_cast<unsigned>(std::atoi(argv[i + 1]));
    if (name == "--findings") folder = argv[i + 1];
  }
  taut::testing::Soak soak(first, minutes, folder);
  std::vector<std::thread> threads;
  for (unsigned k = 0; k < jobs; ++k) threads.emplace_back([&soak] { soak.work(); });
  for (std::thread& thread : threads) thread.join();
  return soak.report();
}
