// Crossings near a singular end of a segment, where windows of time are short.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>

#include "spacetime/crossing.hpp"

namespace taut::internal::spacetime {

/// Where a motion begins or ends with infinite speed, windows of time become shorter and shorter towards that instant,
/// several for each factor of two. If doubles do not decide in one window, they do not decide in the next one. A search
/// at high precision from the instant itself takes about as long for all of that time as for a single window. So each
/// pair is searched once over the whole remaining neighbourhood of the end, and the result is kept for the following
/// windows.
class CrossingsNearEnd {
 public:
  CrossingsNearEnd(const MotionSegment& segment, CrossingDirections directions, PreciseCrossings& precise)
      : segment_(segment), directions_(directions), precise_(precise) {}

  bool is_near(double t) const;
  /// Has the pair been searched from there, or from before?
  bool covers(const VertexEdge& pair, double t) const {
    const auto known = known_.find(pair.number());
    return known != known_.end() && !known->second.hopeless && known->second.covers(t);
  }
  /// The pair's first crossing in (from, to]. Throws Undecidable.
  std::optional<Crossing> first(const VertexEdge& pair, double from, double to);

 private:
  /// The result for a pair from an instant on, up to the end of the neighbourhood.
  struct Foreseen {
    double from = 0, to = 0;
    std::optional<Crossing> crossing;  ///< the first one
    bool hopeless = false;             ///< a later event, which may not matter, cannot be decided
    bool covers(double t) const { return from <= t && t < to && !(crossing && crossing->hi <= t); }
  };

  /// Null if the search is hopeless.
  const Foreseen* foreseen(const VertexEdge& pair, double from, double until);
  /// If all crossings are searched for, each belongs to one of the stretches that divide time. A first contact that may
  /// lie in this stretch or in the next one is reported in both.
  bool within(const Crossing& c, double to) const {
    return directions_ == CrossingDirections::both ? c.hi <= to : c.lo <= to;
  }

  const MotionSegment& segment_;
  CrossingDirections directions_;
  PreciseCrossings& precise_;
  std::unordered_map<std::uint64_t, Foreseen> known_;
};

}  // namespace taut::internal::spacetime
