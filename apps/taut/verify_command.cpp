#include "verify_report.hpp"

#include <memory>

#include "commands.hpp"

namespace taut::cli {

void add_verify(const Command& app, Action& action) {
  const Command command = app.add_command("verify", "Check a proof, and say what it proves");
  const auto arguments = std::make_shared<VerifyArguments>();
  add_verify_options(command, *arguments, "taut verify scene.json scene.proof");
  command.on_chosen([&action, arguments] { action = [arguments] { return verify_and_report(*arguments); }; });
}

}  // namespace taut::cli
