#include <gtest/gtest.h>

#include <cmath>

#include "import/import.hpp"
#include "support/bad_input.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

/// "0 LINE 8 plate": groups with their values, in lines of their own.
std::string dxf_lines(const std::string& words) {
  std::string s = words;
  for (char& c : s)
    if (c == ' ') c = '\n';
  return s;
}

std::string dxf_of(const std::string& entities, const std::string& before = "") {
  return dxf_lines((before.empty() ? "" : before + " ") + "0 SECTION 2 ENTITIES " + entities + " 0 ENDSEC 0 EOF\n");
}

drawing::Import dxf_import(const std::string& text, const drawing::ImportSettings& settings = {}) {
  return drawing::import_drawings({drawing::read_drawing(text, "d.dxf", settings)}, settings);
}

const char* const triangle_lines =
    "0 LINE 8 a 10 0 20 0 11 4 21 0 0 LINE 8 a 10 0 20 3 11 4 21 0 0 LINE 8 a 10 0 20 0 11 0 21 3";

TEST(ImportDxf, PutsLinesTogetherInAnyDirection) {
  const auto import = dxf_import(dxf_of(triangle_lines));
  ASSERT_EQ(import.scene.bodies.size(), 1u);
  EXPECT_EQ(import.scene.bodies[0].name, "a");
  EXPECT_EQ(import.scene.bodies[0].polygon.size(), 3u);
  EXPECT_TRUE(import.files[0].gaps.empty());
}

TEST(ImportDxf, TakesTheLineEndsOfAllSystems) {
  for (const char* end : {"\n", "\r\n", "\r"}) {
    std::string text;
    for (const char c : dxf_of(triangle_lines)) text += c == '\n' ? std::string(end) : std::string(1, c);
    EXPECT_EQ(dxf_import(text).scene.bodies.at(0).polygon.size(), 3u);
  }
}

TEST(ImportDxf, JoinsEndsWithinTheDistanceAndNoFarther) {
  const std::string gap =
      "0 LINE 8 a 10 0 20 0 11 4 21 0 0 LINE 8 a 10 4.05 20 0 11 0 21 3 0 LINE 8 a 10 0 20 3 11 0 21 0";
  drawing::ImportSettings settings;
  settings.join = 0.06;
  const auto import = dxf_import(dxf_of(gap), settings);
  EXPECT_EQ(import.scene.bodies.at(0).polygon.size(), 3u);
  ASSERT_EQ(import.files[0].gaps.size(), 1u);
  EXPECT_NEAR(import.files[0].gaps[0].width, 0.05, 1e-12);
  // Farther than that from the end and from the line.
  settings.join = 0.02;
  try {
    dxf_import(dxf_of(gap), settings);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_NE(e.problem().find("an outline stays open, with a gap of 0.05 from (4"), std::string::npos) << e.what();
    EXPECT_NE(e.hint().find("--join 0.05"), std::string::npos) << e.what();
  }
}

TEST(ImportDxf, NestsOutlinesHolesAndIslands) {
  const auto circle = [](int r) { return "0 CIRCLE 8 a 10 0 20 0 40 " + std::to_string(r); };
  const auto import = dxf_import(dxf_of(circle(3) + " " + circle(1) + " " + circle(2)));
  const Body& body = import.scene.bodies.at(0);
  ASSERT_EQ(body.parts.size(), 2u);
  EXPECT_EQ(body.parts[0].holes.size() + body.parts[1].holes.size(), 1u);
  drawing::ImportSettings split;
  split.split = true;
  EXPECT_EQ(dxf_import(dxf_of(circle(3) + " " + circle(1) + " " + circle(2)), split).scene.bodies.size(), 2u);
}

/// Programs write 2 pi with six digits, or fewer, and rounded up it is a little more than a turn.
TEST(ImportDxf, ReadsTurnsThatWereRoundedUp) {
  const std::string plate = "0 LWPOLYLINE 8 a 90 4 70 1 10 0 20 0 10 40 20 0 10 40 20 40 10 0 20 40 ";
  const std::string ellipse = "0 ELLIPSE 8 a 10 20 20 20 11 10 21 0 40 0.5 41 0 42 ";
  const std::string arc = "0 ARC 8 a 10 20 20 20 40 10 50 0 51 ";
  for (const std::string& hole :
       {ellipse + "6.283185", ellipse + "6.28319", ellipse + "6.2832", arc + "360", arc + "360.0001"}) {
    const auto import = dxf_import(dxf_of(plate + hole));
    ASSERT_EQ(import.scene.bodies.size(), 1u) << hole;
    ASSERT_EQ(import.scene.bodies[0].parts.size(), 1u) << hole;
    EXPECT_EQ(import.scene.bodies[0].parts[0].holes.size(), 1u) << hole;
  }
}

