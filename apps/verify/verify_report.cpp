#include "verify_report.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iostream>
#include <sstream>

#include "coverage_text.hpp"
#include "feature_text.hpp"
#include "io/answer_writer.hpp"
#include "io/json_writer.hpp"
#include "io/platform.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "numeric/budget.hpp"
#include "progress.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/motions.hpp"
#include "taut/path_proof.hpp"
#include "taut/proof.hpp"
#include "terminal.hpp"

namespace taut::cli {
using namespace internal;
namespace {

enum : int { exit_proved = 0, exit_not_proved = 1, exit_time_is_up = 3 };

/// When the contact is, as far as that was proved.
std::string contact_time(const Verified& v) {
  const TimeInterval& t = v.contact->time;
  if (v.contact_at == ContactAt::start) return fmt::format("contact at the start, t = {}", t.lo);
  if (v.contact_at == ContactAt::joint)
    return fmt::format("contact at the joint t = {}, in the jump from one piece of a motion to the next", t.hi);
  return fmt::format("{} within [{}, {}]", v.contact->grazing ? "grazing contact" : "contact", t.lo, t.hi);
}

/// The claim of a proof about a clearance.
std::string clearance_claim(const Scene& scene, const Verified& v) {
  const std::string kept = fmt::format("{} keep {} on [{}, {}", v.coverage.untested() > 0 ? "tested pairs" : "all",
                                       v.clearance, scene.start, v.free_until);
  if (v.outcome == Outcome::free) return kept + "]";
  if (v.outcome == Outcome::locked) return kept + "], where the mechanism locks";
  if (v.outcome == Outcome::undecided) return kept + "); nothing after that";
  const CloseFeatures& f = v.closer->features;
  const std::string peer = f.edge ? edge_text(scene, *f.edge) : vertex_text(scene, *f.other);
  const std::string before = v.free_until > scene.start ? kept + "); " : "";
  const std::string when = v.contact_at == ContactAt::start
                               ? fmt::format("as close at the start, t = {}", v.closer->time.lo)
                               : fmt::format("closer within [{}, {}]", v.closer->time.lo, v.closer->time.hi);
  return before + when + ": " + vertex_text(scene, f.vertex) + " and " + peer;
}

/// The claim in words: what holds when.
std::string claim(const Scene& scene, const Verified& v) {
  if (v.clearance > 0) return clearance_claim(scene, v);
  const char* touching = v.touch == Touch::closed ? ", touching included" : "";
  if (v.outcome == Outcome::free || v.outcome == Outcome::locked)
    return fmt::format("free on [{}, {}]{}{}", scene.start, scene.end, touching,
                       v.outcome == Outcome::locked ? ", where the mechanism locks" : "");
  const std::string before =
      v.free_until > scene.start ? fmt::format("free on [{}, {}){}", scene.start, v.free_until, touching) : "";
  if (v.outcome == Outcome::undecided)
    return before.empty() ? fmt::format("apart at the start, t = {}; nothing after that", scene.start)
                          : before + "; nothing after that";
  const Contact& c = *v.contact;
  const auto angle = contact_angle(scene, c);
  const std::string at = angle ? fmt::format(", at an angle within [{}, {}] deg", angle->lo, angle->hi) : "";
  return before + (before.empty() ? "" : "; ") + contact_time(v) + at + ": " + vertex_text(scene, c.vertex) +
         " meets " + edge_text(scene, c.edge);
}

/// How long the proof is.
std::string length_text(const Verified& v) {
  if (v.kind == ProofKind::separations) return io::counted(v.separations, "separation");
  if (v.kind == ProofKind::tiling) return io::counted(v.events, "event");
  return io::counted(v.segments, "straight edge") + ", " +
         (v.separations > 0 ? io::counted(v.separations, "separation") : io::counted(v.events, "event"));
}

std::string pair_text(const Scene& scene) { return subject_text(scene, std::nullopt); }

std::string unmet_text(const Scene& scene, const Expectation& expected, bool met) {
  return met ? "" : fmt::format("  NOT AS EXPECTED: {}\n", text_of(expected, scene));
}

std::string valid_text(const Scene& scene, const Verified& v, const Expectation& expected, bool met) {
  return fmt::format("VALID  {}\n{}  {}\n  touch {}, {}, scene {:.16}\n", pair_text(scene), coverage_text(v.coverage),
                     claim(scene, v), to_string(v.touch), length_text(v), to_hex(v.fingerprint)) +
         unmet_text(scene, expected, met);
}

/// What a log about paths proves: always that there is no way.
std::string valid_text(const Scene& bodies, const VerifiedPath& v, const Expectation& expected, bool met) {
  const std::string how =
      v.barrier > 0 ? fmt::format("a closed polygon of {} displacements", v.barrier)
                    : fmt::format("{} cells, {} shown to collide, {} reached", v.cells, v.colliding, v.reached);
  return fmt::format("VALID  {}\n  no way from the start to the goal{}{}\n  {}, scene {:.16}\n", pair_text(bodies),
                     v.clearance > 0 ? fmt::format(" that keeps {}", v.clearance) : "",
                     v.touch == Touch::closed ? " without touching" : "", how, to_hex(v.fingerprint)) +
         unmet_text(bodies, expected, met);
}

/// The JSON of what a log proves, with what was expected, if anything was.
std::string valid_json(std::string s, const Scene& scene, const Expectation& expected, bool met) {
  if (expected.any())
    s.insert(s.size() - 1,
             fmt::format(",\"expected\":{},\"as_expected\":{}", io::string_text(text_of(expected, scene)), met));
  return s + "\n";
}

/// Calls `read(stream)` with the log.
template <class Read>
auto with_log(const std::string& log, const Read& read) {
  if (log == "-") {
    // It is looked at twice.
    std::stringstream all;
    all << std::cin.rdbuf();
    return read(all);
  }
  io::open_regular_file(log);  // says what is wrong
  std::ifstream file(io::path_of(log), std::ios::binary);
  if (file.peek() == std::ifstream::traits_type::eof())
    throw InputError(log, "the file is empty", "`taut prove` writes proofs");
  return read(file);
}

/// There is no result: the log is not valid, or was not read to its end.
int report_failure(const Scene& scene, bool json, bool refuted, const std::string& reason) {
  if (json) {
    print_text(unverified_json(refuted, reason) + "\n");
  } else {
    print_text(fmt::format("{}  {}\n  {}\n", refuted ? "NOT VALID" : "UNDECIDED", pair_text(scene), reason));
  }
  return refuted ? exit_not_proved : exit_time_is_up;
}

/// Runs `check()`, which verifies the log and returns the exit code, within the limits.
template <class Check>
int within_limits(const VerifyArguments& arguments, const Scene& scene, const Check& check) {
  try {
    const Budget scope(Limits{arguments.max_seconds});
    const Progress progress;
    return check();
  } catch (const ProofError& error) {
    return report_failure(scene, arguments.json, true, error.what());
  } catch (const Interrupted& limit) {
    return report_failure(scene, arguments.json, false, limit.reason);
  }
}

int report_log(const VerifyArguments& arguments, const Scene& scene, std::istream& log) {
  return within_limits(arguments, scene, [&] {
    const Verified verified = verify(scene, log);
    const bool met = is_met(arguments.expected, scene, verified);
    print_text(arguments.json ? valid_json(verified_json(scene, verified), scene, arguments.expected, met)
                              : valid_text(scene, verified, arguments.expected, met));
    return met ? exit_proved : exit_not_proved;
  });
}

int report_path_log(const VerifyArguments& arguments, const PathProblem& problem, std::istream& log) {
  const Scene& bodies = problem.linkage.scene;
  return within_limits(arguments, bodies, [&] {
    const VerifiedPath verified = verify_path(problem, log);
    const bool met = is_met(arguments.expected, verified);
    print_text(arguments.json ? valid_json(verified_path_json(problem, verified), bodies, arguments.expected, met)
                              : valid_text(bodies, verified, arguments.expected, met));
    return met ? exit_proved : exit_not_proved;
  });
}

const char* const exit_codes =
    "\n"
    "Without --until, --expect free wants a proof for the scene's whole time.\n"
    "\n"
    "Exit codes: 0 the proof is valid, and proves what --expect and --touch say; 1 it is not, or does not;\n"
    "2 bad input; 3 the time was up; 4 internal error. Without --expect, whatever a valid proof proves gives 0.\n";

}  // namespace

void add_verify_options(const Command& command, VerifyArguments& arguments, const std::string& example) {
  add_scene(command, arguments.scene);
  add_at_rest(command, arguments.scene.at_rest);
  command.add_option("PROOF", arguments.proof, "proof log, or - for standard input").required().value(" ");
  command.add_flag("--json", arguments.json, "print one JSON object");
  const auto expect = [&arguments](const std::string& outcome) {
    arguments.expected.no_way = outcome == "none";
    if (outcome != "none") arguments.expected.outcome = outcome == "free" ? Outcome::free : Outcome::contact;
  };
  const Option outcome = command.add_choice("--expect", {"free", "contact", "none"}, expect,
                                            "fail unless this is what the log proves; none: that there is no way");
  const auto touch = [&arguments](const std::string& mode) {
    arguments.expected.touch = mode == "closed" ? Touch::closed : Touch::open;
  };
  command.add_choice("--touch", {"open", "closed"}, touch, "fail unless the log was made with this --touch");
  command.add_option("--until", arguments.expected.until, "with --expect: free before T suffices; or, a contact by T")
      .value("T")
      .needs(outcome);
  command
      .add_option("--clearance", arguments.expected.clearance,
                  "fail unless the log proves that bodies keep C, or, with --expect contact, come closer")
      .value("C");
  command.add_option("--max-seconds", arguments.max_seconds, "give up after S seconds").value("S").not_negative();
  command.footer("Example:\n  " + example + "\n  " + example + " --expect free --touch closed\n" + exit_codes);
}

int verify_and_report(const VerifyArguments& arguments) {
  if (arguments.scene.path == "-" && arguments.proof == "-")
    throw InputError("", "the scene and the proof cannot both come from standard input", "name one of the files");
  // What is wrong with what was read is said with its file.
  const auto within_scene = [&](const auto& report) {
    try {
      return report();
    } catch (const InputError& error) {
      const bool about_scene = error.place() != arguments.proof && error.place().rfind("--", 0) != 0;
      throw about_scene ? error.within(display_name(arguments.scene.path)) : error;
    }
  };
  return with_log(arguments.proof, [&](std::istream& log) {
    if (is_path_log(log)) {
      const PathProblem problem = load_path_problem(arguments.scene);
      return within_scene([&] { return report_path_log(arguments, problem, log); });
    }
    const Scene scene = load_scene(arguments.scene);
    return within_scene([&] {
      validate(arguments.expected, scene);
      return report_log(arguments, scene, log);
    });
  });
}

}  // namespace taut::cli
