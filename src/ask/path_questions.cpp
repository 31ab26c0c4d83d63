// The question about ways as text: path.
#include "ask/question.hpp"

#include "io/answer_writer.hpp"
#include "taut/path.hpp"

namespace taut::internal {
namespace {

using io::answer_text;
using io::AnswerWriter;

/// Of each joint by its name.
void write_values(AnswerWriter& json, const PathProblem& problem, const JointValues& values) {
  json.object([&] {
    for (std::size_t k = 0; k < problem.linkage.joints.size(); ++k)
      json.user_key(problem.linkage.joints[k].name).number(values[k]);
  });
}

void write_tight(AnswerWriter& json, const PathProblem& problem, const TightPlace& tight) {
  json.object([&] {
    json.key("values");
    write_values(json, problem, tight.values);
    json.key("size");
    write_values(json, problem, tight.size);
    json.pair("pair", tight.pair);
  });
}

void write_cell(AnswerWriter& json, const PathProblem& problem, const EnvelopeCell& cell) {
  const auto side = [&](const char* name, const JointValues& values) {
    json.key(name).array([&] {
      for (std::size_t k = 0; k < problem.linkage.joints.size(); ++k) json.number(values[k]);
    });
  };
  json.object([&] {
    json.member("state", to_string(cell.state));
    side("lo", cell.lo);
    side("hi", cell.hi);
    if (cell.state != CellState::free) json.pair("pair", cell.pair);
  });
}

}  // namespace
}  // namespace taut::internal

namespace taut {
using namespace internal;

std::string path_json(const PathProblem& problem, const PathAnswer& answer, const PathOptions& options, bool cells) {
  return answer_text(problem.linkage.scene, [&](AnswerWriter& json) {
    json.verdict(to_string(answer.outcome));
    if (answer.outcome == PathOutcome::path)
      json.key("waypoints").array(answer.waypoints, [&](const JointValues& v) { write_values(json, problem, v); });
    if (answer.tight) {
      json.key("tight");
      write_tight(json, problem, *answer.tight);
    }
    json.member("exact", answer.exact);
    json.member("touch", to_string(options.touch));
    if (options.clearance > 0) json.member("clearance", options.clearance);
    json.member("tolerance", options.tolerance);
    json.member("cell_count", static_cast<std::uint64_t>(answer.cells.size()));
    json.reason(answer.reason);
    if (cells) json.key("cells").array(answer.cells, [&](const EnvelopeCell& c) { write_cell(json, problem, c); });
    json.coverage(answer.coverage);
  });
}

}  // namespace taut

namespace taut::internal {
namespace {

Reply ask_path(const PathProblem& problem, const GivenOptions& given) {
  PathOptions options;
  options.touch = given.touch();
  options.clearance = given.number("clearance");
  options.tolerance = given.number("tolerance");
  options.max_cells = given.whole_number("max_cells");
  options.limits = given.limits();
  return {path_json(problem, find_path(problem, options), options, given.flag("cells"))};
}

}  // namespace

std::vector<QuestionEntry> path_questions() {
  const PathOptions defaults;
  return {
      {.name = "path",
       .meaning = "A way from the start to the goal on which nothing collides, or the proof that there is none.",
       .answer = "PathAnswer",
       .options = {touch_option(),
                   number_option("clearance", 0, "The distance that bodies keep all of the way; 0: touching decides."),
                   number_option("tolerance", defaults.tolerance,
                                 "Cells shorter than this share of a joint's range are not divided any more."),
                   whole_option("max_cells", 1, UINT32_MAX, defaults.max_cells,
                                "Undecided when there are so many cells."),
                   flag_option("cells", "The partition of all joint values, too."), max_seconds_option()},
       .about_problem = ask_path}};
}

}  // namespace taut::internal
