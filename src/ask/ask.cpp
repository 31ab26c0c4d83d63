// Questions as text: a table of their names, of the options that each one takes, and of the functions that answer.
#include "taut/ask.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <sstream>
#include <utility>

#include "io/answer_json.hpp"
#include "io/json_numbers.hpp"
#include "io/json_object.hpp"
#include "io/json_text.hpp"
#include "io/number_text.hpp"
#include "numeric/budget.hpp"
#include "taut/clearance.hpp"
#include "taut/error.hpp"
#include "taut/intervals.hpp"
#include "taut/io.hpp"
#include "taut/proof.hpp"
#include "taut/separate.hpp"

namespace taut::internal {
namespace {

/// All whole numbers up to this one are doubles.
constexpr std::uint64_t most_events = std::uint64_t{1} << 53;

/// The options of one question, read when its function asks for them.
class QuestionOptions {
 public:
  QuestionOptions(const Question& question, const std::vector<std::string>& known)
      : question_(question),
        document_(io::parse_json(question.options, "options", "{}")),
        object_(document_, 0, "", known, R"({"max_seconds": 5})") {}

  double number(const char* key, double otherwise) const {
    const auto token = object_.find(key);
    return token ? io::read_number(document_, *token, key) : otherwise;
  }
  double required(const char* key) const { return io::read_number(document_, object_.get(key), key); }
  std::uint64_t whole_number(const char* key, std::uint64_t least, std::uint64_t most, std::uint64_t otherwise) const {
    if (!object_.find(key)) return otherwise;
    const double given = required(key);
    if (!(given >= static_cast<double>(least) && given <= static_cast<double>(most) && given == std::floor(given)))
      throw InputError(key,
                       io::number_text(given) + " is not a whole number from " + std::to_string(least) + " to " +
                           std::to_string(most),
                       "give one, or leave it out");
    return static_cast<std::uint64_t>(given);
  }
  int instants() const { return static_cast<int>(whole_number("instants", 2, 1000000, 101)); }
  bool flag(const char* key) const {
    const auto token = object_.find(key);
    if (!token) return false;
    document_.require(*token, io::JsonKind::boolean, key, "true or false");
    return io::value_text(document_, *token) == "true";
  }
  /// The value that a word stands for; the first one where none is given.
  template <class Value>
  Value word(const char* key, std::initializer_list<std::pair<const char*, Value>> words) const {
    const auto token = object_.find(key);
    if (!token) return words.begin()->second;
    std::string all;
    for (const auto& [name, value] : words) all += (all.empty() ? "" : ", ") + io::string_text(name);
    document_.require(*token, io::JsonKind::string, key, "one of " + all);
    const std::string given = document_.string_at(*token);
    for (const auto& [name, value] : words)
      if (given == name) return value;
    throw InputError(key, "unknown value " + io::string_text(given), "one of " + all);
  }

  Touch touch() const { return word<Touch>("touch", {{"open", Touch::open}, {"closed", Touch::closed}}); }
  bool all_pairs() const { return word<bool>("pairs", {{"first", false}, {"all", true}}); }
  Limits limits() const { return {number("max_seconds", Limits{}.max_seconds), question_.stop}; }
  CheckOptions check() const {
    CheckOptions options;
    options.limits = limits();
    options.touch = touch();
    options.all_pairs = all_pairs();
    options.engine = word<EngineChoice>("engine", {{"usual", EngineChoice::usual},
                                                   {"kinetic", EngineChoice::kinetic},
                                                   {"spacetime", EngineChoice::spacetime},
                                                   {"both", EngineChoice::both},
                                                   {"either", EngineChoice::either}});
    options.fit = number("fit", 0);
    options.time_tolerance = number("time_tolerance", options.time_tolerance);
    options.max_events = whole_number("max_events", 0, most_events, options.max_events);
    return options;
  }
  const std::string& log() const { return question_.log; }

