#include "heap.hpp"

#include <cstdlib>
#include <new>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace {

// One thread runs all benchmarks: plain counters do.
taut::bench::HeapUse use;

std::size_t size_of_block([[maybe_unused]] void* block) {
#ifdef __GLIBC__
  return malloc_usable_size(block);
#else
  return 0;
#endif
}

void* counted(void* block) {
  if (!block) throw std::bad_alloc();
  ++use.allocations;
  use.live += size_of_block(block);
  if (use.live > use.peak) use.peak = use.live;
  return block;
}

void give_back(void* block) {
  if (block) use.live -= size_of_block(block);
  std::free(block);
}

}  // namespace

// The other forms of new and delete end up in these.
void* operator new(std::size_t size) { return counted(std::malloc(size == 0 ? 1 : size)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto a = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(a, (size + a - 1) / a * a));
}
void operator delete(void* block) noexcept { give_back(block); }
void operator delete(void* block, std::size_t) noexcept { give_back(block); }
void operator delete(void* block, std::align_val_t) noexcept { give_back(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { give_back(block); }

namespace taut::bench {

HeapUse heap_use() { return use; }
void reset_heap_peak() { use.peak = use.live; }

}  // namespace taut::bench
