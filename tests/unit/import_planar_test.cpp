// Lines as people draw them: twice, not quite to the end, on any layer, across each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "support/drawings.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

using drawing::Import;
using drawing::ImportSettings;
using testing::DxfText;
using testing::examine;
using testing::expect_totals;
using testing::totals_of;

/// Inputs that were reported, with the areas that are right.
TEST(ImportPlanar, ReadsWhatWasReported) {
  const std::filesystem::path folder = "../shared/reports";
  if (!std::filesystem::exists(folder))
    GTEST_SKIP() << "the inputs that were reported are not here (../shared/reports)";
  struct Report {
    const char* file;
    double area, within;
    std::size_t bodies, parts, holes;
  };
  constexpr double disc = 3.14159265358979323846 * 16;
  for (const Report& r : std::vector<Report>{{"one_line_twice_outline_lost.dxf", 400 - disc, 0.3, 1, 1, 1},
                                             {"one_line_twice_refused.dxf", 400, 0, 1, 1, 0},
                                             {"dup_circle_hole.dxf", 400 - disc, 0.3, 1, 1, 1},
                                             {"boxes_corner_loop.svg", 400, 1e-9, 1, 1, 0},
                                             {"holes_on_other_layer.dxf", 2173.8, 1, 1, 1, 2},
                                             {"style_entities.svg", 6400, 0, 1, 1, 1},
                                             {"metre_plate.dxf", 2173.8e-6, 1e-6, 1, 1, 2},
                                             {"repeat_vertex.geojson", 12, 0, 1, 1, 0},
                                             {"hole_touches_outline.wkt", 94, 1e-12, 1, 2, 0},
                                             {"two_geometries.wkt", 1, 0, 1, 2, 0},
                                             {"shared_edge.dxf", 800, 0, 1, 2, 0},
                                             {"latin1_layers.dxf", 200, 0, 2, 2, 0},
                                             {"fit_spline_stops_import.dxf", 2035.7, 0.1, 1, 2, 1}}) {
    SCOPED_TRACE(r.file);
    const Import import = drawing::examine_files({(folder / r.file).string()}, {});
    expect_totals(import, r.area, r.parts, r.holes, r.within);
    EXPECT_EQ(import.bodies.size(), r.bodies);
  }
  const Import latin = drawing::examine_files({(folder / "latin1_layers.dxf").string()}, {});
  EXPECT_EQ(latin.bodies.at(0).name,
            "pi\xC3\xA8"
            "ce");
  EXPECT_EQ(latin.bodies.at(1).name,
            "pi\xC3\xA9"
            "ce");
  const Import spline = drawing::examine_files({(folder / "fit_spline_stops_import.dxf").string()}, {});
  EXPECT_TRUE(spline.faults.empty());
  EXPECT_TRUE(spline.files[0].skipped.empty());
  ASSERT_EQ(spline.files[0].open.size(), 1u);
  EXPECT_EQ(spline.files[0].open[0].layer, "0");
}

TEST(ImportPlanar, CountsWhatIsDrawnTwiceOnce) {
  DxfText twice;
  twice.box({0, 0}, {20, 20}).line({20, 0}, {0, 0}).line({5, 0}, {9, 0}).circle({10, 10}, 4).circle({10, 10}, 4);
  const Import import = examine(twice);
  expect_totals(import, 400 - 16 * 3.14159265, 1, 1, 0.3);
  EXPECT_GT(import.files[0].repeated, 2u);
  EXPECT_TRUE(import.files[0].open.empty());
}

TEST(ImportPlanar, TakesNearlyEqualLinesForOne) {
  DxfText near;
  near.box({0, 0}, {20, 20}).line({0, 0.001}, {20, 0.002}).circle({10, 10}, 4).circle({10.001, 10}, 4);
  expect_totals(examine(near), 400 - 16 * 3.14159265, 1, 1, 0.4);
  // Concentric, the smaller one within the larger one: no ring that is 0.002 wide.
  DxfText rings;
  rings.circle({0, 0}, 5).circle({0, 0}, 4.998);
  const Import import = examine(rings);
  expect_totals(import, 25 * 3.14159265, 1, 0, 0.3);
  ASSERT_EQ(import.files[0].repairs.size(), 1u);
  EXPECT_EQ(import.files[0].repairs[0].what, "sliver");
  EXPECT_NEAR(import.files[0].repairs[0].size, 0.002, 0.0002);
}

