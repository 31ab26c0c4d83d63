// Closed contours of a drawing that cross each other, or share a part of their lines, and what lies in which.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "import/faces.hpp"

namespace taut::drawing {

/// Two contours each of which has a part outside of the other one.
struct ContourCrossing {
  std::size_t smaller = 0, larger = 0;  ///< chains
  double smaller_area = 0, larger_area = 0, common_area = 0;
  Point at;           ///< where they meet
  bool hole = false;  ///< within material: they are one hole
};

/// Cells are the faces of the contours' edges alone; blocks are those of the edges.
class CrossingContours {
 public:
  CrossingContours() = default;
  CrossingContours(const LineGraph& graph, const Contours& contours, const std::vector<int>& block,
                   const FaceMap& cells);

  /// Is the cell, at an edge of the block, within none of the block's contours?
  bool between(int block, int cell) const;
  /// Is the cell within a contour of the block that has a part in a larger one?
  bool in_smaller(int block, int cell) const;
  /// The same number for cells within contours of the block that cross each other, directly or by others; -1 for cells
  /// between them.
  int united(int block, int cell) const;
  /// In the order of the contours.
  std::vector<std::pair<int, ContourCrossing>> crossings() const;  ///< with their blocks

 private:
  using Rings = std::map<int, int>;

  void go_around(const FaceMap& cells, const std::vector<Rings>& winding);
  void compare_rings(const FaceMap& cells);
  std::vector<int> rings_at(int block, int cell) const;
  int root(int ring) const;

  const LineGraph* graph_ = nullptr;
  const Contours* contours_ = nullptr;
  std::set<int> tangled_;               ///< blocks of several contours, or of one that meets itself
  std::vector<std::set<int>> blocks_;   ///< of each ring
  std::vector<Rings> rings_;            ///< of each cell: how often rings go around it, where that is not 0
  std::vector<double> areas_;           ///< of each ring
  std::vector<int> cells_in_, united_;  ///< of each ring: how many cells it goes around, and a ring that it crosses
  std::vector<bool> smaller_;           ///< has it a part in a larger one?
  struct Common {
    int cells = 0, block = 0;
    double area = 0;
  };
  std::map<std::pair<int, int>, Common> common_;  ///< of pairs of rings, the smaller one first
};

struct LineFaces {
  FaceKeys keys;
  std::vector<ContourCrossing> crossings;
};

/// Of lines: what a block of closed contours encloses differs from what surrounds the block, so that contours in each
/// other are outlines, holes and islands in turn. All faces that a contour of the block goes around are alike: contours
/// that cross, or have edges in common, divide material into parts, or are one hole; `crossing` says what else they may
/// do in material. Faces between them that no contour goes around are like what surrounds the block. Other lines only
/// divide; outside of all contours, what they enclose is material. Each face of material has a number of its own.
LineFaces faces_of_lines(const LineGraph& graph, const std::vector<bool>& alive, const Contours& contours,
                         const FaceMap& faces, Crossing crossing);

}  // namespace taut::drawing
