#include "support/world_judge.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace taut::testing {
namespace {

/// Deeper than this is an overlap, whatever rounding does to poses.
constexpr double clear_overlap = 1e-7;
/// Nearer than this may be touching.
constexpr double close_enough = 1e-8;

Complex corner_at(const BodyAtPose& body, int part, int ring, int index) {
  const RingAtPose& points = body[static_cast<std::size_t>(part)].rings[static_cast<std::size_t>(ring)];
  return points[static_cast<std::size_t>(index) % points.size()];
}

}  // namespace

WorldJudge::WorldJudge(const MadeWorld& world, int samples) : world_(world), count_(samples) {
  for (int body = 0; body < static_cast<int>(world.bodies.size()); ++body) {
    samples_.emplace_back();
    for (int k = 0; k <= samples; ++k) samples_.back().push_back(placed(body, instant(k)));
  }
}

WorldJudge::Placed WorldJudge::placed(int body, double t) const {
  Placed p{posed(world_, body, t), INFINITY, -INFINITY, INFINITY, -INFINITY};
  for (const PartAtPose& part : p.rings) {
    for (const Complex& z : part.rings[0]) {
      p.lo_x = std::min(p.lo_x, z.real());
      p.hi_x = std::max(p.hi_x, z.real());
      p.lo_y = std::min(p.lo_y, z.imag());
      p.hi_y = std::max(p.hi_y, z.imag());
    }
  }
  return p;
}

bool WorldJudge::overlap_at(const std::array<BodyId, 2>& pair, double t, double margin) const {
  return overlap_clearly(posed(world_, pair[0], t), posed(world_, pair[1], t), margin);
}

bool WorldJudge::overlap_sampled(const std::array<BodyId, 2>& pair, int k, double margin) const {
  const Placed &p = sampled(pair[0], k), &q = sampled(pair[1], k);
  if (p.hi_x < q.lo_x || q.hi_x < p.lo_x || p.hi_y < q.lo_y || q.hi_y < p.lo_y) return false;
  return overlap_clearly(p.rings, q.rings, margin);
}

bool WorldJudge::meet_at(const std::array<BodyId, 2>& pair, double t) const {
  const BodyAtPose p = posed(world_, pair[0], t), q = posed(world_, pair[1], t);
  return overlap_clearly(p, q, 0) || between_rings(p, q) < close_enough;
}

std::string WorldJudge::witness_fault(const PairAnswer& pair) const {
  const Contact& c = *pair.contact;
  const int v = c.vertex.body, e = c.edge.body;
  if (!(v == pair.bodies[0] && e == pair.bodies[1]) && !(v == pair.bodies[1] && e == pair.bodies[0]))
    return "the witness is of other bodies";
  const double width = c.time.hi - c.time.lo, t = c.time.lo + width / 2;
  const BodyAtPose vertex = posed(world_, v, t), edge = posed(world_, e, t);
  const double distance = to_segment(corner_at(vertex, c.vertex.part, c.vertex.ring, c.vertex.index),
                                     corner_at(edge, c.edge.part, c.edge.ring, c.edge.index),
                                     corner_at(edge, c.edge.part, c.edge.ring, c.edge.index + 1));
  return distance <= close_enough + 1e3 * width ? "" : fmt::format("the vertex is {} from the edge", distance);
}

std::string WorldJudge::pair_fault(const PairAnswer& pair) {
  if (pair.outcome == Outcome::overlap_at_start)
    return meet_at(pair.bodies, 0) ? "" : "an overlap at the start that is none";
  if (pair.outcome == Outcome::undecided) return "undecided: " + pair.reason;
  const bool meets = pair.outcome == Outcome::contact;
  const double until = meets ? pair.contact->time.lo : world_.end;
  for (int k = 0; k <= count_ && instant(k) <= until; ++k) {
    if (overlap_sampled(pair.bodies, k, clear_overlap)) return fmt::format("they overlap before, at {}", instant(k));
  }
  if (!meets) return {};
  for (const double before : {0.0, 1e-9, 1e-6, 1e-3}) {
    if (until >= before && overlap_at(pair.bodies, until - before, clear_overlap))
      return fmt::format("they overlap {} before the contact", before);
  }
  const double after = pair.contact->time.hi + 1e-4;
  entered += after <= world_.end && overlap_at(pair.bodies, after, 0);
  return witness_fault(pair);
}