TEST(ImportPlanar, DividesAtCutsThatPartsShare) {
  DxfText shared;
  shared.box({0, 0}, {20, 20}).line({20, 0}, {40, 0}).line({40, 0}, {40, 20}).line({40, 20}, {20, 20});
  expect_totals(examine(shared), 800, 2, 0);
  DxfText polylines;
  polylines.polyline({{0, 0}, {20, 0}, {20, 20}, {0, 20}}, true).polyline({{20, 5}, {40, 5}, {40, 30}, {20, 30}}, true);
  expect_totals(examine(polylines), 900, 2, 0);
  // A line across, with ends on both sides, one of them a little short.
  DxfText across;
  across.box({0, 0}, {20, 20}).line({0, 7}, {19.99, 7});
  const Import import = examine(across);
  expect_totals(import, 400, 2, 0);
  ASSERT_EQ(import.files[0].gaps.size(), 1u);
  EXPECT_NEAR(import.files[0].gaps[0].width, 0.01, 1e-9);
}

/// Four bars that make a frame, by overlapping or by touching: its gap is in none of them.
TEST(ImportPlanar, LeavesGapsBetweenContoursEmpty) {
  for (const double overlap : {0.0, 10.0}) {
    DxfText frame;
    const auto bar = [&](const Point& low, const Point& high) {
      frame.polyline({low, {high.x, low.y}, high, {low.x, high.y}}, true);
    };
    bar({0, 0}, {100, 20});
    bar({0, 80}, {100, 100});
    bar({0, 20 - overlap}, {20, 80 + overlap});
    bar({80, 20 - overlap}, {100, 80 + overlap});
    EXPECT_EQ(totals_of(examine(frame)).area, 6400);
    bar({40, 40}, {60, 60});
    bar({45, 45}, {55, 55});
    const Import island = examine(frame);
    EXPECT_EQ(totals_of(island).area, 6700);
    EXPECT_EQ(totals_of(island).holes, 1u);
    // As a hole in a plate it is cut out, and what is in its gap stays.
    bar({-10, -10}, {110, 110});
    EXPECT_EQ(totals_of(examine(frame)).area, 120 * 120 - 6700);
  }
}

/// What its lines go around twice is within a contour, too.
TEST(ImportPlanar, FillsStarsThatCrossThemselves) {
  std::vector<Point> star;
  for (int k = 0; k < 5; ++k)
    star.push_back({10 * std::sin(k * 2.5132741228718345), 10 * std::cos(k * 2.5132741228718345)});
  DxfText text;
  const Import import = examine(text.polyline(star, true));
  EXPECT_EQ(totals_of(import).parts, 6u);
  ASSERT_EQ(import.files[0].crossings.size(), 1u);
}

TEST(ImportPlanar, ListsContoursThatCrossThemselves) {
  DxfText text;
  text.polyline({{0, 0}, {10, 10}, {10, 0}, {0, 10}}, true, "bow").box({20, 0}, {30, 10}, "plain");
  const Import import = examine(text);
  expect_totals(import, 150, 3, 0);
  ASSERT_EQ(import.files[0].crossings.size(), 1u);
  EXPECT_EQ(import.files[0].crossings[0].at, (Point{5, 5}));
  EXPECT_EQ(import.files[0].crossings[0].layer, "bow");
  EXPECT_NE(drawing::report_text(import, {}).find("crossing: a contour meets itself at (5, 5)"), std::string::npos);
  EXPECT_NE(drawing::report_json(import, {}).find("\"crossings\":[{\"at\":[5,5]"), std::string::npos);
  const Import filled = examine("<svg><path d='M0 0L10 10 10 0 0 10Z'/></svg>", "d.svg");
  EXPECT_EQ(filled.files[0].crossings.size(), 1u);
}

TEST(ImportPlanar, DoesNotFillHolesThroughWhichLinesRun) {
  DxfText plate;
  plate.box({0, 0}, {20, 20}).box({5, 5}, {9, 9}).box({12, 5}, {16, 9});
  // Marks of the middle, one from side to side of the plate, one in a hole, one that ends in the material.
  plate.line({-3, 7}, {23, 7}).line({14, 5}, {14, 9}).line({7, 3}, {7, 11});
  expect_totals(examine(plate), 400 - 32, 2, 0);
}

