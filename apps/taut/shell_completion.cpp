// Completions for three shells. Where a word is wanted, the shell offers the words; where a file, files.
#include <fmt/format.h>

#include "manual.hpp"
#include "taut/error.hpp"

namespace taut::cli {

namespace {

/// Every command that words can follow, the program itself first.
void flatten(const CommandModel& command, std::vector<const CommandModel*>& all) {
  all.push_back(&command);
  for (const CommandModel& inner : command.commands) flatten(inner, all);
}

std::string joined(const std::vector<std::string>& words, const std::string& separator = " ") {
  std::string s;
  for (const std::string& word : words) s += (s.empty() ? "" : separator) + word;
  return s;
}

std::vector<std::string> options_of(const CommandModel& command) {
  std::vector<std::string> words;
  for (const OptionModel& option : command.options) words.insert(words.end(), option.names.begin(), option.names.end());
  return words;
}

/// What may stand where no option does: inner commands, or the words for an argument. If there are none, it is a file.
std::vector<std::string> words_of(const CommandModel& command) {
  std::vector<std::string> words;
  for (const CommandModel& inner : command.commands) words.push_back(inner.word());
  for (const OptionModel& option : command.options)
    if (!option.positional.empty()) words.insert(words.end(), option.choices.begin(), option.choices.end());
  return words;
}

std::string one_line(std::string text) {
  for (char& c : text) {
    if (c == '\n') c = ' ';
  }
  return text;
}

std::string escaped(const std::string& text, const std::string& special) {
  std::string s;
  for (const char c : text) {
    if (special.find(c) != std::string::npos) s += '\\';
    s += c;
  }
  return s;
}

// bash: the command is the words that are no options, as far as they are known; what was typed before decides whether a
// value is wanted.

std::string bash_values(const CommandModel& command) {
  std::string cases;
  for (const OptionModel& option : command.options) {
    if (option.names.empty() || option.value.empty()) continue;
    const std::string reply = !option.choices.empty()
                                  ? "COMPREPLY=($(compgen -W \"" + joined(option.choices) + "\" -- \"$word\"))"
                              : option.takes_file() ? "COMPREPLY=(); _taut_files"
                                                    : "COMPREPLY=()";
    cases += fmt::format("        {}) {}; return ;;\n", joined(option.names, "|"), reply);
  }
  return cases.empty() ? "" : "      case \"$before\" in\n" + cases + "      esac\n";
}

std::string bash(const std::vector<const CommandModel*>& all) {
  std::string s =
      "# bash completion for taut, made by `taut completion bash`\n"
      "# Line by line: a name may have spaces.\n"
      "_taut_files() {\n"
      "  local name\n"
      "  while IFS= read -r name; do COMPREPLY+=(\"$name\"); done < <(compgen -f -- \"$word\")\n"
      "}\n"
      "_taut() {\n"
      "  local word=\"${COMP_WORDS[COMP_CWORD]}\" before=\"${COMP_WORDS[COMP_CWORD-1]}\" command=taut i\n"
      "  for ((i = 1; i < COMP_CWORD; i++)); do\n"
      "    case \"$command ${COMP_WORDS[i]}\" in\n";
  for (std::size_t k = 1; k < all.size(); ++k) s += fmt::format("      \"{0}\") command=\"{0}\" ;;\n", all[k]->name);
  s += "    esac\n  done\n  case \"$command\" in\n";
  for (const CommandModel* command : all) {
    s += fmt::format("    \"{}\")\n{}", command->name, bash_values(*command));
    const std::string words = joined(words_of(*command));
    const auto offer = [](const std::string& from) {
      return fmt::format("COMPREPLY=($(compgen -W \"{}\" -- \"$word\"))", from);
    };
    s += fmt::format("      if [[ $word == -* ]]; then {}; else {}; fi\n      ;;\n",
                     offer(joined(options_of(*command))), words.empty() ? "COMPREPLY=(); _taut_files" : offer(words));
  }
  return s + "  esac\n}\ncomplete -o filenames -F _taut taut\n";
}

// zsh: _arguments takes the options of a command, and goes on to the function of an inner command.

std::string zsh_function(const CommandModel& command) {
  std::string s = "_";
  for (const char c : command.name) s += c == ' ' ? '_' : c;
  return s;
}

std::string zsh_option(const OptionModel& option) {
  const std::string what = escaped(one_line(option.description), "[]:'\\");
  std::string action;
  if (!option.choices.empty())
    action = ":" + option.value + ":(" + joined(option.choices) + ")";
  else if (option.takes_file())
    action = ":" + (option.positional.empty() ? option.value : option.positional) + ":_files";
  else if (!option.value.empty())
    action = ":" + option.value + ": ";
  std::string quoted;
  for (const char c : what) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  if (option.names.empty()) return " \\\n    '" + action + "'";
  std::string s;
  for (const std::string& name : option.names) s += fmt::format(" \\\n    '{}[{}]{}'", name, quoted, action);
  return s;
}

std::string zsh(const std::vector<const CommandModel*>& all) {
  std::string s = "#compdef taut\n# zsh completion for taut, made by `taut completion zsh`\n";
  for (auto it = all.rbegin(); it != all.rend(); ++it) {
    const CommandModel& command = **it;
    s += zsh_function(command) + "() {\n";
    std::string options;
    for (const OptionModel& option : command.options) options += zsh_option(option);
    if (command.commands.empty()) {
      s += "  _arguments" + options + "\n}\n";
      continue;
    }
    s += "  local state line\n  _arguments -C" + options +
         " \\\n    '1: :->command' '*:: :->rest'\n  case $state in\n    command)\n      local -a words=(\n";
    for (const CommandModel& inner : command.commands)
      s += fmt::format("        \"{}:{}\"\n", inner.word(), escaped(inner.description, "\"$`\\:"));
    s += "      )\n      _describe command words ;;\n    rest)\n      case $line[1] in\n";
    for (const CommandModel& inner : command.commands)
      s += fmt::format("        {}) {} ;;\n", inner.word(), zsh_function(inner));
    s += "      esac ;;\n  esac\n}\n";
  }
  return s + "if [ \"$funcstack[1]\" = _taut ]; then _taut \"$@\"; else compdef _taut taut; fi\n";
}

// fish: a line for each word or option, with the commands after which it may stand.

std::string fish_quoted(const std::string& text) { return "'" + escaped(one_line(text), "'\\") + "'"; }

std::string fish_condition(const CommandModel& command) {
  std::string inner;
  for (const CommandModel& c : command.commands) inner += " " + c.word();
  std::string condition;
  const std::size_t space = command.name.find(' ');
  if (space != std::string::npos) {
    for (std::size_t at = space; at != std::string::npos;) {
      const std::size_t next = command.name.find(' ', at + 1);
      condition += (condition.empty() ? "" : "; and ") + std::string("__fish_seen_subcommand_from ") +
                   command.name.substr(at + 1, next == std::string::npos ? next : next - at - 1);
      at = next;
    }
  }
  if (!inner.empty())
    condition += (condition.empty() ? "" : "; and ") + std::string("not __fish_seen_subcommand_from") + inner;
  return condition;
}

std::string fish(const std::vector<const CommandModel*>& all) {
  std::string s = "# fish completion for taut, made by `taut completion fish`\n";
  for (const CommandModel* command : all) {
    const std::string condition = fish_quoted(fish_condition(*command));
    for (const CommandModel& inner : command->commands)
      s += fmt::format("complete -c taut -f -n {} -a {} -d {}\n", condition, inner.word(),
                       fish_quoted(inner.description));
    for (const OptionModel& option : command->options) {
      if (option.names.empty() && !option.choices.empty())
        s += fmt::format("complete -c taut -f -n {} -a {}\n", condition, fish_quoted(joined(option.choices)));
      if (option.names.empty()) continue;
      s += fmt::format("complete -c taut -n {}", condition);
      for (const std::string& name : option.names)
        s += name.rfind("--", 0) == 0 ? " -l " + name.substr(2) : " -s " + name.substr(1);
      if (!option.choices.empty())
        s += " -x -a " + fish_quoted(joined(option.choices));
      else if (option.takes_file())
        s += " -r";
      else if (!option.value.empty())
        s += " -x";
      s += " -d " + fish_quoted(option.description) + "\n";
    }
  }
  return s;
}

}  // namespace

std::string completion(const CommandModel& taut, const std::string& shell) {
  std::vector<const CommandModel*> all;
  flatten(taut, all);
  if (shell == "bash") return bash(all);
  if (shell == "zsh") return zsh(all);
  return fish(all);
}

}  // namespace taut::cli
