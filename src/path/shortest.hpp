// A way made shorter, and how much shorter any other one could be.
#pragma once

#include "path/cell_tree.hpp"
#include "path/goal.hpp"
#include "path/way.hpp"

namespace taut::internal::path {

/// Of an answer that is a path, with the tree of cells that found it: divides cells and their faces where the shortest
/// chain through them leads, until the way is at most the options' share longer than that chain. Sets its length.
void shorten(const PathProblem& problem, const PathOptions& options, const JointSpace& space, const WayChecker& checker,
             CellTree& tree, PathAnswer& answer);

}  // namespace taut::internal::path
