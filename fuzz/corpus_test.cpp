// Scenes that once broke something, and the examples, from all sides: what the fuzz target `session` does.
#include <gtest/gtest.h>

#include <filesystem>

#include "examine.hpp"
#include "support/effort.hpp"
#include "taut/io.hpp"

namespace taut::fuzz {
namespace {

class Examined : public ::testing::TestWithParam<std::string> {};

TEST_P(Examined, NothingIsWrong) {
  Evaluations looks;
  looks.max_events = testing::effort(500);
  looks.max_seconds = 60;
  std::string report;
  const Finding found = examine(read_scene(GetParam()), looks, &report);
  EXPECT_EQ(found.kind, FindingKind::none) << found.message << '\n' << report;
}

std::vector<std::string> scenes() {
  std::vector<std::string> all;
  for (const char* folder : {"tests/corpus", "examples"}) {
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(TAUT_ROOT) / folder)) {
      if (entry.path().extension() == ".json" && entry.path().stem().extension() != ".answer")
        all.push_back(entry.path().string());
    }
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Examined, ::testing::ValuesIn(scenes()));

}  // namespace
}  // namespace taut::fuzz
