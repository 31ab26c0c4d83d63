// taut-verify: checks a proof log, with none of the code that writes such logs.
#include <fmt/format.h>

#include <cstring>
#include <exception>

#include "taut/error.hpp"
#include "taut/io.hpp"
#include "verify_report.hpp"

int main(int argc, char** argv) {
  const bool json = argc == 4 && std::strcmp(argv[1], "--json") == 0;
  if (argc != 3 && !json) {
    fmt::print(stderr, "usage: taut-verify [--json] SCENE PROOF\nexit codes: 0 valid, 1 not valid, 2 bad input\n");
    return 2;
  }
  const std::string scene = argv[argc - 2], log = argv[argc - 1];
  try {
    return taut::cli::verify_and_report(taut::read_scene(scene), scene, log, json);
  } catch (const taut::InputError& error) {
    fmt::print(stderr, "taut-verify: {}\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "taut-verify: internal error: {}\n", error.what());
    return 4;
  }
}
