#include "spacetime/margin.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "numeric/errors.hpp"
#include "numeric/undecided.hpp"
#include "spacetime/walk.hpp"

namespace taut::internal::spacetime {
namespace {

/// Which features come as close as the margin first on one segment: what the walk asks.
class MarginOnSegment {
 public:
  MarginOnSegment(const PairGeometry& geometry, const TreePair& trees, const MotionSegment& segment,
                  const Margin& margin)
      : shortest(shortest_stretch * (segment.end - segment.start)),
        geometry_(geometry),
        approaches_(geometry, segment, margin),
        greatest_(approaches_.margin().over(segment.start, segment.end).most),
        walk_(trees, segment, *this),
        proved_(segment.start) {}

  /// On [from, to] of the segment's parameter.
  std::optional<Approach> run(double from, double to) {
    at_instant_ = true;
    walk_.at(from);
    at_instant_ = false;
    if (!best_) walk_.through(from, to);
    return best_;
  }
  /// Up to when they are certainly no closer.
  double proved() const { return proved_; }

  const double shortest;
  double distance_of_interest() const { return greatest_; }
  bool begins(double start) {
    if (best_) return start < best_->hi;
    proved_ = start;
    return true;
  }
  BoxDecision evaluate(const StretchOfTime& time, const BoxNode& p, const BoxNode& q) {
    const Stretch& s = time.bounds;
    const SegmentMargin::Bounds margin = approaches_.margin().over(time.start, time.end);
    const Path relative = s.in_p.place(q.box.centre, p.box.centre);
    const Vector towards{relative.x.a, relative.y.a};
    if (farther(s, p.box, q.box, towards, margin.most)) return BoxDecision::done;
    const bool leaf = p.count == 1 && q.count == 1;
    if (time.divisible && (motion(s, p.box, q.box) + margin.change >
                               subdivision_threshold * (p.box.radius + q.box.radius + (leaf ? margin.most : 0)) ||
                           (leaf && farther_around_middle(s, worth_trying, p.box, q.box, towards, margin.most))))
      return BoxDecision::deferred;
    if (!leaf) return BoxDecision::divided;
    // Each edge stands for its first vertex.
    const VertexId of_p(p.first), of_q(geometry_.np + q.first);
    if (!vertices_farther(s, point(of_p), point(of_q), margin.most)) resolve(time, {of_p, of_q, false});
    if (!misses_edge(s.in_q, s, of_p, of_q, margin.most)) resolve(time, {of_p, of_q, true});
    if (!misses_edge(s.in_p, s, of_q, of_p, margin.most)) resolve(time, {of_q, of_p, true});
    return BoxDecision::done;
  }

 private:
  Vector point(VertexId v) const { return {geometry_.point(v).x, geometry_.point(v).y}; }
  bool misses_edge(const RelativePose& relative_pose, const Stretch& s, VertexId vertex, VertexId edge,
                   double margin) const {
    return misses(s, relative_pose, point(vertex), point(edge), point(geometry_.next(edge)), margin);
  }
  /// The pair's first approach within the stretch becomes the best if it is.
  void resolve(const StretchOfTime& time, const VertexPeer& pair) {
    if (at_instant_) {
      if (!best_ && approaches_.close_at(pair, time.start)) best_ = Approach{pair, time.start, time.start, {}};
      return;
    }
    double end = time.end;
    if (best_) end = std::min(end, std::nextafter(best_->hi, std::numeric_limits<double>::infinity()));
    if (!(time.start < end)) return;
    std::optional<Approach> found = approaches_.first(pair, time.start, end);
    if (!found) return;
    const double lo = best_ ? std::min(best_->lo, found->lo) : found->lo;
    if (!best_ || approaches_.before(*found, *best_)) best_ = std::move(found);
    // Where their order stays open, the enclosure begins with that of the one that may be earlier.
    if (best_->lo > lo) best_->lo = lo;
  }

  const PairGeometry& geometry_;
  PreciseApproaches approaches_;
  double greatest_;  ///< the margin is not greater on the segment
  Walk<MarginOnSegment> walk_;
  std::optional<Approach> best_;
  bool at_instant_ = false;
  double proved_;
};

void note_approach(const Approach& found, MarginResult& result) {
  result.outcome = MarginResult::close;
  result.lo = found.lo;
  result.hi = found.hi;
  result.pair = found.pair;
  result.at_once = found.precise.stage < Stage::precise;
}

}  // namespace

MarginResult first_closer(const PairGeometry& geometry, const TreePair& trees, const MotionSegments& segments,
                          const Margin& margin, const TimeInterval& window) {
  MarginResult result;
  for (std::size_t i = segments.first_until(window.lo); i < segments.size(); ++i) {
    const SegmentPlace at = segments.place(i);
    if (at.start > window.hi) break;
    if (at.bridge) continue;
    const std::shared_ptr<const MotionSegment> held = segments.hold(i);
    const MotionSegment& segment = *held;
    MarginOnSegment search(geometry, trees, segment, margin);
    result.segment = i;
    try {
      if (const auto found = search.run(std::max(segment.start, window.lo), std::min(segment.end, window.hi))) {
        note_approach(*found, result);
        return result;
      }
      continue;
    } catch (const Undecidable& limit) {
      result.reason = not_decided(limit);
    } catch (const Interrupted& limit) {
      result.reason = limit.reason;
    }
    result.outcome = MarginResult::undecided;
    result.lo = search.proved();
    return result;
  }
  return result;
}

}  // namespace taut::internal::spacetime