std::string WorldJudge::intervals_fault(const std::array<BodyId, 2>& pair,
                                        const std::vector<OverlapInterval>& intervals) {
  auto next = intervals.begin();
  for (int k = 0; k <= count_; ++k) {
    while (next != intervals.end() && next->to.hi < instant(k)) ++next;
    const bool outside = next == intervals.end() || instant(k) < next->from.lo;
    if (outside && overlap_sampled(pair, k, clear_overlap))
      return fmt::format("an overlap at {} that is in no interval", instant(k));
  }
  double last = -INFINITY;
  for (const OverlapInterval& o : intervals) {
    if (!(o.from.lo <= o.to.hi) || o.from.hi < last) return "intervals that are not in order";
    last = o.to.lo;
    for (const double share : {0.01, 0.5, 0.99}) {
      const double t = o.from.hi + share * (o.to.lo - o.from.hi);
      if (o.from.hi < o.to.lo && !meet_at(pair, t)) return fmt::format("a gap at {} within an interval", t);
    }
  }
  return {};
}

std::string WorldJudge::clearance_fault(const std::array<BodyId, 2>& pair, double lo) {
  for (int k = 0; k <= count_; ++k) {
    const double d = between_rings(sampled(pair[0], k).rings, sampled(pair[1], k).rings);
    if (d < lo - close_enough) return fmt::format("a distance of {} at {}, below the clearance {}", d, instant(k), lo);
  }
  return {};
}

double WorldJudge::distance_at(const std::array<BodyId, 2>& pair, double t) const {
  const BodyAtPose p = posed(world_, pair[0], t), q = posed(world_, pair[1], t);
  return overlap_clearly(p, q, 0) ? 0 : between_rings(p, q);
}

std::string WorldJudge::curve_fault(const std::array<BodyId, 2>& pair, const DistanceCurve& curve) {
  const auto outside = [](double d, double lo, double hi) { return d < lo - close_enough || d > hi + close_enough; };
  double most = 0;
  for (const DistanceAt& at : curve.instants) {
    const double d = distance_at(pair, at.t);
    most = std::max(most, d);
    if (outside(d, at.lo, at.hi)) return fmt::format("{} at {}, not in [{}, {}]", d, at.t, at.lo, at.hi);
    if (at.lo > 0 && at.hi - at.lo > 1e-5 * at.hi + close_enough) return fmt::format("a wide bracket at {}", at.t);
  }
  for (int k = 0; k <= count_; ++k) {
    const double t = instant(k), d = distance_at(pair, t);
    most = std::max(most, d);
    for (const DistanceWithin& s : curve.stretches) {
      if (s.from <= t && t <= s.to && outside(d, s.lo, s.hi))
        return fmt::format("{} at {}, not in [{}, {}] of its stretch", d, t, s.lo, s.hi);
    }
  }
  if (most > curve.largest_hi + close_enough) return fmt::format("{}, above the greatest distance", most);
  if (outside(distance_at(pair, curve.largest_at), curve.largest_lo, curve.largest_hi))
    return "no such distance where the greatest is";
  return {};
}

std::string earliest_fault(const Answer& headline, const std::vector<PairAnswer>& pairs) {
  double first = INFINITY;
  bool overlap = false;
  for (const PairAnswer& pair : pairs) {
    overlap = overlap || pair.outcome == Outcome::overlap_at_start;
    if (pair.contact) first = std::min(first, pair.contact->time.lo);
  }
  const Outcome right = overlap ? Outcome::overlap_at_start : first < INFINITY ? Outcome::contact : Outcome::free;
  if (headline.outcome != right)
    return fmt::format("the headline is {}, the pairs say {}", to_string(headline.outcome), to_string(right));
  if (right == Outcome::contact && !(std::fabs(headline.contact->time.lo - first) <= 1e-11))
    return fmt::format("the headline is at {}, the first pair at {}", headline.contact->time.lo, first);
  return {};
}

}  // namespace taut::testing
