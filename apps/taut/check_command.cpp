#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>

#include "check_batch.hpp"
#include "commands.hpp"
#include "feature_text.hpp"
#include "interrupt.hpp"
#include "io/answer_writer.hpp"
#include "margin_report.hpp"
#include "report.hpp"
#include "taut/check.hpp"
#include "taut/clearance.hpp"
#include "taut/io.hpp"
#include "terminal.hpp"
#include "watched_run.hpp"

namespace taut::cli {
using namespace internal;

namespace {

struct CheckArguments {
  AskedScene scene;
  CheckOptions options;
  bool json = false, timing = false;
  bool time_tolerance = false;  ///< was it given?
  double clearance = 0;         ///< 0: none was asked for
  std::string svg = {};         ///< a picture of the answer about a clearance
};

CheckArguments single(const CheckBatch& batch) {
  return {{batch.source_of(batch.paths.front()), batch.allow_untested},
          batch.options,
          batch.json,
          batch.timing,
          batch.time_tolerance};
}

/// All that is needed to see a disagreement again. On standard error, and whole: the scene may have come from a pipe.
void print_disagreement(const Scene& scene, Touch touch, const EngineDisagreement& error) {
  fmt::print(stderr, "taut: {}\nkinetic:   {}\nspacetime: {}\nscene:\n{}\n", error.what(),
             answer_json(scene, error.kinetic(), touch), answer_json(scene, error.spacetime(), touch),
             write_scene(scene));
}

/// Nobody is to believe that the answer would be another one without it.
void note_time_tolerance(const Scene& scene, const CheckArguments& arguments) {
  const bool curved =
      std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const Body& body) { return !body.curves.empty(); });
  if (arguments.time_tolerance && !curved)
    fmt::print(stderr,
               "taut: note: --time-tolerance changes nothing, since no body has curves: the times of polygons "
               "are as exact as doubles\n");
}

int run_check(const CheckArguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  const Scene scene = load_scene(arguments.scene.source);
  const double read_seconds = seconds_since(start);
  note_time_tolerance(scene, arguments);
  Answer answer;
  try {
    answer = watched_run(scene, arguments.scene.source.path, arguments.options, check);
  } catch (const EngineDisagreement& error) {
    print_disagreement(scene, arguments.options.touch, error);
    throw;
  }
  const AnswerTiming timing{read_seconds, answer.build_seconds, answer.run_seconds};
  if (arguments.json) {
    const auto wanted = arguments.timing ? std::optional(timing) : std::nullopt;
    print_text(answer_json(scene, answer, arguments.options.touch, wanted) + "\n");
  } else {
    print_text(report(scene, answer, arguments.options.touch));
    if (arguments.timing) {
      print_text(fmt::format("  read {}, build {}, run {}\n", seconds_text(timing.read), seconds_text(timing.build),
                             seconds_text(timing.run)));
    }
  }
  return exit_code(answer.outcome, arguments.scene.allow_untested);
}

int run_margin(const CheckArguments& arguments) {
  const Scene scene = load_scene(arguments.scene.source);
  CheckOptions options = arguments.options;
  options.limits.stop = stop_on_signals();
  const MarginAnswer answer =
      watched(scene, arguments.scene.source.path, [&] { return check_clearance(scene, arguments.clearance, options); });
  if (!arguments.svg.empty()) write_output(arguments.svg, margin_svg(scene, arguments.clearance, answer));
  // What goes to standard output is one thing.
  if (arguments.svg != "-")
    print_text(arguments.json ? margin_json(scene, arguments.clearance, answer, options.touch) + "\n"
                              : margin_in_words(scene, arguments.clearance, answer));
  return exit_code(answer.outcome, arguments.scene.allow_untested);
}

/// Answers of one scene are not introduced by its name, and may have a picture.
int check_one(const CheckBatch& batch, const std::string& svg) {
  CheckArguments arguments = single(batch);
  arguments.clearance = batch.clearance;
  arguments.svg = svg;
  return batch.clearance > 0 ? run_margin(arguments) : run_check(arguments);
}

