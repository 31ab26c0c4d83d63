// Corner certificates.
#pragma once

#include <cstdint>
#include <limits>

#include "geometry/ids.hpp"
#include "sign/fast_function.hpp"

namespace taut {

inline constexpr double never = std::numeric_limits<double>::infinity();

/// What is known of a certificate's next failure.
enum class FailureKind : std::uint8_t {
  not_before,  ///< the certificate holds until `lo` at least
  bracketed,   ///< it fails within [lo, hi], where its function is monotone
  isolated,    ///< the same, and [lo, hi] is about as short as doubles can make it, or shorter
};

/// One corner u -> v -> w of a face, as long as it keeps its orientation.
struct Certificate {
  FastFunction function;
  double lo = 0, hi = 0;
  double monotone_until = 0;  ///< of those that fail: the function is monotone from `lo` to here
  HalfedgeId corner;          ///< the half-edge u -> v of the face
  VertexId u, v, w;
  std::int32_t precise = -1;  ///< index of a multi-precision enclosure of the failure time, or -1
  std::int8_t sign = 0;       ///< +1 convex, -1 reflex
  FailureKind kind = FailureKind::not_before;
};

}  // namespace taut