TEST(ImportDxf, CountsLinesThatComeTwiceAsNothing) {
  const auto import = dxf_import(
      dxf_of(std::string(triangle_lines) + " 0 LINE 8 a 10 50 20 0 11 60 21 0 0 LINE 8 a 10 60 20 0 11 50 21 0"));
  EXPECT_TRUE(import.files[0].skipped.empty());
  EXPECT_EQ(import.files[0].repeated, 1u);
  ASSERT_EQ(import.files[0].open.size(), 1u);
  EXPECT_EQ(import.files[0].open[0].points, (std::vector<Point>{{50, 0}, {60, 0}}));
}

TEST(ImportDxf, ReadsUnitsAndLayersThatAreOff) {
  const std::string before =
      "0 SECTION 2 HEADER 9 $INSUNITS 70 5 9 $LUNITS 70 2 0 ENDSEC 0 SECTION 2 TABLES 0 TABLE 2 LAYER 0 LAYER 2 b 70 0 "
      "62 -7 "
      "0 LAYER 2 c 70 1 62 7 0 ENDTAB 0 ENDSEC";
  const auto import =
      dxf_import(dxf_of(std::string(triangle_lines) + " 0 CIRCLE 8 b 10 0 20 0 40 9 0 CIRCLE 8 c 10 0 20 0 40 9 "
                                                      "0 CIRCLE 8 d 67 1 10 0 20 0 40 9 0 POINT 8 a 10 1 20 1",
                        before));
  EXPECT_EQ(import.files[0].units, "cm");
  EXPECT_EQ(import.scene.bodies.size(), 1u);
  ASSERT_EQ(import.files[0].skipped.size(), 4u);
  EXPECT_EQ(import.files[0].skipped[0].layer, "b");
  EXPECT_EQ(import.files[0].skipped[1].layer, "c");
  EXPECT_EQ(import.files[0].skipped[2].reason, "is in paper space, not in the model");
  EXPECT_EQ(import.files[0].skipped[3].what, "POINT");
  EXPECT_TRUE(import.files[0].skipped[3].unread);
}

TEST(ImportDxf, InsertsBlocksInRowsWithTheirLayers) {
  const std::string blocks =
      "0 SECTION 2 BLOCKS 0 BLOCK 2 P 10 1 20 0 0 LWPOLYLINE 8 0 70 1 10 1 20 0 10 3 20 0 10 1 20 1 0 ENDBLK 0 ENDSEC";
  const auto import = dxf_import(dxf_of("0 INSERT 8 pins 2 P 10 5 20 5 41 2 42 2 50 90 70 2 71 1 44 10", blocks));
  const Body& body = import.scene.bodies.at(0);
  EXPECT_EQ(body.name, "pins");
  ASSERT_EQ(body.parts.size(), 2u);
  EXPECT_EQ(body.parts[0].outline, (Polygon{{5, 5}, {5, 9}, {3, 5}}));
  EXPECT_EQ(body.parts[1].outline, (Polygon{{5, 15}, {5, 19}, {3, 15}}));
}

TEST(ImportDxf, SeesAHalfCircleInABulgeOfOne) {
  const auto ring = dxf_import(dxf_of("0 LWPOLYLINE 8 a 70 1 10 0 20 0 42 1 10 2 20 0")).scene.bodies.at(0).polygon;
  for (const Point& p : ring) EXPECT_NEAR(std::hypot(p.x - 1, p.y), 1, 1e-12);
  for (const Point& p : ring) EXPECT_LE(p.y, 1e-12);
  const auto below =
      dxf_import(dxf_of("0 LWPOLYLINE 8 a 70 1 230 -1 10 0 20 0 42 1 10 2 20 0")).scene.bodies.at(0).polygon;
  for (const Point& p : below) EXPECT_NEAR(std::hypot(p.x + 1, p.y), 1, 1e-12);
}

class BadDxfTest : public ::testing::TestWithParam<testing::BadInput> {};

TEST_P(BadDxfTest, IsRefused) {
  testing::expect_refused(GetParam(), [](const std::string& text) { dxf_import(text); });
}

