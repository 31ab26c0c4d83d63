// The commands and their options as data, read off the definitions that parse them: completions and the manual are made
// from it, so that they cannot differ from what the program accepts.
#pragma once

#include <string>
#include <vector>

#include "command_line/command_line.hpp"

namespace taut::cli {

struct OptionModel {
  std::vector<std::string> names;    ///< "--touch", "-o", ...; empty for a positional
  std::string positional;            ///< "SCENE"; empty for an option
  std::string value;                 ///< "T", "FILE", "open|closed"; empty for a flag
  std::vector<std::string> choices;  ///< the words that the value may be, if these are few
  std::string description;           ///< may have line breaks

  bool takes_file() const { return value == "FILE" || !positional.empty(); }
};

struct CommandModel {
  std::string name;         ///< "taut check"
  std::string description;  ///< one line
  std::string footer;       ///< examples and more
  std::vector<OptionModel> options;
  std::vector<CommandModel> commands;

  /// The last word of the name.
  std::string word() const { return name.substr(name.rfind(' ') + 1); }
};

CommandModel command_model(const Command& taut);

}  // namespace taut::cli
