// taut: when do moving shapes first touch?
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <iterator>
#include <string_view>

#include "commands.hpp"
#include "interrupt.hpp"
#include "io/json_object.hpp"
#include "io/platform.hpp"
#include "io/text_file.hpp"
#include "scene/names.hpp"
#include "taut/error.hpp"
#include "taut/simulation.hpp"
#include "terminal.hpp"

namespace {

const char* const examples =
    "Example: taut demo lid && taut check lid.json. More: taut COMMAND --help; taut schema; taut completion "
    "bash|zsh|fish; taut "
    "man\n"
    "Exit codes: 0 free, 1 contact or overlap at the start, 2 bad input or nothing tested, 3 undecided, 4 internal "
    "error.\n";

/// CLI11 would only say that a subcommand is required.
void require_known_command(const taut::cli::Command& taut, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  const std::vector<std::string> known = taut.command_names();
  const std::string word = argv[1];
  if (std::find(known.begin(), known.end(), word) != known.end()) return;
  const std::string near = taut::internal::nearest_word(word, known);
  throw taut::InputError("", fmt::format("unknown command \"{}\"", taut::internal::io::excerpt(word)),
                         near.empty() ? "see `taut --help`" : fmt::format("did you mean `taut {}`?", near));
}

/// Only the command that is called: to define all of them takes longer than most questions. All of them where there is
/// none, for help and for what is said of unknown ones.
void add_commands(const taut::cli::Command& app, taut::cli::Action& action, int argc, char** argv) {
  const std::string_view word = argc > 1 ? argv[1] : "";
  if (argc == 2 && word == "--version") return;
  const auto called = std::find_if(std::begin(taut::cli::commands), std::end(taut::cli::commands),
                                   [&](const taut::cli::NamedCommand& c) { return c.name == word; });
  if (called != std::end(taut::cli::commands) && !called->needs_all) return called->add(app, action);
  taut::cli::add_demo(app, action, argc > 0 ? argv[0] : "taut");
  for (const taut::cli::NamedCommand& command : taut::cli::commands) command.add(app, action);
}

}  // namespace

int main(int argc, char** argv) {
  taut::internal::io::start_program(argc, argv);
  taut::cli::Program program("taut: exactly when moving shapes first touch, or a proof that they never do", "taut");
  program.version("taut " TAUT_VERSION);
  const taut::cli::Command app = program.command();
  app.require_command();
  app.footer(examples);
  taut::cli::Action action;
  add_commands(app, action, argc, argv);
  taut::cli::clean_up_on_signals();
  try {
    require_known_command(app, argc, argv);
    if (!program.parse(argc, argv)) return taut::cli::flushed("taut", taut::cli::exit_free);
    return taut::cli::flushed("taut", action());
  } catch (const taut::cli::UsageError& error) {
    taut::cli::print_error("taut", error.text_with_hint("see `taut --help` or `taut COMMAND --help`"));
    return taut::cli::exit_bad_input;
  } catch (const taut::InputError& error) {
    taut::cli::print_error("taut", error);
    return taut::cli::exit_bad_input;
  } catch (const taut::UndecidedError& error) {
    taut::cli::print_error("taut", error.what());
    return taut::cli::exit_undecided;
  } catch (const std::exception& error) {
    taut::cli::print_error(
        "taut", std::string("internal error: ") + error.what() +
                    "\nThis is a defect of taut. Please report it, together with the scene and the command line.");
    return taut::cli::exit_internal;
  }
}