TEST(ImportPlanar, NestsContoursThatTouchAtAPoint) {
  DxfText inside;
  inside.box({0, 0}, {10, 10}).polyline({{5, 0}, {7, 3}, {3, 3}}, true);
  expect_totals(examine(inside), 94, 2, 0);
  DxfText holes;
  holes.box({0, 0}, {10, 10}).polyline({{5, 5}, {7, 8}, {3, 8}}, true).polyline({{5, 5}, {3, 2}, {7, 2}}, true);
  expect_totals(examine(holes), 100 - 12, 3, 0);
  DxfText bow;
  bow.polyline({{0, 0}, {2, 2}, {2, 0}, {0, 2}}, true);
  expect_totals(examine(bow), 2, 2, 0);
}

TEST(ImportPlanar, CutsOffLoopsAndOvershoots) {
  DxfText loops;
  loops.polyline({{0, 0}, {10.05, 0}, {10.05, 0.03}, {10, -0.02}, {10, 10}, {0, 10}}, true);
  const Import import = examine(loops);
  expect_totals(import, 100, 1, 0, 0.01);
  // Above and below the lower side.
  ASSERT_EQ(import.files[0].repairs.size(), 2u);
  EXPECT_EQ(import.files[0].repairs[0].what, "loop");
  EXPECT_NEAR(import.files[0].repairs[0].at.x, 10, 0.03);
  DxfText over;
  over.line({-0.01, 0}, {10.01, 0})
      .line({10, -0.01}, {10, 10.01})
      .line({10.01, 10}, {-0.01, 10})
      .line({0, 10.01}, {0, -0.01});
  const Import trimmed = examine(over);
  expect_totals(trimmed, 100, 1, 0);
  EXPECT_TRUE(trimmed.files[0].open.empty());
}

TEST(ImportPlanar, DoesNotDependOnTheOrderOfLines) {
  std::vector<std::pair<Point, Point>> lines{{{0, 0}, {20, 0}},    {{20, 0}, {20, 20}}, {{20, 20}, {0, 20}},
                                             {{0, 20}, {0, 0.01}}, {{20, 0}, {40, 0}},  {{40, 0}, {40, 20}},
                                             {{40, 20}, {20, 20}}, {{20, 20}, {20, 0}}, {{5, 5}, {15, 5}},
                                             {{15, 5}, {10, 12}},  {{10, 12}, {5, 5}}};
  std::string first;
  for (unsigned seed = 0; seed < 50; ++seed) {
    std::uint64_t state = seed + 1;
    for (std::size_t i = lines.size(); i-- > 1;) {
      state = state * 6364136223846793005u + 1442695040888963407u;
      std::swap(lines[i], lines[(state >> 33) % (i + 1)]);
      if ((state >> 20) % 2) std::swap(lines[i].first, lines[i].second);
    }
    DxfText text;
    for (const auto& [a, b] : lines) text.line(a, b);
    const Import import = examine(text);
    expect_totals(import, 800 - 35, 2, 1, 0.2);
    std::ostringstream scene;
    for (const Part& part : import.scene.bodies.at(0).parts) {
      for (const Point& p : part.outline) scene << p.x << ',' << p.y << ' ';
      for (const Polygon& hole : part.holes)
        for (const Point& p : hole) scene << p.x << ';' << p.y << ' ';
    }
    if (first.empty()) first = scene.str();
    EXPECT_EQ(scene.str(), first) << seed;
  }
}

TEST(ImportPlanar, ListsWhatIsNotReadAndGoesOn) {
  DxfText odd;
  odd.box({0, 0}, {20, 20}).begin("REGION", "solids").group(5, "2F");
  odd.begin("TEXT", "marks").at(10, {1, 1});
  ImportSettings settings;
  settings.open = drawing::OpenRings::skip;
  const Import import = examine(odd, settings);
  expect_totals(import, 400, 1, 0);
  ASSERT_EQ(import.files[0].skipped.size(), 2u);
  EXPECT_EQ(import.files[0].skipped[0].handle, "2F");
  EXPECT_NE(drawing::report_text(import, settings).find("REGION at d.dxf:"), std::string::npos);
  settings.strict = true;
  EXPECT_EQ(examine(odd, settings).faults.size(), 2u);
}

