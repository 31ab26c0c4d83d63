#include "command_line/command_line.hpp"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <optional>

namespace taut::cli {
namespace {

/// CLI11's own checks name all of the range, which has 300 digits.
std::string number_fault(const std::string& text, bool zero_allowed) {
  double value = 0;
  if (!CLI::detail::lexical_cast(text, value)) return "'" + text + "' is not a number";
  if (value > 0 || (zero_allowed && value == 0)) return {};
  return "'" + text + "' is not " + (zero_allowed ? "0 or more" : "more than 0");
}

}  // namespace

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
  return Option(app_->add_option(names, value, description));
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
    : app_(std::make_unique<CLI::App>(description, name)) {}
Program::~Program() = default;

void Program::version(const std::string& text) { app_->set_version_flag("--version", text); }

bool Program::parse(int argc, char** argv) {
  try {
    app_->parse(argc, argv);
    return true;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) throw UsageError(error.what());
    app_->exit(error);
    return false;
  }
}

int run_program(Program& program, int argc, char** argv, const std::function<int()>& work) {
  const char* const name = argc > 0 ? argv[0] : "";
  try {
    return program.parse(argc, argv) ? work() : 0;
  } catch (const UsageError& error) {
    std::fprintf(stderr, "%s: %s\nhint: --help lists the options\n", name, error.what());
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
