#include "command_line/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <system_error>
#include <type_traits>

#include "io/json_object.hpp"
#include "scene/names.hpp"

namespace taut::cli {
using namespace internal;
namespace {

/// CLI11's own checks name all of the range, which has 300 digits.
std::string number_fault(const std::string& text, bool zero_allowed) {
  double value = 0;
  if (!CLI::detail::lexical_cast(text, value)) return "'" + text + "' is not a number";
  if (value > 0 || (zero_allowed && value == 0)) return {};
  return "'" + text + "' is not " + (zero_allowed ? "0 or more" : "more than 0");
}

/// CLI11 would take -1 for 2^64 - 1, and the largest number for all that are larger.
std::string whole_number_fault(const std::string& text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && end == text.data() + text.size()) return {};
  return "'" + text + "' is not a whole number from 0 to " + std::to_string(UINT64_MAX);
}

}  // namespace

std::string UsageError::text_with_hint(const std::string& hint) const {
  const std::string text = what();
  return text.find("\nhint: ") == std::string::npos ? text + "\nhint: " + hint : text;
}

Option& Option::required() {
  option_->required();
  return *this;
}
Option& Option::value(const std::string& text) {
  option_->option_text(text);
  return *this;
}
Option& Option::within(int low, int high) {
  option_->check(CLI::Range(low, high));
  return *this;
}
Option& Option::positive() {
  option_->check([](const std::string& text) { return number_fault(text, false); });
  return *this;
}
Option& Option::not_negative() {
  option_->check([](const std::string& text) { return number_fault(text, true); });
  return *this;
}
Option& Option::existing_folder() {
  option_->check(CLI::ExistingDirectory);
  return *this;
}
Option& Option::or_alone(const std::string& value) {
  option_->expected(0, 1)->default_str(value);
  return *this;
}
Option& Option::needs(const Option& other) {
  option_->needs(other.option_);
  return *this;
}
Option& Option::excludes(const Option& other) {
  option_->excludes(other.option_);
  return *this;
}
bool Option::given() const { return option_->count() > 0; }

Command Command::add_command(const std::string& name, const std::string& description) const {
  return Command(app_->add_subcommand(name, description));
}
void Command::require_command() const { app_->require_subcommand(1); }

template <class T>
Option Command::add_option(const std::string& names, T& value, const std::string& description) const {
  CLI::Option* const option = app_->add_option(names, value, description);
  if constexpr (std::is_unsigned_v<T>) option->check(whole_number_fault);
  return Option(option);
}
template Option Command::add_option(const std::string&, std::string&, const std::string&) const;
template Option Command::add_option(const std::string&, std::vector<std::string>&, const std::string&) const;
template Option Command::add_option(const std::string&, double&, const std::string&) const;
template Option Command::add_option(const std::string&, std::optional<double>&, const std::string&) const;
template Option Command::add_option(const std::string&, int&, const std::string&) const;
template Option Command::add_option(const std::string&, std::optional<int>&, const std::string&) const;
template Option Command::add_option(const std::string&, unsigned&, const std::string&) const;
template Option Command::add_option(const std::string&, std::uint64_t&, const std::string&) const;

Option Command::add_choice(const std::string& names, const std::vector<std::string>& words,
                           const std::function<void(const std::string&)>& chosen,
                           const std::string& description) const {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : "|") + word;
  return Option(app_->add_option_function<std::string>(names, chosen, description)
                    ->check(CLI::IsMember(words))
                    ->option_text(all));
}
Option Command::add_flag(const std::string& names, bool& value, const std::string& description) const {
  return Option(app_->add_flag(names, value, description));
}
void Command::footer(const std::string& text) const { app_->footer(text); }
void Command::hide() const { app_->group(""); }
void Command::on_chosen(const std::function<void()>& work) const { app_->callback(work); }

std::vector<std::string> Command::command_names() const {
  std::vector<std::string> names;
  const CLI::App& app = *app_;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

Program::Program(const std::string& description, const std::string& name)
    : app_(std::make_unique<CLI::App>(description, name)) {
  // The same words on all systems; and files may have names that begin with a slash.
  app_->allow_windows_style_options(false);
}
Program::~Program() = default;

void Program::version(const std::string& text) { app_->set_version_flag("--version", text); }

namespace {

/// The innermost command that the words name.
const CLI::App& command_of(const CLI::App& app, int argc, char** argv) {
  const CLI::App* at = &app;
  for (int i = 1; i < argc; ++i) {
    for (const CLI::App* inner : at->get_subcommands({})) {
      if (inner->get_name() == argv[i]) at = inner;
    }
  }
  return *at;
}

/// "--pair" for "--pairs": the option of the command that is meant by a word which it does not know.
std::string nearest_option(const CLI::App& command, const std::string& word) {
  std::vector<std::string> known;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) known.push_back(name);
  }
  const std::string name = word.substr(2, word.find('=') - 2), near = nearest_word(name, known);
  return near.empty() ? "" : "--" + near;
}

