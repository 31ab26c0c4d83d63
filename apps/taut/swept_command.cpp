// taut swept: which region does a moving body pass over?
#include <fmt/format.h>

#include <memory>

#include "chosen_body.hpp"
#include "commands.hpp"
#include "interrupt.hpp"
#include "io/text.hpp"
#include "report.hpp"
#include "scene_argument.hpp"
#include "scene_source.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/swept.hpp"
#include "terminal.hpp"
#include "watched_run.hpp"

namespace taut::cli {
namespace {

struct SweptArguments {
  SceneSource scene;
  std::string body, output;
  SweptOptions options;
  bool json = false;
};

std::string in_words(const Scene& scene, BodyId body, const SweptRegion& region) {
  std::size_t holes = 0, vertices = 0;
  for (const Part& part : region.parts) {
    holes += part.holes.size();
    vertices += part.outline.size();
    for (const Polygon& hole : part.holes) vertices += hole.size();
  }
  return fmt::format("SWEPT  {} passes over {:.9g} on [{}, {}]\n", scene.bodies[static_cast<std::size_t>(body)].name,
                     region.area, scene.start, scene.end) +
         fmt::format("  {} with {} and {} vertices, at most {:.6g} too large anywhere\n",
                     io::counted(region.parts.size(), "polygon"), io::counted(holes, "hole"), vertices,
                     region.tolerance) +
         lock_text(scene);
}

/// What a file can hold, by how its name ends.
struct Form {
  const char* ending;
  std::string (*text)(const Scene& scene, BodyId body, const SweptRegion& region);
};
constexpr Form forms[] = {
    {".svg", [](const Scene& scene, BodyId body, const SweptRegion& region) { return swept_svg(scene, body, region); }},
    {".dxf", [](const Scene&, BodyId, const SweptRegion& region) { return swept_dxf(region); }},
    {".wkt", [](const Scene&, BodyId, const SweptRegion& region) { return swept_wkt(region) + "\n"; }},
    {".geojson", [](const Scene& scene, BodyId body,
                    const SweptRegion& region) { return swept_geojson(scene, body, region) + "\n"; }},
    {".json", [](const Scene& scene, BodyId body, const SweptRegion& region) {
       return swept_json(scene, body, region) + "\n";
     }}};

const Form& form_of(const std::string& file) {
  for (const Form& form : forms) {
    if (file.ends_with(form.ending)) return form;
  }
  throw InputError(file, "the name does not say which form is wanted", "end it in .svg, .dxf, .wkt, .geojson or .json");
}

int run_swept(const SweptArguments& arguments) {
  const Form* const form = arguments.output.empty() ? nullptr : &form_of(arguments.output);
  const Scene scene = load_scene(arguments.scene);
  SweptOptions options = arguments.options;
  options.limits.stop = stop_on_signals();
  const BodyId body = chosen_body(scene, arguments.body);
  const SweptRegion region = watched(scene, arguments.scene.path, [&] { return swept(scene, body, options); });
  if (form) write_file(arguments.output, form->text(scene, body, region));
  print_text(arguments.json ? swept_json(scene, body, region) + "\n" : in_words(scene, body, region));
  return exit_free;
}

}  // namespace

void add_swept(const Command& app, Action& action) {
  const Command command = app.add_command("swept", "Find the region that a moving body passes over");
  const auto arguments = std::make_shared<SweptArguments>();
  add_scene(command, arguments->scene);
  command.add_option("--body", arguments->body, "the body (the only one that moves)").value("NAME");
  command
      .add_option("--tolerance", arguments->options.tolerance,
                  "how far the region may reach beyond it, in units of the scene (a thousandth of the body's diagonal)")
      .value("X")
      .positive();
  command.add_option("-o,--output", arguments->output, "write the region as .svg, .dxf, .wkt, .geojson or .json")
      .value("FILE");
  add_max_seconds(command, arguments->options.limits);
  command.add_flag("--json", arguments->json, "print one JSON object");
  command.footer(
      "Example:\n"
      "  taut swept --tolerance 0.01 -o way.dxf car.json\n"
      "\n"
      "The region certainly contains all that the body covers at any instant, whatever happens between poses, and "
      "reaches\n"
      "at most the tolerance beyond it. Other bodies do not matter.\n");
  command.on_chosen([&action, arguments] { action = [arguments] { return run_swept(*arguments); }; });
}

}  // namespace taut::cli
