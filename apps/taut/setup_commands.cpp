// taut completion SHELL and taut man: what an installation needs.
#include <memory>

#include "commands.hpp"
#include "manual.hpp"
#include "terminal.hpp"

namespace taut::cli {

void add_completion(const Command& app, Action& action) {
  const Command command = app.add_command("completion", "Print completions for bash, zsh or fish");
  command.hide();  // not in `taut --help`, which is to fit a screen; its last line names it
  const auto shell = std::make_shared<std::string>();
  command
      .add_choice(
          "SHELL", {"bash", "zsh", "fish"}, [shell](const std::string& word) { *shell = word; }, "bash, zsh or fish")
      .required();
  command.footer(
      "Example:\n"
      "  source <(taut completion bash)        for this shell\n"
      "  taut completion bash >~/.local/share/bash-completion/completions/taut\n"
      "  taut completion fish >~/.config/fish/completions/taut.fish\n"
      "  taut completion zsh >_taut            into a folder of $fpath\n");
  command.on_chosen([app, &action, shell] {
    action = [app, shell] {
      print_text(completion(command_model(app), *shell));
      return static_cast<int>(exit_free);
    };
  });
}

void add_man(const Command& app, Action& action) {
  const Command command = app.add_command("man", "Print the manual page");
  command.hide();
  command.footer(
      "Example:\n"
      "  taut man | man -l -\n"
      "  taut man >/usr/local/share/man/man1/taut.1\n");
  command.on_chosen([app, &action] {
    action = [app] {
      print_text(manual(command_model(app), TAUT_VERSION));
      return static_cast<int>(exit_free);
    };
  });
}

}  // namespace taut::cli
