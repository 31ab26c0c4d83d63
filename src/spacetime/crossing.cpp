#include "spacetime/crossing.hpp"

#include <algorithm>
#include <cmath>

#include "certificate/search_from_end.hpp"
#include "numeric/errors.hpp"
#include "numeric/stages.hpp"
#include "scene/placement.hpp"

namespace taut::internal::spacetime {
namespace {

int sign_at(const PreciseTriple& f, const PreciseTime& t) {
  return decide("whether a vertex crosses an edge", [&](Stage stage) { return f.sign_at(t, stage); });
}

void store(const PreciseTime& t, Crossing& c) {
  c.precise = t;
  c.lo = t.floor();
  c.hi = t.ceiling();
}

}  // namespace

int PreciseCrossings::side(const VertexEdge& pair, double t) {
  return sign_at(triple(pair.line(geometry_)), PreciseTime::between(t, t));
}

/// Goes from root to root of the line's function until one is a contact.
std::optional<Crossing> PreciseCrossings::first(const VertexEdge& pair, double from, double to) {
  const PreciseTriple line = triple(pair.line(geometry_));
  PreciseTime at = PreciseTime::between(from, from);
  for (int sign = sign_at(line, at);; sign = -sign) {
    const std::optional<PreciseTime> root = line.first_failure(sign, at, to);
    if (!root) return std::nullopt;
    Crossing c;
    c.pair = pair;
    c.out = sign > 0;
    store(*root, c);
    // If outward crossings are not searched for, it does not matter whether one of them is on the edge.
    if ((sign < 0 || directions_ == CrossingDirections::both) && on_edge(c, sign) == OnEdge::yes) return c;
    at = *c.precise;
  }
}

/// A crossing that a stage cannot improve stays as it is.
void PreciseCrossings::refine(Crossing& c, int sign, Stage stage) {
  PreciseTime t = c.precise.value_or(PreciseTime::between(c.lo, c.hi));
  if (t.stage >= stage) return;
  if (!triple(c.pair.line(geometry_)).refine(sign, t, stage)) t.stage = stage;
  store(t, c);
}

OnEdge PreciseCrossings::on_edge(Crossing& root, int sign) {
  const PreciseTriple from_start = triple(root.pair.from_start(geometry_));
  const PreciseTriple from_end = triple(root.pair.from_end(geometry_));
  const auto ask = [&](Stage stage) -> std::optional<OnEdge> {
    refine(root, sign, stage);
    const int a = from_start.sign_at(*root.precise, stage), b = from_end.sign_at(*root.precise, stage);
    if (a < 0 || b < 0) return OnEdge::no;
    if (a > 0 && b > 0) return OnEdge::yes;
    return std::nullopt;
  };
  return *decide("whether a vertex meets an edge or passes its end", ask);
}

bool PreciseCrossings::before(Crossing& a, Crossing& b) {
  if (a.hi < b.lo) return true;
  if (b.hi < a.lo) return false;
  const auto order = [&](Stage stage) {
    refine(a, -1, stage);
    refine(b, -1, stage);
    return a.precise->is_first(*b.precise);
  };
  return *decide("the order of two contacts", order);
}

void PreciseCrossings::tighten(Crossing& c) {
  if (c.hi - c.lo > 0x1p-51 * std::fabs(c.hi)) refine(c, c.out ? 1 : -1, Stage::precise);
}

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
