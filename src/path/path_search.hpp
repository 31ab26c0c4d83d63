// The search for a way among cells of joint values.
#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "path/channel.hpp"
#include "path/goal.hpp"
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
  std::vector<EnvelopeCell> cells() const;
  CellTree& tree() { return tree_; }

 private:
  bool try_straight(PathAnswer& answer);
  bool try_chain(const Chain& chain, PathAnswer& answer);
  bool can_be_divided(CellId id) const;
  Chain doubtful_in(const Chain& chain);
  bool divide_some_of(const Chain& chain);
  bool may_lock(CellId id) const;
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

}  // namespace taut::internal::path
