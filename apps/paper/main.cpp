// taut_paper FOLDER SCENES [PART...]: measures what the paper claims and draws its figures. See docs/paper.md.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <functional>

#include "study.hpp"

int main(int argc, char** argv) {
  using namespace taut::paper;
  if (argc < 3) {
    fmt::print(stderr, "usage: taut_paper FOLDER SCENES [PART...]\n");
    return 2;
  }
  Output output(argv[1]);
  const std::string scenes = argv[2];
  const std::vector<std::pair<std::string, std::function<void()>>> parts = {
      {"figures", [&] { draw_figures(output, scenes); }},
      {"compactness", [&] { study_compactness(output); }},
      {"responsiveness", [&] { study_responsiveness(output); }},
      {"locality", [&] { study_locality(output); }},
      {"efficiency", [&] { study_efficiency(output); }},
      {"structures", [&] { study_structures(output); }},
      {"worlds", [&] { study_worlds(output); }},
  };
  try {
    for (const auto& [name, run] : parts) {
      if (argc > 3 && std::find(argv + 3, argv + argc, name) == argv + argc) continue;
      const auto start = std::chrono::steady_clock::now();
      run();
      const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
      fmt::print(stderr, "{}: {:.1f} s\n", name, spent.count());
    }
    if (argc == 3) output.finish();
  } catch (const std::exception& error) {
    fmt::print(stderr, "taut_paper: {}\n", error.what());
    return 4;
  }
  return 0;
}
