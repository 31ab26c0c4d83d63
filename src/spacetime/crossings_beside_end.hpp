// Crossings beside a singular end of a segment, where windows of time are short.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>

#include "spacetime/crossing.hpp"

namespace taut::internal::spacetime {

/// Where a motion begins or ends with infinite speed, windows of time become shorter and shorter towards that instant,
/// several for each factor of two, and what doubles do not tell in one they do not tell in the next one. A search at
/// high precision that is made from the instant itself takes about as long for all of that time as for a single window.
/// So each pair is asked once about all that is left beside the end, and what was found is kept for the windows to
/// come.
class CrossingsBesideEnd {
 public:
  CrossingsBesideEnd(const MotionSegment& segment, Ways ways, PreciseCrossings& precise)
      : segment_(segment), ways_(ways), precise_(precise) {}

  bool is_near(double t) const;
  /// Has the pair been asked about from there, or before?
  bool tells(const VertexEdge& pair, double t) const {
    const auto known = known_.find(pair.number());
    return known != known_.end() && !known->second.hopeless && known->second.tells(t);
  }
  /// The pair's first crossing in (from, to]. Throws Undecidable.
  std::optional<Crossing> first(const VertexEdge& pair, double from, double to);

 private:
  /// What is known of a pair from an instant on, up to where the neighbourhood of the end ends.
  struct Foreseen {
    double from = 0, to = 0;
    std::optional<Crossing> crossing;  ///< the first one
    bool hopeless = false;             ///< something later cannot be decided, which may not matter
    bool tells(double t) const { return from <= t && t < to && !(crossing && crossing->hi <= t); }
  };

  /// Nothing if it is hopeless.
  const Foreseen* foreseen(const VertexEdge& pair, double from, double until);
  /// Each crossing belongs to one stretch of those that divide time, if all are looked for. A first contact that may
  /// lie in this stretch or in the next one is told of in both.
  bool within(const Crossing& c, double to) const { return ways_ == Ways::both ? c.hi <= to : c.lo <= to; }

  const MotionSegment& segment_;
  Ways ways_;
  PreciseCrossings& precise_;
  std::unordered_map<std::uint64_t, Foreseen> known_;
};

}  // namespace taut::internal::spacetime
