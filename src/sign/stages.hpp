// The stages of the arithmetic, and how often each answered: see "Numbers and stages" in ARCHITECTURE.md.
#pragma once

#include <cstdint>

namespace taut {

struct StageCounts {
  std::uint64_t fast = 0;      ///< doubles with an error bound
  std::uint64_t level1 = 0;    ///< doubles, on the part that is linear in the displacement
  std::uint64_t precise = 0;   ///< multi-precision failure times
  std::uint64_t compared = 0;  ///< multi-precision comparisons of two failure times

  StageCounts& operator+=(const StageCounts& o) {
    fast += o.fast;
    level1 += o.level1;
    precise += o.precise;
    compared += o.compared;
    return *this;
  }
};

}  // namespace taut
