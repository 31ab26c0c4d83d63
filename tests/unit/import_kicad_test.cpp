// Boards of KiCad: rounded edges, polygons with arcs, and drills.
#include <gtest/gtest.h>

#include "support/drawings.hpp"

namespace taut {
namespace {

using drawing::Import;
using drawing::ImportSettings;
using testing::examine;
using testing::totals_of;

constexpr double kicad_pi = 3.14159265358979323846;

Import board_of(const std::string& items, std::optional<double> drills = {}, double scale = 1) {
  ImportSettings settings;
  settings.drills = drills;
  settings.scale = scale;
  return examine("(kicad_pcb (version 20260206) " + items + ")", "b.kicad_pcb", settings);
}

const char* const board_square = "(gr_rect (start 30 30) (end 0 0) (layer \"Edge.Cuts\"))";

TEST(ImportKicad, RoundsRectangles) {
  const auto area = [](const std::string& radius) {
    return totals_of(board_of("(gr_rect (start 30 10) (end 0 0) (layer Edge.Cuts) " + radius + ")")).area;
  };
  EXPECT_EQ(area(""), 300);
  EXPECT_NEAR(area("(radius 2)"), 300 - (4 - kicad_pi) * 4, 0.1);
  EXPECT_NEAR(area("(radius 99)"), 200 + kicad_pi * 25, 0.2);
}

TEST(ImportKicad, ReadsPolygonsWithArcs) {
  const Import import = board_of(
      "(gr_poly (pts (xy 0 0) (xy 10 0) (arc (start 10 0) (mid 15 5) (end 10 10)) (xy 0 10) "
      "(arc (start 0 8) (mid 1 7) (end 0 6))) (layer Edge.Cuts))");
  EXPECT_TRUE(import.faults.empty());
  EXPECT_NEAR(totals_of(import).area, 100 + 12.5 * kicad_pi - kicad_pi / 2, 0.2);
}

/// Pads: a mounting hole, a slot that stands upright on the board, a small one; vias: one through the board, one not.
const std::string drilled =
    std::string(board_square) +
    "(footprint H (layer F.Cu) (at 10 10 90) (property Reference H1)"
    " (pad \"\" np_thru_hole circle (at 0 0 90) (size 3.2 3.2) (drill 3.2) (layers *.Cu *.Mask))"
    " (pad 2 thru_hole oval (at -10 10 180) (size 3 5) (drill oval 2 4 (offset 9 9)) (layers *.Cu))"
    " (pad 3 thru_hole circle (at 5 0 90) (size 2 2) (drill 1) (layers *.Cu)) (pad 4 smd rect (at 0 9) (size 1 1)))"
    "(via (at 2 2) (size 0.8) (drill 0.4) (layers F.Cu B.Cu)) (via blind (at 4 4) (size 1) (drill 0.5))";

TEST(ImportKicad, CountsDrillsThatAreNoHoles) {
  const Import import = board_of(drilled);
  EXPECT_EQ(totals_of(import).area, 900);
  ASSERT_EQ(import.files[0].notes.size(), 2u);
  EXPECT_NE(import.files[0].notes[0].find("3 of pads and 1 of vias, 0.4 to 3.2 wide"), std::string::npos)
      << import.files[0].notes[0];
  EXPECT_NE(import.files[0].notes[1].find("1 of blind"), std::string::npos);
  EXPECT_TRUE(board_of(board_square).files[0].notes.empty());
}

/// A board encloses all courtyards, and is no border of a sheet.
TEST(ImportKicad, ABoardWithAHoleIsNoSheet) {
  const Import import = board_of(std::string(board_square) +
                                 "(gr_circle (center 20 20) (end 23 20) (layer \"Edge.Cuts\"))"
                                 "(footprint R (layer F.Cu) (at 8 8) (property Reference R1)"
                                 " (fp_rect (start -2 -1) (end 2 1) (layer F.CrtYd)))");
  EXPECT_EQ(import.bodies.size(), 2u);
  EXPECT_TRUE(import.files[0].notes.empty()) << import.files[0].notes[0];
}

TEST(ImportKicad, MakesDrillsHoles) {
  const double mounting = kicad_pi * 1.6 * 1.6, slot = kicad_pi + 4, small = kicad_pi / 4, via = kicad_pi * 0.04;
  const Import wide = board_of(drilled, 2);
  EXPECT_NEAR(totals_of(wide).area, 900 - mounting - slot, 0.2);
  EXPECT_EQ(totals_of(wide).holes, 2u);
  EXPECT_NEAR(totals_of(board_of(drilled, 0.5)).area, 900 - mounting - slot - small, 0.2);
  EXPECT_NEAR(totals_of(board_of(drilled, 0)).area, 900 - mounting - slot - small - via, 0.2);
  EXPECT_EQ(totals_of(board_of(drilled, 3.3)).holes, 0u);
  EXPECT_NEAR(totals_of(board_of(drilled, 4, 2)).area, 4 * (900 - mounting - slot), 1) << "D is a length of the scene";
  // The angle of a pad is that on the board: the slot is 2 wide and 4 high, at (20, 20).
  const Polygon* slot_ring = nullptr;
  for (const Polygon& hole : wide.scene.bodies.at(0).parts.at(0).holes)
    if (hole[0].x > 15) slot_ring = &hole;
  ASSERT_TRUE(slot_ring);
  for (const Point& p : *slot_ring) {
    EXPECT_LE(std::fabs(p.x - 20), 1 + 1e-9);
    EXPECT_LE(std::fabs(p.y + 20), 2 + 1e-9);
  }
}

TEST(ImportKicad, CutsNotchesAndOverlappingDrills) {
  const auto vias = [](const std::string& places) { return totals_of(board_of(board_square + places, 0)); };
  const auto via = [](const std::string& at) { return "(via (at " + at + ") (drill 2) (size 3))"; };
  const testing::Totals notch = vias(via("0 15"));
  EXPECT_NEAR(notch.area, 900 - kicad_pi / 2, 0.1);
  EXPECT_EQ(notch.parts, 1u);
  EXPECT_EQ(notch.holes, 0u);
  const testing::Totals twice = vias(via("15 15") + via("15 15"));
  EXPECT_NEAR(twice.area, 900 - kicad_pi, 0.1);
  const testing::Totals lens = vias(via("15 15") + via("16 15"));
  EXPECT_NEAR(lens.area, 900 - 2 * kicad_pi + 2 * kicad_pi / 3 - std::sqrt(3) / 2, 0.1);
  EXPECT_EQ(lens.holes, 1u);
  EXPECT_EQ(vias(via("99 99")).area, 900);
  // In a hole that is there already.
  const std::string hole = "(gr_circle (center 10 10) (end 15 10) (layer Edge.Cuts))";
  const double less = vias(hole).area - vias(hole + via("10 10") + via("14.5 10")).area;
  EXPECT_GT(less, 0.3);
  EXPECT_LT(less, kicad_pi / 2);
}

}  // namespace
}  // namespace taut
