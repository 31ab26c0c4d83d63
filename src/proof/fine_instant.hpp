// Instants of a segment that lie between two doubles.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "certificate/instant.hpp"
#include "numeric/exact_sum.hpp"

namespace taut::internal::proof {

/// The exact sum of these three, where a single double may be too coarse: displaced bodies can come to each other, or
/// closer than a clearance, for a time that has no double in it.
using FineInstant = std::array<double, 3>;

/// The first number is at least as large as the others, and all of it lies in [start, end].
inline bool is_within(const FineInstant& at, double start, double end) {
  const double rest = std::fabs(at[1]) + std::fabs(at[2]);
  if (!std::isfinite(at[0]) || !(rest <= 0x1p-40 * (std::fabs(at[0]) + 1))) return false;
  ExactSum<4> after, before;
  for (const double x : at) {
    after.add(x);
    before.add(x);
  }
  after.add(-start);
  before.add(-end);
  return after.sign() >= 0 && before.sign() <= 0;
}

inline Instant instant_at(const FineInstant& at) {
  ExactSum<3> sum;
  for (const double x : at) sum.add(x);
  const ShortSum exactly = ShortSum::of(sum);
  return Instant::exactly(PreciseTime(exactly, exactly, Stage::doubles));
}

/// A double that is not before it.
inline double rounded_up(const FineInstant& at) {
  return at[1] == 0 && at[2] == 0 ? at[0] : at[0] + 2 * (std::fabs(at[1]) + std::fabs(at[2])) + 0x1p-1060;
}

/// About as near to a number as three doubles come.
inline FineInstant nearest_instant(RealMax rest) {
  FineInstant at{};
  for (double& part : at) {
    part = static_cast<double>(rest);
    rest -= part;
  }
  return at;
}

}  // namespace taut::internal::proof
