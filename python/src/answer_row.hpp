// An answer of fixed size, as a row of a numpy array.
#pragma once

#include <cstdint>

#include "taut/check.hpp"

namespace taut_python {

/// A vertex or an edge; -1 throughout where there is none.
struct FeatureRow {
  std::int32_t body = -1, part = -1, ring = -1, index = -1;
};

/// Numbers are NaN, and indices -1, where there is nothing to say. Its layout is that of answer_dtype() in
/// taut2d/many.py.
struct AnswerRow {
  double t_lo, t_hi;
  double free_until;
  double point[2], normal[2];
  std::uint64_t events;
  std::uint64_t untested;  ///< pairs about which nothing is said
  std::int32_t pair[2];
  FeatureRow vertex, edge;
  std::uint8_t outcome;   ///< as taut::Outcome counts
  std::uint8_t touching;  ///< free, and the rest of the row is about a touch
  std::uint8_t grazing;
  std::uint8_t unused[5];  ///< all bytes of a row are known: equal answers are equal bytes
};

AnswerRow answer_row(const taut::Answer& answer);

}  // namespace taut_python
