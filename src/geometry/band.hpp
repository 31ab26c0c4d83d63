// A closed curve in a band of cells, finer wherever somebody asks for it.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "geometry/cell.hpp"

namespace taut::internal::curve {

/// Where a vertex of a wall, or the edge from it on, comes from.
struct Source {
  int cell = 0;
  double parameter = 0;  ///< of the cell's segment
};

/// One ring: cells in the order of the outline's segments, gate k before cell k. Splitting keeps cells within cells, so
/// that the polygons of a finer band lie between those of a coarser one, and what did not meet never does.
class Band {
 public:
  /// Throws InputError, `name` as its place, where a segment runs back into itself, or there is nothing to enclose.
  Band(const Outline& outline, const std::string& name);

  const std::vector<Cell>& cells() const { return cells_; }
  const Gate& gate(std::size_t k) const { return gates_[k % gates_.size()]; }
  const Resolution& resolution() const { return resolution_; }
  std::vector<Point> corners(std::size_t cell) const;

  /// Halves cell k `halvings[k]` times, as far as doubles allow. True if anything has become finer.
  bool refine(const std::vector<int>& halvings);

  /// The polygon along the left walls or the right ones, in the order of the outline.
  Polygon wall(bool left) const;
  std::vector<Source> sources(bool left) const;
  /// Counterclockwise (+1) or clockwise (-1); once no cells meet.
  int orientation() const;

 private:
  void add(const Piece& piece, const Gate& first, const Gate& last, int depth, const std::string& name);
  bool add_split(const Cell& cell, const Gate& first, const Gate& last, int halvings, std::vector<Cell>& cells,
                 std::vector<Gate>& gates) const;

  Resolution resolution_;
  std::vector<Cell> cells_;
  std::vector<Gate> gates_;
};

/// The segments of the ring, the closing line included where the outline needs one.
std::vector<CurveSegment> closed_segments(const Outline& outline);

/// A cell of one of several bands.
struct CellId {
  int band = 0, cell = 0;
};

/// All pairs of cells that meet elsewhere than neighbours may, in their gate; by exact signs, about O(n log n) where
/// few meet.
std::vector<std::array<CellId, 2>> meeting_cells(const std::vector<const Band*>& bands);

// A part bounded by curves, between polygons.

/// Refines bands until their cells meet neither each other nor their own: then the curves do not, either. Throws
/// InputError with the segments and the place where they still meet when doubles end. `places` name the bands.
void make_apart(std::vector<Band>& bands, const std::string& name, const std::vector<std::string>& places);

/// The outline and its holes, in bands that are apart.
class BandedPart {
 public:
  /// Throws InputError unless the curves are simple, and lie as those of a part must.
  BandedPart(const CurvedPart& part, const std::string& name);

  const std::vector<Band>& bands() const { return bands_; }
  Band& band(std::size_t ring) { return bands_[ring]; }
  /// Are the left walls of this ring on that side of its curve?
  bool left_is(std::size_t ring, CurveSide side) const { return left_is_inner_[ring] == (side == CurveSide::inner); }
  /// The polygons within the part, or around it, ring by ring.
  Part polygons(CurveSide side) const;
  /// The thickest cell's thickness.
  double tolerance() const;

 private:
  std::vector<Band> bands_;
  std::vector<bool> left_is_inner_;
};

// Bands as fine as they are wanted everywhere.

/// Halves what is thicker than the tolerance. Throws InputError where doubles do not allow that.
void refine_to(BandedPart& part, double tolerance, const std::string& name);

}  // namespace taut::internal::curve
