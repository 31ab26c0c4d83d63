// Forms of WKT and GeoJSON that programs write: empty geometries, dimensions, sequences.
#include <gtest/gtest.h>

#include "support/drawings.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut {
namespace {

const std::string unit_ring = "(0 0, 1 0, 1 1, 0 1, 0 0)", far_ring = "(5 0, 6 0, 6 1, 5 1, 5 0)";

std::size_t wkt_parts(const std::string& text) { return parse_wkt_parts(text, "o.wkt", {}).size(); }

TEST(Wkt, PassesOverWhatIsEmpty) {
  const std::string one = "POLYGON (" + unit_ring + ")";
  for (const std::string& text :
       {one + "\nPOLYGON EMPTY", "MULTIPOLYGON (EMPTY, (" + unit_ring + "), EMPTY)", "POINT EMPTY;" + one,
        "GEOMETRYCOLLECTION (POINT EMPTY, LINESTRING Z EMPTY, " + one + ", GEOMETRYCOLLECTION EMPTY)",
        "MULTIPOLYGON Z EMPTY\n" + one, "POLYGON (" + unit_ring + ", EMPTY)", "POLYGON (EMPTY)\n" + one,
        "TIN EMPTY " + one})
    EXPECT_EQ(wkt_parts(text), 1u) << text;
  for (const char* nothing : {"POLYGON EMPTY", "POINT EMPTY", "GEOMETRYCOLLECTION EMPTY", "MULTIPOLYGON Z EMPTY",
                              "POLYGON (EMPTY)", "GEOMETRYCOLLECTION (POINT EMPTY)"})
    EXPECT_THROW(wkt_parts(nothing), InputError) << nothing;
  EXPECT_THROW(wkt_parts("THING EMPTY\n" + one), InputError);
  EXPECT_THROW(wkt_parts("POLYGON Q (" + unit_ring + ")"), InputError);
}

TEST(Wkt, TakesAllDimensionsAndSurfaces) {
  for (const char* text :
       {"POLYGON Z ((0 0 1,1 0 1,1 1 2))", "POLYGONZ((0 0 1,1 0 1,1 1 2))", "POLYGON M ((0 0 1,1 0 1,1 1 2))",
        "PolygonZM((0 0 1 2,1 0 1 2,1 1 2 3))", "POLYGON ZM((0 0 1 2,1 0 1 2,1 1 2 3))", "TRIANGLE ((0 0,1 0,1 1,0 0))",
        "TRIANGLE Z((0 0 5,1 0 5,1 1 5,0 0 5))", "SRID=4326;TRIANGLE((0 0,1 0,1 1,0 0))",
        "\xEF\xBB\xBFPOLYGON((0 0,1 0,1 1))", "MULTIPOLYGONZ(((0 0 1,1 0 1,1 1 2)))"})
    EXPECT_EQ(wkt_parts(text), 1u) << text;
  EXPECT_EQ(wkt_parts("TIN (((0 0,1 0,1 1,0 0)),((0 0,1 1,0 1,0 0)))"), 2u);
  EXPECT_EQ(wkt_parts("POLYHEDRALSURFACE Z (((0 0 3,1 0 3,1 1 3)),((0 0 3,1 1 3,0 1 3)))"), 2u);
  EXPECT_EQ(wkt_parts("TIN M (((0 0 1,1 0 2,1 1 3,0 0 1)))"), 1u);
  // The next surface may be at another height.
  EXPECT_EQ(wkt_parts("TIN Z (((0 0 1,1 0 1,1 1 1)))\nTIN Z (((0 0 2,1 0 2,1 1 2)))"), 2u);
  EXPECT_THROW(wkt_parts("TIN Z (((0 0 1,1 0 2,1 1 3)))"), InputError) << "it is not flat";
  EXPECT_THROW(wkt_parts("POLYHEDRALSURFACE (((0 0 1,1 0 1,1 1 1)),((0 0 2,1 0 2,1 1 2)))"), InputError);
}

const std::string square_json = R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,1],[0,0]]]})";