TEST(ImportPlanar, ReadsFillingsWhereTheyAreAllThereIs) {
  const auto hatch = [](DxfText& text, const std::string& layer) -> DxfText& {
    text.begin("HATCH", layer)
        .at(10, {0, 0})
        .group(91, "2")
        .group(92, "3")
        .group(72, "0")
        .group(73, "1")
        .group(93, "4");
    text.at(10, {0, 0}).at(10, {10, 0}).at(10, {10, 10}).at(10, {0, 10}).group(97, "0");
    text.group(92, "0").group(93, "2").group(72, "2").at(10, {5, 5}).group(40, "2").group(50, "0").group(51, "180");
    text.group(73, "1").group(72, "1").at(10, {3, 5}).at(11, {7, 5}).group(97, "0").group(75, "0");
    return text;
  };
  DxfText alone;
  expect_totals(examine(hatch(alone, "fill")), 100 - 2 * 3.14159265, 1, 1, 0.1);
  DxfText with_lines;
  with_lines.box({-5, -5}, {15, 15}, "fill");
  const Import import = examine(hatch(with_lines, "fill"));
  expect_totals(import, 400, 1, 0);
  EXPECT_EQ(import.files[0].skipped.at(0).what, "HATCH");
}

/// The edge of a board with a hole, and a courtyard that lies on it, turned by 90 degrees.
TEST(ImportPlanar, ReadsBoardsOfKicad) {
  const std::string board =
      "(kicad_pcb (version 20221018) (general (thickness 1.6))\n"
      " (gr_line (start 0 0) (end 20 0) (layer \"Edge.Cuts\"))\n (gr_line (start 20 0) (end 20 10) (layer Edge.Cuts))\n"
      " (gr_arc (start 20 10) (mid 15 15) (end 10 10) (stroke (width 0.1)) (layer \"Edge.Cuts\"))\n"
      " (gr_line (start 10 10) (end 0 10) (layer \"Edge.Cuts\")) (gr_line (start 0 10) (end 0 0) (layer "
      "\"Edge.Cuts\"))\n"
      " (gr_circle (center 5 5) (end 6 5) (layer \"Edge.Cuts\")) (gr_text \"R(1)\" (at 0 0) (layer \"Edge.Cuts\"))\n"
      " (footprint \"R\" (layer \"F.Cu\") (at 15 5 90) (property \"Reference\" \"R1\" (at 0 0))\n"
      "  (fp_rect (start -3 -1) (end 2 1) (layer \"F.CrtYd\")) (fp_line (start 0 0) (end 9 9) (layer \"F.SilkS\"))\n"
      "  (fp_poly (pts (xy -1 0) (xy 1 0) (xy 1 1)) (layer \"B.CrtYd\"))))\n";
  const Import import = examine(board, "b.kicad_pcb");
  ASSERT_TRUE(import.faults.empty());
  ASSERT_EQ(import.bodies.size(), 3u);
  EXPECT_EQ(import.bodies[0].name, "board");
  EXPECT_NEAR(import.bodies[0].area, 200 + 12.5 * 3.14159265 - 3.14159265, 0.3);
  EXPECT_EQ(import.bodies[0].holes, 1u);
  EXPECT_EQ(import.bodies[1].name, "courtyards F");
  EXPECT_EQ(import.bodies[1].area, 10);
  // On the screen it is turned counterclockwise: what was left is below.
  EXPECT_EQ(import.bodies[1].low, (Point{14, -8}));
  EXPECT_EQ(import.bodies[1].high, (Point{16, -3}));
  EXPECT_EQ(import.bodies[2].area, 1);
  ASSERT_EQ(import.files[0].skipped.size(), 1u);
  EXPECT_EQ(import.files[0].skipped[0].what, "gr_text");
  ImportSettings settings;
  settings.split = true;
  EXPECT_EQ(examine(board, "b.kicad_pcb", settings).bodies[1].name, "R1");
  EXPECT_THROW(examine("(kicad_sch)", "b.kicad_pcb"), InputError);
  EXPECT_THROW(examine("(kicad_pcb (a", "b.kicad_pcb"), InputError);
}

TEST(ImportPlanar, FollowsTheUnitAndTheSize) {
  const auto tolerance = [](double size, int unit) {
    DxfText text;
    text.box({0, 0}, {size, size}).circle({size / 2, size / 2}, size / 8);
    return examine(text.file(unit), "d.dxf").files.at(0).fineness.tolerance;
  };
  EXPECT_EQ(tolerance(100, 4), 0.01);
  EXPECT_EQ(tolerance(100, 0), 0.01);
  EXPECT_DOUBLE_EQ(tolerance(0.06, 6), 1e-5);
  EXPECT_DOUBLE_EQ(tolerance(4, 1), 0.01 / 25.4);
  EXPECT_NEAR(tolerance(0.1, 0), 1.414e-4, 1e-6);
}

