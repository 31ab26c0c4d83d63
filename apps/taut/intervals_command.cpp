// taut intervals and taut range: when do bodies overlap, and how far can they go without?
#include <fmt/format.h>

#include <memory>

#include "commands.hpp"
#include "feature_text.hpp"
#include "interrupt.hpp"
#include "report.hpp"
#include "scene_argument.hpp"
#include "taut/intervals.hpp"
#include "taut/io.hpp"
#include "taut/motions.hpp"
#include "terminal.hpp"
#include "watched_run.hpp"

namespace taut::cli {
namespace {

struct IntervalArguments {
  AskedScene scene;
  CheckOptions options;
  double from = 0;
  bool json = false;
  std::string svg;
};

std::string body_called(const Scene& scene, BodyId id) { return scene.bodies[static_cast<std::size_t>(id)].name; }

std::string names_of(const Scene& scene, const OverlapInterval& o) {
  return body_called(scene, o.pair[0]) + " x " + body_called(scene, o.pair[1]);
}

/// The angle of the body that sweeps, if one of the pair does.
std::string degrees_at(const Scene& scene, const OverlapInterval& o, const TimeInterval& t) {
  for (const BodyId id : o.pair) {
    const auto angle = angle_at(scene.bodies[static_cast<std::size_t>(id)].motion, t);
    if (angle) return fmt::format(" ({:.9g} deg)", angle->lo + (angle->hi - angle->lo) / 2);
  }
  return "";
}

std::string meeting_text(const char* what, const Contact& c, const Scene& scene) {
  return fmt::format("    {}: {} and {}{}\n", what, vertex_text(scene, c.vertex), edge_text(scene, c.edge),
                     c.grazing ? ", grazing" : "");
}

std::string text_of_answer(const Scene& scene, const OverlapInterval& o) {
  std::string text = fmt::format("  {}   t = {}{} to {}{}\n", names_of(scene, o), time_text(o.from),
                                 degrees_at(scene, o, o.from), time_text(o.to), degrees_at(scene, o, o.to));
  if (o.enter) text += meeting_text("enter", *o.enter, scene);
  if (o.exit) text += meeting_text("exit", *o.exit, scene);
  return text;
}

std::string untested_text(const Scene& scene, const std::string& reason) {
  return "UNTESTED  " + subject_text(scene, std::nullopt) + "\n  " + reason + "\n";
}

/// The weakest part of the answer.
std::string first_line(const Intervals& answer, const std::string& found) {
  const std::size_t open = answer.undecided.size();
  if (open > 0) return fmt::format("UNDECIDED  {} pair{}; of the others {}", open, open == 1 ? "" : "s", found);
  if (answer.intervals.empty()) return "NO OVERLAP";
  return fmt::format("{} INTERVAL{} OF OVERLAP", answer.intervals.size(), answer.intervals.size() == 1 ? "" : "S");
}

std::string text_of_answer(const Scene& scene, const Intervals& answer, bool all_pairs) {
  if (answer.outcome == Outcome::untested) return untested_text(scene, answer.reason);
  const std::size_t n = answer.intervals.size();
  const std::string found = fmt::format("{} interval{} of overlap", n, n == 1 ? "" : "s");
  std::string text = first_line(answer, found) + fmt::format("   on [{}, {}]\n", scene.start, scene.end);
  text += grounds_text(scene, answer.coverage);
  if (answer.outcome == Outcome::undecided) text += "  " + answer.reason + "\n";
  for (const OverlapInterval& o : answer.intervals) text += text_of_answer(scene, o);
  if (answer.undecided.size() > 1 && !all_pairs) return text + "  --pairs all lists the undecided pairs\n";
  for (const PairAnswer& pair : answer.undecided)
    text += fmt::format("  undecided: {} x {}{}{}\n", body_called(scene, pair.bodies[0]),
                        body_called(scene, pair.bodies[1]), pair.reason == answer.reason ? "" : ": ",
                        pair.reason == answer.reason ? "" : pair.reason);
  return text;
}

std::string text_of_answer(const Scene& scene, double t, const Range& answer) {
  if (answer.outcome == Outcome::untested) return untested_text(scene, answer.reason);
  if (answer.outcome != Outcome::free)
    return "UNDECIDED  " + subject_text(scene, std::nullopt) + "\n" + grounds_text(scene, answer.coverage) + "  " +
           answer.reason + "\n";
  const std::string from = answer.from ? time_text(*answer.from) + degrees_at(scene, *answer.before, *answer.from)
                                       : fmt::format("{}, the start", scene.start);
  const std::string to = answer.to ? time_text(*answer.to) + degrees_at(scene, *answer.after, *answer.to)
                                   : fmt::format("{}, the {}", scene.end, scene.lock ? "lock" : "end");
  std::string text =
      fmt::format("FREE  around t = {}: from {} to {}\n", t, from, to) + grounds_text(scene, answer.coverage);
  if (answer.before) text += "  before: " + names_of(scene, *answer.before) + "\n";
  if (answer.after) text += "  after:  " + names_of(scene, *answer.after) + "\n";
  return text;
}

int run_intervals(const IntervalArguments& arguments) {
  const Scene scene = load_scene(arguments.scene.source);
  CheckOptions options = arguments.options;
  options.limits.stop = stop_on_signals();
  const Intervals answer = watched(scene, arguments.scene.source.path, [&] { return intervals(scene, options); });
  if (!arguments.svg.empty()) write_output(arguments.svg, intervals_svg(scene, answer, options.touch));
  // What goes to standard output is one thing.
  if (arguments.svg != "-")
    print_text(arguments.json ? intervals_json(scene, answer, options.touch) + "\n"
                              : text_of_answer(scene, answer, options.all_pairs));
  return exit_code(answer.outcome, arguments.scene.allow_untested);
}

int run_range(const IntervalArguments& arguments) {
  const Scene scene = load_scene(arguments.scene.source);
  CheckOptions options = arguments.options;
  options.limits.stop = stop_on_signals();
  const Range answer =
      watched(scene, arguments.scene.source.path, [&] { return range(scene, arguments.from, options); });
  if (!arguments.svg.empty()) write_output(arguments.svg, range_svg(scene, arguments.from, answer));
  if (arguments.svg != "-")
    print_text(arguments.json ? range_json(scene, arguments.from, answer, options.touch) + "\n"
                              : text_of_answer(scene, arguments.from, answer));
  return exit_code(answer.outcome, arguments.scene.allow_untested);
}

void add_question(const Command& command, IntervalArguments& arguments) {
  add_asked_scene(command, arguments.scene);
  add_touch(command, arguments.options.touch);
  add_max_seconds(command, arguments.options.limits);
  command.add_flag("--json", arguments.json, "print one JSON object");
}

}  // namespace

void add_intervals(const Command& app, Action& action) {
  const Command command = app.add_command("intervals", "Say when bodies overlap: all intervals, of every pair");
  const auto arguments = std::make_shared<IntervalArguments>();
  add_question(command, *arguments);
  const auto pairs = [arguments](const std::string& which) { arguments->options.all_pairs = which == "all"; };
  command.add_choice("--pairs", {"first", "all"}, pairs,
                     "first: count the undecided pairs, and say why the first one is; all: list them");
  command.add_option("--svg", arguments->svg, "draw them over time to FILE (- is standard output)").value("FILE");
  command.footer(
      "Example:\n"
      "  taut intervals --json scene.json\n"
      "  taut intervals scene.json --svg overlaps.svg\n"
      "\n"
      "Each interval is maximal; its ends are enclosed in doubles, with the features that meet and part there. Exit\n"
      "codes: 0 no overlap, 1 at least one, 2 bad input, or no pair was tested, 3 undecided, 4 internal error.\n");
  command.on_chosen([&action, arguments] { action = [arguments] { return run_intervals(*arguments); }; });
}

void add_range(const Command& app, Action& action) {
  const Command command = app.add_command("range", "Say how far the bodies can go, both ways, without overlap");
  const auto arguments = std::make_shared<IntervalArguments>();
  add_question(command, *arguments);
  command.add_option("--from", arguments->from, "an instant at which no bodies overlap").required().value("T");
  command.add_option("--svg", arguments->svg, "draw it over time to FILE (- is standard output)").value("FILE");
  command.footer(
      "Example:\n"
      "  taut range scene.json --from 0.5\n"
      "\n"
      "Prints the maximal interval of time around T without overlap, of a sweep in degrees, too. Exit codes: 0, or\n"
      "2 bad input (bodies overlap at T), or no pair was tested, 3 undecided, 4 internal error.\n");
  command.on_chosen([&action, arguments] { action = [arguments] { return run_range(*arguments); }; });
}

}  // namespace taut::cli
