// The manual page, in the macros of man(7).
#include <fmt/format.h>

#include "manual.hpp"

namespace taut::cli {

namespace {

/// Text that roff must take literally.
std::string literal(const std::string& text) {
  std::string s;
  bool line_start = true;
  for (const char c : text) {
    if (line_start && (c == '.' || c == '\'')) s += "\\&";
    line_start = c == '\n';
    if (c == '\\')
      s += "\\e";
    else if (c == '-')
      s += "\\-";
    else
      s += c;
  }
  return s;
}

std::string synopsis(const CommandModel& command) {
  std::string s = ".B " + literal(command.name) + "\n";
  if (!command.commands.empty()) return s + ".I COMMAND\n";
  for (const OptionModel& option : command.options) {
    if (!option.positional.empty()) s += ".I " + literal(option.positional) + "\n";
  }
  return s + "[options]\n";
}

std::string options(const CommandModel& command) {
  std::string s;
  for (const OptionModel& option : command.options) {
    std::string names = option.positional;
    for (const std::string& name : option.names) names += (names.empty() ? "" : ", ") + name;
    if (!option.value.empty() && option.positional.empty()) names += " " + option.value;
    s += ".TP\n.B " + literal(names) + "\n" + literal(option.description) + "\n";
  }
  return s;
}

/// A command and those within it.
std::string section(const CommandModel& command) {
  std::string s = ".SS " + literal(command.name) + "\n" + synopsis(command) + ".PP\n" + literal(command.description) +
                  ".\n" + options(command);
  if (!command.footer.empty()) s += ".PP\n.nf\n" + literal(command.footer) + ".fi\n";
  for (const CommandModel& inner : command.commands) s += section(inner);
  return s;
}

}  // namespace

std::string manual(const CommandModel& taut, const std::string& version) {
  std::string s = fmt::format(".TH TAUT 1 \"\" \"taut {0}\" \"User Commands\"\n.SH NAME\ntaut \\- {1}\n.SH SYNOPSIS\n",
                              version, literal(taut.description.substr(taut.description.find(": ") + 2)));
  s += synopsis(taut) + ".SH OPTIONS\n" + options(taut) + ".SH COMMANDS\n";
  for (const CommandModel& command : taut.commands) s += section(command);
  return s + ".SH NOTES\n.nf\n" + literal(taut.footer) + ".fi\n";
}

}  // namespace taut::cli
