#include <fmt/format.h>

#include <chrono>
#include <memory>

#include "commands.hpp"
#include "io/answer_json.hpp"
#include "report.hpp"
#include "taut/check.hpp"
#include "taut/io.hpp"
#include "watched_run.hpp"

namespace taut::cli {

namespace {

struct CheckArguments {
  std::string path;
  CheckOptions options;
  bool json = false, timing = false;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// All that is needed to see a disagreement again. On standard error, and whole: the scene may have come from a pipe.
void print_disagreement(const Scene& scene, Touch touch, const EngineDisagreement& error) {
  fmt::print(stderr, "taut: {}\nkinetic:   {}\nspacetime: {}\nscene:\n{}\n", error.what(),
             answer_json(scene, error.kinetic, touch), answer_json(scene, error.spacetime, touch), write_scene(scene));
}

int run_check(const CheckArguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  const Scene scene = load_scene(arguments.path);
  const double read_seconds = seconds_since(start);
  Answer answer;
  try {
    answer = watched_run(scene, arguments.path, arguments.options, check);
  } catch (const EngineDisagreement& error) {
    print_disagreement(scene, arguments.options.touch, error);
    throw;
  }
  const AnswerTiming timing{read_seconds, answer.build_seconds, answer.run_seconds};
  if (arguments.json) {
    const auto wanted = arguments.timing ? std::optional(timing) : std::nullopt;
    fmt::print("{}\n", answer_json(scene, answer, arguments.options.touch, wanted));
  } else {
    fmt::print("{}", report(scene, answer, arguments.options.touch));
    if (arguments.timing) {
      fmt::print("  read {}, build {}, run {}\n", seconds_text(timing.read), seconds_text(timing.build),
                 seconds_text(timing.run));
    }
  }
  return exit_code(answer.outcome);
}

}  // namespace

void add_check(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("check", "Say whether and when the two bodies of a scene first collide");
  const auto arguments = std::make_shared<CheckArguments>();
  add_run(*command, arguments->path, arguments->options);
  command->add_flag("--json", arguments->json, "print one JSON object");
  command->add_flag("--timing", arguments->timing, "tell how long reading, building and running took");
  add_engine(*command, arguments->options.engine);
  command->footer(
      "Example:\n"
      "  taut check --touch closed scene.json\n"
      "\n"
      "A scene is a JSON file:\n"
      "  {\"format\":\"taut-scene/1\",\"time\":[0,10],\"bodies\":[\n"
      "    {\"name\":\"anvil\",\"polygon\":[[0,0],[4,0],[4,1],[0,1]]},\n"
      "    {\"name\":\"hammer\",\"polygon\":[[1,5],[3,5],[2,6]],\"motion\":{\"y\":[0,-0.5]}}]}\n"
      "\n"
      "Exit codes: 0 free, 1 contact or overlap at the start, 2 bad input, 3 undecided, 4 internal error.\n");
  command->callback([&action, arguments] { action = [arguments] { return run_check(*arguments); }; });
}

}  // namespace taut::cli
