// Layers and blocks of DXF by name, what hides them, and how fillings lie in each other.
#include <gtest/gtest.h>

#include "support/drawings.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

using drawing::Import;
using drawing::ImportSettings;
using testing::DxfText;
using testing::examine;
using testing::totals_of;

std::string section(const std::string& name, const std::string& inside) {
  return "0\nSECTION\n2\n" + name + "\n" + inside + "0\nENDSEC\n";
}

std::string layer_entry(const std::string& name, int flags, int color) {
  return "0\nLAYER\n2\n" + name + "\n70\n" + std::to_string(flags) + "\n62\n" + std::to_string(color) + "\n";
}

/// A block of two discs, of radius 1 on layer 0 and of radius 2 on layer `inner`, which is inserted on layer `outer`.
std::string block_file(const std::string& layers, const std::string& inner, const std::string& outer,
                       const std::string& name = "PAIR") {
  const auto text = [](const DxfText& drawing) {
    const std::string all = drawing.file();
    const std::size_t begin = all.find("ENTITIES\n") + 9;
    return all.substr(begin, all.rfind("0\nENDSEC") - begin);
  };
  DxfText discs, insert;
  discs.circle({0, 0}, 1).circle({10, 0}, 2, inner);
  insert.begin("INSERT", outer).group(2, name).at(10, {5, 5});
  return section("TABLES", layers) +
         section("BLOCKS", "0\nBLOCK\n2\nPair\n10\n0\n20\n0\n" + text(discs) + "0\nENDBLK\n") +
         section("ENTITIES", text(insert)) + "0\nEOF\n";
}

/// The areas of the discs that are read, by pi.
double discs_of(const std::string& text, const ImportSettings& settings = {}) {
  return totals_of(examine(text, "d.dxf", settings)).area / 3.14159265358979323846;
}

TEST(ImportDxfLayers, HidesOfBlocksWhatLiesOnLayersThatAreOff) {
  constexpr int frozen = 1;
  const double within = 0.1;
  const auto discs = [](const std::string& layers) { return discs_of(block_file(layers, "in", "out")); };
  EXPECT_NEAR(discs(""), 5, within);
  EXPECT_NEAR(discs(layer_entry("out", 0, -7)), 4, within) << "off: what is on layer 0 goes with the insertion";
  EXPECT_NEAR(discs(layer_entry("out", frozen, 7)), 0, within) << "frozen: all of the block";
  EXPECT_NEAR(discs(layer_entry("in", 0, -7)), 1, within);
  EXPECT_NEAR(discs(layer_entry("in", frozen, 7)), 1, within);
  EXPECT_NEAR(discs(layer_entry("0", 0, -7)), 5, within) << "layer 0 of a block is another one";
  EXPECT_NEAR(discs(layer_entry("in", 0, -7) + layer_entry("out", 0, -7)), 0, within);
}

/// XCLIP hides a part of an inserted block: by a filter that hangs on the dictionary of the INSERT.
TEST(ImportDxfLayers, RefusesBlocksOfWhichAClipHidesAPart) {
  const auto file = [](const std::string& enabled) {
    std::string text = block_file("", "in", "out");
    text.insert(text.find("0\nINSERT\n") + 9, "5\n30\n102\n{ACAD_XDICTIONARY\n360\n3A\n102\n}\n");
    const std::string objects = "0\nDICTIONARY\n5\n3a\n3\nACAD_FILTER\n360\n3B\n0\nDICTIONARY\n5\n3B\n3\nSPATIAL\n" +
                                std::string("360\n3C\n0\nSPATIAL_FILTER\n5\n3C\n70\n2\n10\n0\n20\n0\n10\n1\n20\n1\n") +
                                "71\n" + enabled + "\n";
    return text.insert(text.rfind("0\nEOF"), section("OBJECTS", objects));
  };
  const Import clipped = examine(file("1"), "d.dxf");
  ASSERT_EQ(clipped.faults.size(), 1u);
  EXPECT_NE(clipped.faults[0].problem().find("\"PAIR\", and shows only a part of it (XCLIP)"), std::string::npos);
  EXPECT_NE(clipped.faults[0].hint().find("XCLIP OFF"), std::string::npos);
  ASSERT_EQ(clipped.files[0].skipped.size(), 1u);
  EXPECT_EQ(clipped.files[0].skipped[0].handle, "30");
  EXPECT_TRUE(examine(file("0"), "d.dxf").faults.empty()) << "the clip is switched off";
  ImportSettings settings;
  settings.open = drawing::OpenRings::skip;
  EXPECT_NEAR(discs_of(file("1"), settings), 5, 0.1) << "as it is";
  settings.strict = true;
  EXPECT_EQ(examine(file("1"), "d.dxf", settings).faults.size(), 1u);
}