TEST(ImportPlanar, FillsByTheRuleWhatCrossesItself) {
  const auto area = [](const std::string& path, const std::string& rule) {
    const Import import = examine("<svg><path fill-rule='" + rule + "' d='" + path + "'/></svg>", "d.svg");
    EXPECT_TRUE(import.faults.empty());
    return totals_of(import).area;
  };
  EXPECT_EQ(area("M0 0L2 2 2 0 0 2Z", "nonzero"), 2);
  // Twice around the inner square.
  const std::string twice = "M0 0H10V10H0ZM2 2H4V4H2Z";
  EXPECT_EQ(area(twice, "nonzero"), 100);
  EXPECT_EQ(area(twice, "evenodd"), 96);
  EXPECT_EQ(area("M0 0H6V6H0ZM4 4H10V10H4Z", "nonzero"), 68);
  EXPECT_EQ(area("M0 0H6V6H0ZM4 4H10V10H4Z", "evenodd"), 64);
  EXPECT_EQ(area("M0 0H9V9H0ZM0 2V4H2V2Z", "nonzero"), 77);
}

TEST(ImportPlanar, MendsPolygonsOnlyIfAsked) {
  const std::string spike =
      "{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[10,0],[10,10],[0,10],[0,4.96],[0.05,5],[-0.03,5.02],[-0.03,4.9],["
      "0,4.9],[0,0]]]}";
  ImportSettings settings;
  EXPECT_EQ(examine(spike, "p.geojson", settings).faults.size(), 1u);
  settings.repair = 0.2;
  const Import mended = examine(spike, "p.geojson", settings);
  expect_totals(mended, 100, 1, 0, 0.01);
  EXPECT_FALSE(mended.files[0].repairs.empty());
  const std::string bow = "POLYGON ((0 0, 10 10, 10 0, 0 10, 0 0))";
  EXPECT_FALSE(examine(bow, "p.wkt", settings).faults.empty());
  settings.repair = 20;
  expect_totals(examine(bow, "p.wkt", settings), 25, 1, 0);
}

TEST(ImportPlanar, ListsSpikesOfPolygons) {
  const auto polygon = [](const std::string& more) { return "POLYGON ((0 0, 10 0" + more + ", 10 10, 0 10, 0 0))"; };
  ImportSettings settings;
  settings.repair = 6;
  for (const char* spike : {", 10 5, 15 5, 10 5", ", 10 5, 5 5, 10 5", ", 10 5, 13 5, 13 8, 13 4, 13 5, 10 5"}) {
    const Import import = examine(polygon(spike), "p.wkt", settings);
    expect_totals(import, 100, 1, 0);
    ASSERT_EQ(import.files[0].repairs.size(), 1u) << spike;
    EXPECT_EQ(import.files[0].repairs[0].what, "spike");
    EXPECT_EQ(import.files[0].repairs[0].at, (Point{10, 5}));
    EXPECT_NEAR(import.files[0].repairs[0].size, 4.5, 0.5);
  }
  // A hole that is no more than a line.
  const Import slit = examine("POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0), (3 3, 5 3, 4 3, 3 3))", "p.wkt", settings);
  expect_totals(slit, 100, 1, 0);
  EXPECT_EQ(slit.files[0].repairs.size(), 1u);
  // A cut to a hole changes nothing.
  const Import cut = examine(polygon(", 10 5, 7 5, 7 3, 4 3, 4 7, 7 7, 7 5, 10 5"), "p.wkt", settings);
  expect_totals(cut, 100 - 12, 1, 1);
  EXPECT_TRUE(cut.files[0].repairs.empty());
  settings.repair = 1;
  const Import long_spike = examine(polygon(", 10 5, 15 5, 10 5"), "p.wkt", settings);
  ASSERT_EQ(long_spike.faults.size(), 1u);
  EXPECT_NE(long_spike.faults[0].problem().find("to and fro along a line near (10, 5)"), std::string::npos);
}

/// Copies of a part of a side that meet at both ends go to and fro, and are no contour of their own.
TEST(ImportPlanar, CopiesOfAPartOfASideAreNoContour) {
  DxfText text;
  text.box({0, 0}, {40, 40}).box({10, 10}, {20, 20}).line({10, 10}, {10, 15});
  text.line({12, 10}, {18, 10}).line({12, 10}, {15, 10}).line({18, 10}, {15, 10});
  expect_totals(examine(text), 1500, 1, 1);
  // With another contour across the hole, both are one.
  text.polyline({{17, 12}, {25, 12}, {25, 14}, {17, 14}}, true);
  expect_totals(examine(text), 1490, 1, 1);
}

}  // namespace
}  // namespace taut