/// CLI11's message in plain words, with what may be meant.
std::string usage_problem(const CLI::App& app, const CLI::ParseError& error, int argc, char** argv) {
  const CLI::App& command = command_of(app, argc, argv);
  const auto is = [&](CLI::ExitCodes code) { return error.get_exit_code() == static_cast<int>(code); };
  if (is(CLI::ExitCodes::ExtrasError)) {
    for (int i = 1; i < argc; ++i) {
      const std::string word = argv[i];
      if (word.rfind("--", 0) != 0 || word.size() < 4 || command.get_option_no_throw(word.substr(0, word.find('='))))
        continue;
      const std::string near = nearest_option(command, word);
      return "unknown option " + word.substr(0, word.find('=')) +
             (near.empty() ? "" : "\nhint: did you mean " + near + "?");
    }
  }
  if (is(CLI::ExitCodes::ConversionError)) {
    const std::string text = error.what(), mark = "Could not convert: ";
    const std::size_t at = text.find(mark), equals = text.find(" = ", at);
    if (at != std::string::npos && equals != std::string::npos)
      return text.substr(at + mark.size(), equals - at - mark.size()) + ": '" + text.substr(equals + 3) +
             "' is not a number";
  }
  if (is(CLI::ExitCodes::RequiredError) && command.get_require_subcommand_min() > 0) {
    std::vector<std::string> known;
    std::string all;
    for (const CLI::App* inner : command.get_subcommands({})) {
      known.push_back(inner->get_name());
      all += (all.empty() ? "" : ", ") + inner->get_name();
    }
    const std::string word = argc > 2 ? argv[2] : "", near = nearest_word(word, known);
    if (!word.empty() && word[0] != '-')
      return "unknown kind \"" + word + "\"\nhint: " + (near.empty() ? "one of " + all : "did you mean " + near + "?");
    return "what is wanted is missing\nhint: one of " + all;
  }
  return error.what();
}

/// What the option is that a message begins with: its name, its value and its description.
std::string option_hint(const CLI::App& command, const std::string& text) {
  const std::string name = text.substr(0, text.find_first_of(": "));
  const CLI::Option* option = name.rfind("--", 0) == 0 ? command.get_option_no_throw(name) : nullptr;
  if (!option || text.find('\n') != std::string::npos) return "";
  const std::string value = option->get_option_text();
  std::string hint = "\nhint: " + name + (value.empty() ? "" : " " + value) + ": ";
  for (const char c : option->get_description()) hint += c == '\n' ? std::string("; ") : std::string(1, c);
  return hint;
}

std::string usage_text(const CLI::App& app, const CLI::ParseError& error, int argc, char** argv) {
  const std::string text = usage_problem(app, error, argc, argv);
  return text + option_hint(command_of(app, argc, argv), text);
}

}  // namespace

namespace {

/// The words behind the program's name, last one first, as CLI11 takes them. CLI11 would take the word behind an option
/// whose value may be left out for the value.
std::vector<std::string> words_in_reverse(const CLI::App& app, int argc, char** argv) {
  const CLI::App& command = command_of(app, argc, argv);
  std::vector<std::string> words;
  bool options = true;
  for (int i = 1; i < argc; ++i) {
    words.emplace_back(argv[i]);
    options = options && words.back() != "--";
    const CLI::Option* option = options ? command.get_option_no_throw(words.back()) : nullptr;
    if (option && option->get_type_size_max() > 0 && option->get_expected_min() == 0)
      words.back() += "=" + option->get_default_str();
  }
  std::reverse(words.begin(), words.end());
  return words;
}

}  // namespace

bool Program::parse(int argc, char** argv) {
  try {
    app_->parse(words_in_reverse(*app_, argc, argv));
    return true;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) throw UsageError(usage_text(*app_, error, argc, argv));
    app_->exit(error);
    return false;
  }
}

int run_program(Program& program, int argc, char** argv, const std::function<int()>& work) {
  const char* const name = argc > 0 ? argv[0] : "";
  try {
    return program.parse(argc, argv) ? work() : 0;
  } catch (const UsageError& error) {
    std::fprintf(stderr, "%s: %s\n", name, error.text_with_hint("--help lists the options").c_str());
    return 2;
  } catch (const InputError& error) {
    std::fprintf(stderr, "%s: %s\n", name, error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", name, error.what());
    return 1;
  }
}

}  // namespace taut::cli
