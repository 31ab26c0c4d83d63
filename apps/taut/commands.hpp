// The subcommands of taut, one file each.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace taut::cli {

/// What the process returns. Part of the interface: scripts and CI jobs depend on it.
enum ExitCode : int {
  exit_free = 0,       ///< or: the command did what it was asked
  exit_contact = 1,    ///< contact or overlap at the start
  exit_bad_input = 2,  ///< the scene or the command line is wrong
  exit_undecided = 3,  ///< a limit was hit first
  exit_internal = 4,   ///< a defect of taut
};

/// Set to the chosen subcommand's work while the command line is parsed, run afterwards.
using Action = std::function<int()>;

void add_check(CLI::App& app, Action& action);
void add_trace(CLI::App& app, Action& action);
void add_prove(CLI::App& app, Action& action);
void add_verify(CLI::App& app, Action& action);
void add_draw(CLI::App& app, Action& action);
void add_view(CLI::App& app, Action& action);
void add_separator(CLI::App& app, Action& action);
void add_schema(CLI::App& app, Action& action);
void add_demo(CLI::App& app, Action& action);
void add_completion(CLI::App& app, Action& action);
void add_man(CLI::App& app, Action& action);
void add_gen(CLI::App& app, Action& action);

}  // namespace taut::cli
