// taut path: is there any way from the start to the goal?
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "commands.hpp"
#include "interrupt.hpp"
#include "path_report.hpp"
#include "scene_argument.hpp"
#include "taut/io.hpp"
#include "taut/path.hpp"
#include "terminal.hpp"
#include "watched_run.hpp"

namespace taut::cli {
namespace {

struct PathArguments {
  AskedScene scene;
  PathOptions options;
  bool json = false, cells = false;
  std::string output, svg, map;
};

/// The way as a picture that moves; without one, the bodies at the start.
std::string picture(const PathProblem& problem, const PathAnswer& answer) {
  if (answer.outcome == PathOutcome::path) {
    AnimateOptions options;
    options.free = true;
    options.ending = "at the goal";
    const Scene scene = path_scene(problem, answer.waypoints);
    return animate_svg(scene, scene.end, options);
  }
  DrawOptions options;
  options.title = answer.outcome == PathOutcome::none ? "no way from here to the goal" : "undecided";
  return draw_svg(posed(problem.linkage, problem.start), 0, options);
}

int run_path(const PathArguments& arguments) {
  const PathProblem problem = load_path_problem(arguments.scene.source);
  require_drawable("--map", arguments.map, problem.linkage.joints);
  PathOptions options = arguments.options;
  options.limits.stop = stop_on_signals();
  std::optional<Progress> progress(std::in_place);
  const PathAnswer answer = within_file(arguments.scene.source.path, [&] { return find_path(problem, options); });
  progress.reset();
  if (!arguments.output.empty()) {
    if (answer.outcome == PathOutcome::path)
      write_output(arguments.output, write_scene(path_scene(problem, answer.waypoints)));
    else
      fmt::print(stderr, "taut: {}\n", not_written("scene", arguments.output));
  }
  if (!arguments.svg.empty()) write_output(arguments.svg, picture(problem, answer));
  if (!arguments.map.empty()) write_output(arguments.map, path_svg(problem, answer));
  // What goes to standard output is one thing.
  if (arguments.output != "-" && arguments.svg != "-" && arguments.map != "-")
    print_text(arguments.json ? path_json(problem, answer, options, arguments.cells) + "\n"
                              : path_in_words(problem, answer));
  return exit_code(answer.outcome, arguments.scene.allow_untested);
}

}  // namespace

void add_path(const Command& app, Action& action) {
  const Command command = app.add_command("path", "Find a way from a start to a goal, or prove that there is none");
  const auto arguments = std::make_shared<PathArguments>();
  add_asked_scene(command, arguments->scene);
  add_touch(command, arguments->options.touch);
  command.add_option("--clearance", arguments->options.clearance, "keep at least this distance all of the way (0)")
      .value("C");
  command
      .add_option("--tolerance", arguments->options.tolerance,
                  "divide cells down to this share of each joint's range (1e-4)")
      .value("X");
  command.add_flag("--shortest", arguments->options.shortest,
                   "make the way short, and say how much shorter another one could be");
  command
      .add_option("--within", arguments->options.within,
                  "with --shortest: stop when it is at most this share longer than any way (0.05)")
      .value("X");
  command.add_option("--max-cells", arguments->options.max_cells, "undecided when there are so many cells (4000000)")
      .value("N");
  add_max_seconds(command, arguments->options.limits);
  command
      .add_option("-o,--output", arguments->output,
                  "write the way to FILE, as a scene with time (- is standard output)")
      .value("FILE");
  command.add_option("--svg", arguments->svg, "draw the way to FILE, as a picture that moves (- is standard output)")
      .value("FILE");
  command
      .add_option("--map", arguments->map,
                  "draw the values of one or two joints to FILE: what is free, what collides, and the way")
      .value("FILE");
  command.add_flag("--json", arguments->json, "print one JSON object");
  command.add_flag("--cells", arguments->cells, "with --json: the partition of all joint values, too");
  command.footer(
      "Example:\n"
      "  taut path sofa.json -o moved.json && taut check moved.json\n"
      "\n"
      "The scene has joints, as for taut envelope, a \"start\" and a \"goal\": {\"x\": [8, 9]}, or \"outside\".\n"
      "A body may move freely: \"motion\": {\"free\": {\"x\": \"x\", \"y\": \"y\", \"deg\": \"turn\"}}. Exit codes:\n"
      "0 a way was found, 1 there is none, 2 bad input, or no pair was tested, 3 undecided, 4 internal error.\n");
  command.on_chosen([&action, arguments] { action = [arguments] { return run_path(*arguments); }; });
}

}  // namespace taut::cli
