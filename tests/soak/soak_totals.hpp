// What a soak has seen, by family and by injection, over as many runs as it takes.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "kinetic/failure_solver.hpp"

namespace taut::testing {
using namespace internal;

struct Tally {
  std::uint64_t scenes = 0, free = 0, contact = 0, at_start = 0, invalid = 0, events = 0, proofs = 0;
  /// By the oracle by definition: answers compared, some of them on an assumption, and scenes beyond it.
  std::uint64_t judged = 0, assumed = 0, beyond = 0;
  /// Of worlds: those with ten bodies or more, and what was asked and compared, of which some only of a share of
  /// worlds.
  std::uint64_t large = 0, unproved = 0, simulated = 0, intervals = 0, ranges = 0, clearances = 0, profiles = 0,
                laws = 0, maps = 0;
  /// Of curves: damaged logs that were refused, and those that proved what is so all the same.
  std::uint64_t refused = 0, still_true = 0;

  Tally& operator+=(const Tally& o);
};

struct SoakTotals {
  std::uint64_t next_scene = 0;
  std::map<std::string, Tally> by_family, by_injection;
  StageCounts stages;
  std::vector<std::string> findings;

  SoakTotals& operator+=(const SoakTotals& o);
  Tally all() const;
  /// Tables and totals; columns about worlds and curves only if there are any, as docs/evidence.md has them.
  std::string report() const;
};

/// Totals of earlier runs; none if there is no such file.
SoakTotals read_soak_totals(const std::string& file);
void write_soak_totals(const std::string& file, const SoakTotals& totals);

}  // namespace taut::testing
