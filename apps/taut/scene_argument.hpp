// What several subcommands share.
#pragma once

#include <cstdint>
#include <string>
#include "command_line/command_line.hpp"

#include "scene_source.hpp"
#include "taut/check.hpp"
#include "taut/scene.hpp"

namespace taut::cli {

/// Adds --touch open|closed.
void add_touch(const Command& command, Touch& touch);
/// Adds --engine kinetic|spacetime|both|either.
void add_engine(const Command& command, EngineChoice& engine);
/// Adds --max-events and --max-seconds.
void add_limits(const Command& command, CheckOptions& options);

/// Writes to a file, or to standard output if `path` is empty or "-".
void write_output(const std::string& path, const std::string& text);

/// The exit code that an outcome stands for.
int exit_code(Outcome outcome);

}  // namespace taut::cli
