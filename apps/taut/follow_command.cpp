// taut follow: how high does a cam lift its follower?
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "chosen_body.hpp"
#include "commands.hpp"
#include "interrupt.hpp"
#include "report.hpp"
#include "scene_argument.hpp"
#include "scene_source.hpp"
#include "taut/follow.hpp"
#include "terminal.hpp"
#include "watched_run.hpp"

namespace taut::cli {
namespace {

struct FollowArguments {
  SceneSource scene;
  std::string body, csv, contacts_csv;
  double direction = 90, reach = 0;
  FollowOptions options;
  bool json = false;
};

/// What touches in a stretch: the first few.
std::string touching_text(const Scene& scene, const std::vector<FollowContact>& contacts) {
  constexpr std::size_t most = 4;
  std::string text;
  for (std::size_t k = 0; k < std::min(most, contacts.size()); ++k)
    text += (k > 0 ? ", " : "") + contact_text(scene, contacts[k]);
  return contacts.size() > most ? fmt::format("{} and {} others", text, contacts.size() - most) : text;
}

std::string stretch_text(const Scene& scene, const FollowStretch& s) {
  const std::string touching = touching_text(scene, s.contacts);
  switch (s.state) {
    case FollowState::carried:
      return fmt::format("  [{:.10g}, {:.10g}] {}\n", s.time.lo, s.time.hi, touching);
    case FollowState::low:
      return fmt::format("  [{:.10g}, {:.10g}] below 0\n", s.time.lo, s.time.hi);
    case FollowState::change:
      if (s.once) return fmt::format("  {:.10g} {}\n", s.time.lo, s.jumps ? "jumps" : "changes");
      return fmt::format("  {:.10g} {}among {}\n", s.time.lo, s.jumps ? "jumps, " : "", touching);
    case FollowState::open:
      break;
  }
  return fmt::format("  [{:.10g}, {:.10g}] UNDECIDED{}{}\n", s.time.lo, s.time.hi, touching.empty() ? "" : ", among ",
                     touching);
}

/// The sequence of contacts, its first lines.
std::string contacts_text(const Scene& scene, const FollowOptions& options, const FollowAnswer& answer) {
  if (!options.contacts) return {};
  constexpr std::size_t most = 40;
  const auto decided = std::count_if(answer.contacts.begin(), answer.contacts.end(), [](const FollowStretch& s) {
    return s.state == FollowState::carried || s.state == FollowState::low;
  });
  std::string text = fmt::format("CONTACTS  {} {}, changes known to {:.3g} of the time\n", decided,
                                 decided == 1 ? "stretch" : "stretches", options.tolerance);
  for (std::size_t k = 0; k < std::min(most, answer.contacts.size()); ++k)
    text += stretch_text(scene, answer.contacts[k]);
  if (answer.contacts.size() > most)
    text += fmt::format("  and {} more: --contacts-csv and --json have all\n", answer.contacts.size() - most);
  if (!answer.contacts_reason.empty()) text += "  " + answer.contacts_reason + "\n";
  return text;
}

bool is_decided(const FollowAnswer& answer) { return answer.undecided.empty() && answer.contacts_reason.empty(); }

std::string in_words(const Scene& scene, BodyId body, const FollowOptions& options, const FollowAnswer& answer) {
  const std::string& name = scene.bodies[static_cast<std::size_t>(body)].name;
  const std::vector<Lift>& lifts = answer.lifts;
  const std::string grounds = grounds_text(scene, answer.coverage);
  std::string open;
  if (!answer.undecided.empty()) {
    const std::size_t more = answer.undecided.size() - 1;
    open = fmt::format("  undecided on [{}, {}]{}: {}\n", answer.undecided[0].lo, answer.undecided[0].hi,
                       more > 0 ? fmt::format(" and {} other stretch{} of time", more, more > 1 ? "es" : "") : "",
                       answer.reason);
    if (lifts.empty()) return fmt::format("UNDECIDED  {}   on [{}, {}]\n", name, scene.start, scene.end) + open;
  }
  if (lifts.empty())
    return fmt::format("NOT LIFTED  {}   on [{}, {}]\n", name, scene.start, scene.end) + grounds +
           fmt::format("  at {} instants nothing reaches up to where it is drawn\n", options.instants);
  const auto [low, high] =
      std::minmax_element(lifts.begin(), lifts.end(), [](const Lift& a, const Lift& b) { return a.lift < b.lift; });
  const auto extreme = [](const Lift& at) { return fmt::format("{:.10g} at t = {:.10g}", at.lift[0], at.time.lo); };
  double widest = 0;
  for (const Lift& at : lifts) widest = std::max(widest, at.lift[1] - at.lift[0]);
  return fmt::format("LIFTED  {}   on [{}, {}]\n", name, scene.start, scene.end) + grounds +
         fmt::format("  at {} of {} instants, from {} to {}\n  known to {:.3g}\n", lifts.size(), options.instants,
                     extreme(*low), extreme(*high), widest) +
         open;
}

int run_follow(const FollowArguments& arguments) {
  const Scene scene = load_scene(arguments.scene);
  FollowOptions options = arguments.options;
  if (!arguments.contacts_csv.empty()) options.contacts = true;
  options.limits.stop = stop_on_signals();
  const BodyId body = chosen_body(scene, arguments.body);
  const FollowAnswer answer = watched(scene, arguments.scene.path, [&] {
    return follow(scene, body, direction_of(arguments.direction), arguments.reach, options);
  });
  if (!arguments.csv.empty()) write_output(arguments.csv, follow_csv(answer));
  if (!arguments.contacts_csv.empty()) write_output(arguments.contacts_csv, follow_contacts_csv(scene, answer));
  // What goes to standard output is one thing.
  const int code = is_decided(answer) ? exit_free : exit_undecided;
  if (arguments.csv == "-" || arguments.contacts_csv == "-") return code;
  print_text(arguments.json ? follow_json(scene, body, options, answer) + "\n"
                            : in_words(scene, body, options, answer) + contacts_text(scene, options, answer));
  return code;
}

}  // namespace

void add_follow(const Command& app, Action& action) {
  const Command command = app.add_command("follow", "Find the lift of a follower on a cam");
  const auto arguments = std::make_shared<FollowArguments>();
  add_scene(command, arguments->scene);
  command.add_option("--body", arguments->body, "the follower").value("NAME").required();
  command.add_option("--reach", arguments->reach, "the lift at which it clears all other bodies at all times")
      .value("X")
      .positive()
      .required();
  command
      .add_option("--direction-deg", arguments->direction,
                  "along which it is lifted, counterclockwise from the x axis (90)")
      .value("A");
  command.add_option("--instants", arguments->options.instants, "at about how many instants (360)").value("N");
  command.add_flag("--contacts", arguments->options.contacts, "also find what touches what, at all times");
  command
      .add_option("--tolerance", arguments->options.tolerance,
                  "of the contacts: how long a change may be, as a share of the time (1e-9)")
      .value("X");
  add_touch(command, arguments->options.touch);
  command.add_option("--csv", arguments->csv, "write the lifts to FILE, with their bounds (- is standard output)")
      .value("FILE");
  command.add_option("--contacts-csv", arguments->contacts_csv, "write the contacts to FILE, and find them")
      .value("FILE");
  add_max_seconds(command, arguments->options.limits);
  command.add_flag("--json", arguments->json, "print one JSON object");
  command.footer(
      "Example:\n"
      "  taut follow examples/curves/cam.json --body roller --reach 20\n"
      "\n"
      "The follower is pressed onto the cam at all times. Its lift is counted from where the scene has it, and is not "
      "known\n"
      "where nothing reaches up to there. Every instant and every lift is enclosed; what touches only between two "
      "instants is\n"
      "not among the lifts: --contacts lists it, too, for bodies without curves. Exit code 3 if some of the time is "
      "undecided.\n");
  command.on_chosen([&action, arguments] { action = [arguments] { return run_follow(*arguments); }; });
}

}  // namespace taut::cli
