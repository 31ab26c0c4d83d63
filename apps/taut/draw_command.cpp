#include <fmt/format.h>

#include <memory>
#include <optional>

#include "ask/scene_pictures.hpp"
#include "commands.hpp"
#include "io/text.hpp"
#include "scene/validate_scene.hpp"
#include "taut/check.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/simulation.hpp"
#include "watched_run.hpp"

namespace taut::cli {
using namespace internal;

namespace {

struct DrawArguments {
  SceneSource scene;
  std::string output;
  std::optional<double> at;
  Touch touch = Touch::open;
  TilingDrawOptions options;
  std::optional<int> level;
  bool plain = false, no_corners = false, animate = false;
};

double instant(const DrawArguments& arguments, const Scene& scene) {
  const double at = arguments.at.value_or(scene.end);
  if (at >= scene.start && at <= scene.end) return at;
  throw InputError("--at", fmt::format("{} is outside the scene's time [{}, {}]", at, scene.start, scene.end),
                   "choose an instant within");
}

/// All bodies, and between those that are near the edges of their tilings.
int draw_bodies(const DrawArguments& arguments, const Scene& scene) {
  if (arguments.level)
    throw InputError("--level", "there are no geodesic cycles of these bodies",
                     "only of two bodies of one polygon each, without holes and parents, that do not overlap");
  std::optional<double> at;
  if (arguments.at) at = instant(arguments, scene);
  CheckOptions options;
  options.touch = arguments.touch;
  options.tell_touching = false;
  const Answer answer = watched_run(scene, arguments.scene.path, options, check);
  const std::string note = world_note(scene, answer, at);
  if (!note.empty()) fmt::print(stderr, "taut: {}\n", io::line_for_terminal(note));
  DrawOptions drawn;
  drawn.width = arguments.options.width;
  const DrawnTilings how{!arguments.plain, arguments.touch};
  write_output(arguments.output, arguments.animate ? world_animation(scene, answer, how, {.draw = drawn})
                                                   : world_picture(scene, answer, at, how, drawn));
  return exit_free;
}

/// Two polygons at rest in the picture: the faces of their tiling, and its corners.
int draw_tiling(DrawArguments arguments, const Scene& scene, Simulation& simulation) {
  const double at = instant(arguments, scene);
  arguments.options.faces = !arguments.plain;
  arguments.options.certificates = !arguments.no_corners;
  if (simulation.advance_to(at) == SimulationState::contact && simulation.contact()) {
    arguments.options.contact = &*simulation.contact();
    if (arguments.at) {
      fmt::print(stderr, "taut: the bodies touch at t = {}; drawing that instant\n", simulation.contact()->time.lo);
    }
  }
  const Tiling tiling = simulation.tiling();
  if (arguments.level) {
    for (const int body : {0, 1})
      arguments.options.paths.push_back(drawn_cycle(tiling, simulation.geodesic_cycle(body, *arguments.level)));
  }
  write_output(arguments.output, draw_svg(scene, tiling, arguments.options));
  return exit_free;
}

int run_draw(DrawArguments arguments) {
  const Scene scene = load_scene(arguments.scene);
  if (arguments.animate || !is_ring_pair(scene)) return draw_bodies(arguments, scene);
  auto simulation = within_file(arguments.scene.path, [&] { return Simulation(scene, arguments.touch); });
  if (simulation.tiling().edges.empty()) return draw_bodies(arguments, scene);
  return draw_tiling(std::move(arguments), scene, simulation);
}

}  // namespace

void add_draw(const Command& app, Action& action) {
  const Command command = app.add_command("draw", "Draw bodies and tiling at one instant as SVG");
  const auto arguments = std::make_shared<DrawArguments>();
  add_scene(command, arguments->scene);
  const Option at =
      command.add_option("--at", arguments->at, "the instant; without it, the first contact, or the end").value("T");
  command.add_option("-o,--output", arguments->output, "write to FILE instead of standard output").value("FILE");
  command.add_option("--width", arguments->options.width, "width in pixels (default 800)")
      .within(200, 20000)
      .value("N");
  const Option level = command
                           .add_option("--level", arguments->level,
                                       "also draw both bodies' pinned geodesic cycles of level K of their\n"
                                       "trees: 0 is the relative convex hull")
                           .within(0, 40)
                           .value("K");
  command.add_flag("--animate", arguments->animate, "a picture that moves from the start to the contact, or to the end")
      .excludes(at)
      .excludes(level);
  command.add_flag("--plain", arguments->plain, "do not colour the faces; with --animate, bodies only");
  command.add_flag("--no-corners", arguments->no_corners, "do not mark the active corners");
  add_touch(command, arguments->touch);
  command.footer(
      "Example:\n"
      "  taut draw scene.json --at 0.5 -o scene.svg\n"
      "  taut draw scene.json --animate -o moving.svg\n"
      "\n"
      "If the bodies touch before T, the instant of the contact is drawn instead, and the contact is marked.\n"
      "Of a world, every body is drawn in a colour of its own, with its number in the legend, and the tilings of the\n"
      "pairs that are near are drawn as lines; --plain leaves them out.\n");
  command.on_chosen([&action, arguments] { action = [arguments] { return run_draw(*arguments); }; });
}

}  // namespace taut::cli
