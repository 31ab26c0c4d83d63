// The list of all questions, and the one that is asked.
#include "taut/ask.hpp"

#include <algorithm>

#include "ask/question.hpp"
#include "io/json_writer.hpp"
#include "scene/names.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut::internal {
namespace {

const std::vector<QuestionEntry>& entries() {
  static const std::vector<QuestionEntry> all = [] {
    std::vector<QuestionEntry> joined;
    for (const auto& family : question_families) {
      for (const QuestionEntry& entry : family()) joined.push_back(entry);
    }
    return joined;
  }();
  return all;
}

/// Null for a name that no question has.
const QuestionEntry* find_entry(const std::string& name) {
  const auto& all = entries();
  const auto found = std::find_if(all.begin(), all.end(), [&](const QuestionEntry& e) { return e.name == name; });
  return found == all.end() ? nullptr : &*found;
}

const QuestionEntry& entry_of(const std::string& name) {
  if (const QuestionEntry* entry = find_entry(name)) return *entry;
  const std::string near = nearest_word(name, question_names());
  throw InputError("question", "there is no question " + io::string_text(name),
                   near.empty() ? "ask check, or another one" : "did you mean " + near + "?");
}

const char* type_name(OptionType type) {
  switch (type) {
    case OptionType::number:
      return "number";
    case OptionType::whole_number:
      return "whole number";
    case OptionType::flag:
      return "flag";
    case OptionType::text:
      return "text";
    case OptionType::word:
      break;
  }
  return "word";
}

void write_option(io::JsonWriter& json, const OptionEntry& option) {
  json.object([&] {
    json.member("name", option.name);
    json.member("type", type_name(option.type));
    json.member("meaning", option.meaning);
    json.member("required", option.required);
    // A limit that nothing reaches is none.
    const bool limited = option.type == OptionType::number && !option.required && option.otherwise < 1e300;
    if (limited) json.member("default", option.otherwise);
    if (option.type == OptionType::whole_number && option.otherwise_whole <= option.most)
      json.member("default", option.otherwise_whole);
    if (!option.words.empty())
      json.key("words").array(option.words, [&](const std::string& word) { json.string(word); });
  });
}

const char* about(const QuestionEntry& entry) {
  return entry.about_scene ? "scene" : entry.about_linkage ? "linkage" : "problem";
}

/// The entry is about something else than `given`.
[[noreturn]] void refuse(const QuestionEntry& entry, const char* given) {
  const std::string wanted = about(entry);
  const std::string wants = wanted == "scene"     ? "a scene over time"
                            : wanted == "linkage" ? "a linkage"
                                                  : "a linkage with a start and a goal";
  throw InputError("question", entry.name + " is asked about " + wants + ", and this is " + given,
                   wanted == "scene"     ? R"(give it "time")"
                   : wanted == "linkage" ? R"(give it "joints")"
                                         : R"(give it "joints", "start" and "goal")");
}

void write_entry(io::JsonWriter& json, const QuestionEntry& entry) {
  json.object([&] {
    json.member("name", entry.name);
    json.member("meaning", entry.meaning);
    json.member("about", about(entry));
    json.member("answer", entry.answer);
    json.member("writes_log", entry.log == QuestionLog::written);
    json.member("reads_log", entry.log == QuestionLog::read);
    json.key("options").array(entry.options, [&](const OptionEntry& option) { write_option(json, option); });
  });
}

}  // namespace
}  // namespace taut::internal

namespace taut {
using namespace internal;

std::vector<std::string> question_names() {
  std::vector<std::string> names;
  for (const QuestionEntry& entry : entries()) names.push_back(entry.name);
  return names;
}

std::string question_descriptions() {
  return io::json_text([](io::JsonWriter& json) {
    json.array(entries(), [&](const QuestionEntry& entry) { write_entry(json, entry); });
  });
}

std::string asked_about(const std::string& name) {
  const QuestionEntry* entry = find_entry(name);
  return entry ? about(*entry) : "";
}

Reply ask(const Question& question, const Scene& scene) {
  const QuestionEntry& entry = entry_of(question.name);
  if (!entry.about_scene) refuse(entry, "a scene over time");
  return entry.about_scene(scene, GivenOptions(question, entry));
}

Reply ask(const Question& question, const Linkage& linkage) {
  const QuestionEntry& entry = entry_of(question.name);
  if (!entry.about_linkage) refuse(entry, "a linkage");
  return entry.about_linkage(linkage, GivenOptions(question, entry));
}

Reply ask(const Question& question, const PathProblem& problem) {
  const QuestionEntry& entry = entry_of(question.name);
  if (!entry.about_problem) refuse(entry, "a linkage with a start and a goal");
  return entry.about_problem(problem, GivenOptions(question, entry));
}

Reply ask_about_text(const Question& question, const std::string& text, const std::string& name,
                     const std::string& folder) {
  const std::string about = asked_about(question.name);
  if (about == "linkage") return ask(question, parse_linkage(text, name, folder));
  if (about == "problem") return ask(question, parse_path_problem(text, name, folder));
  return ask(question, parse_scene(text, name, folder));
}

}  // namespace taut