TEST(ImportDxfLayers, ReadsOfBlocksTheLayersThatAreWanted) {
  ImportSettings settings;
  settings.layers = {"in"};
  EXPECT_NEAR(discs_of(block_file("", "in", "0"), settings), 4, 0.1);
  settings.layers = {"out"};
  EXPECT_NEAR(discs_of(block_file("", "in", "out"), settings), 1, 0.1);
  settings.layers = {"none"};
  EXPECT_THROW(discs_of(block_file("", "in", "out"), settings), InputError);
}

TEST(ImportDxfLayers, ComparesNamesWithoutCase) {
  for (const char* name : {"PAIR", "pair", "Pair"})
    EXPECT_NEAR(discs_of(block_file("", "in", "out", name)), 5, 0.1) << name;
  EXPECT_NEAR(discs_of(block_file(layer_entry("OUT", 1, 7), "in", "out")), 0, 0.1);
  const auto halves = [](const std::string& one, const std::string& other) {
    DxfText drawing;
    drawing.line({0, 0}, {9, 0}, one).line({9, 0}, {9, 9}, other).line({9, 9}, {0, 0}, one).circle({7, 3}, 1, other);
    return drawing;
  };
  for (const auto& [one, other] : {std::pair("Cut", "CUT"),
                                   {"St\xC3\xBC"
                                    "ck",
                                    "ST\xC3\x9C"
                                    "CK"},
                                   {"\xD0\x9A\xD1\x80\xD0\x81", "\xD0\xBA\xD0\xA0\xD1\x91"},
                                   {"\xC4\x8C\xC5\xBD", "\xC4\x8D\xC5\xBE"}}) {
    ImportSettings settings;
    settings.by = drawing::Grouping::layer;
    const Import import = examine(halves(one, other), settings);
    ASSERT_EQ(import.bodies.size(), 1u) << one;
    EXPECT_EQ(import.bodies[0].name, one);
    EXPECT_EQ(import.bodies[0].holes, 1u);
    EXPECT_EQ(import.files[0].notes.size(), 1u);
    settings.layers = {other};
    EXPECT_EQ(examine(halves(one, other), settings).bodies.size(), 1u);
    settings.layers = {};
    settings.merged = {other};
    EXPECT_EQ(examine(halves(one, other), settings).bodies.size(), 1u);
  }
}

/// Squares in each other, whose sides are 10, 8, 6 and so on.
double nested_hatch(int style, int flags_of_third = 3) {
  DxfText drawing;
  drawing.begin("HATCH", "0").at(10, {0, 0}).group(30, "0").group(2, "SOLID").group(70, "1").group(91, "4");
  for (int k = 0; k < 4; ++k) {
    const double s = 5 - k;
    drawing.group(92, std::to_string(k == 2 ? flags_of_third : 3)).group(72, "0").group(73, "1").group(93, "4");
    // They run in all directions.
    const std::vector<Point> ring{{-s, -s}, {s, -s}, {s, s}, {-s, s}};
    for (int i = 0; i < 4; ++i) drawing.at(10, ring[static_cast<std::size_t>(k % 2 == 0 ? i : 3 - i)]);
    drawing.group(97, "0");
  }
  drawing.group(75, std::to_string(style)).group(76, "1");
  return totals_of(examine(drawing)).area;
}

TEST(ImportDxfLayers, FillsHatchesByTheirStyle) {
  EXPECT_EQ(nested_hatch(0), 100 - 64 + 36 - 16);
  EXPECT_EQ(nested_hatch(1), 100 - 64);
  EXPECT_EQ(nested_hatch(2), 100);
  constexpr int room_for_text = 8 + 3;
  EXPECT_EQ(nested_hatch(0, room_for_text), 100 - 64 + 16);
}

}  // namespace
}  // namespace taut
