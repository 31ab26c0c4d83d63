#include "verify_report.hpp"

#include <memory>

#include "commands.hpp"

namespace taut::cli {

void add_verify(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("verify", "Check a proof, and say what it proves");
  const auto arguments = std::make_shared<VerifyArguments>();
  add_verify_options(*command, *arguments, "taut verify scene.json scene.proof");
  command->callback([&action, arguments] { action = [arguments] { return verify_and_report(*arguments); }; });
}

}  // namespace taut::cli
