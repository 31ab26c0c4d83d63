#include <memory>

#include "commands.hpp"
#include "scene_argument.hpp"
#include "verify_report.hpp"

namespace taut::cli {

namespace {

struct VerifyArguments {
  std::string path, proof;
  bool json = false;
};

}  // namespace

void add_verify(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("verify", "Check a proof, and say what it proves");
  const auto arguments = std::make_shared<VerifyArguments>();
  add_scene(*command, arguments->path);
  command->add_option("PROOF", arguments->proof, "proof log, or - for standard input")->required()->option_text(" ");
  command->add_flag("--json", arguments->json, "print one JSON object");
  command->footer(
      "Example:\n"
      "  taut verify scene.json scene.proof\n"
      "\n"
      "Exit codes: 0 the proof is valid (whatever it proves), 1 it is not, 2 bad input.\n");
  command->callback([&action, arguments] {
    action = [arguments] {
      return verify_and_report(load_scene(arguments->path), arguments->path, arguments->proof, arguments->json);
    };
  });
}

}  // namespace taut::cli
