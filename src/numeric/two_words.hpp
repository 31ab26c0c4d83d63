// Products of two words, and their halves.
#pragma once

#include <cstdint>

namespace taut::internal {

__extension__ using TwoWords = unsigned __int128;

inline std::uint64_t high_word(TwoWords x) { return static_cast<std::uint64_t>(x >> 64); }
inline std::uint64_t low_word(TwoWords x) { return static_cast<std::uint64_t>(x); }

}  // namespace taut::internal
