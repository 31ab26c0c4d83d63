// find_path(), for those who want to know which cells showed that there is no way.
#pragma once

#include <functional>

#include "path/cell_tree.hpp"

namespace taut::internal::path {

/// Called where cells, and not exact signs alone, show that there is no way.
using OnNone = std::function<void(const JointSpace& space, CellTree& tree)>;

/// With `on_none`, a problem that only exact signs decide to have no way is undecided.
PathAnswer find_path(const PathProblem& problem, const PathOptions& options, const OnNone& on_none);

}  // namespace taut::internal::path
