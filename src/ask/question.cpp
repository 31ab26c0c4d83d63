#include "ask/question.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/json_object.hpp"
#include "io/json_writer.hpp"
#include "io/text.hpp"
#include "scene/names.hpp"
#include "taut/error.hpp"

namespace taut::internal {
namespace {

/// All whole numbers up to this one are doubles.
constexpr std::uint64_t most_events = std::uint64_t{1} << 53;

std::vector<std::string> option_names(const QuestionEntry& entry) {
  std::vector<std::string> names;
  for (const OptionEntry& option : entry.options) names.push_back(option.name);
  return names;
}

}  // namespace

OptionEntry number_option(const char* name, double otherwise, const char* meaning) {
  return {.name = name, .type = OptionType::number, .meaning = meaning, .otherwise = otherwise};
}

OptionEntry required_number(const char* name, const char* meaning) {
  return {.name = name, .type = OptionType::number, .meaning = meaning, .required = true};
}

OptionEntry required_text(const char* name, const char* meaning) {
  return {.name = name, .type = OptionType::text, .meaning = meaning, .required = true};
}

OptionEntry whole_option(const char* name, std::uint64_t least, std::uint64_t most, std::uint64_t otherwise,
                         const char* meaning) {
  return {.name = name,
          .type = OptionType::whole_number,
          .meaning = meaning,
          .least = least,
          .most = most,
          .otherwise_whole = otherwise};
}

OptionEntry flag_option(const char* name, const char* meaning) {
  return {.name = name, .type = OptionType::flag, .meaning = meaning};
}

OptionEntry word_option(const char* name, std::vector<std::string> words, const char* meaning) {
  return {.name = name, .type = OptionType::word, .meaning = meaning, .words = std::move(words)};
}

OptionEntry touch_option() {
  return word_option("touch", {"open", "closed"}, "Bodies may touch (open, the default), or touching counts (closed).");
}

OptionEntry engine_option() {
  return word_option("engine", {"usual", "kinetic", "spacetime", "both", "either"},
                     "Which engine answers: one of them, both, compared, or the first that does. Usual is either.");
}

OptionEntry pairs_option() { return word_option("pairs", {"first", "all"}, "All: every pair's own answer, too."); }

OptionEntry max_seconds_option() {
  return number_option("max_seconds", Limits{}.max_seconds, "Give up after so many seconds of wall time.");
}

OptionEntry max_events_option() {
  return whole_option("max_events", 0, most_events, CheckOptions{}.max_events,
                      "Give up after so many events of the kinetic engine.");
}

OptionEntry clearance_option() {
  return required_number("clearance", "The distance to keep, in the scene's units, > 0.");
}

GivenOptions::GivenOptions(const Question& question, const QuestionEntry& entry)
    : question_(question),
      entry_(entry),
      document_(io::parse_json(question.options, "options", "{}")),
      object_(document_, 0, "", option_names(entry), R"({"max_seconds": 5})") {}

bool GivenOptions::takes(const char* name) const {
  const auto& all = entry_.options;
  return std::any_of(all.begin(), all.end(), [&](const OptionEntry& o) { return o.name == name; });
}

const OptionEntry& GivenOptions::option(const char* name, OptionType type) const {
  for (const OptionEntry& option : entry_.options)
    if (option.name == name && option.type == type) return option;
  throw InternalError("the question " + entry_.name + " has no such option: " + name);
}

double GivenOptions::number(const char* name) const {
  const OptionEntry& of = option(name, OptionType::number);
  if (of.required) return io::read_number(document_, object_.get(name), name);
  const auto token = object_.find(name);
  return token ? io::read_number(document_, *token, name) : of.otherwise;
}

std::uint64_t GivenOptions::whole_number(const char* name) const {
  const OptionEntry& of = option(name, OptionType::whole_number);
  const auto token = object_.find(name);
  if (!token) return of.otherwise_whole;
  const double given = io::read_number(document_, *token, name);
  if (!(given >= static_cast<double>(of.least) && given <= static_cast<double>(of.most) && given == std::floor(given)))
    throw InputError(name,
                     io::number_text(given) + " is not a whole number from " + std::to_string(of.least) + " to " +
                         std::to_string(of.most),
                     "give one, or leave it out");
  return static_cast<std::uint64_t>(given);
}

bool GivenOptions::flag(const char* name) const {
  option(name, OptionType::flag);
  const auto token = object_.find(name);
  if (!token) return false;
  document_.require(*token, io::JsonKind::boolean, name, "true or false");
  return io::value_text(document_, *token) == "true";
}

std::size_t GivenOptions::word_index(const char* name) const {
  const std::vector<std::string>& words = option(name, OptionType::word).words;
  const auto token = object_.find(name);
  if (!token) return 0;
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : ", ") + io::string_text(word);
  document_.require(*token, io::JsonKind::string, name, "one of " + all);
  const std::string given = document_.string_at(*token);
  const auto found = std::find(words.begin(), words.end(), given);
  if (found == words.end()) throw InputError(name, "unknown value " + io::string_text(given), "one of " + all);
  return static_cast<std::size_t>(found - words.begin());
}

std::string GivenOptions::text(const char* name) const {
  option(name, OptionType::text);
  const auto token = object_.get(name);
  document_.require(token, io::JsonKind::string, name, "a text");
  return document_.string_at(token);
}

std::string GivenOptions::word(const char* name) const {
  return option(name, OptionType::word).words[word_index(name)];
}

CheckOptions GivenOptions::check() const {
  CheckOptions options;
  options.limits = limits();
  if (takes("touch")) options.touch = touch();
  if (takes("pairs")) options.all_pairs = all_pairs();
  if (takes("engine"))
    options.engine =
        word_as<EngineChoice>("engine", {EngineChoice::usual, EngineChoice::kinetic, EngineChoice::spacetime,
                                         EngineChoice::both, EngineChoice::either});
  if (takes("fit")) options.fit = number("fit");
  if (takes("time_tolerance")) options.time_tolerance = number("time_tolerance");
  if (takes("max_events")) options.max_events = whole_number("max_events");
  return options;
}

BodyId body_called(const Scene& scene, const std::string& name) {
  const auto found =
      std::find_if(scene.bodies.begin(), scene.bodies.end(), [&](const Body& body) { return body.name == name; });
  if (found != scene.bodies.end()) return static_cast<BodyId>(found - scene.bodies.begin());
  std::string names;
  for (const Body& body : scene.bodies) names += (names.empty() ? "" : ", ") + body.name;
  throw no_such_body(names_of(scene.bodies), name, "body", "", "the scene has " + names);
}

}  // namespace taut::internal