std::string feature_json(const std::string& geometry) {
  return R"({"type":"Feature","properties":{"s":"}\"{"},"geometry":)" + geometry + "}";
}

std::size_t geojson_parts(const std::string& text) { return parse_geojson_parts(text, "o.json", {}).size(); }

TEST(GeoJson, PassesOverWhatIsEmpty) {
  const std::string square = feature_json(square_json);
  for (const char* empty :
       {"null", R"({"type":"Polygon","coordinates":[]})", R"({"type":"Polygon","coordinates":[[]]})",
        R"({"type":"MultiPolygon","coordinates":[]})", R"({"type":"MultiPolygon","coordinates":[[]]})",
        R"({"type":"Point","coordinates":[]})", R"({"type":"GeometryCollection","geometries":[]})"}) {
    const std::string features = R"({"type":"FeatureCollection","features":[)" + feature_json(empty) + ",";
    EXPECT_EQ(geojson_parts(features + square + "]}"), 1u) << empty;
    EXPECT_THROW(geojson_parts(features.substr(0, features.size() - 1) + "]}"), InputError) << empty;
    const drawing::Import import = testing::examine(features + square + "]}", "d.geojson");
    EXPECT_TRUE(import.faults.empty());
    EXPECT_EQ(testing::totals_of(import).area, 1);
  }
  EXPECT_EQ(geojson_parts(R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1]],[]]})"), 1u);
}

TEST(GeoJson, ReadsSequences) {
  const std::string square = feature_json(square_json), mark = "\x1E";
  for (const std::string& text : {square + "\n" + square + "\n", mark + square + "\n" + mark + square + "\n",
                                  square + "\r\n\r\n" + square, "\xEF\xBB\xBF" + square + "\n" + square_json})
    EXPECT_EQ(geojson_parts(text), 2u) << text;
  EXPECT_EQ(geojson_parts(mark + square + "\n"), 1u);
  EXPECT_EQ(testing::examine(square + "\n" + square, "d.ndjson").bodies.size(), 2u);
  const auto place = [&](const std::string& text) {
    try {
      geojson_parts(text);
      return std::string("no error");
    } catch (const InputError& error) {
      return error.place();
    }
  };
  // Errors name the line in the file.
  EXPECT_EQ(place(square + "\n\n" + R"({"type":"Polygon"})").substr(0, 9), "o.json:3:");
  EXPECT_EQ(place(square + "\n" + R"({"type":"Polygon")").substr(0, 9), "o.json:2:");
  EXPECT_EQ(place(square + "\nx").substr(0, 9), "o.json:2:");
}

/// As a program of Windows saves it.
std::string utf16_of(const std::string& ascii, bool big, bool mark) {
  std::string text = mark ? (big ? "\xFE\xFF" : "\xFF\xFE") : "";
  for (const char c : ascii) text += big ? std::string(1, '\0') + c : c + std::string(1, '\0');
  return text;
}

TEST(ImportText, ReadsByteOrderMarks) {
  testing::DxfText dxf;
  dxf.box({0, 0}, {1, 1});
  const std::vector<std::pair<std::string, std::string>> files{
      {"d.svg", "<?xml version='1.0' encoding='utf-8'?><svg><rect width='1' height='1'/></svg>"},
      {"d.dxf", dxf.file()},
      {"d.wkt", "POLYGON (" + unit_ring + ")"},
      {"d.geojson", square_json},
      {"d.kicad_pcb", "(kicad_pcb (gr_rect (start 0 0) (end 1 1) (layer Edge.Cuts)))"}};
  for (const auto& [file, text] : files) {
    for (const std::string& saved : {"\xEF\xBB\xBF" + text, utf16_of(text, false, true), utf16_of(text, true, true),
                                     utf16_of(text, false, false), utf16_of(text, true, false)}) {
      const drawing::Import import = testing::examine(saved, file);
      EXPECT_TRUE(import.faults.empty()) << file;
      EXPECT_EQ(testing::totals_of(import).area, 1) << file;
    }
  }
}

}  // namespace
}  // namespace taut
