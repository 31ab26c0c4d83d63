#include <gtest/gtest.h>
#ifndef _WIN32
#include <sys/stat.h>
#endif

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/platform.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut {
using namespace internal;
namespace {

namespace fs = std::filesystem;

#ifdef _WIN32
const char* const null_device = "NUL";
#else
const char* const null_device = "/dev/null";
#endif

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
  write_file(null_device, "text");
  EXPECT_TRUE(io::is_device(null_device));
}

TEST_F(WriteFile, KeepsTheModeOfWhatItReplaces) {
#ifdef _WIN32
  GTEST_SKIP() << "files of Windows have no mode";
#endif
  const fs::path path = folder_ / "a.txt";
  write_file(path.string(), "first");
  for (const fs::perms mode : {fs::perms::owner_read | fs::perms::owner_write, fs::perms::all}) {
    fs::permissions(path, mode);
    write_file(path.string(), "second");
    EXPECT_EQ(fs::status(path).permissions(), mode);
  }
}

TEST_F(WriteFile, UnfinishedFilesCanBeRemovedAtOnce) {
  io::AtomicFile first((folder_ / "a.txt").string());
  {
    io::AtomicFile second((folder_ / "b.txt").string());
    second.stream() << "whole";
    second.commit();
  }
  EXPECT_EQ(files(), 2);
  io::remove_unfinished_files();
#ifndef _WIN32  // where the name may stay until the file is closed
  EXPECT_EQ(files(), 1);
#endif
  EXPECT_EQ(content(folder_ / "b.txt"), "whole");
}

/// As by a signal handler, after which the system closes it.
TEST_F(WriteFile, AnOpenFileCanBeRemoved) {
  const std::string name = (folder_ / "a.txt").string();
  io::SystemFile file = io::SystemFile::to_write(name);
  ASSERT_TRUE(file.write("text", 4));
  io::remove_open_file(name.c_str());
  EXPECT_TRUE(file.close());
  EXPECT_EQ(files(), 0);
}

TEST_F(WriteFile, NamesEndWhereTheyEnd) {
  EXPECT_THROW(write_file((folder_ / "a").string() + std::string("\0b", 2), "text"), InputError);
  EXPECT_THROW(io::read_text_file(null_device + std::string("\0b", 2), 10), InputError);
  EXPECT_EQ(files(), 0);
}

/// Opening a pipe would wait for somebody to write to it, and a device may have no end.
TEST_F(WriteFile, OnlyRegularFilesAreRead) {
  const auto problem = [](const std::string& path) {
    try {
      io::read_text_file(path, 1 << 20);
      return std::string();
    } catch (const InputError& e) {
      EXPECT_EQ(e.place(), path);
      EXPECT_NE(e.hint(), "");
      return e.problem();
    }
  };
  EXPECT_EQ(problem(null_device), "cannot read the file: it is a device");
  EXPECT_EQ(problem(folder_.string()), "cannot read the file: it is a folder");
  write_file((folder_ / "a").string(), "text");
  EXPECT_EQ(problem((folder_ / "a").string()), "");
#ifndef _WIN32
  const std::string pipe = (folder_ / "pipe").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(problem(pipe), "cannot read the file: it is a pipe");
  EXPECT_EQ(problem("/dev/zero"), "cannot read the file: it is a device");
  fs::create_symlink("a", folder_ / "link");
  EXPECT_EQ(problem((folder_ / "link").string()), "");
#endif
}

/// Whatever the code page of a console is.
TEST_F(WriteFile, NamesAreUtf8) {
  const std::string name = io::name_of(folder_ / fs::path(u"\u30d7 \u0441\u0446 \u00e9.txt"));
  EXPECT_NE(name.find("\xe3\x83\x97 \xd1\x81\xd1\x86 \xc3\xa9.txt"), std::string::npos);
  write_file(name, "first");
  write_file(name, "text");
  EXPECT_EQ(io::read_text_file(name, 4), "text");
  EXPECT_EQ(content(io::path_of(name)), "text");
  EXPECT_EQ(files(), 1);
}

TEST(FolderOf, IsWhatTheNameBeginsWith) {
  EXPECT_EQ(io::folder_of("a"), ".");
  EXPECT_EQ(io::folder_of("a/b"), "a");
  EXPECT_EQ(io::folder_of("a/b/c"), "a/b");
  EXPECT_EQ(io::folder_of("/a"), "/");
#ifdef _WIN32
  EXPECT_EQ(io::folder_of("a\\b/c"), "a\\b");
  EXPECT_EQ(io::folder_of("a/b\\c"), "a/b");
  EXPECT_EQ(io::folder_of("C:\\a"), "C:\\");
  EXPECT_EQ(io::folder_of("C:a"), "C:");
#else
  EXPECT_EQ(io::folder_of("a\\b"), ".");
#endif
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
