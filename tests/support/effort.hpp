// How much a random test does: less where every access is watched, and where somebody waits.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace taut::testing {

#if defined(__SANITIZE_ADDRESS__)
#define TAUT_WATCHED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define TAUT_WATCHED 1
#endif
#endif

#ifdef TAUT_WATCHED
inline constexpr bool watched = true;
#else
inline constexpr bool watched = false;
#endif

/// n, or a tenth of it: under the sanitizers, which make everything about that much slower, and where TAUT_EFFORT says
/// so, as `./dev test` does.
inline std::uint64_t effort(std::uint64_t n) {
  static const char* const said = std::getenv("TAUT_EFFORT");
  static const bool tenth = watched || (said && std::string_view(said) == "tenth");
  return tenth ? n / 10 : n;
}

/// What a count over effort(n) rounds has to exceed: n, or half of its share where that is less, since fewer samples
/// stray farther.
inline std::uint64_t enough(std::uint64_t n) { return effort(n) == n ? n : effort(n) / 2; }

}  // namespace taut::testing
