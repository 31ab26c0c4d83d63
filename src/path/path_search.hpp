// The search for a way among cells of joint values.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "path/cell_tree.hpp"
#include "path/channel.hpp"
#include "path/goal.hpp"
#include "path/translations.hpp"
#include "path/way.hpp"

namespace taut::internal::path {

/// Cells, each a neighbour of the next.
using Chain = std::vector<CellId>;

class PathSearch {
 public:
  /// `reach`: `none` is about ways within it.
  PathSearch(const PathProblem& problem, const PathOptions& options, const JointSpace& space, const WayChecker& checker,
             const Reach* reach = nullptr);

  /// Throws Interrupted at a limit.
  void run(PathAnswer& answer);
  /// The partition as it is.
  std::vector<EnvelopeCell> cells(PathOutcome outcome) const;
  CellTree& tree() { return tree_; }

 private:
  bool try_straight(PathAnswer& answer);
  bool try_chain(const Chain& chain, PathAnswer& answer);
  bool can_be_divided(CellId id) const;
  Chain doubtful_in(const Chain& chain);
  bool divide_some_of(const Chain& chain);
  bool may_lock(CellId id) const;
  std::vector<char> reached() const;
  bool reaches_lock() const;
  void set_tight(const Chain& chain, PathAnswer& answer) const;
  std::optional<JointValues> start_in(const JointCell& box) const;
  bool passes(CellId from, CellId to, const JointValues& a, const JointValues& b, bool exactly);
  bool accept(std::vector<JointValues> way, PathAnswer& answer);

  const PathProblem& problem_;
  const PathOptions& options_;
  const JointSpace& space_;
  const WayChecker& checker_;
  Goal goal_;
  CellTree tree_;
  Channel channel_;
  std::array<CellId, 2> failed_{no_cell, no_cell};    ///< cells of the last chain between which no segment passes
  std::map<std::pair<CellId, CellId>, bool> passed_;  ///< between the samples of cells
};

// find_path(), for those who want to know which cells showed that there is no way.

/// Who wants to know why there is no way.
struct OnNone {
  /// Of translations: the barrier that keeps the start from the goal. If that is refused, cells are tried.
  OnBarrier barrier;
  /// The cells that show it.
  std::function<void(const JointSpace& space, CellTree& tree)> cells;
};

/// With `on_none`, a problem is undecided that has no way for reasons that neither a barrier nor cells give.
PathAnswer find_path(const PathProblem& problem, const PathOptions& options, const OnNone& on_none);

}  // namespace taut::internal::path
