// taut clearance: how close do bodies come?
#include <fmt/format.h>

#include <memory>

#include "commands.hpp"
#include "feature_text.hpp"
#include "interrupt.hpp"
#include "report.hpp"
#include "scene_argument.hpp"
#include "taut/clearance.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/motions.hpp"
#include "terminal.hpp"
#include "watched_run.hpp"

namespace taut::cli {
namespace {

struct ClearanceArguments {
  AskedScene scene;
  ClearanceOptions options;
  bool json = false;
  ProfileOptions profile;
  std::string csv, svg;
};

std::string body_name(const Scene& scene, BodyId id) { return scene.bodies[static_cast<std::size_t>(id)].name; }

std::string nearest_line(const Scene& scene, const NearestPoints& n) {
  const std::string pair = body_name(scene, n.pair[0]) + " x " + body_name(scene, n.pair[1]);
  std::string angle;
  for (const BodyId id : n.pair) {
    const auto at = angle_at(scene.bodies[static_cast<std::size_t>(id)].motion, n.time);
    if (at && angle.empty()) angle = fmt::format(" ({:.9g} deg)", at->lo + (at->hi - at->lo) / 2);
  }
  if (!(n.hi > 0)) return fmt::format("0  {}   they touch, at t = {}{}\n", pair, time_text(n.time), angle);
  return fmt::format("{}  {}   at t = {}{}\n", time_text({n.lo, n.hi}), pair, instant_text(scene, n.time.lo), angle);
}

std::string no_verdict(const Scene& scene, Outcome outcome, const std::string& reason, const Coverage& coverage) {
  const std::string subject = subject_text(scene, std::nullopt);
  if (outcome == Outcome::untested) return "UNTESTED  " + subject + "\n  " + reason + "\n";
  return "UNDECIDED  " + subject + "\n" + grounds_text(scene, coverage) + "  " + reason + "\n";
}

std::string clearance_text(const Scene& scene, const Clearance& answer) {
  if (!answer.nearest || answer.outcome == Outcome::undecided)
    return no_verdict(scene, answer.outcome, answer.reason, answer.coverage);
  const NearestPoints& n = *answer.nearest;
  std::string text = "CLEARANCE  " + nearest_line(scene, n) + grounds_text(scene, answer.coverage);
  if (n.hi > 0)
    text += fmt::format("  {} at ({:.9g}, {:.9g}), {} at ({:.9g}, {:.9g})\n", edge_text(scene, n.edges[0]),
                        n.points[0].x, n.points[0].y, edge_text(scene, n.edges[1]), n.points[1].x, n.points[1].y);
  if (!answer.wide.empty()) text += "  " + answer.wide + '\n';
  for (const NearestPoints& pair : answer.pairs) text += "    " + nearest_line(scene, pair);
  return text;
}

std::string curve_line(const Scene& scene, const DistanceCurve& c) {
  const std::string pair = c.pair ? body_name(scene, (*c.pair)[0]) + " x " + body_name(scene, (*c.pair)[1])
                                  : std::string("all pairs, the least");
  return fmt::format("{}   greatest {} at t = {}\n", pair, time_text({c.largest_lo, c.largest_hi}),
                     instant_text(scene, c.largest_at));
}

std::string instants_text(const Scene& scene, const DistanceCurve& c) {
  std::string text = fmt::format("  {:>14}  {:>14}   {}\n", "t", "distance", "until the next");
  for (std::size_t k = 0; k < c.instants.size(); ++k) {
    const DistanceAt& d = c.instants[k];
    const bool is_wide = d.hi - d.lo > 1e-8 * d.hi && d.lo > 0;
    text += fmt::format("  {:>14}  {:>14}", instant_text(scene, d.t),
                        is_wide ? fmt::format("[{:.6g}, {:.6g}]", d.lo, d.hi) : fmt::format("{:.9g}", d.hi));
    if (k < c.stretches.size()) text += fmt::format("   {:.6g} to {:.6g}", c.stretches[k].lo, c.stretches[k].hi);
    text += '\n';
  }
  return text;
}

std::string profile_text(const Scene& scene, const DistanceProfile& answer) {
  if (answer.curves.empty()) return no_verdict(scene, answer.outcome, answer.reason, answer.coverage);
  std::string text;
  for (const DistanceCurve& c : answer.curves)
    text += "PROFILE  " + curve_line(scene, c) + (text.empty() ? grounds_text(scene, answer.coverage) : "") +
            (c.wide.empty() ? "" : "  " + c.wide + '\n') + instants_text(scene, c);
  return text;
}

int run_profile(const ClearanceArguments& arguments) {
  if (arguments.csv == "-" && arguments.svg == "-")
    throw InputError("--svg", "the plot and the values cannot both go to standard output",
                     "name a file for one of them");
  const Scene scene = load_scene(arguments.scene.source);
  ProfileOptions options = arguments.profile;
  options.relative = arguments.options.relative;
  options.all_pairs = arguments.options.all_pairs;
  options.limits.max_seconds = arguments.options.limits.max_seconds;
  options.limits.stop = stop_on_signals();
  const DistanceProfile answer =
      watched(scene, arguments.scene.source.path, [&] { return distance_profile(scene, options); });
  if (!arguments.csv.empty()) write_output(arguments.csv, profile_csv(scene, answer));
  if (!arguments.svg.empty()) write_output(arguments.svg, profile_svg(scene, answer));
  // What goes to standard output is one thing.
  if (arguments.csv != "-" && arguments.svg != "-")
    print_text(arguments.json ? profile_json(scene, answer) + "\n" : profile_text(scene, answer));
  return exit_code(answer.outcome, arguments.scene.allow_untested);
}

int run_clearance(const ClearanceArguments& arguments) {
  const Scene scene = load_scene(arguments.scene.source);
  ClearanceOptions options = arguments.options;
  options.limits.stop = stop_on_signals();
  const Clearance answer = watched(scene, arguments.scene.source.path, [&] { return clearance(scene, options); });
  if (!arguments.svg.empty()) write_output(arguments.svg, clearance_svg(scene, answer));
  if (arguments.svg != "-")
    print_text(arguments.json ? clearance_json(scene, answer) + "\n" : clearance_text(scene, answer));
  return exit_code(answer.outcome, arguments.scene.allow_untested);
}

}  // namespace

void add_clearance(const Command& app, Action& action) {
  const Command command = app.add_command("clearance", "Say how close bodies come, with a certain bracket");
  const auto arguments = std::make_shared<ClearanceArguments>();
  add_asked_scene(command, arguments->scene);
  command.add_option("--tolerance", arguments->options.relative, "how wide the bracket may be, relative to it; 1e-9")
      .value("X");
  const auto pairs = [arguments](const std::string& which) { arguments->options.all_pairs = which == "all"; };
  command.add_choice("--pairs", {"first", "all"}, pairs, "first: the pair that comes closest; all: every pair");
  command
      .add_option("--within", arguments->options.within,
                  "with --pairs all: only those that may come as close as D; others are counted as apart")
      .value("D");
  add_max_seconds(command, arguments->options.limits);
  const Option profile =
      command
          .add_option("--profile", arguments->profile.instants,
                      "instead, the distance over time, at N instants and between them, and the greatest")
          .within(2, 1000000)
          .value("N");
  command.add_option("--csv", arguments->csv, "with --profile, write it to FILE (- is standard output)")
      .value("FILE")
      .needs(profile);
  command
      .add_option("--svg", arguments->svg,
                  "draw the bodies where they are closest to FILE (- is standard output);\nwith --profile, the curve")
      .value("FILE");
  command.add_flag("--json", arguments->json, "print one JSON object");
  command.footer(
      "Example:\n"
      "  taut clearance scene.json --pairs all --svg closest.svg\n"
      "  taut clearance layout.json --pairs all --within 0.5\n"
      "  taut clearance scene.json --profile 200 --svg distance.svg\n"
      "\n"
      "Prints the least distance over the scene's time, when, and between which points. Exit codes: 0, or 1 if bodies\n"
      "touch, 2 bad input, or no pair was tested, 3 undecided, or not decided whether they touch, 4 internal error.\n");
  command.on_chosen([&action, arguments, profile] {
    action = [arguments, profile] { return profile.given() ? run_profile(*arguments) : run_clearance(*arguments); };
  });
}

}  // namespace taut::cli
