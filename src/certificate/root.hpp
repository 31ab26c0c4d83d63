// The next root of a certificate function, as far as it is known.
#pragma once

#include <cstdint>
#include <limits>

#include "certificate/fast_function.hpp"

namespace taut::internal {

inline constexpr double never = std::numeric_limits<double>::infinity();

/// The kind of information known about a function's next root.
enum class RootKind : std::uint8_t {
  not_before,  ///< the function keeps its sign at least until `lo`
  bracketed,   ///< the root is within [lo, hi], where the function is monotone
  isolated,    ///< bracketed, and [lo, hi] is about as short as doubles can make it, or shorter
};

/// A function that has a sign now, and the time when it loses it: first a bound, then an enclosure. Both are improved
/// only on demand (FastRoots, FailureSolver).
struct Root {
  FastFunction function;
  double lo = 0, hi = 0;
  double monotone_until = 0;  ///< for an enclosed root: the function is monotone from `lo` to here
  std::int32_t precise = -1;  ///< index of a multi-precision enclosure, or -1
  std::int8_t sign = 0;       ///< the current sign
  RootKind kind = RootKind::not_before;

  /// The root comes no earlier than t, and not at all on a segment that ends by then.
  void come_after(double t, double end) {
    kind = RootKind::not_before;
    lo = t >= end ? never : t;
  }
};

}  // namespace taut::internal