 private:
  const Question& question_;
  io::JsonDocument document_;
  io::JsonObject object_;
};

Reply ask_check(const Scene& scene, const QuestionOptions& given) {
  const CheckOptions options = given.check();
  return {answer_json(scene, check(scene, options), options.touch)};
}

Reply ask_margin(const Scene& scene, const QuestionOptions& given) {
  const CheckOptions options = given.check();
  const double clearance = given.required("clearance");
  return {margin_json(scene, clearance, check_clearance(scene, clearance, options), options.touch)};
}

/// What clearance() and distance_profile() have in common.
template <class Options>
Options distance_options(const QuestionOptions& given) {
  Options options;
  options.limits = given.limits();
  options.relative = given.number("tolerance", options.relative);
  options.all_pairs = given.all_pairs();
  return options;
}

Reply ask_clearance(const Scene& scene, const QuestionOptions& given) {
  return {clearance_json(scene, clearance(scene, distance_options<ClearanceOptions>(given)))};
}

Reply ask_profile(const Scene& scene, const QuestionOptions& given) {
  ProfileOptions options = distance_options<ProfileOptions>(given);
  options.instants = given.instants();
  return {profile_json(scene, distance_profile(scene, options))};
}

Reply ask_intervals(const Scene& scene, const QuestionOptions& given) {
  const CheckOptions options = given.check();
  return {intervals_json(scene, intervals(scene, options), options.touch)};
}

Reply ask_range(const Scene& scene, const QuestionOptions& given) {
  const CheckOptions options = given.check();
  const double from = given.required("from");
  return {range_json(scene, from, range(scene, from, options), options.touch)};
}

Reply ask_separate(const Scene& scene, const QuestionOptions& given) {
  SeparateOptions options;
  options.limits = given.limits();
  options.travel = given.number("travel", options.travel);
  return {separation_json(scene, separate(scene, options))};
}

Reply ask_proof(const Scene& scene, const QuestionOptions& given) {
  const CheckOptions options = given.check();
  std::ostringstream log;
  const Answer answer = prove(scene, log, options);
  // There is nothing to prove about bodies that overlap from the start, or where nothing was decided.
  const bool proved = answer.outcome == Outcome::free || answer.contact || answer.free_until > scene.start;
  return {answer_json(scene, answer, options.touch), proved ? log.str() : std::string(),
          to_hex(scene_fingerprint(scene, options.touch))};
}

Reply ask_proof_of_margin(const Scene& scene, const QuestionOptions& given) {
  const CheckOptions options = given.check();
  const double clearance = given.required("clearance");
  std::ostringstream log;
  const MarginAnswer answer = prove_clearance(scene, clearance, log, options);
  return {margin_json(scene, clearance, answer, options.touch), log.str(),
          to_hex(scene_fingerprint(scene, options.touch))};
}

Reply ask_verify(const Scene& scene, const QuestionOptions& given) {
  try {
    const Budget scope(given.limits());
    std::istringstream stream(given.log());
    return {verified_json(scene, verify(scene, stream))};
  } catch (const ProofError& error) {
    return {unverified_json(true, error.what())};
  } catch (const Interrupted& limit) {
    return {unverified_json(false, limit.reason)};
  }
}

struct QuestionEntry {
  std::string name;
  std::vector<std::string> options;
  Reply (*answer)(const Scene&, const QuestionOptions&);
};

const std::vector<QuestionEntry>& table() {
  static const std::vector<QuestionEntry> entries = {
      {"check", {"touch", "engine", "pairs", "max_seconds", "max_events", "fit", "time_tolerance"}, ask_check},
      {"check_clearance", {"clearance", "touch", "pairs", "max_seconds"}, ask_margin},
      {"clearance", {"tolerance", "pairs", "max_seconds"}, ask_clearance},
      {"distance_profile", {"instants", "tolerance", "pairs", "max_seconds"}, ask_profile},
      {"intervals", {"touch", "max_seconds"}, ask_intervals},
      {"range", {"from", "touch", "max_seconds"}, ask_range},
      {"separate", {"travel", "max_seconds"}, ask_separate},
      {"prove", {"touch", "engine", "max_seconds", "max_events"}, ask_proof},
      {"prove_clearance", {"clearance", "touch", "max_seconds"}, ask_proof_of_margin},
      {"verify", {"max_seconds"}, ask_verify},
  };
  return entries;
}

constexpr const char* envelope_name = "envelope";

[[noreturn]] void refuse_name(const std::string& name) {
  const std::string near = io::nearest_word(name, question_names());
  throw InputError("question", "there is no question " + io::string_text(name),
                   near.empty() ? "ask check, or another one" : "did you mean " + near + "?");
}

}  // namespace
}  // namespace taut::internal

namespace taut {
using namespace internal;

std::vector<std::string> question_names() {
  std::vector<std::string> names;
  for (const QuestionEntry& entry : table()) names.push_back(entry.name);
  names.push_back(envelope_name);
  return names;
}

Reply ask(const Question& question, const Scene& scene) {
  const auto& all = table();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& e) { return e.name == question.name; });
  if (question.name == envelope_name)
    throw InputError("question", "an envelope is of joints, and this is a scene over time", "give it \"joints\"");
  if (found == all.end()) refuse_name(question.name);
  return found->answer(scene, QuestionOptions(question, found->options));
}

Reply ask(const Question& question, const Linkage& linkage) {
  if (question.name != envelope_name) refuse_name(question.name);
  const QuestionOptions given(question, {"tolerance", "cells", "max_seconds"});
  EnvelopeOptions options;
  options.limits = given.limits();
  options.tolerance = given.number("tolerance", options.tolerance);
  return {envelope_json(linkage, envelope(linkage, options), options.tolerance, given.flag("cells"))};
}

}  // namespace taut
