// taut import: drawings and maps as a scene.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>

#include "commands.hpp"
#include "import/heights.hpp"
#include "import/import.hpp"
#include "io/platform.hpp"
#include "io/text.hpp"
#include "progress.hpp"
#include "scene_argument.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "terminal.hpp"

namespace taut::cli {
using namespace internal;

namespace {

struct ImportArguments {
  std::vector<std::string> files;
  std::vector<std::string> layers;
  std::string output, svg, merged;
  drawing::ImportSettings settings;
  bool json = false;
};

void require_size(const char* option, std::optional<double> value, bool zero_is_fine) {
  if (!value || (std::isfinite(*value) && (*value > 0 || (zero_is_fine && *value == 0)))) return;
  throw InputError(option, fmt::format("{} is not a {} number", *value, zero_is_fine ? "sensible" : "positive"),
                   "give a length in the units of the scene, or a factor for --scale");
}

/// "a,b" as two names.
std::vector<std::string> names_in(const std::string& list) {
  std::vector<std::string> names;
  for (std::size_t at = 0; at <= list.size();) {
    const std::size_t comma = std::min(list.find(',', at), list.size());
    if (comma > at) names.push_back(list.substr(at, comma - at));
    at = comma + 1;
  }
  return names;
}

/// A file that is there already is not that of this run.
void tell_unwritten(const std::string& output) {
  std::error_code none;
  if (!output.empty() && std::filesystem::is_regular_file(internal::io::path_of(output), none))
    fmt::print(stderr, "taut: {}\n", not_written("scene", output));
}

int import_files(ImportArguments& arguments) {
  drawing::ImportSettings& settings = arguments.settings;
  require_size("--tolerance", settings.tolerance, false);
  require_size("--scale", settings.scale, false);
  require_size("--join", settings.join, true);
  require_size("--repair", settings.repair, true);
  require_size("--drills", settings.drills, true);
  if (!settings.unit.empty() && !drawing::unit_named(settings.unit))
    throw InputError("--unit", "\"" + settings.unit + "\" is no unit of length",
                     "write mm, cm, m, um, in, ft, mil, pt or px");
  for (const std::string& choice : arguments.layers) drawing::choose_layer(settings, choice, "--layer");
  settings.merge_all = arguments.merged == "*";
  if (!settings.merge_all) settings.merged = names_in(arguments.merged);
  std::optional<Progress> progress(std::in_place);
  const drawing::Import import = drawing::examine_files(arguments.files, settings);
  progress.reset();
  // What is wrong is seen best in the picture: it is written in any case, and so is the report.
  if (!arguments.svg.empty()) write_output(arguments.svg, report_svg(import));
  if (arguments.json)
    print_text(report_json(import, settings));
  else
    fmt::print(stderr, "{}", io::for_terminal(report_text(import, settings)));
  if (!import.faults.empty()) throw import.faults.front();
  write_output(arguments.output, write_scene(import.scene));
  return exit_free;
}

int run_import(ImportArguments arguments) {
  try {
    return import_files(arguments);
  } catch (const InputError&) {
    tell_unwritten(arguments.output);
    throw;
  }
}

template <class Value>
std::function<void(const std::string&)> choose(Value& target, std::map<std::string, Value> values) {
  return [&target, values = std::move(values)](const std::string& word) { target = values.at(word); };
}

/// How lines are read.
void add_reading_options(const Command& command, drawing::ImportSettings& settings) {
  command
      .add_option(
          "--tolerance", settings.tolerance,
          "chords are at most D away from their curves, in units of the scene (0.01 mm, less\nfor small drawings)")
      .value("D");
  command.add_flag("--curves", settings.curves,
                   "keep arcs and Bezier curves as they are, instead of chords: outlines are paths");
  command
      .add_option("--join", settings.join,
                  "ends of lines that are at most E from another end or line meet it (0.02 mm)")
      .value("E");
  command
      .add_option(
          "--repair", settings.repair,
          "loops up to the size D are cut off (0.1 mm); if it is given, so are crossings of the\nrings of WKT and "
          "GeoJSON")
      .value("D");
  command.add_choice(
      "--open", {"error", "close", "skip"},
      choose<drawing::OpenRings>(settings.open, {{"error", drawing::OpenRings::error},
                                                 {"close", drawing::OpenRings::close},
                                                 {"skip", drawing::OpenRings::skip}}),
      "what becomes of outlines that stay open, and of shapes that are not read and may\nbound a body (error)");
  command.add_choice(
      "--crossing", {"error", "subtract", "union", "parts"},
      choose<drawing::Crossing>(settings.crossing, {{"error", drawing::Crossing::error},
                                                    {"subtract", drawing::Crossing::subtract},
                                                    {"union", drawing::Crossing::unite},
                                                    {"parts", drawing::Crossing::parts}}),
      "what becomes of closed contours that cross: the smaller is taken out of the larger,\nboth are one part, or they "
      "divide each other (error)");
}

/// What becomes a body.
void add_layer_options(const Command& command, ImportArguments& arguments) {
  drawing::ImportSettings& settings = arguments.settings;
  command.add_choice(
      "--by", {"layer", "color", "group", "nesting"},
      choose<drawing::Grouping>(settings.by, {{"layer", drawing::Grouping::layer},
                                              {"color", drawing::Grouping::color},
                                              {"group", drawing::Grouping::group},
                                              {"nesting", drawing::Grouping::nesting}}),
      "what becomes a body, by itself (layers, but contours in material of another layer\nare its holes)");
  command
      .add_option("--layer", arguments.layers,
                  "read only this layer; may be given more than once. With =LO:HI, its bodies lie\nbetween these "
                  "heights, and meet only what shares some of them")
      .value("NAME[=LO:HI]");
  command.add_option("--merge-layers", arguments.merged, "read these layers, or all, as one: --merge-layers=A,B")
      .value("[=NAMES]")
      .or_alone("*");
}

}  // namespace

void add_import(const Command& app, Action& action) {
  const Command command =
      app.add_command("import", "Make a scene of drawings and maps: SVG, DXF, KiCad, WKT, GeoJSON, PGM, PNG");
  const auto arguments = std::make_shared<ImportArguments>();
  drawing::ImportSettings& settings = arguments->settings;
  command.add_option("FILE", arguments->files, "drawings and maps, distinguished by their endings")
      .required()
      .value(" ");
  const Option output =
      command.add_option("-o,--output", arguments->output, "write to FILE instead of standard output").value("FILE");
  add_reading_options(command, settings);
  add_layer_options(command, *arguments);
  command.add_option("--scale", settings.scale, "multiply all lengths by S (1)").value("S");
  command
      .add_option("--unit", settings.unit,
                  "what a drawing is in that does not say so: mm, cm, m, um, in, ft, mil, pt or px.\nSeveral files are "
                  "converted to the unit of the first one")
      .value("U");
  command.add_flag("--split", settings.split, "a body for each part, instead of one for each group or layer");
  command.add_option("--drills", settings.drills, "of a board: drills that are at least D wide are holes in it (none)")
      .value("D");
  command.add_flag("--unknown-free", settings.unknown_free,
                   "what a robot's map does not know is no obstacle (it is one)");
  command.add_flag("--strict", settings.strict, "what is not read is an error");
  command
      .add_option("--svg", arguments->svg,
                  "draw the bodies, and in red the lines that stay open, to FILE, also if there\n"
                  "is an error")
      .value("FILE");
  command.add_flag("--json", arguments->json, "print the report as JSON, on standard output").needs(output);
  command.footer(
      "Example:\n"
      "  taut import plate.svg gear.dxf -o scene.json\n"
      "  taut import plate.dxf --svg report.svg -o scene.json      a picture of what was read, and what stays open\n"
      "  taut import arm.dxf --layer base=0:3 --layer lever=3:6 -o scene.json      two plates, one above the other\n"
      "  taut import map.yaml -o scene.json          a map of ROS's map_server, with its image\n"
      "\n"
      "A body is what one group of an SVG drawing, one layer of a DXF, or one feature of GeoJSON encloses. All bodies\n"
      "rest: give them motions in the scene. The report, on standard error, lists the gaps that were closed, what was "
      "cut\n"
      "off, what stays open, and what was skipped, and why.\n");
  command.on_chosen([&action, arguments] { action = [arguments] { return run_import(*arguments); }; });
}

}  // namespace taut::cli
