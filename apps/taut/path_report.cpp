#include "path_report.hpp"

#include <fmt/format.h>

#include "commands.hpp"
#include "coverage_text.hpp"
#include "feature_text.hpp"
#include "io/text.hpp"

namespace taut::cli {
namespace {

std::string values_text(const PathProblem& problem, const JointValues& values) {
  std::string text;
  for (std::size_t k = 0; k < problem.linkage.joints.size(); ++k)
    text += fmt::format("{}{} = {:.9g}", k ? ", " : "", problem.linkage.joints[k].name, values[k]);
  return text;
}

std::string name_in(const PathProblem& problem, BodyId id) {
  return problem.linkage.scene.bodies[static_cast<std::size_t>(id)].name;
}

std::string length_text(const PathLength& length) {
  if (!(length.shortest_at_least > 0)) return fmt::format("  {:.9g} long\n", length.way);
  return fmt::format("  {:.9g} long; every way is at least {:.9g} long, so this one is at most {:.3g} % too long\n",
                     length.way, length.shortest_at_least, 100 * (length.way / length.shortest_at_least - 1));
}

}  // namespace

std::string path_in_words(const PathProblem& problem, const PathAnswer& answer) {
  std::string text = answer.outcome == PathOutcome::path       ? "PATH  from the start to the goal\n"
                     : answer.outcome == PathOutcome::none     ? "NONE  there is no way from the start to the goal\n"
                     : answer.outcome == PathOutcome::untested ? "UNTESTED\n"
                                                               : "UNDECIDED\n";
  text += coverage_text(answer.coverage);
  for (const JointValues& values : answer.waypoints) text += "  " + values_text(problem, values) + "\n";
  if (answer.length) text += length_text(*answer.length);
  if (!answer.reason.empty()) text += "  " + answer.reason + "\n";
  if (answer.tight) {
    text += fmt::format("  {} x {}, about {}\n", name_in(problem, answer.tight->pair[0]),
                        name_in(problem, answer.tight->pair[1]), values_text(problem, answer.tight->values));
    for (const TightFeatures& f : answer.tight->features)
      text += fmt::format("    {} and {}, {:.3g} apart\n", vertex_text(problem.linkage.scene, f.vertex),
                          edge_text(problem.linkage.scene, f.edge), f.distance);
  }
  text +=
      answer.exact ? "  decided by exact signs\n" : "  " + internal::io::counted(answer.cells.size(), "cell") + "\n";
  return text;
}

int exit_code(PathOutcome outcome, bool allow_untested) {
  switch (outcome) {
    case PathOutcome::path:
      return exit_free;
    case PathOutcome::none:
      return exit_contact;
    case PathOutcome::untested:
      return allow_untested ? exit_free : exit_bad_input;
    case PathOutcome::undecided:
      break;
  }
  return exit_undecided;
}

}  // namespace taut::cli
