// The questions about ways as text: path, prove_path and verify_path.
#include <sstream>

#include "ask/question.hpp"

#include "io/answer_writer.hpp"
#include "taut/path.hpp"
#include "taut/path_proof.hpp"

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
    json.key("features").array(tight.features, [&](const TightFeatures& f) {
      json.object([&] {
        json.vertex("vertex", f.vertex);
        json.edge("edge", f.edge);
        json.member("distance", f.distance);
      });
    });
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
    if (answer.length) {
      json.key("length").object([&] {
        json.member("way", answer.length->way);
        json.member("shortest_at_least", answer.length->shortest_at_least);
        if (!answer.exact) {
          json.key("weights");
          write_values(json, problem, answer.length->weights);
        }
      });
    }
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
    if (cells)
      json.key("cells").array(answer.cells,
                              [&](const EnvelopeCell& c) { json.cell(c, problem.linkage.joints.size()); });
    json.coverage(answer.coverage);
  });
}

}  // namespace taut

namespace taut::internal {
namespace {

/// Without what not all of these take.
PathOptions path_options(const GivenOptions& given) {
  PathOptions options;
  options.touch = given.touch();
  options.clearance = given.number("clearance");
  options.tolerance = given.number("tolerance");
  options.max_cells = given.whole_number("max_cells");
  options.limits = given.limits();
  return options;
}

Reply ask_path(const PathProblem& problem, const GivenOptions& given) {
  PathOptions options = path_options(given);
  options.shortest = given.flag("shortest");
  options.within = given.number("within");
  return {path_json(problem, find_path(problem, options), options, given.flag("cells"))};
}

Reply ask_path_proof(const PathProblem& problem, const GivenOptions& given) {
  const PathOptions options = path_options(given);
  std::ostringstream log;
  const PathAnswer answer = prove_path(problem, log, options);
  return {path_json(problem, answer, options), answer.outcome == PathOutcome::none ? log.str() : std::string(),
          to_hex(path_fingerprint(problem))};
}

Reply ask_verify_path(const PathProblem& problem, const GivenOptions& given) {
  return verified([&](std::istream& log) { return verified_path_json(problem, verify_path(problem, log)); }, given);
}

}  // namespace

std::vector<QuestionEntry> path_questions() {
  const PathOptions defaults;
  const std::vector<OptionEntry> common{
      touch_option(),
      number_option("clearance", 0, "The distance that bodies keep all of the way; 0: touching decides."),
      number_option("tolerance", defaults.tolerance,
                    "Cells shorter than this share of a joint's range are not divided any more."),
      whole_option("max_cells", 1, UINT32_MAX, defaults.max_cells, "Undecided when there are so many cells."),
      max_seconds_option()};
  std::vector<OptionEntry> with_cells = common;
  const std::vector<OptionEntry> of_ways{
      flag_option("shortest", "Make the way short, and bound from below how long any way is."),
      number_option("within", defaults.within,
                    "A way that is at most this share longer than that bound is short enough."),
      flag_option("cells", "The partition of all joint values, too.")};
  with_cells.insert(with_cells.end() - 1, of_ways.begin(), of_ways.end());
  return {{.name = "path",
           .meaning = "A way from the start to the goal on which nothing collides, or the proof that there is none.",
           .answer = "PathAnswer",
           .options = with_cells,
           .about_problem = ask_path},
          {.name = "prove_path",
           .meaning = "As path, with a proof where there is none; a way is proved as a scene.",
           .answer = "PathAnswer",
           .options = common,
           .about_problem = ask_path_proof,
           .log = QuestionLog::written},
          {.name = "verify_path",
           .meaning = "Checks a proof that there is no way, whoever made it.",
           .answer = "VerifiedPath",
           .options = {max_seconds_option()},
           .about_problem = ask_verify_path,
           .log = QuestionLog::read}};
}

}  // namespace taut::internal
