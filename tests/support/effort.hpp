// How much a random test does: less where every access is watched, and where somebody waits.
#pragma once

#include <algorithm>
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

/// Of so many rounds, one is gone: all of them, every tenth under the sanitizers, which make everything about that much
/// slower, and where TAUT_EFFORT says `tenth`, as `./dev test` does; every fortieth where both is so.
inline std::uint64_t one_of() {
  static const char* const said = std::getenv("TAUT_EFFORT");
  static const bool tenth = said && std::string_view(said) == "tenth";
  return watched && tenth ? 40 : watched || tenth ? 10 : 1;
}

/// How many times more rounds to go: TAUT_EFFORT=x50 makes a soak of any random test.
inline std::uint64_t soak_times() {
  static const char* const said = std::getenv("TAUT_EFFORT");
  static const long n = said && *said == 'x' ? std::strtol(said + 1, nullptr, 10) : 1;
  return n > 0 ? static_cast<std::uint64_t>(n) : 1;
}

/// How many of n rounds to go. Where a tenth is few, it is not made fewer.
inline std::uint64_t effort(std::uint64_t n) {
  constexpr std::uint64_t few = 20;
  n *= soak_times();
  return one_of() <= 10 ? n / one_of() : std::max(n / one_of(), std::min(n / 10, few));
}

/// What a count over effort(N) rounds has to exceed, if that is n for N of them: half of its share where rounds are
/// left out, since fewer samples stray farther.
inline std::uint64_t enough(std::uint64_t n) { return one_of() == 1 ? n : n / one_of() / 2; }

}  // namespace taut::testing
