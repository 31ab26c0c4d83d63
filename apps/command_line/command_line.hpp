// Commands and their options, as the programs define them. CLI11 does the work, behind this small header: its own costs
// every file that includes it five seconds of compilation.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "taut/error.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace taut::cli {

/// The command line is wrong; what() says how, and may end with a line that begins with "hint: ".
class UsageError : public Error {
 public:
  using Error::Error;
  /// what(), with this hint if it has none of its own.
  std::string text_with_hint(const std::string& hint) const;
};

/// An option of a command, or one of its arguments, while it is defined.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  Option& required();
  /// What help calls the value: "FILE".
  Option& value(const std::string& text);
  Option& within(int low, int high);
  Option& positive();
  Option& not_negative();
  Option& existing_folder();
  /// Without a value, as if this one were given. A value stands behind "=": the next word is none.
  Option& or_alone(const std::string& value);
  Option& needs(const Option& other);
  Option& excludes(const Option& other);
  /// After parsing: was it given?
  bool given() const;

 private:
  CLI::Option* option_;
};

/// A command, which may have others below it. Copies are the same command.
class Command {
 public:
  explicit Command(CLI::App* app) : app_(app) {}

  Command add_command(const std::string& name, const std::string& description) const;
  /// One of `add_command` has to be given.
  void require_command() const;
  /// `names`: "-o,--output" for an option, "SCENE" for an argument. T is a string or a number, a list or an optional
  /// one: see command_line.cpp.
  template <class T>
  Option add_option(const std::string& names, T& value, const std::string& description) const;
  /// For one of some words.
  Option add_choice(const std::string& names, const std::vector<std::string>& words,
                    const std::function<void(const std::string&)>& chosen, const std::string& description) const;
  Option add_flag(const std::string& names, bool& value, const std::string& description) const;
  /// What help ends with.
  void footer(const std::string& text) const;
  /// Not in the list of commands.
  void hide() const;
  /// Called while the command line is parsed, if this is the command.
  void on_chosen(const std::function<void()>& work) const;

  std::vector<std::string> command_names() const;
  const CLI::App& app() const { return *app_; }

 private:
  CLI::App* app_;
};

/// A whole program.
class Program {
 public:
  Program(const std::string& description, const std::string& name);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  Command command() const { return Command(app_.get()); }
  /// --version prints this.
  void version(const std::string& text);
  /// False if help or the version was asked for, and is printed. Throws UsageError.
  bool parse(int argc, char** argv);

 private:
  std::unique_ptr<CLI::App> app_;
};

/// For tools: parses, runs `work` unless help was asked for, and returns the exit code; 2, with a message, if the
/// command line or the input is wrong, 1 for any other exception.
int run_program(Program& program, int argc, char** argv, const std::function<int()>& work);

}  // namespace taut::cli
