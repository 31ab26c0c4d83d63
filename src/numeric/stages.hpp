// The stages by which a sign, a root or an order of roots is told, and how often each did: the table under "Numbers and
// stages" in ARCHITECTURE.md, row by row.
//
// Where no stage beyond doubles was needed, the displacement decided nothing: both readings of touching have the same
// answer.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "numeric/real.hpp"

namespace taut {

enum class Stage : std::uint8_t {
  doubles,      ///< with a bound of the error
  first_order,  ///< doubles, on the part that is linear in the displacement
  exact,        ///< sums of doubles
  fixed,        ///< numbers of a fixed length, whose point is fixed
  precise,      ///< balls of the first of the Precisions; the others follow
};
constexpr Stage stage_of_precision(int precision) {
  return static_cast<Stage>(static_cast<int>(Stage::precise) + precision);
}

inline constexpr int stage_count = static_cast<int>(Stage::precise) + precise_stages;

struct StagedSign {
  int sign = 0;
  Stage stage = Stage::doubles;
};

class StageCounts {
 public:
  void add(Stage stage) { ++counts_[static_cast<std::size_t>(stage)]; }
  std::uint64_t operator[](Stage stage) const { return counts_[static_cast<std::size_t>(stage)]; }
  std::uint64_t& operator[](Stage stage) { return counts_[static_cast<std::size_t>(stage)]; }
  std::uint64_t beyond_doubles() const { return std::accumulate(counts_.begin() + 1, counts_.end(), std::uint64_t{0}); }
  StageCounts& operator+=(const StageCounts& o) {
    for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += o.counts_[i];
    return *this;
  }

 private:
  std::array<std::uint64_t, stage_count> counts_{};
};

}  // namespace taut
