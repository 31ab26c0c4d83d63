#include "spacetime/clearance.hpp"

#include <cmath>

#include "numeric/budget.hpp"
#include "spacetime/margin.hpp"
#include "spacetime/stretch.hpp"

namespace taut::internal::spacetime {
namespace {

/// From zero, this many halvings pass all margins that differ in the scale of the scene.
constexpr int most_halvings = 120;

/// Stores the features that come as close as the margin as the nearest found so far.
void take_approach(const PairGeometry& geometry, const MarginResult& found, double margin, Nearest& best) {
  const bool first = geometry.in_p(found.pair.vertex);
  best.distance = margin;
  best.segment = found.segment;
  best.parameter = found.hi;
  best.edge_p = first ? found.pair.vertex : found.pair.peer;
  best.edge_q = first ? found.pair.peer : found.pair.vertex;
}

/// Lowers the least distance to its value at some instants. Each evaluation costs far less than a query about a margin.
/// Such a query shows only that a margin is not kept, and each such answer halves the gap.
class Evaluations {
 public:
  Evaluations(const PairGeometry& geometry, const TreePair& trees, const MotionSegments& segments,
              const TimeInterval& window, const ClearanceTolerance& tolerance, Nearest& best)
      : geometry_(geometry), trees_(trees), segments_(segments), window_(window), tolerance_(tolerance), best_(best) {}

  /// Evaluates where bodies rotate with infinite speed. The features that are nearest there need not be nearest a
  /// rounding error away.
  void at_singular_ends() {
    for (std::size_t i = segments_.first_until(window_.lo); i < segments_.size(); ++i) {
      const SegmentPlace place = segments_.place(i);
      if (place.start > window_.hi) break;
      if (place.bridge) continue;
      const std::shared_ptr<const MotionSegment> segment = segments_.hold(i);
      for (const double t : {segment->start, segment->end}) {
        if (segment->singular_at(t)) at(*segment, i, t);
      }
    }
  }
  /// Evaluates where they come closer than a margin, and then at instants farther and farther from there.
  void after(const MarginResult& found) {
    const SegmentPlace place = segments_.place(found.segment);
    if (place.bridge) return;
    const std::shared_ptr<const MotionSegment> segment = segments_.hold(found.segment);
    const double time_ahead = std::fmin(place.end, window_.hi) - found.hi;
    for (double share = 1; time_ahead > 0 && share > 0x1p-40; share /= 4)
      at(*segment, found.segment, found.hi + time_ahead * share);
  }

 private:
  void at(const MotionSegment& segment, std::size_t index, double t) {
    if (!(t >= std::fmax(segment.start, window_.lo) && t <= std::fmin(segment.end, window_.hi))) return;
    checkpoint();
    Nearest there = best_;
    find_nearest_in_middle(geometry_, trees_, segment, Stretch::at_instant(segment, t), tolerance_, there);
    if (!(there.distance < best_.distance)) return;
    there.segment = index;
    there.unresolved = best_.unresolved;  // which refers to the whole window
    best_ = there;
  }

  const PairGeometry& geometry_;
  const TreePair& trees_;
  const MotionSegments& segments_;
  TimeInterval window_;
  ClearanceTolerance tolerance_;
  Nearest& best_;
};

}  // namespace

std::string resolve_nearest(const PairGeometry& geometry, const TreePair& trees, const MotionSegments& segments,
                            const TimeInterval& window, const ClearanceTolerance& tolerance, Nearest& best) {
  double certain = best.unresolved;
  Evaluations evaluations(geometry, trees, segments, window, tolerance, best);
  if (certain < tolerance.least(best.distance)) evaluations.at_singular_ends();
  // Most often doubles have found the least distance, or nearly so, and only the lower bound is missing. So the bound
  // is searched for at growing distances below the value found, not halfway down to zero.
  double margin = tolerance.least(best.distance), below = best.distance - margin;
  for (int step = 0; certain < tolerance.least(best.distance); ++step) {
    checkpoint();
    if (!(margin > certain && margin < best.distance) || step == most_halvings)
      return "doubles do not resolve the distance further";
    const MarginResult found = first_closer(geometry, trees, segments, constant_margin(margin), window);
    if (found.outcome == MarginResult::undecided) return found.reason;
    if (found.outcome == MarginResult::free) {
      best.unresolved = certain = margin;
    } else {
      take_approach(geometry, found, margin, best);
      evaluations.after(found);
      below *= 8;
    }
    const double halfway = certain + (best.distance - certain) / 2;
    margin = std::fmin(tolerance.least(best.distance), std::fmax(halfway, best.distance - below));
  }
  best.unresolved = INFINITY;
  return {};
}

}  // namespace taut::internal::spacetime
