// taut_shrink SCENE -o OUT: a short scene that fails as SCENE does.
#include <fmt/format.h>

#include "command_line/command_line.hpp"
#include "examine.hpp"
#include "shrink.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut::fuzz {
namespace {

struct Arguments {
  std::string scene, output;
  double seconds = 20;
  int tries = 5000;
  bool undecided = false, look_only = false;
};

int run(const Arguments& arguments) {
  const Scene scene = read_scene(arguments.scene);
  Evaluations looks;
  looks.undecided = arguments.undecided;
  const auto examined = [&](const Scene& s, std::string* report) {
    return in_process_apart([&](std::string& text) { return examine(s, looks, &text); }, arguments.seconds, report);
  };
  std::string report;
  const Finding found = examined(scene, &report);
  fmt::print("{}{}\n", report, found.message);
  if (!found.is_defect()) {
    fmt::print(stderr, "taut_shrink: {}: nothing is wrong here\n", arguments.scene);
    return 1;
  }
  if (arguments.look_only) return 0;
  const std::string signature = found.signature();
  int kept = 0;
  const auto still_fails = [&](const Scene& s) {
    const bool fails = examined(s, nullptr).signature() == signature;
    if (fails && ++kept % 20 == 0) fmt::print(stderr, "{} simplifications\n", kept);
    return fails;
  };
  const Scene small = shrunk(scene, still_fails, arguments.tries);
  write_file(arguments.output, write_scene(small));
  fmt::print("{} bytes instead of {}, in {}\n", write_scene(small).size(), write_scene(scene).size(), arguments.output);
  return 0;
}

}  // namespace
}  // namespace taut::fuzz

int main(int argc, char** argv) {
  taut::cli::Program program("Turns a scene that fails into a short one with the same failure.", "taut_shrink");
  const taut::cli::Command app = program.command();
  taut::fuzz::Arguments arguments;
  app.add_option("SCENE", arguments.scene, "scene file on which the engines, the proof or the audit fail").required();
  const taut::cli::Option output = app.add_option("-o,--output", arguments.output, "the short scene");
  app.add_option("--seconds", arguments.seconds, "a scene that takes longer hangs (20)").positive();
  app.add_option("--tries", arguments.tries, "give up after so many scenes (5000)").positive();
  app.add_flag("--undecided", arguments.undecided, "count what the precision does not decide as a failure");
  app.add_flag("--look", arguments.look_only, "only tell what is wrong").excludes(output);
  return taut::cli::run_program(program, argc, argv, [&] {
    if (!arguments.look_only && arguments.output.empty())
      throw taut::cli::UsageError("say where to write the short scene: -o FILE");
    return taut::fuzz::run(arguments);
  });
}
