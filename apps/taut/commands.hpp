// The subcommands of taut, one file each.
#pragma once

#include <functional>
#include <string>
#include "command_line/command_line.hpp"

namespace taut::cli {

/// What the process returns. Part of the interface: scripts and CI jobs depend on it.
enum ExitCode : int {
  exit_free = 0,       ///< or: the command did what it was asked
  exit_contact = 1,    ///< contact or overlap at the start
  exit_bad_input = 2,  ///< the scene or the command line is wrong, or nothing was tested
  exit_undecided = 3,  ///< a limit was hit first
  exit_internal = 4,   ///< a defect of taut
};

/// Set to the chosen subcommand's work while the command line is parsed, run afterwards.
using Action = std::function<int()>;

void add_check(const Command& app, Action& action);
void add_trace(const Command& app, Action& action);
void add_prove(const Command& app, Action& action);
void add_verify(const Command& app, Action& action);
void add_draw(const Command& app, Action& action);
void add_view(const Command& app, Action& action);
void add_clearance(const Command& app, Action& action);
void add_intervals(const Command& app, Action& action);
void add_range(const Command& app, Action& action);
void add_separate(const Command& app, Action& action);
void add_envelope(const Command& app, Action& action);
void add_cells(const Command& app, Action& action);
void add_flatten(const Command& app, Action& action);
void add_separator(const Command& app, Action& action);
void add_schema(const Command& app, Action& action);
/// `program`: how it was called, argv[0].
void add_demo(const Command& app, Action& action, const std::string& program);
void add_completion(const Command& app, Action& action);
void add_man(const Command& app, Action& action);
void add_gen(const Command& app, Action& action);
void add_import(const Command& app, Action& action);

}  // namespace taut::cli
