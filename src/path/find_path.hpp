// find_path(), for those who want to know which cells showed that there is no way.
#pragma once

#include <functional>

#include "path/cell_tree.hpp"
#include "path/translations.hpp"

namespace taut::internal::path {

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
