// taut mechanism
#include <fmt/format.h>

#include <memory>

#include "commands.hpp"
#include "interrupt.hpp"
#include "report.hpp"
#include "scene_argument.hpp"
#include "taut/mechanism_motion.hpp"
#include "terminal.hpp"
#include "watched_run.hpp"

namespace taut::cli {
namespace {

struct MechanismArguments {
  SceneSource scene;
  MechanismOptions options;
  bool json = false;
  std::string csv;
};

/// A value that is enclosed: 0 where that cannot be told from it.
double shown(const Extreme& e) { return e.lo <= 0 && e.hi >= 0 ? 0 : e.lo + (e.hi - e.lo) / 2; }

std::string range_text(const Extreme& least, const Extreme& greatest, const char* unit) {
  return fmt::format("{:.7g} to {:.7g}{}   at t = {:.7g}, {:.7g}", shown(least), shown(greatest), unit, least.t,
                     greatest.t);
}

std::string in_words(const Scene& scene, const MechanismMotion& answer) {
  const char* const word = answer.outcome == MechanismMotion::Outcome::moves    ? "MOVES"
                           : answer.outcome == MechanismMotion::Outcome::locked ? "LOCKED"
                                                                                : "UNDECIDED";
  std::string text = fmt::format("{}  on [{}, {}]   mobility {}, {} loop{}\n", word, scene.start, scene.end,
                                 answer.mobility, answer.loops, answer.loops == 1 ? "" : "s");
  if (!answer.reason.empty()) text += "  " + answer.reason + "\n";
  text += lock_text(scene);
  for (const JointRange& joint : answer.joints)
    text += fmt::format("  {:<12} {} x {}: {}\n", joint.joint, joint.first, joint.second,
                        range_text(joint.least, joint.greatest, joint.slides ? "" : " deg"));
  for (const TransmissionAngle& angle : answer.transmission)
    text += fmt::format("  transmission angle at {}, {} and {}: {}\n", angle.joint, angle.links[0], angle.links[1],
                        range_text(angle.least, angle.greatest, " deg"));
  return text;
}

int run_mechanism(const MechanismArguments& arguments) {
  const Scene scene = load_scene(arguments.scene);
  MechanismOptions options = arguments.options;
  options.limits.stop = stop_on_signals();
  if (!arguments.csv.empty() && options.instants == 0) options.instants = 361;
  const MechanismMotion answer = watched(scene, arguments.scene.path, [&] { return mechanism_motion(scene, options); });
  if (!arguments.csv.empty()) write_output(arguments.csv, mechanism_csv(scene, answer));
  // What goes to standard output is one thing.
  if (arguments.csv != "-") print_text(arguments.json ? mechanism_json(scene, answer) + "\n" : in_words(scene, answer));
  return answer.outcome == MechanismMotion::Outcome::moves ? exit_free : exit_undecided;
}

}  // namespace

void add_mechanism(const Command& app, Action& action) {
  const Command command =
      app.add_command("mechanism", "Say how a mechanism moves: ranges of joints, transmission angles, locks");
  const auto arguments = std::make_shared<MechanismArguments>();
  add_scene(command, arguments->scene);
  command
      .add_option("--instants", arguments->options.instants,
                  "list all joint values at N instants, evenly over the time (361 for --csv)")
      .value("N");
  command.add_option("--csv", arguments->csv, "write these to FILE, with the bounds of each (- is standard output)")
      .value("FILE");
  add_max_seconds(command, arguments->options.limits);
  command.add_flag("--json", arguments->json, "print one JSON object");
  command.footer(
      "Example:\n"
      "  taut mechanism examples/mechanisms/crank_rocker.json\n"
      "\n"
      "Values are 0 in the drawn pose: degrees, or lengths of slides. Exit codes: 0 it moves to the end of the time, "
      "2\n"
      "bad input, 3 it locks before, or that is undecided, 4 internal error.\n");
  command.on_chosen([&action, arguments] { action = [arguments] { return run_mechanism(*arguments); }; });
}

}  // namespace taut::cli
