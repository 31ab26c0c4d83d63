#include "spacetime/settle_nearest.hpp"

#include <cmath>

#include "base/interruption.hpp"
#include "spacetime/margin.hpp"

namespace taut::spacetime {
namespace {

/// From zero, so many halvings pass all margins that differ in the scale of the scene.
constexpr int most_halvings = 120;

/// The features that come as close as the margin are the nearest found so far.
void take_approach(const PairGeometry& geometry, const MarginResult& found, double margin, Nearest& best) {
  const bool first = geometry.in_p(found.pair.vertex);
  best.distance = margin;
  best.leg = found.leg;
  best.parameter = found.hi;
  best.edge_p = first ? found.pair.vertex : found.pair.peer;
  best.edge_q = first ? found.pair.peer : found.pair.vertex;
}

}  // namespace

std::string settle_nearest(const PairGeometry& geometry, const TreePair& trees, const Legs& legs,
                           const TimeInterval& window, const ClearanceTolerance& tolerance, Nearest& best) {
  double certain = best.unresolved;
  // Most often doubles have found the least distance, and only the bound from below is missing.
  double margin = tolerance.least(best.distance);
  for (int step = 0; certain < tolerance.least(best.distance); ++step) {
    interruption_point();
    if (!(margin > certain && margin < best.distance) || step == most_halvings)
      return "doubles do not tell the distance better";
    const MarginResult found = first_closer(geometry, trees, legs, margin, window);
    if (found.outcome == MarginResult::undecided) return found.reason;
    if (found.outcome == MarginResult::free) {
      best.unresolved = certain = margin;
    } else {
      take_approach(geometry, found, margin, best);
    }
    margin = std::fmin(tolerance.least(best.distance), certain + (best.distance - certain) / 2);
  }
  best.unresolved = INFINITY;
  return {};
}

}  // namespace taut::spacetime
