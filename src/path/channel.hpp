// Chains of cells that do not collide, from the start to the goal, through cells as large as possible.
//
// Two searches grow a tree of cells each, one from the start and one from the goal, always by the largest cell next to
// it: by Prim's algorithm, with free cells before all others. Where they meet, the smallest cell of the chain is as
// large as it can be. When that cell is divided, what was reached through it is forgotten, and the search goes on.
#pragma once

#include <array>
#include <deque>
#include <optional>
#include <vector>

#include "path/cell_tree.hpp"

namespace taut::internal::path {

class Channel {
 public:
  explicit Channel(CellTree& tree) : tree_(tree) {}

  enum class Side : std::uint8_t { start, goal };
  /// The cell, a leaf, holds the start, or some of the goal.
  void add_seed(Side side, CellId cell);
  /// A chain from a seed of the start to one of the goal, each cell a neighbour of the next; nothing if there is none.
  std::optional<std::vector<CellId>> find();
  /// Halves a cell; false if it is not divided any more. `is_seed(half, side)`: does a half of a seed hold it, too?
  template <class IsSeed>
  bool divide(CellId id, const IsSeed& is_seed) {
    const std::array<bool, 2> was{mark(Side::start, id).is_seed, mark(Side::goal, id).is_seed};
    const std::array<std::vector<CellId>, 2> lost{forget(Side::start, id), forget(Side::goal, id)};
    const bool divided = tree_.divide(id);
    for (const Side side : {Side::start, Side::goal}) {
      if (divided) {
        for (const CellId half : {tree_[id].children, tree_[id].children + 1})
          find_anew(side, half, was[index(side)] && is_seed(half, side));
      } else {
        find_anew(side, id, was[index(side)]);
      }
      for (const CellId other : lost[index(side)]) find_anew(side, other, mark(side, other).is_seed);
    }
    return divided;
  }

 private:
  struct Front {
    std::vector<std::deque<CellId>> queues;  ///< by rank: the largest cells first
    std::size_t first = 0;                   ///< no queue before this one has cells
    std::size_t reached = 0;
  };
  static std::size_t index(Side side) { return side == Side::start ? 0 : 1; }
  static Side other(Side side) { return side == Side::start ? Side::goal : Side::start; }
  ReachMark& mark(Side side, CellId id) { return tree_[id].marks[index(side)]; }
  bool waits(Side side, CellId id);
  std::size_t rank(CellId id);
  void queue(Side side, CellId id);
  std::optional<std::size_t> next_rank(Side side);
  CellId reach_next(Side side);
  /// What was reached, or found, through the cell, is so no more; these cells.
  std::vector<CellId> forget(Side side, CellId id);
  void find_anew(Side side, CellId id, bool is_seed);
  std::vector<CellId> chain_through(CellId meeting);

  CellTree& tree_;
  std::array<Front, 2> fronts_;
};

}  // namespace taut::internal::path