std::vector<testing::BadInput> bad_dxf() {
  const std::string insert_itself = "0 SECTION 2 BLOCKS 0 BLOCK 2 P 0 INSERT 8 0 2 P 0 ENDBLK 0 ENDSEC";
  const std::string spline = "0 SPLINE 8 a 71 2 10 0 20 0 10 1 20 1 10 2 20 0 ";
  return {
      {"empty", "", "d.dxf", "the file is empty", "ASCII DXF"},
      {"binary", "AutoCAD Binary DXF\r\n\x1a", "d.dxf", "binary", "ASCII DXF"},
      {"dwg", "AC1032", "d.dxf", "DWG", "ASCII DXF"},
      {"text", "hello\nworld\n", "d.dxf:1", "expected a group code", "ASCII DXF"},
      {"cut_off", dxf_lines("0 SECTION 2"), "d.dxf:3", "without a value", "ASCII DXF"},
      {"no_eof", dxf_lines("0 SECTION 2 ENTITIES"), "d.dxf", "without EOF", "ASCII DXF"},
      {"first", dxf_lines("2 SECTION"), "d.dxf:1", "not 0", "ASCII DXF"},
      // What one entity has wrong is told where nothing else is left.
      {"number", dxf_of("0 CIRCLE 8 a 10 zero 20 0 40 1"), "d.dxf", "group 10 of CIRCLE, found \"zero\"", "closed"},
      {"no_block", dxf_of("0 INSERT 8 a 2 P"), "d.dxf", "block \"P\", which is not in the file", "closed"},
      {"itself", dxf_of("0 INSERT 8 a 2 P", insert_itself), "d.dxf", "more than 16 deep", "closed"},
      {"nothing", dxf_of("0 TEXT 8 a 1 hi"), "d.dxf", "skipped: TEXT at d.dxf:6 is no line", "--join"},
      {"knots", dxf_of(spline + "40 0 40 1"), "d.dxf", "3 control points has 2 knots", "closed"},
      {"falling_knots", dxf_of(spline + "40 0 40 0 40 1 40 0 40 1 40 1"), "d.dxf", "decrease", "closed"},
      {"weights", dxf_of(spline + "40 0 40 0 40 0 40 1 40 1 40 1 41 1 41 0 41 1"), "d.dxf", "not positive", "closed"},
      {"fit_points", dxf_of("0 SPLINE 8 a 71 2 11 0 21 0"), "d.dxf", "neither control points nor two points", "closed"},
  };
}

INSTANTIATE_TEST_SUITE_P(Dxf, BadDxfTest, ::testing::ValuesIn(bad_dxf()), testing::name_of);

/// A rational quadratic spline, a quarter of a circle, cannot be kept: which ones, where, how many and how far is told.
TEST(ImportDxf, NamesSplinesThatBecomeChordsThoughCurvesAreKept) {
  const std::string quarter = "0 SPLINE 8 cut 71 2 40 0 40 0 40 0 40 1 40 1 40 1 41 1 41 0.7071067811865476 41 1 ";
  const std::string closing = "0 LINE 8 cut 10 0 20 1 11 0 21 0 0 LINE 8 cut 10 0 20 0 11 1 21 0 ";
  const std::string far = "0 LINE 8 cut 10 8 20 1 11 8 21 0 0 LINE 8 cut 10 8 20 0 11 9 21 0 ";
  const std::string text = dxf_of(quarter + "10 1 20 0 10 1 20 1 10 0 20 1 " + closing + quarter +
                                  "10 9 20 0 10 9 20 1 10 8 20 1 " + far + "0 CIRCLE 8 cut 10 4 20 4 40 1");
  drawing::ImportSettings settings;
  EXPECT_TRUE(dxf_import(text, settings).files[0].chorded.empty()) << "nothing was to be kept";
  settings.curves = true;
  const auto import = dxf_import(text, settings);
  EXPECT_EQ(import.files[0].kept, 4u);
  ASSERT_EQ(import.files[0].chorded.size(), 1u);
  const drawing::Chorded& decided = import.files[0].chorded[0];
  EXPECT_EQ(decided.what, "rational SPLINE");
  EXPECT_EQ(decided.layer, "cut");
  EXPECT_EQ(decided.entities, 2u);
  EXPECT_EQ(decided.counts.segments, 2u);
  EXPECT_GT(decided.counts.chords, 4u);
  EXPECT_GT(decided.counts.deviation, 0);
  EXPECT_LE(decided.counts.deviation, settings.tolerance.value_or(0.01));
  const std::string report = drawing::report_text(import, settings);
  EXPECT_NE(report.find("as chords: rational SPLINE at d.dxf:"), std::string::npos) << report;
  EXPECT_NE(report.find(", and 1 more, layer cut: 2 curves as "), std::string::npos) << report;
  EXPECT_NE(drawing::report_json(import, settings).find("\"as_chords\":[{\"what\":\"rational SPLINE\""),
            std::string::npos);
}

}  // namespace
}  // namespace taut
