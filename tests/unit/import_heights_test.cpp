// Layers of drawings with heights across the plane.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "import/heights.hpp"
#include "io/text.hpp"
#include "support/drawings.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut {
namespace {

using drawing::Import;
using drawing::ImportSettings;
using testing::DxfText;
using testing::examine;
using testing::expect_totals;

const double no_height = std::numeric_limits<double>::infinity();

ImportSettings layers_of(const std::vector<std::string>& choices) {
  ImportSettings settings;
  for (const std::string& choice : choices) drawing::choose_layer(settings, choice, "--layer");
  return settings;
}

/// A lever with a bore on a plate, and a pin in the bore.
DxfText arm() {
  DxfText text;
  return text.box({0, 0}, {40, 20}, "Base")
      .box({5, 5}, {35, 15}, "Lever")
      .box({8, 8}, {12, 12}, "Lever")
      .box({9, 9}, {11, 11}, "Pin");
}

const Body& body_of(const Import& import, const std::string& name) {
  for (const Body& body : import.scene.bodies)
    if (body.name == name) return body;
  throw std::out_of_range(name);
}

void expect_layers(const Layers& z, double lo, double hi) {
  EXPECT_EQ(z.lo, lo);
  EXPECT_EQ(z.hi, hi);
}

void expect_refused(const std::vector<std::string>& choices, const std::string& problem, const std::string& hint) {
  try {
    examine(arm(), layers_of(choices));
    FAIL() << problem;
  } catch (const InputError& error) {
    EXPECT_EQ(error.place(), "--layer");
    EXPECT_NE(error.problem().find(problem), std::string::npos) << error.problem();
    EXPECT_NE(error.hint().find(hint), std::string::npos) << error.hint();
  }
}

TEST(ImportHeights, TakesNamesWithAndWithoutHeights) {
  const ImportSettings settings = layers_of({"a", "b=0:3", "c=d=-1.5:", "e=:2", "f=g"});
  EXPECT_EQ(settings.layers, (std::vector<std::string>{"a", "b", "c=d", "e", "f=g"}));
  ASSERT_EQ(settings.heights.size(), 3u);
  expect_layers(settings.heights[0].z, 0, 3);
  EXPECT_EQ(settings.heights[1].name, "c=d");
  expect_layers(settings.heights[1].z, -1.5, no_height);
  expect_layers(settings.heights[2].z, -no_height, 2);
  EXPECT_EQ(internal::io::heights_text(settings.heights[1].z), "z -1.5..");
}

TEST(ImportHeights, RefusesHeightsThatAreNone) {
  expect_refused({"Base=3:3"}, "runs from 3 to 3", "the lower height first");
  expect_refused({"Base=x:3"}, "\"x\" is no height for layer \"Base\"", "two numbers");
  expect_refused({"Base=1:2:3"}, "\"2:3\" is no height", "two numbers");
  expect_refused({"Base=0:1e999"}, "is no height", "two numbers");
  expect_refused({"Bse=0:3"}, "no layer \"Bse\"", "did you mean \"Base\"? its layers are: ");
  expect_refused({"Base=0:3", "BASE=0:4"}, "two pairs of heights, z 0..3 and z 0..4", "one pair");
}

TEST(ImportHeights, ReadsLayersOfDifferentHeightsApart) {
  // Without heights the lever is a hole in the plate, and the pin a body in the bore.
  expect_totals(examine(arm()), 800 - 300 + 16 - 4, 2, 2, 1e-9);
  const Import import = examine(arm(), layers_of({"Base=0:3", "Lever=3:6", "Pin=3:6"}));
  // The pin lies in the bore at the same heights: there it is read as ever.
  expect_totals(import, 800 + 300 - 16 + 4, 3, 1, 1e-9);
  expect_layers(body_of(import, "Base").z, 0, 3);
  expect_layers(body_of(import, "Lever").z, 3, 6);
  expect_layers(body_of(import, "Pin").z, 3, 6);
  EXPECT_TRUE(import.files[0].notes.empty()) << drawing::report_text(import, {});
  const std::string text = drawing::report_text(import, {});
  EXPECT_NE(text.find("40 x 20, z 0..3\n"), std::string::npos) << text;
  EXPECT_NE(drawing::report_json(import, {}).find("\"z\":[[3,6]]"), std::string::npos);
  // What is written is read again.
  const Scene again = parse_scene(write_scene(import.scene), "scene");
  expect_layers(again.bodies[1].z, import.scene.bodies[1].z.lo, import.scene.bodies[1].z.hi);
}

TEST(ImportHeights, NotesLayersWithoutHeights) {
  const Import import = examine(arm(), layers_of({"base=0:3", "lever=3:6", "Pin"}));
  ASSERT_EQ(import.files[0].notes.size(), 1u);
  EXPECT_NE(import.files[0].notes[0].find("no heights are given for layer Pin"), std::string::npos);
  EXPECT_EQ(body_of(import, "Pin").z, Layers{});
  expect_layers(body_of(import, "Lever").z, 3, 6);
  const Import without = examine(arm(), layers_of({"Base", "Lever", "Pin"}));
  for (const std::string& note : without.files[0].notes) EXPECT_EQ(note.find("no heights"), std::string::npos) << note;
}

TEST(ImportHeights, GivesPartsOfMergedLayersTheirOwn) {
  ImportSettings settings = layers_of({"Base=0:3", "Lever=3:6", "Pin=3:8"});
  settings.merge_all = true;
  for (const bool curves : {false, true}) {
    settings.curves = curves;
    const Import import = examine(arm().circle({38, 10}, 1, "Base"), settings);
    ASSERT_EQ(import.scene.bodies.size(), 1u);
    const Body& body = import.scene.bodies[0];
    EXPECT_EQ(body.z, Layers{});
    std::vector<double> tops;
    for (const Part& part : body.parts) tops.push_back(part.z.value().hi);
    for (const CurvedPart& part : body.curves) tops.push_back(part.z.value().hi);
    std::sort(tops.begin(), tops.end());
    EXPECT_EQ(tops, (std::vector<double>{3, 6, 8})) << curves;
    EXPECT_EQ(import.bodies[0].overlap, 0);
    EXPECT_EQ(import.bodies[0].z.size(), 3u);
  }
  settings.merge_all = false;
  settings.by = drawing::Grouping::nesting;
  EXPECT_EQ(examine(arm(), settings).scene.bodies.size(), 3u) << "what lies at other heights is not in an outline";
}

TEST(ImportHeights, ReadsThemOfSvg) {
  const std::string text =
      "<svg width=\"40mm\" viewBox=\"0 0 40 40\"><g id=\"g1\" inkscape:label=\"base plate\" "
      "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"><rect width=\"40\" height=\"20\"/></g>"
      "<g id=\"lever\"><rect width=\"40\" height=\"20\"/></g></svg>";
  const Import import = examine(text, "a.svg", layers_of({"base plate=0:3", "lever=3:6"}));
  EXPECT_TRUE(import.files[0].notes.empty()) << "one lies on the other, and does not repeat it";
  expect_layers(body_of(import, "base plate").z, 0, 3);
  expect_layers(body_of(import, "lever").z, 3, 6);
  EXPECT_EQ(examine(text, "a.svg").files[0].notes.size(), 1u);
}

Import board_with(const std::string& items, const ImportSettings& settings = {}) {
  return examine("(kicad_pcb (version 20260206) (gr_rect (start 30 30) (end 0 0) (layer Edge.Cuts)) " + items + ")",
                 "b.kicad_pcb", settings);
}

std::string courtyard(const std::string& name, const std::string& side) {
  return "(footprint " + name + " (at 10 10) (property Reference " + name + ") (fp_rect (start 0 0) (end 4 4) (layer " +
         side + ".CrtYd)))";
}

TEST(ImportHeights, StacksTheSidesOfBoards) {
  const std::string both = courtyard("R1", "F") + courtyard("R2", "B");
  ImportSettings settings;
  settings.scale = 2;
  const Import import = board_with("(general (thickness 1)) " + both, settings);
  expect_layers(body_of(import, "board").z, 0, 2);
  expect_layers(body_of(import, "courtyards F").z, 2, no_height);
  expect_layers(body_of(import, "courtyards B").z, -no_height, 0);
  expect_layers(body_of(board_with(both), "board").z, 0, 1.6);
  for (const Body& body : board_with(courtyard("R1", "F")).scene.bodies) EXPECT_EQ(body.z, Layers{}) << body.name;
  const Import chosen = board_with(both, layers_of({"board", "courtyards F=1.6:12"}));
  expect_layers(body_of(chosen, "courtyards F").z, 1.6, 12);
  expect_layers(body_of(chosen, "board").z, 0, 1.6);
}

}  // namespace
}  // namespace taut
