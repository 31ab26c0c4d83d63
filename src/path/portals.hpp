// A lower bound of the length of all ways: through the faces of cells that do not collide.
//
// A way that collides nowhere passes from cell to cell, through faces of cells that do not collide. Within a cell it is
// at least as long as the straight segment from the face where it comes in to the one where it leaves. Faces are cut
// into pieces. So the shortest chain of pieces, each two of them at a cell in common and as far apart as their nearest
// points are, is no longer than any way. The smaller the pieces, the better the bound; those are dropped through which
// no way leads that is shorter than the bound has to be.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "path/goal.hpp"
#include "path/way.hpp"

namespace taut::internal::path {

class Portals {
 public:
  /// Of all leaves of the tree that do not collide.
  Portals(const PathProblem& problem, const CellTree& tree, const JointMetric& metric, const Goal& goal);

  /// A piece of a face, passed in one of two directions.
  struct Crossing {
    std::uint32_t piece = 0;
    std::uint8_t into = 0;  ///< 0: from the second cell into the first one
  };
  struct Chain {
    double length = 0;  ///< no way is shorter
    /// From the start's cell to the goal's one: one more than crossings.
    std::vector<CellId> cells;
    std::vector<Crossing> crossings;
  };
  /// The shortest chain; nothing if each way is at least as long as `enough`. Drops all pieces through which each way
  /// is that long.
  std::optional<Chain> shortest(double enough);
  /// The same, of values that the way through the chain may take: straight where it can be. The goal's nearest one ends
  /// it, if the last cell has some.
  std::vector<JointValues> way_through(const Chain& chain) const;
  /// The largest extent of a piece.
  double largest() const;
  /// Halves all pieces of at least that extent. False if there are none.
  bool refine(double extent);
  /// Cells that are undecided and larger than that from corner to corner, but for those that no piece is left of.
  std::vector<CellId> undecided_above(double extent) const;
  /// To be called when that leaf of the tree was divided.
  void divided(CellId cell);
  /// Of pieces that are in use.
  std::size_t size() const { return size_; }

 private:
  struct Piece {
    CellFace face;
    std::array<CellId, 2> cell{no_cell, no_cell};
    std::array<ValueBox, 2> box;  ///< as each of its cells sees it
    bool is_in_use = true;
  };
  /// A piece, as one of its cells sees it.
  struct Seen {
    std::uint32_t piece;
    std::uint8_t side;
  };
  const ValueBox& box(const Seen& s) const { return pieces_[s.piece].box[s.side]; }
  const ValueBox& box(const Crossing& c) const { return pieces_[c.piece].box[c.into]; }
  /// Crossings by number: twice the piece's, and `into`.
  struct Node {
    double length = INFINITY;
    std::uint32_t before = UINT32_MAX;  ///< none: from where the search began
    CellId from = no_cell;
  };
  struct Reached {
    std::vector<Node> nodes;
    double length = INFINITY;  ///< as far as the other end
    std::uint32_t last = UINT32_MAX;
    CellId cell = no_cell;
  };
  enum class End : std::uint8_t { start, goal };
  Reached search(End from, double enough) const;
  std::vector<ValueBox> ends_in(End end, CellId cell) const {
    return end == End::start ? starts_in(cell) : goals_in(cell);
  }
  bool is_back(const Crossing& in, const Seen& out) const;
  void add(const CellFace& face, CellId a, CellId b);
  void remove(std::uint32_t piece);
  void hand_on(const Seen& seen, CellId half);
  std::size_t longest_side(const Piece& piece) const;
  double extent(const Piece& piece) const;
  std::vector<ValueBox> starts_in(CellId cell) const;
  std::vector<ValueBox> goals_in(CellId cell) const;
  std::vector<ValueBox> shifted_into(CellId cell, const ValueBox& box) const;
  ValueBox box_of(CellId cell) const;

  const PathProblem& problem_;
  const CellTree& tree_;
  const JointMetric& metric_;
  const Goal& goal_;
  std::size_t dimension_;
  std::vector<Piece> pieces_;
  std::vector<std::vector<Seen>> at_;  ///< by cells
  std::size_t size_ = 0;
};

}  // namespace taut::internal::path
