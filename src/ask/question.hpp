// What describes a question to those who ask it by text: `ask()`, Python and the npm package.
//
// One QuestionEntry says its name, its options with their types, defaults and meanings, and the type of its answer.
// From it options are read and checked, and the functions and types of the npm package are written. Python's functions
// look up the types of their options there.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "io/json_document.hpp"
#include "io/json_object.hpp"
#include "taut/ask.hpp"
#include "taut/check.hpp"
#include "taut/envelope.hpp"

namespace taut::internal {

class GivenOptions;

/// A word is one of a few, a text any.
enum class OptionType : std::uint8_t { number, whole_number, flag, word, text };

/// An option by the name that it has on the command line, with underscores.
struct OptionEntry {
  std::string name;
  OptionType type = OptionType::number;
  /// In words that hold for every interface: units, and what the default is.
  const char* meaning = "";
  /// Without it there is no question: an argument by position in Python and npm.
  bool required = false;
  /// The default of a number.
  double otherwise = 0;
  /// Of whole numbers: the range, and the default.
  std::uint64_t least = 0, most = 0, otherwise_whole = 0;
  /// Of words: the first one is the default.
  std::vector<std::string> words = {};
};

OptionEntry number_option(const char* name, double otherwise, const char* meaning);
OptionEntry required_number(const char* name, const char* meaning);
OptionEntry required_text(const char* name, const char* meaning);
OptionEntry whole_option(const char* name, std::uint64_t least, std::uint64_t most, std::uint64_t otherwise,
                         const char* meaning);
OptionEntry flag_option(const char* name, const char* meaning);
OptionEntry word_option(const char* name, std::vector<std::string> words, const char* meaning);

/// Options that several questions take.
OptionEntry touch_option();
OptionEntry engine_option();
OptionEntry pairs_option();
OptionEntry max_seconds_option();
OptionEntry max_events_option();
OptionEntry clearance_option();

/// What comes out of a question besides the answer, or goes into it.
enum class QuestionLog : std::uint8_t { none, written, read };

/// One question. One of `about_scene`, `about_linkage` and `about_problem` answers it.
struct QuestionEntry {
  std::string name;
  const char* meaning = "";
  /// What the type of its answer is called in TypeScript: packaging/npm/src/answers.d.ts declares it.
  const char* answer = "";
  std::vector<OptionEntry> options;
  Reply (*about_scene)(const Scene&, const GivenOptions&) = nullptr;
  Reply (*about_linkage)(const Linkage&, const GivenOptions&) = nullptr;
  Reply (*about_problem)(const PathProblem&, const GivenOptions&) = nullptr;
  QuestionLog log = QuestionLog::none;
};

/// The options that came with a question, read as its entry says.
class GivenOptions {
 public:
  /// Throws InputError for text that is no object of the entry's options. Both must outlive this.
  GivenOptions(const Question& question, const QuestionEntry& entry);

  /// The option of that name and type, or its default. Throws InputError for a value that it does not take, and where
  /// it is required and not there.
  double number(const char* name) const;
  std::uint64_t whole_number(const char* name) const;
  bool flag(const char* name) const;
  std::string word(const char* name) const;
  /// Of a text that is required.
  std::string text(const char* name) const;
  /// The value that the word stands for, by its place in the option's words.
  template <class Value>
  Value word_as(const char* name, const std::vector<Value>& values) const {
    return values[word_index(name)];
  }

  /// Options that mean the same in every question.
  Touch touch() const { return word_as<Touch>("touch", {Touch::open, Touch::closed}); }
  bool all_pairs() const { return word("pairs") == "all"; }
  Limits limits() const { return {number("max_seconds"), question_.stop}; }
  /// As far as the question takes them; the others have their defaults.
  CheckOptions check() const;
  const std::string& log() const { return question_.log; }

 private:
  const OptionEntry& option(const char* name, OptionType type) const;
  bool takes(const char* name) const;
  std::size_t word_index(const char* name) const;

  const Question& question_;
  const QuestionEntry& entry_;
  io::JsonDocument document_;
  io::JsonObject object_;
};

/// What `check` returns about the question's log; or why the log proves nothing.
Reply verified(const std::function<std::string(std::istream&)>& check, const GivenOptions& given);

/// The body of that name, which an option called "body" gives. Throws InputError if there is none.
BodyId body_called(const Scene& scene, const std::string& name);

/// The questions of a file each, in the order of the documentation.
std::vector<QuestionEntry> contact_questions();
std::vector<QuestionEntry> distance_questions();
std::vector<QuestionEntry> overlap_questions();
std::vector<QuestionEntry> separate_questions();
std::vector<QuestionEntry> mechanism_questions();
std::vector<QuestionEntry> proof_questions();
std::vector<QuestionEntry> envelope_questions();
std::vector<QuestionEntry> path_questions();
std::vector<QuestionEntry> swept_questions();
std::vector<QuestionEntry> follow_questions();
std::vector<QuestionEntry> cells_questions();
std::vector<QuestionEntry> flatten_questions();
std::vector<QuestionEntry> draw_questions();

inline constexpr std::array question_families{
    contact_questions, distance_questions, overlap_questions, separate_questions, mechanism_questions,
    proof_questions,   envelope_questions, path_questions,    swept_questions,    follow_questions,
    cells_questions,   flatten_questions,  draw_questions};

}  // namespace taut::internal
