// Random scenes without end: the kinetic engine, the spacetime engine and the verified proof must agree on each, and
// with the oracle by definition if the scene is small; none may be undecided. With --worlds, scenes of several bodies,
// and all that is asked about them. `./dev soak --minutes N` builds and runs it.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <map>
#include <mutex>
#include <sstream>
#include <thread>

#include "command_line/command_line.hpp"
#include "curve_examination.hpp"
#include "prove/proof_writer.hpp"
#include "question_examination.hpp"
#include "question_times.hpp"
#include "soak_scene.hpp"
#include "soak_totals.hpp"
#include "support/carried_scene.hpp"
#include "support/exact_comparison.hpp"
#include "support/prepared_scene.hpp"
#include "support/simulated_run.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/proof.hpp"
#include "world_examination.hpp"

namespace taut::testing {
using namespace internal;
namespace {

Answer answer_of(const Scene& scene, CheckOptions options, EngineChoice engine) {
  options.engine = engine;
  return run_engines(scene, options);
}

/// What a proof says must be what the engines say.
std::string refutation(const Answer& answer, const Verified& v) {
  if (v.outcome != answer.outcome) return "the proof has another outcome";
  if (v.events != answer.events) return "the proof has another number of events";
  if (!answer.contact) return {};
  const bool apart = v.contact->time.hi < answer.contact->time.lo || answer.contact->time.hi < v.contact->time.lo;
  return apart ? "the proof has another time of contact" : std::string();
}

/// Prepared shapes must not change anything.
std::string prepared_difference(const SoakScene& s, const CheckOptions& options, const Answer& bare) {
  const Answer answer = answer_of(prepared(s.scene), options, EngineChoice::kinetic);
  if (answer.outcome != bare.outcome) return "prepared shapes give another outcome";
  if (answer.events != bare.events) return "prepared shapes give another number of events";
  if (!bare.contact) return {};
  const TimeInterval &a = answer.contact->time, &b = bare.contact->time;
  return a.lo == b.lo && a.hi == b.hi ? "" : "prepared shapes give another time of contact";
}

/// Nor must a parent, to which a part of the motion is left.
std::string carried_difference(const SoakScene& s, const CheckOptions& options, bool turned, const Answer& bare) {
  const auto orbits = [](const MotionPiece& piece) { return !piece.orbit.angle.empty(); };
  const std::vector<MotionPiece>& pieces = s.scene.bodies[1].motion.pieces;
  if (pieces.empty() || std::any_of(pieces.begin(), pieces.end(), orbits)) return {};
  CheckOptions both = options;
  both.engine = EngineChoice::both;
  const Answer answer = check(carried(s.scene, turned), both);
  if (answer.outcome != bare.outcome) return std::string("with a parent: ") + to_string(answer.outcome) + answer.reason;
  if (!bare.contact) return {};
  const TimeInterval &a = answer.contact->time, &b = bare.contact->time;
  return a.lo <= b.hi && b.lo <= a.hi ? "" : "a parent gives another time of contact";
}

struct Limits {
  double minutes = 1;
  unsigned jobs = 2;
  double seconds = 1e300;       ///< for each engine and scene
  std::size_t oracle_size = 0;  ///< vertices of the scenes that the oracle judges
  bool contacts = false;        ///< soak_contact_scene(), not soak_scene()
  bool worlds = false;          ///< soak_world()
  bool questions = false;       ///< all questions about small scenes
  bool curves = false;          ///< curved_soak_scene()
  bool simulations = false;     ///< simulations of soak_world() that go on after contacts
};

/// Questions are asked about scenes made of contacts, and others by turns, if they are small.
SoakScene scene_for(std::uint64_t number, const Limits& limits) {
  if (!limits.questions) return limits.contacts ? soak_contact_scene(number) : soak_scene(number);
  if (number % 2 == 0) return soak_contact_scene(number);
  constexpr std::size_t small = 80;
  for (std::uint64_t k = number;; k += 0x100000000) {
    SoakScene s = soak_scene(k);
    if (s.scene.bodies[0].polygon.size() + s.scene.bodies[1].polygon.size() <= small) return s;
  }
}

/// What the oracle says against the answer.
std::string judgement(const SoakScene& s, const Limits& limits, const Answer& answer, Tally& tally) {
  if (s.scene.bodies[0].polygon.size() + s.scene.bodies[1].polygon.size() > limits.oracle_size) return {};
  const exact::ExactAnswer truth = exact::first_contact(s.scene, s.touch);
  ++(truth.verdict == exact::Verdict::beyond ? tally.beyond : tally.judged);
  tally.assumed += truth.assumed;
  return exact::difference(truth, answer, s.scene, s.touch);
}

/// Empty if all agree.
std::string examine(const SoakScene& s, std::uint64_t number, const Limits& limits, Tally& tally, StageCounts& stages) {
  ++tally.scenes;
  CheckOptions options;
  options.touch = s.touch;
  options.limits.max_seconds = limits.seconds;
  std::ostringstream log;
  ProofWriter writer(s.scene, s.touch, log);
  try {
    CheckOptions by_tiling = options;
    by_tiling.engine = EngineChoice::kinetic;
    Run run(s.scene, by_tiling, &writer);
    run.run();
    const Answer kinetic = run.answer_with_touching();
    Answer proved = kinetic;
    writer.end(proved);
    const Answer answer = agreed(kinetic, answer_of(s.scene, options, EngineChoice::spacetime));
    if (run.search()) stages += run.search()->stages();
    tally.events += kinetic.events;
    if (const std::string wrong = judgement(s, limits, answer, tally); !wrong.empty()) return wrong;
    if (kinetic.outcome == Outcome::undecided) return "undecided: " + kinetic.reason;
    if (number % 4 == 0) {
      if (const std::string wrong = prepared_difference(s, options, kinetic); !wrong.empty()) return wrong;
    }
    if (limits.contacts && number % 4 == 1) {
      if (const std::string wrong = carried_difference(s, options, number % 8 == 1, answer); !wrong.empty())
        return wrong;
    }
    if (answer.outcome == Outcome::overlap_at_start) {
      ++tally.at_start;
      return {};
    }
    ++(answer.outcome == Outcome::free ? tally.free : tally.contact);
    std::istringstream in(log.str());
    const Verified verified = verify(s.scene, in);
    std::string wrong = refutation(proved, verified);
    if (wrong.empty() && proved.contact &&
        (proved.contact->time.lo != verified.contact->time.lo || proved.contact->time.hi != verified.contact->time.hi))
      wrong = "the contact is stated with another time than the one that is proved";
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
  Soak(const Limits& limits, std::string totals_file, std::string folder)
      : limits_(limits), totals_file_(std::move(totals_file)), folder_(std::move(folder)) {
    if (!totals_file_.empty()) totals_ = read_soak_totals(totals_file_);
  }

  void skip_to(std::uint64_t scene) { totals_.next_scene = scene; }

  /// In rounds of a minute, each saved: a soak that is ended early loses one.
  void run() {
    const Clock::time_point end = after(Clock::now(), limits_.minutes);
    while (Clock::now() < end) {
      round(limits_.jobs, std::min(end, after(Clock::now(), 1)));
      if (!totals_file_.empty()) write_soak_totals(totals_file_, totals_);
    }
  }

  const SoakTotals& totals() const { return totals_; }

 private:
  using Clock = std::chrono::steady_clock;

  static Clock::time_point after(Clock::time_point start, double minutes) {
    return start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(60 * minutes));
  }

  void round(unsigned jobs, Clock::time_point end) {
    std::atomic<std::uint64_t> next{totals_.next_scene};
    std::vector<SoakTotals> parts(jobs);
    std::vector<std::thread> threads;
    for (SoakTotals& part : parts) {
      threads.emplace_back([this, end, &next, &part] {
        while (Clock::now() < end) look_at(next++, part);
      });
    }
    for (std::thread& thread : threads) thread.join();
    for (const SoakTotals& part : parts) totals_ += part;
    totals_.next_scene = next;
  }

  void look_at_world(std::uint64_t number, SoakTotals& part) {
    const LargeWorld made = soak_world(number);
    Tally tally;
    const std::string wrong = examine_world(number, made, limits_.seconds, tally);
    part.by_family["worlds, " + made.family] += tally;
    if (wrong.empty()) return;
    const std::string file = fmt::format("{}/world-{}.json", folder_, number);
    report(fmt::format("{}, {}: {}", file, made.family, wrong), file, scene_of(made.world), part);
  }

  void look_at_simulation(std::uint64_t number, SoakTotals& part) {
    const LargeWorld made = soak_world(number);
    Tally tally;
    RunTally run;
    const Scene scene = scene_of(made.world);
    ++tally.scenes;
    std::string wrong;
    try {
      wrong = wrong_with_run(number, scene, number % 3 == 2 ? Touch::closed : Touch::open, 100, run);
    } catch (const std::exception& error) {
      wrong = error.what();
    }
    tally.contact += static_cast<std::uint64_t>(run.contacts);
    tally.free += static_cast<std::uint64_t>(run.scenes);
    part.by_family["simulations, " + made.family] += tally;
    if (wrong.empty()) return;
    const std::string file = fmt::format("{}/simulation-{}.json", folder_, number);
    report(fmt::format("{}, {}: {}", file, made.family, wrong), file, scene, part);
  }

  void look_at_curves(std::uint64_t number, SoakTotals& part) {
    const CurvedSoakScene made = curved_soak_scene(number);
    Tally tally;
    const std::string wrong = examine_curves(number, made, limits_.seconds, tally);
    part.by_family[made.family] += tally;
    if (wrong.empty()) return;
    const std::string file = fmt::format("{}/curves-{}.json", folder_, number);
    report(fmt::format("{}, {}: {}", file, made.family, wrong), file, made.scene, part);
  }

  static void report(const std::string& finding, const std::string& file, const Scene& scene, SoakTotals& part) {
    part.findings.push_back(finding);
    fmt::print(stderr, "{}\n", finding);
    write_file(file, write_scene(scene));
  }

  void look_at(std::uint64_t number, SoakTotals& part) {
    if (limits_.worlds) return look_at_world(number, part);
    if (limits_.curves) return look_at_curves(number, part);
    if (limits_.simulations) return look_at_simulation(number, part);
    const SoakScene s = scene_for(number, limits_);
    Tally tally;
    const std::string wrong = limits_.questions ? examine_questions(s, number, limits_.seconds, tally)
                                                : examine(s, number % 4 == 0, limits_, tally, part.stages);
    part.by_family[s.family] += tally;
    part.by_injection[to_string(s.injection)] += tally;
    if (wrong.empty()) return;
    const std::string file = fmt::format("{}/{}{}.json", folder_,
                                         limits_.contacts    ? "contact-"
                                         : limits_.questions ? "questions-"
                                                             : "",
                                         number);
    report(fmt::format("{}, {}, {}, touch {}: {}", file, s.family, to_string(s.injection), to_string(s.touch), wrong),
           file, s.scene, part);
  }

  Limits limits_;
  std::string totals_file_, folder_;
  SoakTotals totals_;
};

/// One scene a line.
void print_scenes(std::uint64_t first, std::uint64_t count, const Limits& limits) {
  for (std::uint64_t k = first; k < first + count; ++k) {
    std::string text = write_scene(limits.worlds || limits.simulations ? scene_of(soak_world(k).world)
                                   : limits.curves                     ? curved_soak_scene(k).scene
                                                                       : scene_for(k, limits).scene);
    text.erase(std::remove(text.begin(), text.end(), '\n'), text.end());
    fmt::print("{}\n", text);
  }
}

/// Whether all of so many scenes' questions are decided, each within the limit. Some threads make each of them slower.
bool time_questions(std::uint64_t first, std::uint64_t count, double limit, const Limits& limits) {
  std::atomic<std::uint64_t> next{first};
  std::vector<QuestionTimes> parts(limits.jobs, QuestionTimes(limit));
  std::vector<std::thread> threads;
  for (QuestionTimes& part : parts) {
    threads.emplace_back([&next, &part, &limits, end = first + count] {
      for (std::uint64_t k = next++; k < end; k = next++) part.ask_all(k, scene_for(k, limits).scene);
    });
  }
  for (std::thread& thread : threads) thread.join();
  QuestionTimes all(limit);
  for (const QuestionTimes& part : parts) all += part;
  fmt::print("{}", all.report());
  return all.all_well();
}

}  // namespace
}  // namespace taut::testing

