#include "curve_proofs.hpp"

#include <fmt/format.h>

#include <sstream>

#include "proof/curve_log.hpp"
#include "support/rng.hpp"
#include "taut/error.hpp"
#include "taut/proof.hpp"

namespace taut::testing {
using namespace internal;
namespace {

constexpr int damages = 12;

Verified verified(const Scene& scene, const std::string& log) {
  std::istringstream in(log);
  return verify(scene, in);
}

/// What is not so of it, by the chords.
std::string untruth(const Verified& v, const Scene& scene, const ChordBracket& chords) {
  if (v.free_until > chords.latest)
    return fmt::format("free until {}, but by chords not from {} on", v.free_until, chords.latest);
  if (v.outcome == Outcome::free && v.free_until != scene.end) return "free, but not to the end";
  if (v.outcome == Outcome::contact && v.contact->time.hi < chords.earliest)
    return fmt::format("a contact by {}, but by chords not before {}", v.contact->time.hi, chords.earliest);
  return {};
}

std::string damages_are_harmless(const Scene& scene, const std::string& log, const ChordBracket& chords, Touch touch,
                                 Rng& rng, Tally& tally) {
  const CurveLog parts = curve_log_of(scene, log);
  for (int k = 0; k < damages; ++k) {
    const std::string other = damaged(parts, scene, touch, [&](int n) { return rng.below(n); });
    if (other == log) continue;
    try {
      const std::string wrong = untruth(verified(scene, other), scene, chords);
      if (!wrong.empty()) return fmt::format("damage {} proves what is not so: {}", k, wrong);
      ++tally.still_true;
    } catch (const ProofError&) {
      ++tally.refused;
    }
  }
  return {};
}

}  // namespace

std::string examine_curve_proof(const Scene& scene, const Answer& answer, const ChordBracket& chords,
                                const CheckOptions& options, std::uint64_t number, Tally& tally) {
  Rng rng(number);
  std::ostringstream out;
  const Answer proved = prove(scene, out, options);
  if (proved.outcome != answer.outcome) {
    if (proved.outcome != Outcome::undecided) return fmt::format("prove() says {}", to_string(proved.outcome));
    ++tally.unproved;
  }
  const std::string log = out.str();
  if (log.empty()) {
    const bool nothing = proved.free_until <= scene.start || proved.outcome == Outcome::undecided;
    return nothing || proved.outcome == Outcome::overlap_at_start ? "" : "no log";
  }
  try {
    const Verified v = verified(scene, log);
    if (v.outcome != proved.outcome)
      return fmt::format("a log of {}, which proves {}", to_string(proved.outcome), to_string(v.outcome));
    if (const std::string wrong = untruth(v, scene, chords); !wrong.empty()) return "a log proves: " + wrong;
  } catch (const ProofError& error) {
    return fmt::format("the log is refused: {}", error.what());
  }
  ++tally.proofs;
  return damages_are_harmless(scene, log, chords, options.touch, rng, tally);
}

}  // namespace taut::testing
