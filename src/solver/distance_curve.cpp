#include "solver/distance_curve.hpp"

#include <algorithm>

#include "numeric/budget.hpp"
#include "spacetime/clearance.hpp"

namespace taut::internal {

bool DistanceFunction::may_touch(double from, double to) const {
  const auto touches = [&](const OverlapInterval& o) { return o.from.lo <= to && from <= o.to.hi; };
  return std::any_of(pairs_.begin(), pairs_.end(), [&](const PairDistance* p) {
    return std::any_of(p->touching.begin(), p->touching.end(), touches);
  });
}

bool DistanceFunction::overlap_throughout(double from, double to) const {
  const auto overlap = [&](const OverlapInterval& o) { return o.from.hi <= from && to <= o.to.lo; };
  return std::any_of(pairs_.begin(), pairs_.end(), [&](const PairDistance* p) {
    return std::any_of(p->touching.begin(), p->touching.end(), overlap);
  });
}

std::size_t DistanceFunction::search(double from, double to, spacetime::Nearest& best) const {
  best.distance = INFINITY;
  std::size_t which = 0;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    checkpoint();
    const PairInstance& s = pairs_[i]->search;
    const double before = best.distance;
    spacetime::find_nearest_within(s.geometry, s.trees(), s.segments(), from, to, tolerance_, best);
    if (best.distance < before) which = i;
  }
  return which;
}

/// Where doubles leave a gap below the least distance, as where a body rotates with infinite speed, queries about
/// margins close it.
void DistanceFunction::resolve(double from, double to, spacetime::Nearest& best) const {
  double unresolved = INFINITY;
  for (const PairDistance* pair : pairs_) {
    if (!(best.unresolved < tolerance_.least(best.distance))) return;
    const PairInstance& s = pair->search;
    spacetime::Nearest own = best;
    spacetime::resolve_nearest(s.geometry, s.trees(), s.segments(), {from, to}, tolerance_, own);
    unresolved = std::min(unresolved, own.unresolved);
    best.distance = std::min(best.distance, own.distance);
  }
  best.unresolved = unresolved;
}

double DistanceFunction::lower_end(const spacetime::Nearest& best) const {
  const double least = std::min(tolerance_.least(best.distance), best.unresolved);
  return std::max(0.0, std::ldexp(least, -exponent_) * (1 - 0x1p-50));
}

DistanceAt DistanceFunction::at(double t) const {
  if (overlap_throughout(t, t)) return {t, 0, 0};
  spacetime::Nearest best;
  search(t, t, best);
  const bool touches = may_touch(t, t);
  if (!touches) resolve(t, t, best);
  return {t, touches ? 0 : lower_end(best), std::ldexp(best.distance, -exponent_)};
}

double DistanceFunction::least(double from, double to) const {
  if (may_touch(from, to)) return 0;
  spacetime::Nearest best;
  search(from, to, best);
  resolve(from, to, best);
  return lower_end(best);
}

double DistanceFunction::most(double from, double to) const {
  if (overlap_throughout(from, to)) return 0;
  spacetime::Nearest best;
  const double middle = from + (to - from) / 2;
  const PairInstance& s = pairs_[search(middle, middle, best)]->search;
  return std::ldexp(spacetime::distance_bound(s.geometry, s.trees(), s.segments(), from, to, tolerance_), -exponent_);
}

}  // namespace taut::internal
