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
#include <tuple>

#include "numeric/real.hpp"

namespace taut::internal {

enum class Stage : std::uint8_t {
  doubles,      ///< with a bound of the error
  first_order,  ///< doubles with the displacement in them, or on the part that is linear in it
  exact,        ///< sums of doubles
  beside,       ///< doubles, from the root of a form that is nearly the same
  fixed,        ///< numbers of a fixed length, whose point is fixed
  precise,      ///< balls of the first of the Precisions; the others follow
};
constexpr Stage stage_of_precision(int precision) {
  return static_cast<Stage>(static_cast<int>(Stage::precise) + precision);
}

inline constexpr int stage_count = static_cast<int>(Stage::precise) + precise_stages;
inline constexpr Stage last_stage = stage_of_precision(precise_stages - 1);
/// The next one at high precision; beyond the last one there is none.
constexpr Stage next_precise(Stage stage) {
  return stage < Stage::precise ? Stage::precise : static_cast<Stage>(static_cast<int>(stage) + 1);
}
/// The same for instants and their order, of which much may be known beside another one.
constexpr Stage next_closer(Stage stage) { return stage < Stage::beside ? Stage::beside : next_precise(stage); }

/// Runs the generic lambda with a value of the number type of a stage at high precision.
template <int Precision = 0, class Action>
auto with_stage(Stage stage, const Action& action) {
  if constexpr (Precision + 1 < precise_stages) {
    if (stage > stage_of_precision(Precision)) return with_stage<Precision + 1>(stage, action);
  }
  return action(std::tuple_element_t<Precision, Precisions>());
}

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

}  // namespace taut::internal
