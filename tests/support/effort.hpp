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

/// n, or a tenth of it under the sanitizers, which make everything about that much slower.
inline constexpr std::uint64_t effort(std::uint64_t n) {
#ifdef TAUT_WATCHED
  return n / 10;
#else
  return n;
#endif
}

/// What a count over effort(n) rounds has to exceed: n, or half of its share under the sanitizers, since fewer samples
/// stray farther.
inline constexpr std::uint64_t enough(std::uint64_t n) {
#ifdef TAUT_WATCHED
  return effort(n) / 2;
#else
  return n;
#endif
}

}  // namespace taut::testing
