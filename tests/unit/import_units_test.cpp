// Several files in different units.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "support/drawings.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

using drawing::Import;
using drawing::ImportSettings;
using testing::DxfText;

class ImportUnits : public ::testing::Test {
 protected:
  ImportUnits()
      : folder_(std::filesystem::temp_directory_path() /
                ("taut_import_units_" + std::to_string(std::random_device()()))) {
    std::filesystem::create_directories(folder_);
    DxfText box;
    box.box({0, 0}, {2, 1});
    write("none.dxf", box.file(0));
    write("inch.dxf", box.file(1));
    write("mm.dxf", box.file(4));
    write(
        "page.svg",
        R"(<svg xmlns="http://www.w3.org/2000/svg" width="20mm" viewBox="0 0 10 10"><rect width="2" height="1"/></svg>)");
    write("pixels.svg", R"(<svg xmlns="http://www.w3.org/2000/svg"><rect width="2" height="1"/></svg>)");
    write("one.wkt", "POLYGON ((0 0, 2 0, 2 1, 0 1))");
  }
  ~ImportUnits() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }
  Import read(const std::vector<std::string>& names, const ImportSettings& settings = {}) const {
    std::vector<std::string> files;
    for (const std::string& name : names) files.push_back((folder_ / name).string());
    return drawing::examine_files(files, settings);
  }
  std::string problem(const std::vector<std::string>& names) const {
    try {
      read(names);
    } catch (const InputError& error) {
      return error.problem() + error.hint();
    }
    return "";
  }

  std::filesystem::path folder_;
};

TEST_F(ImportUnits, AreConvertedToThatOfTheFirstFile) {
  const Import import = read({"mm.dxf", "inch.dxf", "page.svg", "mm.dxf"});
  ASSERT_EQ(import.bodies.size(), 4u);
  EXPECT_NEAR(import.bodies[0].area, 2, 1e-12);
  EXPECT_NEAR(import.bodies[1].area, 2 * 25.4 * 25.4, 1e-9);
  EXPECT_NEAR(import.bodies[2].area, 8, 1e-12);
  EXPECT_TRUE(import.files[0].notes.empty());
  ASSERT_EQ(import.files[1].notes.size(), 1u);
  EXPECT_NE(import.files[1].notes[0].find("mm.dxf: times 25.4"), std::string::npos) << import.files[1].notes[0];
  EXPECT_TRUE(import.files[2].notes.empty());
  const Import inches = read({"inch.dxf", "mm.dxf"});
  EXPECT_NEAR(inches.bodies[1].area, 2 / 25.4 / 25.4, 1e-12);
  ImportSettings doubled;
  doubled.scale = 2;
  EXPECT_NEAR(read({"mm.dxf", "inch.dxf"}, doubled).bodies[1].area, 8 * 25.4 * 25.4, 1e-9);
}

TEST_F(ImportUnits, ThatAreNotKnownMustBeGivenBesideKnownOnes) {
  for (const auto& names : std::vector<std::vector<std::string>>{
           {"mm.dxf", "none.dxf"}, {"none.dxf", "mm.dxf"}, {"page.svg", "pixels.svg"}, {"one.wkt", "mm.dxf"}}) {
    const std::string what = problem(names);
    EXPECT_NE(what.find("states no unit"), std::string::npos) << names[0];
    EXPECT_NE(what.find("--unit mm"), std::string::npos) << names[0];
  }
  EXPECT_EQ(problem({"none.dxf", "one.wkt", "pixels.svg"}), "");
  ImportSettings settings;
  settings.unit = "cm";
  const Import import = read({"none.dxf", "mm.dxf", "one.wkt"}, settings);
  ASSERT_EQ(import.bodies.size(), 3u);
  EXPECT_NEAR(import.bodies[0].area, 2, 1e-12);
  EXPECT_NEAR(import.bodies[1].area, 0.02, 1e-12);
  EXPECT_NEAR(import.bodies[2].area, 2, 1e-12);
  EXPECT_NE(import.files[0].units.find("taken for cm (--unit)"), std::string::npos);
}

}  // namespace
}  // namespace taut
