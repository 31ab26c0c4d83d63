// taut flatten: polygons for curves.
#include <memory>

#include "commands.hpp"
#include "scene_argument.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/outline.hpp"
#include "watched_run.hpp"

namespace taut::cli {

namespace {

struct FlattenArguments {
  SceneSource scene;
  double tolerance = 0;
  bool inner = false, outer = false;
  std::string output;
};

int run_flatten(const FlattenArguments& arguments) {
  if (arguments.inner == arguments.outer)
    throw InputError("", "the side of the curves is missing",
                     "write --outer for polygons around the bodies, or --inner for polygons within them");
  const Scene scene = load_scene(arguments.scene);
  const CurveSide side = arguments.inner ? CurveSide::inner : CurveSide::outer;
  write_output(arguments.output, write_scene(within_file(arguments.scene.path,
                                                         [&] { return flatten(scene, side, arguments.tolerance); })));
  return exit_free;
}

}  // namespace

void add_flatten(const Command& app, Action& action) {
  const Command command = app.add_command("flatten", "Write polygons within curves, or around them, as a scene");
  const auto arguments = std::make_shared<FlattenArguments>();
  add_scene(command, arguments->scene);
  command
      .add_option("--tolerance", arguments->tolerance,
                  "the most that polygons may be from the curves, in the scene's units")
      .value("X")
      .required();
  const Option outer = command.add_flag("--outer", arguments->outer, "polygons around the bodies");
  command.add_flag("--inner", arguments->inner, "polygons within the bodies").excludes(outer);
  command.add_option("-o,--output", arguments->output, "write to FILE instead of standard output").value("FILE");
  command.footer(
      "Example:\n"
      "  taut flatten --outer --tolerance 0.001 cam.json | taut prove - -o cam.proof\n"
      "\n"
      "That the polygons are on their side is proved. So where those around the bodies never meet, the bodies do not\n"
      "either, and where those within them meet, the bodies do. Polygons stay as they are.\n");
  command.on_chosen([&action, arguments] { action = [arguments] { return run_flatten(*arguments); }; });
}

}  // namespace taut::cli
