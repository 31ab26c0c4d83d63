// The first contact of one pair, asked window by window.
#pragma once

#include <optional>
#include <string>

#include "search/pair_instance.hpp"
#include "sign/contact_at_start.hpp"
#include "sign/instant_order.hpp"

namespace taut::internal {

/// How much the kinetic engine had to do.
struct KineticCounts {
  std::uint64_t events = 0, certificates_initial = 0, certificates_max = 0;

  KineticCounts& operator+=(const KineticCounts& o) {
    events += o.events;
    certificates_initial += o.certificates_initial;
    certificates_max += o.certificates_max;
    return *this;
  }
};

/// What is known of one pair.
struct PairResult {
  int a = 0, b = 0;  ///< a < b
  Outcome outcome = Outcome::free;
  std::optional<Contact> contact;
  double free_until = 0;
  std::string reason;
  /// Of a contact, in the terms of the pair's geometry: what was found, and on which segment; or how the shapes
  /// displaced outwards overlap at the start.
  std::optional<FoundContact> found;
  std::size_t segment = 0;
  std::optional<StartOverlap> touching;
  EngineName engine = EngineName::spacetime;  ///< whose result it is
};

/// A pair that boxes do not tell apart: at the start, then in windows of time, in their order. What is found later and
/// happens before what was known takes its place.
class PairSolver {
 public:
  virtual ~PairSolver() = default;
  /// Does it overlap, or touch, at the start?
  virtual void ask_start() = 0;
  /// Is there a first contact within the window? Nothing happens between the windows that are asked about.
  virtual void ask(double from, double to) = 0;
  virtual const PairResult& result() const = 0;
  /// Of a contact that was found in motion, what it is the root of.
  virtual std::optional<ContactInstant> instant() const = 0;
  virtual StageCounts stages() const = 0;
  /// What another engine says, where two are compared.
  virtual const PairResult* other() const { return nullptr; }
  /// Of the kinetic engine.
  virtual KineticCounts counts() const { return {}; }
  /// Nothing has been found yet.
  bool open() const { return result().outcome == Outcome::free; }
};

inline std::optional<ContactInstant> instant_of(const PairResult& result, const MotionSegments& segments,
                                                const PairGeometry& geometry) {
  if (!result.found) return std::nullopt;
  return ContactInstant{segments.hold(result.segment), &geometry, *result.found};
}

/// Of pairs that are kept by their names.
template <class Pairs>
std::vector<PairResult> results_of(const Pairs& pairs) {
  std::vector<PairResult> results;
  for (const auto& [name, pair] : pairs) results.push_back(pair->result());
  return results;
}
template <class Pairs>
StageCounts stages_of(const Pairs& pairs) {
  StageCounts sum;
  for (const auto& [name, pair] : pairs) sum += pair->stages();
  return sum;
}

/// The spacetime engine's.
class SpacetimeSolver final : public PairSolver {
 public:
  /// About [start, end] of the world's time.
  SpacetimeSolver(PairInstance search, bool inwards, double start, double end);

  void ask_start() override;
  void ask(double from, double to) override;
  /// The same, unless it takes more than that effort: then nothing is noted, and the result is false; the next one
  /// about the same window goes on.
  bool try_ask(double from, double to, std::uint64_t effort);
  const PairResult& result() const override { return result_; }
  std::optional<ContactInstant> instant() const override {
    return instant_of(result_, search_.segments(), search_.geometry);
  }
  StageCounts stages() const override { return stages_; }

 private:
  void resolve_start();
  spacetime::ContactSearch search(double from, double to) const;
  void note(const spacetime::SpacetimeResult& found);
  bool dormant_before(double t) const { return !open() && result_.free_until <= t; }

  PairInstance search_;
  bool inwards_;
  double start_, end_;
  std::optional<spacetime::ContactSearch> left_;  ///< in the middle of a window
  double window_ = 0;                             ///< which begins there
  PairResult result_;
  StageCounts stages_;
};

/// Takes in how a pair whose displaced shapes overlap at the start stands there: see contact_at_start().
void take_start(const std::optional<StartContact>& touching, double start, PairResult& result);

/// The result of a contact that an engine has found on that segment, of what was known before.
PairResult contact_of(const PairResult& known, const FeatureMap& witness, const MotionSegment& segment,
                      std::size_t segment_index, const FoundContact& found, double start);

}  // namespace taut::internal