int main(int argc, char** argv) {
  taut::cli::Program program("Compares both engines and verified proofs on random scenes.", "taut_soak");
  const taut::cli::Command app = program.command();
  taut::testing::Limits limits;
  std::uint64_t first = 0, print = 0, times = 0;
  std::string folder = ".", totals;
  app.add_option("--minutes", limits.minutes, "How long").positive();
  app.add_option("--jobs", limits.jobs, "Threads").within(1, 1024);
  const taut::cli::Option from =
      app.add_option("--first", first, "Number of the first scene; default: after the totals'");
  app.add_option("--oracle", limits.oracle_size, "Judge scenes of up to so many vertices by definition").or_alone("24");
  app.add_flag("--contacts", limits.contacts,
               "Small scenes made of contacts, judged by definition, in place of others");
  app.add_flag("--worlds", limits.worlds,
               "Worlds of 2 to 60 bodies, mostly few, judged by definition, in place of others");
  app.add_flag("--questions", limits.questions,
               "Small scenes, about which all questions are asked, held against each other, in place of others");
  app.add_flag("--curves", limits.curves,
               "Two bodies with curves, held against chords 4096 times finer than a picture's, in place of others");
  app.add_flag(
      "--simulations", limits.simulations,
      "Simulations of worlds that go on after contacts, by all calls there are, held against the rest of their "
      "scenes asked afresh, in place of others; free counts recorded scenes");
  app.add_option("--seconds", limits.seconds, "Limit for each engine and scene").positive();
  app.add_option("--findings", folder, "Folder for the scenes with findings").existing_folder();
  app.add_option("--totals", totals, "File in which the counts of all runs are added up");
  app.add_option("--print", print, "Only print so many scenes, one a line");
  const taut::cli::Option timed =
      app.add_option("--times", times,
                     "Only ask about so many scenes, by each engine alone and by both in turn, both ways of touching, "
                     "and name the questions that are undecided or take more than 50 ms of processor time");
  return taut::cli::run_program(program, argc, argv, [&] {
    if (print > 0) {
      taut::testing::print_scenes(first, print, limits);
      return 0;
    }
    if (timed.given()) return taut::testing::time_questions(first, times, 0.05, limits) ? 0 : 1;
    if (limits.contacts) limits.oracle_size = std::max<std::size_t>(limits.oracle_size, 24);
    taut::testing::Soak soak(limits, totals, folder);
    if (from.given()) soak.skip_to(first);
    soak.run();
    fmt::print("{}", soak.totals().report());
    return soak.totals().findings.empty() ? 0 : 1;
  });
}
