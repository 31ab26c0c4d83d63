#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/number_text.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut {
namespace {

namespace fs = std::filesystem;

class WriteFile : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(::testing::TempDir()) / (std::string("taut_file_test_") + info->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  static std::string content(const fs::path& path) {
    std::ostringstream out;
    out << std::ifstream(path, std::ios::binary).rdbuf();
    return out.str();
  }
  std::ptrdiff_t files() const { return std::distance(fs::directory_iterator(folder_), fs::directory_iterator()); }

  fs::path folder_;
};

TEST_F(WriteFile, CreatesAndReplaces) {
  const fs::path path = folder_ / "a.txt";
  write_file(path.string(), "first");
  EXPECT_EQ(content(path), "first");
  write_file(path.string(), std::string("se\0cond\n", 8));
  EXPECT_EQ(content(path), std::string("se\0cond\n", 8));
  EXPECT_EQ(files(), 1) << "a temporary file was left";
}

TEST_F(WriteFile, LeavesNothingBehindOnFailure) {
  const fs::path path = folder_ / "is_a_folder";
  fs::create_directories(path / "not_empty");
  EXPECT_THROW(write_file(path.string(), "text"), InputError);
  EXPECT_EQ(files(), 1);
  EXPECT_TRUE(fs::is_directory(path));
}

TEST_F(WriteFile, NamesAMissingFolder) {
  try {
    write_file((folder_ / "no" / "a.txt").string(), "text");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_EQ(e.place(), (folder_ / "no" / "a.txt").string());
    EXPECT_NE(e.problem().find("No such file or directory"), std::string::npos);
    EXPECT_NE(e.hint().find("folder"), std::string::npos);
  }
}

TEST_F(WriteFile, DoesNotReplaceADevice) {
  write_file("/dev/null", "text");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(WriteFile, AFolderIsNoScene) { EXPECT_THROW(read_scene(folder_.string()), InputError); }

TEST(PlaceInText, CountsLinesAndColumnsFromOne) {
  const std::string text = "ab\ncd\n";
  EXPECT_EQ(io::place_in_text(text, "f", 0), "f:1:1");
  EXPECT_EQ(io::place_in_text(text, "f", 1), "f:1:2");
  EXPECT_EQ(io::place_in_text(text, "f", 2), "f:1:3");
  EXPECT_EQ(io::place_in_text(text, "f", 3), "f:2:1");
  EXPECT_EQ(io::place_in_text(text, "f", 99), "f:3:1");
}

TEST(Excerpt, DoesNotCutACharacter) {
  EXPECT_EQ(io::excerpt("short"), "short");
  EXPECT_EQ(io::excerpt("ab\xC3\xA9xyz", 3), "ab...");
  EXPECT_EQ(io::excerpt("ab\xC3\xA9xyz", 4), "ab\xC3\xA9...");
  EXPECT_EQ(io::excerpt("\x1b[31m"), "?[31m");
}

TEST(NumberText, ScansDecimalsOnly) {
  const auto scan = [](const std::string& text) {
    std::size_t position = 0;
    const auto number = io::scan_number(text, &position);
    return std::pair(number, position);
  };
  EXPECT_EQ(scan("-1.5e2x"), std::pair(std::optional(-150.0), std::size_t{6}));
  EXPECT_EQ(scan("1e"), std::pair(std::optional(1.0), std::size_t{1}));
  EXPECT_EQ(scan("0x10"), std::pair(std::optional(0.0), std::size_t{1}));
  for (const char* text : {"", ".", "-", "e5", "inf", "nan", "+.e1"}) EXPECT_FALSE(scan(text).first) << text;
}

}  // namespace
}  // namespace taut
