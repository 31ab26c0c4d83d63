#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "commands.hpp"
#include "io/platform.hpp"
#include "scene/body_pair.hpp"
#include "scene/curved_world.hpp"
#include "scene_argument.hpp"
#include "taut/error.hpp"
#include "taut/validate.hpp"
#include "viewer_page.hpp"

namespace taut::cli {
using namespace internal;

namespace {

struct ViewArguments {
  SceneSource scene;
  std::string output;
  ViewerOptions options;
};

int run_view(const ViewArguments& arguments) {
  const Scene scene = load_scene(arguments.scene);
  try {
    taut::validate(scene);
  } catch (const InputError& error) {
    throw error.within(display_name(arguments.scene.path));
  }
  const auto& at = arguments.options.at;
  if (at && !(*at >= scene.start && *at <= scene.end)) {
    throw InputError("--at", fmt::format("{} is outside the scene's time [{}, {}]", *at, scene.start, scene.end),
                     "choose an instant within");
  }
  ViewerOptions options = arguments.options;
  if (options.title.empty() && arguments.scene.path != "-")
    options.title = internal::io::name_of(internal::io::path_of(arguments.scene.path).stem());
  write_viewer(scene, options, arguments.output);
  return exit_free;
}

}  // namespace

void add_view(const Command& app, Action& action) {
  const Command command = app.add_command("view", "Write a page that shows the motion and the tiling in a browser");
  const auto arguments = std::make_shared<ViewArguments>();
  add_scene(command, arguments->scene);
  command.add_option("-o,--output", arguments->output, "write to FILE instead of standard output").value("FILE");
  add_touch(command, arguments->options.touch);
  command.add_option("--at", arguments->options.at, "the instant to show first (the start)").value("T");
  ViewerQuestions& ask = arguments->options.ask;
  command.add_flag("--intervals", ask.intervals, "ask when bodies overlap, all of the time: a lane along the time");
  command.add_flag("--clearance", ask.clearance, "ask how close they come: the closest points, and when");
  command.add_option("--profile", ask.profile, "ask how far apart they are, all of the time, at N instants and between")
      .within(2, 1000000)
      .value("N");
  command.add_flag("--separate", ask.separate, "ask in which directions they come apart: a rose for each body");
  command.add_option("--title", arguments->options.title, "of the page (the file's name)").value("TEXT");
  command
      .add_option("--template", arguments->options.template_path,
                  "the page to put the scene into, instead of the one that\n`./dev web` builds")
      .value("FILE");
  command.footer(
      "Example:\n"
      "  taut view scene.json -o scene.html\n"
      "  taut view scene.json --intervals --clearance --profile 200 --separate -o scene.html\n"
      "\n"
      "The page is one file, with the scene and the program inside; it opens without a network. The browser computes\n"
      "the answer anew, by the same code. docs/viewer.md says what is seen, and the keys.\n");
  command.on_chosen([&action, arguments] { action = [arguments] { return run_view(*arguments); }; });
}

}  // namespace taut::cli
