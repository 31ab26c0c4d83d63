// Files of other kinds, and compressed ones.
#include <gtest/gtest.h>

#include "import/file_kinds.hpp"
#include "support/drawings.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

using testing::examine;

std::string hint_for(const std::string& file) {
  try {
    drawing::read_drawing("", file, {});
  } catch (const InputError& error) {
    EXPECT_EQ(error.place(), file);
    return error.hint();
  }
  return "";
}

TEST(ImportKinds, RefusalsSayWhatToDo) {
  EXPECT_NE(hint_for("map.pgm").find("taut import map.yaml"), std::string::npos);
  EXPECT_NE(hint_for("map.PNG").find("resolution: 0.05"), std::string::npos);
  EXPECT_NE(hint_for("plate.dwg").find("ASCII DXF"), std::string::npos);
  EXPECT_NE(hint_for("R1.kicad_mod").find(".kicad_pcb"), std::string::npos);
  EXPECT_NE(hint_for("page.pdf").find("Inkscape"), std::string::npos);
  EXPECT_NE(hint_for("block.step").find("DXF"), std::string::npos);
  EXPECT_NE(hint_for("a.b/plate").find("ending of its format"), std::string::npos);
}

TEST(ImportKinds, AScenePassesForNoGeojson) {
  const std::string scene = R"({"format": "taut-scene/1", "time": [0, 1], "bodies": []})";
  try {
    drawing::read_drawing(scene, "d.json", {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("a scene of taut"), std::string::npos) << error.what();
  }
}

/// <svg xmlns="http://www.w3.org/2000/svg"><rect width="5" height="4"/></svg>
const unsigned char zipped_drawing[] = {
    0x1f, 0x8b, 0x08, 0x00, 0x00, 0x00, 0x00, 0x00, 0x02, 0x03, 0xb3, 0x29, 0x2e, 0x4b, 0x57, 0xa8, 0xc8, 0xcd, 0xc9,
    0x2b, 0xb6, 0x55, 0xca, 0x28, 0x29, 0x29, 0xb0, 0xd2, 0xd7, 0x2f, 0x2f, 0x2f, 0xd7, 0x2b, 0x37, 0xd6, 0xcb, 0x2f,
    0x4a, 0xd7, 0x37, 0x32, 0x30, 0x30, 0xd0, 0x07, 0xaa, 0x50, 0xb2, 0xb3, 0x29, 0x4a, 0x4d, 0x2e, 0x51, 0x28, 0xcf,
    0x4c, 0x29, 0xc9, 0xb0, 0x55, 0x32, 0x55, 0x52, 0xc8, 0x48, 0xcd, 0x4c, 0xcf, 0x28, 0xb1, 0x55, 0x32, 0x51, 0xd2,
    0xb7, 0xb3, 0x01, 0x29, 0xb1, 0x03, 0x00, 0x2c, 0x5d, 0x04, 0xdd, 0x4a, 0x00, 0x00, 0x00};

TEST(ImportKinds, CompressedDrawingsAreRead) {
  const std::string bytes(reinterpret_cast<const char*>(zipped_drawing), sizeof zipped_drawing);
  try {
    drawing::unzipped(bytes, "d.svgz");
  } catch (const InputError& error) {
    GTEST_SKIP() << error.what();
  }
  EXPECT_NEAR(testing::totals_of(examine(bytes, "d.svgz")).area, 20, 1e-12);
  for (const std::string& damaged : {bytes.substr(0, 30), bytes.substr(0, 20) + "x" + bytes.substr(21)})
    EXPECT_THROW(examine(damaged, "d.svgz"), InputError);
}

TEST(ImportKinds, GeometriesThatAreNoPolygonsAreListed) {
  const auto import = examine(
      "POINT (1 2)\nPOLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))\nLINESTRING (0 0, 1 1)\n"
      "GEOMETRYCOLLECTION (POINT EMPTY, MULTIPOINT ((1 1), (2 2)), POLYGON Z ((20 0 3, 30 0 3, 30 10 3)))",
      "d.wkt");
  ASSERT_TRUE(import.faults.empty());
  EXPECT_NEAR(testing::totals_of(import).area, 150, 1e-12);
  const auto& skipped = import.files[0].skipped;
  ASSERT_EQ(skipped.size(), 3u);
  EXPECT_EQ(skipped[0].place + skipped[0].what, "d.wkt:1:1POINT");
  EXPECT_EQ(skipped[1].place + skipped[1].what, "d.wkt:3:1LINESTRING");
  EXPECT_EQ(skipped[2].place + skipped[2].what, "d.wkt:4:34MULTIPOINT");
  ASSERT_EQ(import.files[0].notes.size(), 1u);
  EXPECT_NE(import.files[0].notes[0].find("z and m"), std::string::npos);
  // What encloses an area may be a body.
  const auto curved = examine("POLYGON ((0 0, 1 0, 1 1)); CURVEPOLYGON (CIRCULARSTRING (0 0, 4 0, 0 0))", "d.wkt");
  EXPECT_EQ(curved.faults.size(), 1u);
  EXPECT_FALSE(examine("POINT (1 2)", "d.wkt").faults.empty());
  EXPECT_THROW(examine("POINT (1 2", "d.wkt"), InputError);
}

TEST(ImportKinds, OtherGeometriesSayHowToConvertThem) {
  const char* const curve = "CURVEPOLYGON (CIRCULARSTRING (0 0, 4 0, 0 0))";
  for (const std::string& text : {curve + std::string(""), "POLYGON ((9 0, 10 0, 10 1)); " + std::string(curve)}) {
    const auto import = examine(text, "d.wkt");
    ASSERT_EQ(import.faults.size(), 1u);
    EXPECT_NE(import.faults[0].hint().find("ST_CurveToLine"), std::string::npos) << import.faults[0].hint();
  }
  const auto unknown = examine(R"({"type":"Feature","geometry":{"type":"CurvePolygon","coordinates":[1]}})", "d.json");
  ASSERT_EQ(unknown.faults.size(), 1u);
  EXPECT_NE(unknown.faults[0].hint().find("CONVERT_TO_LINEAR"), std::string::npos);
  const auto lines = examine("LINESTRING (0 0, 1 1)", "d.wkt");
  ASSERT_EQ(lines.faults.size(), 1u);
  EXPECT_NE(lines.faults[0].hint().find("ST_MakePolygon"), std::string::npos);
  const char* const topology = R"({"type":"Topology","objects":{},"arcs":[]})";
  for (const char* file : {"d.json", "d.geojson"}) {
    try {
      examine(topology, file);
      FAIL() << file;
    } catch (const InputError& error) {
      EXPECT_NE(error.hint().find("ogr2ogr"), std::string::npos);
    }
  }
  EXPECT_NE(hint_for("d.topojson").find("ogr2ogr"), std::string::npos);
}

TEST(ImportKinds, HeightsAreLeftOutWithANote) {
  const auto notes = [](const drawing::Import& import) { return import.files[0].notes.size(); };
  const std::string ring = R"({"type":"Polygon","coordinates":[[[0,0,0],[1,0,HEIGHT],[1,1,0]]]})";
  const auto with = [&ring](const char* z) { return std::string(ring).replace(ring.find("HEIGHT"), 6, z); };
  EXPECT_EQ(notes(examine(with("5"), "d.json")), 1u);
  EXPECT_EQ(notes(examine(with("0"), "d.json")), 0u);
  testing::DxfText flat, sloped;
  flat.circle({0, 0}, 5).group(30, "7").circle({0, 0}, 6).group(30, "7");
  EXPECT_EQ(notes(examine(flat)), 0u);
  sloped.circle({0, 0}, 5).group(30, "7").circle({0, 0}, 6);
  ASSERT_EQ(notes(examine(sloped)), 1u);
  EXPECT_NE(examine(sloped).files[0].notes[0].find("z runs from 0 to 7"), std::string::npos);
}

TEST(ImportKinds, WhatHasNoExtentIsListed) {
  testing::DxfText text;
  text.circle({0, 0}, 5).circle({1, 1}, 0).line({2, 2}, {2, 2});
  const auto import = examine(text);
  ASSERT_EQ(import.files[0].skipped.size(), 2u);
  EXPECT_EQ(import.files[0].skipped[0].what, "CIRCLE");
  EXPECT_EQ(import.files[0].skipped[0].reason, "has no extent");
}

/// Curves must not touch in a scene; their chords may.
TEST(ImportKinds, CurvesThatTouchAreChords) {
  testing::DxfText text;
  text.box({0, 0}, {40, 40}).circle({20, 10}, 10).circle({20, 30}, 4).circle({100, 0}, 5, "apart");
  drawing::ImportSettings settings;
  settings.curves = true;
  const auto import = examine(text, settings);
  ASSERT_TRUE(import.faults.empty());
  EXPECT_NEAR(testing::totals_of(import).area, 1600 - 91 * 3.14159265, 0.5);
  ASSERT_EQ(import.files[0].notes.size(), 1u);
  const std::string& note = import.files[0].notes[0];
  EXPECT_NE(note.find("meets segment"), std::string::npos) << note;
  EXPECT_NE(note.find("body 0"), std::string::npos) << note;
  ASSERT_EQ(import.scene.bodies.size(), 2u);
  EXPECT_FALSE(import.scene.bodies[1].curves.empty());
  // Of three circles in four quarters each, the two quarters at the edge are chords.
  EXPECT_EQ(import.files[0].kept, 10u) << note;
  EXPECT_NE(note.find("2 curves at such places are chords"), std::string::npos) << note;
}

TEST(ImportKinds, CurvesThatAreDividedAreChords) {
  testing::DxfText text;
  text.box({0, 0}, {40, 40}).circle({40, 17}, 5).circle({10, 10}, 3);
  drawing::ImportSettings settings;
  settings.curves = true;
  settings.crossing = drawing::Crossing::subtract;
  // Where the edge meets the ends of quarters of a circle, nothing is divided.
  const auto whole = examine(text, settings);
  EXPECT_EQ(whole.files[0].kept, 6u);
  EXPECT_EQ(whole.files[0].notes.size(), 1u);
  text.circle({41, 30}, 5);
  const auto divided = examine(text, settings);
  ASSERT_TRUE(divided.faults.empty());
  ASSERT_EQ(divided.files[0].notes.size(), 2u);
  EXPECT_NE(divided.files[0].notes[1].find("body 0: 2 curves are divided"), std::string::npos)
      << divided.files[0].notes[1];
  EXPECT_EQ(divided.files[0].kept, 6u);
}

}  // namespace
}  // namespace taut
