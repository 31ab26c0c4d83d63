// The heap as operator new sees it: how often, how much, at most how much.
#pragma once

#include <cstddef>
#include <cstdint>

namespace taut::bench {

struct HeapUse {
  std::uint64_t allocations = 0;  ///< since the program started
  std::size_t live = 0;           ///< bytes handed out and not returned, 0 where the C library cannot tell
  std::size_t peak = 0;           ///< the largest `live` since reset_heap_peak()
};

HeapUse heap_use();
void reset_heap_peak();

}  // namespace taut::bench
