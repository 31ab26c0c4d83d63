// taut separate: in which directions do bodies come apart, and in which order does an assembly?
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "commands.hpp"
#include "feature_text.hpp"
#include "interrupt.hpp"
#include "report.hpp"
#include "scene_argument.hpp"
#include "taut/io.hpp"
#include "taut/separate.hpp"
#include "terminal.hpp"
#include "watched_run.hpp"

namespace taut::cli {
namespace {

struct SeparateArguments {
  SceneSource scene;
  SeparateOptions options;
  std::optional<double> tolerance;
  bool json = false, allow_untested = false;
  std::string output, svg;
};

double middle_of(const DirectionInterval& d) { return d.lo + (d.hi - d.lo) / 2; }

std::string name_of_body(const Scene& scene, BodyId id) { return scene.bodies[static_cast<std::size_t>(id)].name; }

std::string end_text(const Scene& scene, const std::optional<std::array<VertexRef, 2>>& vertices,
                     const std::optional<VertexAtEdge>& reach) {
  if (vertices) return vertex_text(scene, (*vertices)[0]) + " comes to " + vertex_text(scene, (*vertices)[1]);
  return "the travel ends where " + vertex_text(scene, reach->vertex) + " comes to " + edge_text(scene, reach->edge);
}

std::string arc_in_words(const Scene& scene, const DirectionArc& arc) {
  const auto from = [&] { return end_text(scene, arc.from_vertices, arc.from_reach); };
  const auto to = [&] { return end_text(scene, arc.to_vertices, arc.to_reach); };
  if (arc.point) return fmt::format("    exactly {:.9g} deg: {}, {}\n", middle_of(arc.from), from(), to());
  return fmt::format("    from {:.9g} to {:.9g} deg\n      at {:.9g}: {}\n      at {:.9g}: {}\n", middle_of(arc.from),
                     middle_of(arc.to), middle_of(arc.from), from(), middle_of(arc.to), to());
}

std::string directions_in_words(const Scene& scene, const BodyDirections& body) {
  if (body.all) return fmt::format("  {} goes in every direction\n", name_of_body(scene, body.body));
  if (body.free.empty()) return fmt::format("  {} goes nowhere\n", name_of_body(scene, body.body));
  std::string text = fmt::format("  {} goes\n", name_of_body(scene, body.body));
  for (const DirectionArc& arc : body.free) text += arc_in_words(scene, arc);
  return text;
}

std::string order_in_words(const Scene& scene, const Separation& answer) {
  std::string text = answer.order.empty() ? "" : "  one by one:\n";
  for (std::size_t i = 0; i < answer.order.size(); ++i) {
    const RemovalStep& step = answer.order[i];
    text += fmt::format("    {}. {} towards {:.9g} deg\n", i + 1, name_of_body(scene, step.body), step.direction_deg);
  }
  if (answer.stuck.empty()) return text;
  text += "  locked, one by one:";
  for (const BodyId id : answer.stuck) text += " " + name_of_body(scene, id);
  return text + "\n";
}

std::string way_in_words(const Scene& scene, std::size_t number, const RemovalWay& way) {
  std::string text = fmt::format("    {}. {}, about ({:.6g}, {:.6g})\n", number, name_of_body(scene, way.body),
                                 way.pivot.x, way.pivot.y);
  for (const WayPoint& at : way.points)
    text += fmt::format("       x = {:.9g}, y = {:.9g}, turned by {:.9g} deg\n", at.x, at.y, at.deg);
  return text;
}

/// Of an answer with turns.
std::string ways_in_words(const Scene& scene, const Separation& answer) {
  std::string text = answer.ways.empty() ? "" : "  one by one:\n";
  for (std::size_t i = 0; i < answer.ways.size(); ++i) text += way_in_words(scene, i + 1, answer.ways[i]);
  const auto list = [&](const char* what, const std::vector<BodyId>& bodies) {
    if (bodies.empty()) return;
    text += what;
    for (const BodyId id : bodies) text += " " + name_of_body(scene, id);
    text += "\n";
  };
  list("  no way out, turned or not:", answer.stuck);
  list("  undecided:", answer.unsure);
  if (answer.rounded > 0)
    text += fmt::format("  about bodies that stand within {:.2g} of where the scene has them\n", answer.rounded);
  return text;
}

const char* word_of(SeparationOutcome outcome) {
  switch (outcome) {
    case SeparationOutcome::free:
      return "FREE";
    case SeparationOutcome::locked:
      return "LOCKED";
    case SeparationOutcome::overlap_at_start:
      return "OVERLAP AT START";
    case SeparationOutcome::untested:
      return "UNTESTED";
    case SeparationOutcome::undecided:
      break;
  }
  return "UNDECIDED";
}

int code_of(SeparationOutcome outcome, bool allow_untested) {
  switch (outcome) {
    case SeparationOutcome::free:
      return exit_free;
    case SeparationOutcome::locked:
    case SeparationOutcome::overlap_at_start:
      return exit_contact;
    case SeparationOutcome::untested:
      return allow_untested ? exit_free : exit_bad_input;
    case SeparationOutcome::undecided:
      break;
  }
  return exit_undecided;
}

std::string in_words(const Scene& scene, const Separation& answer, bool turns) {
  std::string text = fmt::format("{}  {}\n", word_of(answer.outcome), subject_text(scene, answer.overlap));
  if (answer.outcome == SeparationOutcome::untested) return text + "  " + answer.reason + "\n";
  text += grounds_text(scene, answer.coverage);
  if (!answer.reason.empty()) text += "  " + answer.reason + "\n";
  if (turns && !answer.bodies.empty()) return text + ways_in_words(scene, answer);
  if (!answer.reason.empty()) return text;
  for (const BodyDirections& body : answer.bodies) text += directions_in_words(scene, body);
  if (!answer.wide.empty()) text += "  " + answer.wide + "\n";
  return text + order_in_words(scene, answer);
}

/// With turns, the ways as a picture that moves.
std::string picture(const Scene& scene, const Separation& answer) {
  if (answer.ways.empty()) return separation_svg(scene, answer);
  AnimateOptions options;
  options.free = true;
  options.ending = answer.outcome == SeparationOutcome::free ? "apart" : "as far as they come apart";
  const Scene leaving = removal_scene(scene, answer);
  return animate_svg(leaving, leaving.end, options);
}

int run_separate(const SeparateArguments& arguments) {
  if (!arguments.output.empty() && !arguments.options.turns)
    throw InputError("--output", "only ways with turns are written as a scene", "add --turns");
  const bool other_cells = arguments.options.max_cells != SeparateOptions{}.max_cells;
  if ((arguments.tolerance || other_cells) && !arguments.options.turns)
    throw InputError(arguments.tolerance ? "--tolerance" : "--max-cells", "it limits the search for ways with turns",
                     "add --turns, or leave it out");
  const Scene scene = load_scene(arguments.scene);
  SeparateOptions options = arguments.options;
  options.limits.stop = stop_on_signals();
  if (arguments.tolerance) options.tolerance = *arguments.tolerance;
  const Separation answer = watched(scene, arguments.scene.path, [&] { return separate(scene, options); });
  if (!arguments.output.empty()) {
    if (!answer.ways.empty())
      write_output(arguments.output, write_scene(removal_scene(scene, answer)));
    else
      fmt::print(stderr, "taut: {}\n", not_written("scene", arguments.output));
  }
  if (!arguments.svg.empty()) write_output(arguments.svg, picture(scene, answer));
  // What goes to standard output is one thing.
  if (arguments.output != "-" && arguments.svg != "-")
    print_text(arguments.json ? separation_json(scene, answer, options) + "\n"
                              : in_words(scene, answer, options.turns));
  return code_of(answer.outcome, arguments.allow_untested);
}

}  // namespace

void add_separate(const Command& app, Action& action) {
  const Command command = app.add_command("separate", "Say in which directions bodies come apart, and in which order");
  const auto arguments = std::make_shared<SeparateArguments>();
  add_scene(command, arguments->scene);
  add_allow_untested(command, arguments->allow_untested);
  command
      .add_option("--travel", arguments->options.travel,
                  "move bodies as far as S, in the scene's units (without: any distance)")
      .value("S")
      .positive();
  command.add_flag("--turns", arguments->options.turns,
                   "also find ways along which a body turns, where none leaves straight");
  command
      .add_option("--tolerance", arguments->tolerance,
                  "with --turns: divide places and angles down to this share of their ranges (1e-4)")
      .value("X");
  command
      .add_option("--max-cells", arguments->options.max_cells,
                  "with --turns: leave a body undecided at so many cells (4000000)")
      .value("N");
  command
      .add_option("-o,--output", arguments->output,
                  "with --turns: write the bodies as they leave to FILE, as a scene with time (- is standard output)")
      .value("FILE");
  add_max_seconds(command, arguments->options.limits);
  command.add_flag("--json", arguments->json, "print one JSON object");
  command
      .add_option("--svg", arguments->svg,
                  "draw the bodies with a rose for each, or as they leave with --turns, to FILE (- is standard output)")
      .value("FILE");
  command.footer(
      "Example:\n"
      "  taut separate --json scene.json\n"
      "  taut separate --turns puzzle.json -o apart.json && taut check apart.json\n"
      "\n"
      "Bodies stand as at the start; each is moved straight, as far as the travel, and must overlap nothing on the\n"
      "way. Of two bodies, the second one moves. Exit codes: 0 they come apart, 1 they do not, or overlap, 2 bad "
      "input,\n"
      "or no pair was tested, 3 undecided, 4 internal error.\n");
  command.on_chosen([&action, arguments] { action = [arguments] { return run_separate(*arguments); }; });
}

}  // namespace taut::cli
