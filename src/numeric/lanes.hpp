// Two doubles processed in parallel, each rounded as it would be alone: the common subset of SSE2, NEON and
// WebAssembly.
#pragma once

#include <cstring>

namespace taut::internal {

/// GCC's and clang's vector type: + - * / act on both elements, each rounding as IEEE 754 says.
using Lanes = double __attribute__((vector_size(16)));

inline Lanes load_lanes(const double* from) {
  Lanes x;
  std::memcpy(&x, from, sizeof x);
  return x;
}
inline void store_lanes(double* to, Lanes x) { std::memcpy(to, &x, sizeof x); }
inline Lanes both(double x) { return Lanes{x, x}; }

}  // namespace taut::internal
