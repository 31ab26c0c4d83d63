// Keyframes from CSV files.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "io/motion_reader.hpp"
#include "support/bad_input.hpp"
#include "taut/error.hpp"

namespace taut {
using namespace internal;
namespace {

std::vector<Keyframe> csv(const std::string& text, const ReadLimits& limits = {}) {
  return io::parse_keyframes_csv(text, "k.csv", limits);
}

void expect_keyframe(const Keyframe& k, double t, double x, double y, double angle) {
  EXPECT_EQ(k.t, t);
  EXPECT_EQ(k.x, x);
  EXPECT_EQ(k.y, y);
  EXPECT_EQ(k.angle_deg, angle);
}

TEST(KeyframesCsv, ReadsColumnsByName) {
  const auto all = csv("t,x,y,angle_deg\n0,1,2,3\n0.5,-1e1,.5,+360\n");
  ASSERT_EQ(all.size(), 2u);
  expect_keyframe(all[0], 0, 1, 2, 3);
  expect_keyframe(all[1], 0.5, -10, 0.5, 360);
  const auto some = csv("\xEF\xBB\xBF\r\n angle_deg , t \r\n\r\n90 , 1\r\n 45,2 \r\n\t\r\n");
  ASSERT_EQ(some.size(), 2u);
  expect_keyframe(some[0], 1, 0, 0, 90);
  expect_keyframe(some[1], 2, 0, 0, 45);
  EXPECT_EQ(csv("t\n7").size(), 1u);
}

class BadCsvTest : public ::testing::TestWithParam<testing::BadInput> {};

TEST_P(BadCsvTest, IsRefused) {
  testing::expect_refused(GetParam(), [](const std::string& text) { csv(text); });
}

const std::vector<testing::BadInput> bad_files = {
    {"empty", " \n", "k.csv", "the file is empty", "t,x,y,angle_deg"},
    {"no_header", "0,1,2,3\n1,2,3,4\n", "k.csv:1:1", "unknown column in the header", "t,x,y,angle_deg"},
    {"no_time", "x,y\n0,1\n", "k.csv:1:1", "no column \"t\"", "t,x,y,angle_deg"},
    {"misspelt_column", "t,angle\n0,1\n", "k.csv:1:3", "unknown column in the header", "did you mean \"angle_deg\"?"},
    {"column_twice", "t,x,x\n0,1,2\n", "k.csv:1:5", "the column \"x\" appears twice", "keep one"},
    {"empty_column", "t,,x\n0,1,2\n", "k.csv:1:3", "unknown column in the header", "t,x,y,angle_deg"},
    {"semicolons", "t;x\n0;1\n", "k.csv:1:1", "the columns are separated by semicolons", "separate them by commas"},
    {"semicolons_in_a_line", "t,x\n0;1\n", "k.csv:2:2", "the columns are separated by semicolons", "with a point"},
    {"header_only", "t,x\n\n", "k.csv:3:1", "there are no keyframes", "a line of numbers"},
    {"too_few", "t,x,y\n0,1,2\n1,1\n", "k.csv:3:4", "expected 3 numbers as in the header, found 2", "commas"},
    {"too_many", "t,x\n0,1\n1,2,3\n", "k.csv:3:4", "more numbers than columns", "each column"},
    {"empty_field", "t,x\n0,\n", "k.csv:2:3", "expected a number", "decimal"},
    {"word", "t,x\n0,one\n", "k.csv:2:3", "expected a number", "decimal"},
    {"text_after_a_number", "t,x\n0,1 m\n", "k.csv:2:5", "unexpected text", "commas"},
    {"quotes", "t,x\n\"0\",\"1\"\n", "k.csv:2:1", "expected a number", "decimal"},
    {"too_large", "t,x\n0,1e999\n", "k.csv:2:3", "too large", "1.8e308"},
    {"same_time", "t\n0\n\n0\n", "k.csv:4:1", "not later than that of the line before", "by time"},
    {"unsorted", "t,x\n0,0\n2,0\n1,0\n", "k.csv:4:1", "not later than that of the line before", "by time"},
};

INSTANTIATE_TEST_SUITE_P(Files, BadCsvTest, ::testing::ValuesIn(bad_files), testing::name_of);

TEST(KeyframesCsv, LimitsAreKept) {
  EXPECT_EQ(csv("t\n1\n2\n", {.max_pieces = 2}).size(), 2u);
  EXPECT_THROW(csv("t\n1\n2\n3\n", {.max_pieces = 2}), InputError);
}

TEST(KeyframesCsv, AreFoundInTheFolderOfTheScene) {
  const auto folder = std::filesystem::path(::testing::TempDir()) / "taut_keyframes";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "drive.csv") << "t,x\n0,5\n1,4\n";
  const std::string polygon = R"("polygon":[[0,0],[1,0],[0,1]])";
  std::ofstream(folder / "s.json") << R"({"format":"taut-scene/1","time":[0,1],"bodies":[{"name":"P",)" << polygon
                                   << R"(},{"name":"Q",)" << polygon << R"(,"motion":{"csv":"drive.csv"}}]})";
  const Scene scene = read_scene((folder / "s.json").string());
  EXPECT_EQ(scene.bodies[1].motion.pieces.size(), 3u);
  EXPECT_EQ(scene.bodies[1].motion.pieces[1].x, (Coefficients{5, -1}));
  std::ofstream(folder / "drive.csv") << "t,x\n0,5\n0,4\n";
  try {
    read_scene((folder / "s.json").string());
    ADD_FAILURE() << "was accepted";
  } catch (const InputError& e) {
    EXPECT_NE(e.place().find("motion.csv: " + folder.string() + "/drive.csv:3:1"), std::string::npos) << e.what();
  }
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace taut
