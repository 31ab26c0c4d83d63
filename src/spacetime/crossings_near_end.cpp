#include "spacetime/crossings_near_end.hpp"

#include <algorithm>

#include "certificate/search_from_end.hpp"
#include "numeric/undecided.hpp"

namespace taut::internal::spacetime {

bool CrossingsNearEnd::is_near(double t) const { return end_of_neighbourhood(segment_, t) > t; }

const CrossingsNearEnd::Foreseen* CrossingsNearEnd::foreseen(const VertexEdge& pair, double from, double until) {
  Foreseen& known = known_[pair.number()];
  if (!known.hopeless && !known.covers(from)) {
    try {
      known.crossing = precise_.first(pair, from, until);
      // The crossing is not later, although its enclosure may be rounded beyond the end.
      if (known.crossing) known.crossing->hi = std::min(known.crossing->hi, until);
      known.from = from;
      known.to = until;
    } catch (const Undecidable&) {
      known.hopeless = true;
    }
  }
  return known.hopeless ? nullptr : &known;
}

std::optional<Crossing> CrossingsNearEnd::first(const VertexEdge& pair, double from, double to) {
  const double until = end_of_neighbourhood(segment_, from);
  const Foreseen* known = until > from ? foreseen(pair, from, until) : nullptr;
  if (!known) return precise_.first(pair, from, to);
  if (known->crossing && within(*known->crossing, to)) return known->crossing;
  if (to <= until) return std::nullopt;
  return precise_.first(pair, until, to);
}

}  // namespace taut::internal::spacetime
