// Cells: convex polygons of doubles, each around a piece of a curve.
//
// A cell has a left and a right wall along its piece, and at each end a gate: a short segment across the curve, or,
// where the curve's point is a pair of doubles, that point. What verified() proves of a cell and its piece:
//
//   C1  the vertices, right wall forwards and left wall backwards, are a strictly convex polygon, by exact signs;
//   C2  the control points lie on the inner side of every wall's edge, by exact signs or signs of balls;
//   C3  all of them but the end's own, and the vertices of the other gate, lie strictly ahead of the first gate, bent
//   so
//       that it passes through the curve's point, and strictly behind the last one;
//   C4  the control polygon's segments have positive products with one direction.
//
// Hence, by the law of pieces, the piece does not meet itself (C4), stays between the walls (C2), and meets its gates
// in its ends only (C3). If no two cells of a closed curve meet but neighbours in their common gate, the curve is
// simple, the left walls make a simple polygon on its left side, and the right walls one on its right side. A gate's
// bend leaves its two cells together what they are.
#pragma once

#include <optional>
#include <vector>

#include "geometry/piece.hpp"

namespace taut::internal::curve {

/// Where two pieces meet.
struct Gate {
  Point left, right;
  bool exact = false;  ///< both are the curve's point itself
};

struct Cell {
  Piece piece;
  std::vector<Point> left, right;  ///< corners of the walls between the gates, at most two each
  double thickness = 0;            ///< no point of one wall is farther from the other
  bool is_final = false;           ///< a line, or as fine as doubles allow

  bool is_line() const { return piece.is_line(); }
};

/// How coordinates compare with what is computed of them, for the curves of one part.
struct Resolution {
  double size = 1;  ///< a power of two, no coordinate is larger
  /// Half the width of a gate.
  double gate() const { return size * 0x1p-47; }
};

/// A gate across the curve at the end of a piece that is not an exact point.
Gate gate_at_end(const Piece& piece, const Resolution& resolution);

/// A cell around the piece between these gates, proved; none if no attempt has succeeded.
std::optional<Cell> make_cell(const Piece& piece, const Gate& first, const Gate& last, const Resolution& resolution);

/// The polygon of a cell, counterclockwise.
std::vector<Point> corners_of(const Cell& cell, const Gate& first, const Gate& last);

/// Two cells for one, within it, and the gate between them; none where doubles do not allow it.
struct Split {
  Cell first, last;
  Gate gate;
};
std::optional<Split> split(const Cell& cell, const Gate& first, const Gate& last, const Resolution& resolution);

/// C1 to C4 of cell.hpp, for a piece that is not a line.
bool verified(const Cell& cell, const Gate& first, const Gate& last);

}  // namespace taut::internal::curve
