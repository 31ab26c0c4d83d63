// The subcommands of taut, one file each.
#pragma once

#include <functional>
#include <string>
#include <string_view>

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

/// `program`: how it was called, argv[0].
void add_demo(const Command& app, Action& action, const std::string& program);

/// Adds the subcommand of that name.
using AddCommand = void(const Command& app, Action& action);
AddCommand add_check, add_clearance, add_intervals, add_range, add_prove, add_verify, add_draw, add_view, add_trace,
    add_separate, add_mechanism, add_envelope, add_path, add_separator, add_cells, add_swept, add_follow, add_flatten,
    add_gen, add_import, add_schema, add_completion, add_man;

/// A subcommand before it is defined.
struct NamedCommand {
  std::string_view name;
  AddCommand* add;
  bool needs_all = false;  ///< it prints what the others are
};

/// In the order in which `taut --help` lists them, after demo.
inline constexpr NamedCommand commands[] = {{"check", add_check},
                                            {"clearance", add_clearance},
                                            {"intervals", add_intervals},
                                            {"range", add_range},
                                            {"prove", add_prove},
                                            {"verify", add_verify},
                                            {"draw", add_draw},
                                            {"view", add_view},
                                            {"trace", add_trace},
                                            {"separate", add_separate},
                                            {"mechanism", add_mechanism},
                                            {"envelope", add_envelope},
                                            {"path", add_path},
                                            {"separator", add_separator},
                                            {"cells", add_cells},
                                            {"swept", add_swept},
                                            {"follow", add_follow},
                                            {"flatten", add_flatten},
                                            {"gen", add_gen},
                                            {"import", add_import},
                                            {"schema", add_schema},
                                            {"completion", add_completion, true},
                                            {"man", add_man, true}};

}  // namespace taut::cli
