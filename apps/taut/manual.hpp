// What is written from the definitions of the commands: completions and the manual.
#pragma once

#include <string>

#include "command_line/command_model.hpp"

namespace taut::cli {

/// The text of `taut completion SHELL`, for "bash", "zsh" or "fish".
std::string completion(const CommandModel& taut, const std::string& shell);

/// The manual page in man(7) macros.
std::string manual(const CommandModel& taut, const std::string& version);

}  // namespace taut::cli
