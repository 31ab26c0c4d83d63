// The stages that decide a sign, a root or an order of roots, and counts of their decisions: the table in
// docs/internals/numerics.md, row by row.
//
// If no stage beyond doubles was needed, the displacement decided nothing: both readings of touching have the same
// answer.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <tuple>

#include "numeric/errors.hpp"
#include "numeric/real.hpp"
#include "numeric/root_isolation.hpp"

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

// Evaluation at one precision after the other, until one decides.
//
// Cases that doubles leave open are evaluated at 320 bits first, because that nearly always decides and costs least.
// The result is "undecided" if the last precision does not decide. This loop exists only here.

/// Calls ask(stage) from a stage on, usually the first at high precision, until the answer is not empty, or not zero.
/// Otherwise returns that empty answer.
template <class Ask>
auto first_decisive(const Ask& ask, Stage first = Stage::precise) -> decltype(ask(Stage::precise)) {
  for (Stage stage = first; stage <= last_stage; stage = next_precise(stage)) {
    if (auto answer = ask(stage)) return answer;
  }
  return {};
}

/// Like first_decisive(), where a decision is required; `what` is the question for the user.
template <class Ask>
auto decide(const char* what, const Ask& ask) -> decltype(ask(Stage::precise)) {
  auto answer = first_decisive(ask);
  if (!answer) throw Undecidable{what};
  return answer;
}

/// The sign of a ball given as a function of a number of its type; 0 if no stage decides.
template <class Quantity>
int decided_sign(const Quantity& quantity) {
  return first_decisive(
      [&](Stage stage) { return with_stage(stage, [&](auto zero) { return quantity(zero).sign(); }); });
}

/// Calls `ask(zero, stage)`, where a stage that cannot decide throws PrecisionExhausted; nothing if none can.
template <class Ask>
auto at_some_stage(const Ask& ask, Stage first = Stage::precise)
    -> std::optional<decltype(ask(Real320{}, Stage::precise))> {
  for (Stage stage = std::max(first, Stage::precise); stage <= last_stage; stage = next_precise(stage)) {
    try {
      return with_stage(stage, [&](auto zero) { return ask(zero, stage); });
    } catch (const PrecisionExhausted&) {
    }
  }
  return std::nullopt;
}

}  // namespace taut::internal
