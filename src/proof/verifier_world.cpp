#include "proof/verifier_world.hpp"

#include <algorithm>

#include "numeric/budget.hpp"
#include "scene/crossing_edges.hpp"
#include "scene/placement.hpp"

namespace taut::internal::proof {
namespace {

/// Of a pair, several kilobytes are kept, which is far more than what the log says of it.
constexpr std::size_t most_pairs = 1024;

}  // namespace

const EdgeRanges& VerifierWorld::ranges(const RingSet& body) {
  std::unique_ptr<EdgeRanges>& made = ranges_[&body];
  if (!made) made = std::make_unique<EdgeRanges>(*body.displaced(offset_));
  return *made;
}

VerifierPair& VerifierWorld::pair(int a, int b) {
  const auto known = pairs_.find({a, b});
  if (known != pairs_.end()) return *known->second;
  if (pairs_.size() >= most_pairs) pairs_.clear();
  std::unique_ptr<VerifierPair>& place = pairs_[{a, b}];
  BodyPair bodies = scene_.pair(a, b);
  PairGeometry geometry = displaced_pair(bodies, offset_);
  MotionSegments segments = scene_.segments(bodies);
  const EdgeRanges &p = ranges(*bodies.rings[0]), &q = ranges(*bodies.rings[1]);
  place = std::make_unique<VerifierPair>(std::move(bodies), std::move(geometry), std::move(segments), p, q);
  return *place;
}

std::vector<SegmentStretch> stretches(const MotionSegments& segments, const WorldTime& time) {
  std::vector<SegmentStretch> found;
  const double last = std::min(time.to, segments.repeats_from());
  for (std::size_t i = segments.first_until(time.from); i < segments.size(); ++i) {
    const SegmentPlace segment = segments.place(i);
    if (segment.start > last) break;
    if (segment.bridge) {
      if (segment.start > time.from) found.push_back({i, 0, 1});
      continue;
    }
    const double from = std::max(segment.start, time.from), to = std::min(segment.end, last);
    if (from < to || (from == to && time.first && i == 0)) found.push_back({i, from, to});
  }
  return found;
}

void add_stretches_before(const MotionSegments& segments, std::size_t segment, std::vector<SegmentStretch>& all) {
  for (std::size_t i = 0; i < segment; ++i) {
    const SegmentPlace at = segments.place(i);
    all.push_back(at.bridge ? SegmentStretch{i, 0, 1} : SegmentStretch{i, at.start, at.end});
  }
}

/// How often the other body's rings wind around it: outlines once, unless a hole around it takes that back. A ray along
/// the plane sweep's "up" crosses them one way or the other.
bool inside_the_other(const Placement& place, VertexId vertex) {
  const PairGeometry& g = place.geometry();
  const Role role = other(g.role_of(vertex));
  int winds = 0;
  for (std::uint32_t k = g.first(role); k < g.first(role) + g.count(role); ++k) {
    checkpoint();
    const VertexId a(k), b = g.next(a);
    const bool forwards = place.before(a, vertex);
    if (forwards == place.before(b, vertex)) continue;
    if (place.orientation(forwards ? a : b, forwards ? b : a, vertex) < 0) winds += forwards ? -1 : 1;
  }
  return winds > 0;
}

void require_crossing(const Placement& place, VertexId e, VertexId f) {
  const PairGeometry& g = place.geometry();
  const VertexId e2 = g.next(e), f2 = g.next(f);
  if (g.same_body(e, f) || place.orientation(e, e2, f) == place.orientation(e, e2, f2) ||
      place.orientation(f, f2, e) == place.orientation(f, f2, e2))
    throw ProofError("the edges do not cross");
}

bool overlap_at(const VerifierPair& pair, const MotionSegment& segment, double t) {
  const MotionWindow instant(segment, t, t);
  if (separating_step(instant, pair.ranges.p[EdgeRanges::all], pair.ranges.q[EdgeRanges::all])) return false;
  const Placement place(pair.geometry, segment, t);
  if (crossing_edges(place)) return true;
  const auto any_outline = [&](const DisplacedPolygon& body, std::uint32_t first) {
    if (body.rings.empty()) return inside_the_other(place, VertexId(first));
    return std::any_of(body.rings.begin(), body.rings.end(), [&](const RingSpan& ring) {
      return !ring.hole && inside_the_other(place, VertexId(first + ring.first));
    });
  };
  return any_outline(*pair.geometry.p(), 0) || any_outline(*pair.geometry.q(), pair.geometry.np);
}

}  // namespace taut::internal::proof
