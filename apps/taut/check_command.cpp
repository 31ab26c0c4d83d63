#include <fmt/format.h>

#include <chrono>
#include <memory>

#include "check_batch.hpp"
#include "commands.hpp"
#include "io/answer_json.hpp"
#include "report.hpp"
#include "taut/check.hpp"
#include "taut/io.hpp"
#include "terminal.hpp"
#include "watched_run.hpp"

namespace taut::cli {

namespace {

struct CheckArguments {
  SceneSource scene;
  CheckOptions options;
  bool json = false, timing = false;
};

CheckArguments single(const CheckBatch& batch) {
  return {{batch.paths.front(), batch.allow_outside}, batch.options, batch.json, batch.timing};
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// All that is needed to see a disagreement again. On standard error, and whole: the scene may have come from a pipe.
void print_disagreement(const Scene& scene, Touch touch, const EngineDisagreement& error) {
  fmt::print(stderr, "taut: {}\nkinetic:   {}\nspacetime: {}\nscene:\n{}\n", error.what(),
             answer_json(scene, error.kinetic(), touch), answer_json(scene, error.spacetime(), touch),
             write_scene(scene));
}

int run_check(const CheckArguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  const Scene scene = load_scene(arguments.scene);
  const double read_seconds = seconds_since(start);
  Answer answer;
  try {
    answer = watched_run(scene, arguments.scene.path, arguments.options, check);
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
      fmt::print("  read {}, build {}, run {}\n", seconds_text(timing.read), seconds_text(timing.build),
                 seconds_text(timing.run));
    }
  }
  return exit_code(answer.outcome);
}

}  // namespace

void add_check(const Command& app, Action& action) {
  const Command command = app.add_command("check", "Say whether and when bodies of a scene first collide");
  const auto arguments = std::make_shared<CheckBatch>();
  command.add_option("SCENE", arguments->paths, "scene files (taut-scene/1), or - for standard input")
      .required()
      .value(" ");
  add_allow_outside(command, arguments->allow_outside);
  add_touch(command, arguments->options.touch);
  add_limits(command, arguments->options);
  command.add_flag("--json", arguments->json, "print one JSON object for each scene");
  command.add_flag("--timing", arguments->timing, "tell how long reading, building and running took");
  command.add_flag("--lines", arguments->lines, "SCENE holds a scene on every line (JSON Lines)");
  command.add_option("--threads", arguments->threads, "for several scenes; answers come in the scenes' order")
      .value("N")
      .within(1, 1024);
  const auto pairs = [arguments](const std::string& which) { arguments->options.all_pairs = which == "all"; };
  command.add_choice("--pairs", {"first", "all"}, pairs,
                     "first: up to the first contact of any pair; all: each pair's own first contact");
  add_engine(command, arguments->options.engine);
  command.footer(
      "Example:\n"
      "  taut check --touch closed scene.json\n"
      "  taut check --json a.json b.json c.json     several scenes: one answer each, and the worst exit code of all\n"
      "  taut check --json --lines scenes.jsonl     one scene on each line\n"
      "\n"
      "A scene is a JSON file:\n"
      "  {\"format\":\"taut-scene/1\",\"time\":[0,10],\"bodies\":[\n"
      "    {\"name\":\"anvil\",\"polygon\":[[0,0],[4,0],[4,1],[0,1]]},\n"
      "    {\"name\":\"hammer\",\"polygon\":[[1,5],[3,5],[2,6]],\"motion\":{\"y\":[0,-0.5]}}]}\n"
      "\n"
      "Exit codes: 0 free, 1 contact or overlap at the start, 2 bad input, 3 undecided, 4 internal error.\n");
  command.on_chosen([&action, arguments] {
    action = [arguments] {
      const bool one = arguments->paths.size() == 1 && !arguments->lines;
      return one ? run_check(single(*arguments)) : check_batch(*arguments);
    };
  });
}

}  // namespace taut::cli
