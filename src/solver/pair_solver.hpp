// The first contact of one pair, searched window by window.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "certificate/feature_map.hpp"
#include "certificate/instant.hpp"
#include "scene/instance.hpp"
#include "spacetime/first_contact.hpp"

namespace taut::internal {

// A pair of a world, with the data that the spacetime engine needs.

using SharedSegments = std::shared_ptr<const MotionSegments>;

/// Built once, and kept with the body.
const spacetime::Hierarchy& tree_of(const RingSet& rings, Offset offset);

struct PairInstance {
  /// Throws InputError if a body has features that are finer than the displacement.
  PairInstance(BodyPair pair, SharedSegments all_segments, Offset offset);
  PairInstance(const Instance& world, int first, int second, Offset offset);

  spacetime::TreePair trees() const { return {tree_p, tree_q}; }
  const MotionSegments& segments() const { return *shared_segments; }

  int a, b;  ///< a < b: the bodies' numbers, of the world if there is one
  BodyPair bodies;
  PairGeometry geometry;
  SharedSegments shared_segments;
  const spacetime::Hierarchy &tree_p, &tree_q;
};

/// The work of the kinetic engine.
struct KineticCounts {
  std::uint64_t events = 0, certificates_initial = 0, certificates_max = 0;

  KineticCounts& operator+=(const KineticCounts& o) {
    events += o.events;
    certificates_initial += o.certificates_initial;
    certificates_max += o.certificates_max;
    return *this;
  }
};

/// The known result of one pair.
struct PairResult {
  int a = 0, b = 0;  ///< a < b
  Outcome outcome = Outcome::free;
  std::optional<Contact> contact;
  double free_until = 0;
  std::string reason;
  /// For a contact, in the terms of the pair's geometry: the contact found, and its segment; or how the shapes
  /// displaced outwards overlap at the start.
  std::optional<FoundContact> found;
  std::size_t segment = 0;
  std::optional<StartOverlap> touching;
  EngineName engine = EngineName::spacetime;  ///< the engine that gave the result
};

/// Solves a pair that boxes do not separate: at the start, then in windows of time, in order. A result found later that
/// concerns an earlier time replaces the known one.
class PairSolver {
 public:
  virtual ~PairSolver() = default;
  /// Determines whether the pair overlaps, or touches, at the start.
  virtual void ask_start() = 0;
  /// Determines whether there is a first contact within the window. The bodies are disjoint between the windows that
  /// are searched.
  void ask(double from, double to) { work(from, to, UINT64_MAX); }
  /// Like ask(), for about this much work, in units of checkpoint(). Returns true once the window is decided. Otherwise
  /// nothing is recorded, and it can be called again for the same window.
  virtual bool work(double from, double to, std::uint64_t effort) = 0;
  virtual const PairResult& result() const = 0;
  /// For a contact found in motion, the instant as a root.
  virtual std::optional<ContactInstant> instant() const = 0;
  virtual StageCounts stages() const = 0;
  /// The result of another engine, if two are compared.
  virtual const PairResult* other() const { return nullptr; }
  /// The counts of the kinetic engine.
  virtual KineticCounts counts() const { return {}; }
  /// Has nothing been found yet?
  bool open() const { return result().outcome == Outcome::free; }
};

inline std::optional<ContactInstant> instant_of(const PairResult& result, const MotionSegments& segments,
                                                const PairGeometry& geometry) {
  if (!result.found) return std::nullopt;
  return ContactInstant{segments.hold(result.segment), &geometry, *result.found};
}

/// The results of pairs stored by name.
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

/// Solves a pair by the spacetime engine.
class SpacetimeSolver final : public PairSolver {
 public:
  /// Searches [start, end] of the world's time.
  SpacetimeSolver(PairInstance search, Offset offset, double start, double end);

  void ask_start() override;
  bool work(double from, double to, std::uint64_t effort) override;
  const PairResult& result() const override { return result_; }
  std::optional<ContactInstant> instant() const override {
    return instant_of(result_, search_.segments(), search_.geometry);
  }
  StageCounts stages() const override { return stages_; }

 private:
  void resolve_start();
  spacetime::ContactSearch search(double from, double to) const;
  void note(const spacetime::SpacetimeResult& found);
  bool decided_before(double t) const { return !open() && result_.free_until <= t; }

  PairInstance search_;
  Offset offset_;
  double start_, end_;
  std::optional<spacetime::ContactSearch> left_;  ///< the search of a window that has not ended
  double window_ = 0;                             ///< the beginning of that window
  PairResult result_;
  StageCounts stages_;
};

/// Records the state at the start of a pair whose displaced shapes overlap there: see contact_at_start().
void take_start(const std::optional<StartContact>& touching, double start, PairResult& result);

/// The result for a contact that an engine has found on that segment, based on the previous result.
PairResult contact_of(const PairResult& known, const FeatureMap& witness, const MotionSegment& segment,
                      std::size_t segment_index, const FoundContact& found, double start);

}  // namespace taut::internal
