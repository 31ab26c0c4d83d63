#include "proof/verifier_world.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "numeric/budget.hpp"
#include "scene/overlap_witness.hpp"
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

namespace {

/// An interval along the axis of the sweep.
struct Swept {
  double lo, hi;
  int body;
};

/// The intervals that have begun, of which some are over already: these are thrown out when the list is traversed.
class BegunIntervals {
 public:
  void add(const Swept& swept) { list_.push_back(swept); }
  template <class Visit>
  void each(double from, const Visit& visit) {
    std::size_t kept = 0;
    for (const Swept& swept : list_) {
      if (swept.hi < from) continue;
      list_[kept++] = swept;
      visit(swept.body);
    }
    list_.resize(kept);
  }
  bool empty() const { return list_.empty(); }

 private:
  std::vector<Swept> list_;
};

}  // namespace

WindowBoxes::WindowBoxes(const VerifierScene& scene, double room) : room_(room * (1 + 0x1p-40)) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  for (int i = 0; i < scene.size(); ++i) {
    const AxisBox& b = scene[i].rings->bounds();
    rests_.push_back(scene[i].rests());
    boxes_.push_back(rests_.back() ? AxisBox{b.lo_x, b.lo_y, b.hi_x, b.hi_y}
                                   : AxisBox{-infinite, -infinite, infinite, infinite});
  }
}

/// Are boxes shorter along x than along y, relative to how far they are spread?
bool WindowBoxes::sweep_along_x() const {
  double long_x = 0, long_y = 0, lo_x = INFINITY, lo_y = INFINITY, hi_x = -INFINITY, hi_y = -INFINITY;
  for (const AxisBox& b : boxes_) {
    if (!std::isfinite(b.lo_x + b.hi_x + b.lo_y + b.hi_y)) continue;
    long_x += b.hi_x - b.lo_x;
    long_y += b.hi_y - b.lo_y;
    lo_x = std::min(lo_x, b.lo_x);
    lo_y = std::min(lo_y, b.lo_y);
    hi_x = std::max(hi_x, b.hi_x);
    hi_y = std::max(hi_y, b.hi_y);
  }
  return !(long_x * (hi_y - lo_y) > long_y * (hi_x - lo_x));
}

std::optional<BodyPairs> WindowBoxes::meeting(const VerifierScene& scene, std::size_t most) const {
  const bool along_x = sweep_along_x();
  std::vector<Swept> order;
  for (int i = 0; i < scene.size(); ++i) {
    if (scene.ignores(i)) continue;
    const AxisBox& b = of(i);
    // A little longer than it is, so that bodies at rest are seen that are within the room of each other.
    order.push_back({along_x ? b.lo_x : b.lo_y, (along_x ? b.hi_x : b.hi_y) + 2 * room_, i});
  }
  std::sort(order.begin(), order.end(),
            [](const Swept& a, const Swept& b) { return a.lo != b.lo ? a.lo < b.lo : a.body < b.body; });
  BodyPairs found;
  // By bodies that move alike, most of which are not asked about each other. Those that have no interval left are gone.
  std::map<int, BegunIntervals> begun;
  for (const Swept& next : order) {
    checkpoint();
    const auto visit = [&](int other) {
      checkpoint();
      if (meet(next.body, other) && scene.asked(next.body, other)) found.push_back(std::minmax(next.body, other));
    };
    const int own = scene[next.body].alike;
    for (auto& [alike, intervals] : begun) {
      if (alike != own || scene.tests_alike()) intervals.each(next.lo, visit);
    }
    std::erase_if(begun, [](const auto& of) { return of.second.empty(); });
    begun[own].add(next);
    // Many bodies may meet one: what is over the limit is dropped at once.
    if (found.size() > most) return std::nullopt;
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<int> moving_bodies(const VerifierScene& scene, const OpenPairs& open) {
  std::vector<int> bodies;
  if (open.all()) {
    bodies.resize(static_cast<std::size_t>(scene.size()));
    std::iota(bodies.begin(), bodies.end(), 0);
  } else {
    for (const auto& [a, b] : *open.listed) bodies.insert(bodies.end(), {a, b});
    std::sort(bodies.begin(), bodies.end());
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  }
  std::erase_if(bodies, [&](int i) { return scene[i].rests(); });
  return bodies;
}

}  // namespace taut::internal::proof