/// For scenes by the thousands. The share of them that is asked about.
std::shared_ptr<std::string> add_batch(const Command& command, CheckBatch& arguments) {
  command.add_flag("--lines", arguments.lines, "SCENE holds a scene on every line (JSON Lines)");
  command.add_option("--threads", arguments.threads, "for several scenes; answers come in the scenes' order")
      .value("N")
      .within(1, 1024);
  const auto shard = std::make_shared<std::string>();
  command.add_option("--shard", *shard, "of every N scenes check the I-th, from 1 on: N runs then check all of them")
      .value("I/N");
  command
      .add_option("--resume", arguments.resume,
                  "append the answers to a file, and leave out the scenes that it has answers to")
      .value("FILE");
  command.add_option("--junit", arguments.junit, "write a JUnit report for CI servers, a test case for each scene")
      .value("FILE");
  return shard;
}

const char* const check_footer =
    "Example:\n"
    "  taut check --touch closed scene.json\n"
    "  taut check --json a.json b.json c.json     several scenes: one answer each, and the worst exit code of all\n"
    "  taut check --json --lines scenes.jsonl     one scene on each line\n"
    "  taut check --json --lines scenes.jsonl --shard 3/8 --resume answers-3.jsonl\n"
    "                                             one run of eight, which may be killed, and goes on where it was\n"
    "  taut check --clearance 0.3 --junit report.xml a.json b.json\n"
    "                                             for CI: do all keep this distance?\n"
    "\n"
    "A scene is a JSON file:\n"
    "  {\"format\":\"taut-scene/1\",\"time\":[0,10],\"bodies\":[\n"
    "    {\"name\":\"anvil\",\"polygon\":[[0,0],[4,0],[4,1],[0,1]]},\n"
    "    {\"name\":\"hammer\",\"polygon\":[[1,5],[3,5],[2,6]],\"motion\":{\"y\":[0,-0.5]}}]}\n"
    "\n"
    "Exit codes: 0 free, 1 contact or overlap at the start, 2 bad input, or no pair was tested, 3 undecided, or a\n"
    "mechanism locks before the end, 4 internal error.\n";

}  // namespace

void add_check(const Command& app, Action& action) {
  const Command command = app.add_command("check", "Say whether and when bodies of a scene first collide");
  const auto arguments = std::make_shared<CheckBatch>();
  command.add_option("SCENE", arguments->paths, "scene files (taut-scene/1), or - for standard input")
      .required()
      .value(" ");
  add_allow_outside(command, arguments->allow_outside);
  add_at_rest(command, arguments->at_rest);
  add_allow_untested(command, arguments->allow_untested);
  add_touch(command, arguments->options.touch);
  add_limits(command, arguments->options);
  command.add_flag("--json", arguments->json, "print one JSON object for each scene");
  command.add_flag("--timing", arguments->timing, "say how long reading, building and running took");
  const auto shard = add_batch(command, *arguments);
  const auto pairs = [arguments](const std::string& which) { arguments->options.all_pairs = which == "all"; };
  command.add_choice("--pairs", {"first", "all"}, pairs,
                     "first: up to the first contact of any pair; all: each tested pair's own first contact");
  add_engine(command, arguments->options.engine);
  command
      .add_option("--fit", arguments->options.fit,
                  "shrink bodies by E to 2 E first: overlaps by rounding are none then")
      .value("E");
  const Option time_tolerance =
      command
          .add_option("--time-tolerance", arguments->options.time_tolerance,
                      "how precisely to find the time of a contact of curves, as a share of the scene's time (1e-9);\n"
                      "times of polygons are as exact as doubles, whatever it is")
          .value("X");
  const Option margin = command
                            .add_option("--clearance", arguments->clearance,
                                        "ask whether bodies keep at least this distance, in the scene's units")
                            .value("C")
                            .positive();
  const auto svg = std::make_shared<std::string>();
  command.add_option("--svg", *svg, "with --clearance, draw the bodies where they first come closer to FILE")
      .value("FILE")
      .needs(margin);
  command.footer(check_footer);
  command.on_chosen([&action, arguments, shard, svg, time_tolerance] {
    arguments->time_tolerance = time_tolerance.given();
    action = [arguments, shard, svg] {
      if (!shard->empty()) arguments->shard = shard_of(*shard);
      const bool one = arguments->paths.size() == 1 && !arguments->lines && shard->empty() &&
                       arguments->resume.empty() && arguments->junit.empty();
      if (one) return check_one(*arguments, *svg);
      if (!svg->empty())
        throw InputError("--svg", "it draws one scene", "leave out --lines, --shard, --junit and the other scenes");
      return check_batch(*arguments);
    };
  });
}

}  // namespace taut::cli
