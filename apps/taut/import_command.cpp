// taut import: drawings and maps as a scene.
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "commands.hpp"
#include "import/import.hpp"
#include "io/terminal_text.hpp"
#include "scene_argument.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut::cli {

namespace {

struct ImportArguments {
  std::vector<std::string> files;
  std::string output;
  drawing::ImportSettings settings;
  bool json = false;
};

void require_size(const char* option, double value, bool zero_is_fine) {
  if (std::isfinite(value) && (value > 0 || (zero_is_fine && value == 0))) return;
  throw InputError(option, fmt::format("{} is not a {} number", value, zero_is_fine ? "sensible" : "positive"),
                   "give a length in the units of the scene, or a factor for --scale");
}

int run_import(const ImportArguments& arguments) {
  require_size("--tolerance", arguments.settings.tolerance, false);
  require_size("--scale", arguments.settings.scale, false);
  require_size("--join", arguments.settings.join_distance(), true);
  const drawing::Import import = drawing::import_files(arguments.files, arguments.settings);
  write_output(arguments.output, write_scene(import.scene));
  if (arguments.json)
    fmt::print("{}", report_json(import, arguments.settings));
  else
    fmt::print(stderr, "{}", io::for_terminal(report_text(import, arguments.settings)));
  return exit_free;
}

}  // namespace

void add_import(const Command& app, Action& action) {
  const Command command = app.add_command("import", "Make a scene of drawings and maps: SVG, DXF, WKT, GeoJSON, PGM");
  const auto arguments = std::make_shared<ImportArguments>();
  drawing::ImportSettings& settings = arguments->settings;
  command.add_option("FILE", arguments->files, "drawings and maps, told by their endings").required().value(" ");
  const Option output =
      command.add_option("-o,--output", arguments->output, "write to FILE instead of standard output").value("FILE");
  command
      .add_option("--tolerance", settings.tolerance,
                  "chords are at most D away from their curves, in units of the scene (0.01)")
      .value("D");
  command.add_flag("--curves", settings.curves,
                   "keep arcs and Bezier curves as they are, instead of chords: outlines are paths");
  command
      .add_option("--join", settings.join,
                  "ends of lines that are at most E apart are one point (a hundredth of the\ntolerance)")
      .value("E");
  command.add_option("--scale", settings.scale, "multiply all lengths by S (1)").value("S");
  command.add_flag("--split", settings.split, "a body for each part, instead of one for each group or layer");
  command.add_flag("--unknown-free", settings.unknown_free,
                   "what a robot's map does not know is no obstacle (it is one)");
  command.add_flag("--json", arguments->json, "print the report as JSON, on standard output").needs(output);
  command.footer(
      "Example:\n"
      "  taut import plate.svg gear.dxf -o scene.json\n"
      "  taut import map.yaml -o scene.json          a map of ROS's map_server, with its PGM\n"
      "\n"
      "A body is what one group of an SVG drawing, one layer of a DXF, or one feature of GeoJSON encloses. All bodies\n"
      "rest: give them motions in the scene. The report, on standard error, tells what was skipped, and why.\n");
  command.on_chosen([&action, arguments] { action = [arguments] { return run_import(*arguments); }; });
}

}  // namespace taut::cli
