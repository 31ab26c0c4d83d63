// How much a random test does: less where every access is watched.
#pragma once

#include <cstdint>

namespace taut::testing {

#if defined(__SANITIZE_ADDRESS__)
#define TAUT_WATCHED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define TAUT_WATCHED 1
#endif
#endif

/// n, or a fifth of it under the sanitizers.
inline constexpr std::uint64_t effort(std::uint64_t n) {
#ifdef TAUT_WATCHED
  return n / 5;
#else
  return n;
#endif
}

}  // namespace taut::testing
