#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "commands.hpp"
#include "interrupt.hpp"
#include "io/answer_writer.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "margin_report.hpp"
#include "path_report.hpp"
#include "report.hpp"
#include "scene_argument.hpp"
#include "taut/io.hpp"
#include "taut/path_proof.hpp"
#include "taut/proof.hpp"
#include "terminal.hpp"
#include "watched_run.hpp"

namespace taut::cli {
using namespace internal;

namespace {

struct ProveArguments {
  SceneSource scene;
  std::string output;
  CheckOptions options;
  std::optional<double> clearance, tolerance;
  bool json = false, allow_untested = false, exact = false;
};

/// The answer as the command prints it, and, if a proof was written, where.
void print_proved(const ProveArguments& arguments, const Scene& scene, std::string json, const std::string& words,
                  bool proof) {
  const std::string id = to_hex(scene_fingerprint(scene, arguments.options.touch));
  if (arguments.json) {
    if (proof) json.insert(json.size() - 1, ",\"scene_sha256\":\"" + id + "\"");
    if (!proof) fmt::print(stderr, "taut: {}\n", not_written("proof", arguments.output));
    return print_text(json + "\n");
  }
  print_text(words);
  print_text(proof ? "  proof in " + io::line_for_terminal(arguments.output) + ", scene " + id.substr(0, 16) + "\n"
                   : "  " + not_written("proof", arguments.output) + "\n");
}

int run_prove_clearance(const ProveArguments& arguments) {
  const Scene scene = load_scene(arguments.scene);
  const double clearance = *arguments.clearance;
  io::AtomicFile file(arguments.output);
  CheckOptions options = arguments.options;
  options.limits.stop = stop_on_signals();
  const MarginAnswer answer =
      watched(scene, arguments.scene.path, [&] { return prove_clearance(scene, clearance, file.stream(), options); });
  const bool proof = answer.outcome == Outcome::free || answer.outcome == Outcome::locked ||
                     answer.outcome == Outcome::contact ||
                     (answer.outcome == Outcome::undecided && answer.free_until > scene.start);
  if (proof) file.commit();
  print_proved(arguments, scene, margin_json(scene, clearance, answer, options.touch),
               margin_in_words(scene, clearance, answer), proof);
  return exit_code(answer.outcome, arguments.allow_untested);
}

/// Of a scene with joints: the proof that there is no way from its start to its goal.
int run_prove_path(const ProveArguments& arguments) {
  const PathProblem problem = load_path_problem(arguments.scene);
  PathOptions options;
  options.touch = arguments.options.touch;
  options.clearance = arguments.clearance.value_or(0);
  if (arguments.tolerance) options.tolerance = *arguments.tolerance;
  options.limits = arguments.options.limits;
  options.limits.stop = stop_on_signals();
  io::AtomicFile file(arguments.output);
  std::optional<Progress> progress(std::in_place);
  const PathAnswer answer =
      within_file(arguments.scene.path, [&] { return prove_path(problem, file.stream(), options); });
  progress.reset();
  const bool proof = answer.outcome == PathOutcome::none;
  if (proof) file.commit();
  const char* const remedy =
      answer.outcome == PathOutcome::path ? "; to prove the way, prove the scene that `taut path -o` writes" : "";
  if (arguments.json) {
    if (!proof) fmt::print(stderr, "taut: {}{}\n", not_written("proof", arguments.output), remedy);
    print_text(path_json(problem, answer, options) + "\n");
  } else {
    print_text(path_in_words(problem, answer));
    print_text(proof ? "  proof in " + io::line_for_terminal(arguments.output) + ", scene " +
                           to_hex(path_fingerprint(problem)).substr(0, 16) + "\n"
                     : "  " + not_written("proof", arguments.output) + remedy + "\n");
  }
  return exit_code(answer.outcome, arguments.allow_untested);
}

int run_prove(const ProveArguments& arguments) {
  const Scene scene = load_scene(arguments.scene);
  io::AtomicFile file(arguments.output);
  const Answer answer = watched_run(
      scene, arguments.scene.path, arguments.options, [&file, &arguments](const Scene& s, const CheckOptions& options) {
        return arguments.exact ? prove_exact(s, file.stream(), options) : prove(s, file.stream(), options);
      });
  // There is nothing to prove about bodies that overlap from the start, or where nothing was decided. Exact logs prove
  // no contact, but that there is none before.
  const bool contact = answer.contact && !arguments.exact;
  const bool proof = answer.outcome == Outcome::free || contact || answer.free_until > scene.start;
  if (proof) file.commit();
  std::string words = report(scene, answer, arguments.options.touch);
  std::string json = answer_json(scene, answer, arguments.options.touch, std::nullopt);
  if (proof && arguments.exact) {
    const double until = answer.outcome == Outcome::free ? scene.end : answer.free_until;
    words += fmt::format("  the exact log is about [{}, {}]\n", scene.start, until);
    json.insert(json.size() - 1, ",\"exact_until\":" + io::number_text(until));
  }
  print_proved(arguments, scene, std::move(json), words, proof);
  return exit_code(answer.outcome, arguments.allow_untested);
}

}  // namespace

void add_prove(const Command& app, Action& action) {
  const Command command = app.add_command("prove", "Check a scene and write a proof of the answer");
  const auto arguments = std::make_shared<ProveArguments>();
  add_run(command, arguments->scene, arguments->options);
  add_allow_untested(command, arguments->allow_untested);
  add_engine(command, arguments->options.engine);
  command.add_option("-o,--output", arguments->output, "the proof log to write").required().value("FILE");
  command.add_option("--clearance", arguments->clearance, "prove that bodies keep the distance C, or when they do not")
      .value("C");
  command
      .add_option("--tolerance", arguments->tolerance,
                  "of a scene with joints: divide cells down to this share of each range (1e-4)")
      .value("X");
  command.add_flag(
      "--exact", arguments->exact,
      "write an exact log, for the checker that is proved; touching counts, the log ends before a contact");
  command.add_flag("--json", arguments->json, "print the answer as one JSON object");
  command.footer(
      "Example:\n"
      "  taut prove scene.json -o scene.proof; taut verify scene.json scene.proof\n"
      "\n"
      "The proof of two bodies is the one of the engine that answers first: the way of a tiling (--engine kinetic), "
      "or\n"
      "separations (--engine spacetime, and scenes of more bodies). That of bodies with curves is polygons around and\n"
      "within them, and such proofs about these. Of a scene with joints, a start and a goal it is proved that there "
      "is\n"
      "no way; for the proof of a way, prove the scene that `taut path -o` writes.\n"
      "\n"
      "Exit codes as for `taut check`, and for `taut path` of a scene with a goal. An undecided run proves what it has "
      "done. If a limit or Ctrl-C stops the\n"
      "proof of two polygons itself, the log proves a part of the time, and the answer says which; of more bodies, "
      "and\n"
      "of curves, there is then no log.\n");
  command.on_chosen([&action, arguments] {
    action = [arguments] {
      if (has_joints(arguments->scene)) {
        if (arguments->exact) throw InputError("--exact", "the scene has joints instead of a time", "leave it out");
        return run_prove_path(*arguments);
      }
      if (arguments->exact && arguments->clearance)
        throw InputError("--exact", "exact proofs are about contact, not about a clearance",
                         "leave one of the two out");
      if (arguments->exact) arguments->options.touch = Touch::closed;
      if (arguments->tolerance)
        throw InputError("--tolerance", "it is about joints, and the scene has a time", "leave it out");
      return arguments->clearance ? run_prove_clearance(*arguments) : run_prove(*arguments);
    };
  });
}

}  // namespace taut::cli
