// Solutions of a mechanism's equations over a box of values of its drives: Krawczyk's test with parameters.
#pragma once

#include <optional>
#include <vector>

#include "motion/loop_solver.hpp"

namespace taut::internal {

/// Values of all drives of some equations: `middle[k]` up to `half[k]` to either side.
struct DriveBox {
  std::vector<double> middle, half;
};

/// For each d in the box there is exactly one solution u(d) within `tube` of at + slope (d - middle), and it is within
/// `error` of it. So u is one smooth function over the box.
struct BoxSolution {
  std::vector<double> at;
  std::vector<double> tube, error;
  std::vector<double> at_middle;  ///< bounds |u(middle) - at|
  /// The derivatives by each drive whose values vary: all of them are within `slope_error` of `slope`. Else empty.
  std::vector<std::vector<double>> slope, slope_error;

  /// The linear function at d, with what rounds.
  Balls<double> about(const DriveBox& box, const std::vector<double>& d) const;
};

/// The solution near `about` at the middle of the box, if doubles show that there is one over all of it.
std::optional<BoxSolution> solve_over(const LoopEquations& equations, const std::vector<double>& weights,
                                      const DriveBox& box, std::vector<double> about);

}  // namespace taut::internal
