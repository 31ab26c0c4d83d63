// How much a random test does: less where every access is watched.
#pragma once

#include <cstdint>

namespace taut::testing {

/// n, or a fifth of it under the sanitizers.
inline constexpr std::uint64_t effort(std::uint64_t n) {
#if defined(__SANITIZE_ADDRESS__)
  return n / 5;
#else
  return n;
#endif
}

}  // namespace taut::testing
