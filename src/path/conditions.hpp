// Do linear conditions exclude each other over a cell?
#pragma once

#include <array>
#include <vector>

#include "path/pair_cells.hpp"

namespace taut::internal::path {

/// What is known of all conditions together.
struct JointConditions {
  /// No values in the cell fulfil all of them: certain, by the sum below.
  bool exclude_each_other = false;
  /// Of each condition, none negative: constant and rates of the weighted sum are such that it is negative over the
  /// cell.
  std::vector<double> weights;
  /// The values, from -1 to 1 across the cell, at which the least of the conditions is as large as it can be.
  std::array<double, max_joints> best{};
};

/// By linear programming over at most the first `most_conditions`: in doubles, but for the last sum, which bounds its
/// rounding.
JointConditions decide(const std::vector<Condition>& conditions);

inline constexpr std::size_t most_conditions = 24;

}  // namespace taut::internal::path
