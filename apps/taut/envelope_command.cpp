// taut envelope: for which combinations of joint values do bodies keep apart?
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>

#include "commands.hpp"
#include "coverage_text.hpp"
#include "envelope_page.hpp"
#include "feature_text.hpp"
#include "interrupt.hpp"
#include "io/platform.hpp"
#include "io/text.hpp"
#include "scene_argument.hpp"
#include "taut/envelope.hpp"
#include "taut/io.hpp"
#include "terminal.hpp"
#include "viewer_page.hpp"
#include "watched_run.hpp"

namespace taut::cli {
namespace {

struct EnvelopeArguments {
  AskedScene scene;
  EnvelopeOptions options;
  bool json = false, cells = false;
  std::string svg, html, template_path;
};

std::string name_in(const Linkage& linkage, BodyId id) {
  return linkage.scene.bodies[static_cast<std::size_t>(id)].name;
}

std::string combination_text(const Linkage& linkage, const std::array<double, max_joints>& values) {
  std::string text;
  for (std::size_t k = 0; k < linkage.joints.size(); ++k)
    text += fmt::format("{}{} = {:.9g}", k ? ", " : "", linkage.joints[k].name, values[k]);
  return text;
}

std::string joints_in_words(const Linkage& linkage) {
  std::string text;
  for (const Joint& joint : linkage.joints)
    text += fmt::format("{}{} from {:.9g} to {:.9g}", text.empty() ? "" : ", ", joint.name, joint.lo, joint.hi);
  return text;
}

std::string envelope_in_words(const Linkage& linkage, const Envelope& answer) {
  if (answer.outcome == Outcome::untested)
    return "UNTESTED  " + joints_in_words(linkage) + "\n  " + answer.reason + "\n";
  std::string text = answer.outcome == Outcome::free      ? "FREE  for every combination of "
                     : answer.outcome == Outcome::contact ? "COLLIDES  for some combinations of "
                                                          : "UNDECIDED  for some combinations of ";
  text += joints_in_words(linkage) + "\n" + coverage_text(answer.coverage);
  if (answer.witness)
    text += fmt::format("  {} x {} at {}\n", name_in(linkage, answer.witness->pair[0]),
                        name_in(linkage, answer.witness->pair[1]), combination_text(linkage, answer.witness->values));
  text += fmt::format("  free {:.6g} %, colliding {:.6g} %, undecided {:.6g} %, in {}\n", 100 * answer.free,
                      100 * answer.colliding, 100 * answer.undecided, io::counted(answer.cells.size(), "cell"));
  if (answer.may_lock > 0)
    text +=
        fmt::format("  the mechanism may lock, or does not get there, for {:.6g} % of them\n", 100 * answer.may_lock);
  if (answer.other_poses)
    text +=
        "  cells are about one pose of the mechanism: other ways without a lock, through undecided cells, may lead to\n"
        "  another pose at the same values\n";
  if (!answer.reason.empty()) text += "  " + answer.reason + "\n";
  return text;
}

std::string title_of(const EnvelopeArguments& arguments) {
  return internal::io::name_of(internal::io::path_of(arguments.scene.source.path).stem());
}

int run_envelope(const EnvelopeArguments& arguments) {
  const Linkage linkage = load_linkage(arguments.scene.source);
  require_drawable("--svg", arguments.svg, linkage.joints);
  // Found before anything is computed, or it would be lost.
  if (!arguments.html.empty()) load_page_template("envelope.html", arguments.template_path);
  EnvelopeOptions options = arguments.options;
  options.limits.stop = stop_on_signals();
  std::optional<Progress> progress(std::in_place);
  const Envelope answer = within_file(arguments.scene.source.path, [&] { return envelope(linkage, options); });
  progress.reset();
  if (!arguments.svg.empty()) write_output(arguments.svg, envelope_svg(linkage, answer));
  if (!arguments.html.empty())
    write_envelope_page(linkage, answer, {options.tolerance, title_of(arguments), arguments.template_path},
                        arguments.html);
  // What goes to standard output is one thing.
  if (arguments.svg != "-" && arguments.html != "-")
    print_text(arguments.json ? envelope_json(linkage, answer, options.tolerance, arguments.cells) + "\n"
                              : envelope_in_words(linkage, answer));
  return exit_code(answer.outcome, arguments.scene.allow_untested);
}

}  // namespace

void add_envelope(const Command& app, Action& action) {
  const Command command = app.add_command("envelope", "Say for which combinations of joint values bodies keep apart");
  const auto arguments = std::make_shared<EnvelopeArguments>();
  add_asked_scene(command, arguments->scene);
  command
      .add_option("--tolerance", arguments->options.tolerance,
                  "divide cells down to this share of each joint's range (1e-3)")
      .value("X");
  command.add_option("--svg", arguments->svg, "draw all combinations of two joints to FILE (- is standard output)")
      .value("FILE");
  command
      .add_option("--html", arguments->html,
                  "write a page to FILE that shows the bodies at the combination under the pointer")
      .value("FILE");
  command.add_option("--template", arguments->template_path, "with --html: the page to fill in").value("FILE");
  add_max_seconds(command, arguments->options.limits);
  command.add_flag("--json", arguments->json, "print one JSON object");
  command.add_flag("--cells", arguments->cells, "with --json: the whole partition, too");
  command.footer(
      "Example:\n"
      "  taut envelope loader.json --svg loader.svg\n"
      "\n"
      "The scene has joints instead of a time: \"joints\": {\"lift\": [0, 60]}; bodies follow them, as\n"
      "{\"revolute\": {\"pivot\": [x, y], \"by\": \"lift\"}} or {\"slide\": {\"direction\": [1, 0], \"by\": "
      "\"lift\"}}. Exit codes:\n"
      "0 free for every combination, 1 a combination collides, 2 bad input, or no pair was tested, 3 undecided,\n"
      "4 internal error.\n");
  command.on_chosen([&action, arguments] { action = [arguments] { return run_envelope(*arguments); }; });
}

}  // namespace taut::cli
