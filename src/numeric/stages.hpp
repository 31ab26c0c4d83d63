// The stages that decide a sign, a root or an order of roots, and counts of their decisions: the table in
// docs/internals/numerics.md, row by row.
//
// If no stage beyond doubles was needed, the displacement decided nothing: both readings of touching have the same
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
  doubles,      ///< with an error bound
  first_order,  ///< doubles that include the displacement, or on the part that is linear in it
  exact,        ///< sums of doubles
  relative,     ///< doubles, from the root of a nearly proportional certificate function
  fixed,        ///< fixed-point numbers
  precise,      ///< balls of the first of the Precisions; the others follow
};
constexpr Stage stage_of_precision(int precision) {
  return static_cast<Stage>(static_cast<int>(Stage::precise) + precision);
}

inline constexpr int stage_count = static_cast<int>(Stage::precise) + precise_stages;
inline constexpr Stage last_stage = stage_of_precision(precise_stages - 1);
/// The next stage at high precision; there is none beyond the last one.
constexpr Stage next_precise(Stage stage) {
  return stage < Stage::precise ? Stage::precise : static_cast<Stage>(static_cast<int>(stage) + 1);
}
/// The next stage for instants and their order, which may be known relative to another instant.
constexpr Stage next_closer(Stage stage) { return stage < Stage::relative ? Stage::relative : next_precise(stage); }

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
