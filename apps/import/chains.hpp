// Lines that were drawn one by one, put together.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "import/drawing.hpp"

namespace taut::drawing {

/// What was done about gaps.
struct JoinCounts {
  std::size_t joins = 0;  ///< ends that were put together
  double longest = 0;     ///< how far they were apart, at most
};

/// Joins open chains where their ends are equal, then where they are at most `distance` apart, nearest first: the one
/// end takes the place of the other. What is closed by then is in the result, with what was closed before; what is not
/// goes to `open`.
std::vector<Chain> join_chains(std::vector<Chain> chains, double distance, JoinCounts& counts,
                               std::vector<Chain>& open);

}  // namespace taut::drawing
