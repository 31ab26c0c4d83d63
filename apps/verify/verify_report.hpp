// What `taut verify` and `taut-verify` do.
#pragma once

#include <string>
#include "command_line/command_line.hpp"

#include "expectation.hpp"
#include "scene_source.hpp"

namespace taut::cli {

struct VerifyArguments {
  SceneSource scene;
  std::string proof;
  bool json = false;
  Expectation expected;
  double max_seconds = 1e300;
};

/// Adds all that the two programs take, and what `--help` says.
void add_verify_options(const Command& command, VerifyArguments& arguments, const std::string& example);

/// Checks the log and prints what it proves. Returns 0 if it is valid and proves what was expected, 1 if not, 3 if the
/// time was up; throws InputError.
int verify_and_report(const VerifyArguments& arguments);

}  // namespace taut::cli
