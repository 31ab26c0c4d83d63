// taut cells: which cells of a grid does a moving body touch?
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "chosen_body.hpp"
#include "commands.hpp"
#include "interrupt.hpp"
#include "report.hpp"
#include "scene_argument.hpp"
#include "scene_source.hpp"
#include "taut/cells.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "terminal.hpp"
#include "watched_run.hpp"

namespace taut::cli {
namespace {

struct CellsArguments {
  SceneSource scene;
  std::string body;
  CellOptions options;
  std::string pgm;
  bool json = false;
};

std::string in_words(const Scene& scene, BodyId body, const CoveredCells& covered) {
  int i0 = covered.cells[0][0], i1 = i0;
  for (const auto& cell : covered.cells) {
    i0 = std::min(i0, cell[0]);
    i1 = std::max(i1, cell[0]);
  }
  return fmt::format("CELLS  {}   {} of {}, columns {} to {}, rows {} to {}\n",
                     scene.bodies[static_cast<std::size_t>(body)].name, covered.cells.size(), covered.resolution, i0,
                     i1, covered.cells.front()[1], covered.cells.back()[1]) +
         lock_text(scene);
}

/// The image, and beside it what map_server reads first.
void write_map(const std::string& file, const CoveredCells& covered) {
  const std::size_t slash = file.rfind('/'), dot = file.rfind('.');
  const bool ends = dot != std::string::npos && (slash == std::string::npos || dot > slash);
  write_file(file, cells_pgm(covered));
  write_file((ends ? file.substr(0, dot) : file) + ".yaml",
             cells_yaml(covered, slash == std::string::npos ? file : file.substr(slash + 1)));
}

int run_cells(const CellsArguments& arguments) {
  const Scene scene = load_scene(arguments.scene);
  CellOptions options = arguments.options;
  options.limits.stop = stop_on_signals();
  const BodyId body = chosen_body(scene, arguments.body);
  const CoveredCells covered = within_file(arguments.scene.path, [&] { return cells(scene, body, options); });
  if (!arguments.pgm.empty()) write_map(arguments.pgm, covered);
  print_text(arguments.json ? cells_json(scene, body, covered) + "\n" : in_words(scene, body, covered));
  return exit_free;
}

}  // namespace

void add_cells(const Command& app, Action& action) {
  const Command command = app.add_command("cells", "List the cells of a grid that a moving body touches");
  const auto arguments = std::make_shared<CellsArguments>();
  add_scene(command, arguments->scene);
  command.add_option("--resolution", arguments->options.resolution, "the side of a cell, in units of the scene")
      .value("R")
      .required();
  command.add_option("--body", arguments->body, "the body (the only one that moves)").value("NAME");
  command.add_option("--origin-x", arguments->options.origin.x, "the left side of column 0 (0)").value("X");
  command.add_option("--origin-y", arguments->options.origin.y, "the lower side of row 0 (0)").value("Y");
  command.add_option("--pgm", arguments->pgm, "write an image, and a .yaml beside it for map_server").value("FILE");
  add_max_seconds(command, arguments->options.limits);
  command.add_flag("--json", arguments->json, "print one JSON object");
  command.footer(
      "Example:\n"
      "  taut cells --resolution 0.05 --json primitive.json\n"
      "\n"
      "Every cell that the body touches at any instant is listed, and none that is always more than a sixteenth of a\n"
      "cell away from it. Other bodies do not matter. Cell (i, j) is column i and row j, counted from the origin.\n");
  command.on_chosen([&action, arguments] { action = [arguments] { return run_cells(*arguments); }; });
}

}  // namespace taut::cli
