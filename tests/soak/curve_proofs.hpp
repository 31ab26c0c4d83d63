// A proof about one scene with curves of the soak, whole and damaged.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>

#include "soak_totals.hpp"
#include "taut/check.hpp"

namespace taut::testing {

/// What chords tell of a first contact: when the bodies certainly do not touch yet, and by when they certainly overlap.
struct ChordBracket {
  double earliest = INFINITY, latest = INFINITY;
};

/// What is wrong with the proof of what the scene comes to; empty if nothing is. The laws:
///   1. prove() answers as check() does, or says that it found no proof, and writes a log of it that verify() accepts;
///   2. what the log proves is what chords tell: it is not free beyond the one, and has no contact before the other;
///   3. a damaged log, with checksums that are right, is refused, or what it proves is what chords tell.
std::string examine_curve_proof(const Scene& scene, const Answer& answer, const ChordBracket& chords,
                                const CheckOptions& options, std::uint64_t number, Tally& tally);

}  // namespace taut::testing
