#include "sign/witness.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/pose.hpp"

namespace taut {
namespace {

/// x + i y of a pose's frame applied to a local point.
Point place(const Pose<double>& pose, double x, double y) {
  const double c = pose.xx.v.mid, s = pose.xy.v.mid;
  return {pose.ox.v.mid + (c * x - s * y), pose.oy.v.mid + (s * x + c * y)};
}

}  // namespace

VertexRef Witness::vertex(VertexId v) const {
  const std::size_t side = index_of(geometry_.role_of(v));
  const std::uint32_t k = geometry_.in_p(v) ? v.value : v.value - geometry_.np;
  if (plan_.rings[side]) return plan_.rings[side]->vertex(k);
  return {plan_.maps[side].body, plan_.maps[side].vertex(k)};
}

EdgeRef Witness::edge(VertexId v) const {
  const std::size_t side = index_of(geometry_.role_of(v));
  const std::uint32_t k = geometry_.in_p(v) ? v.value : v.value - geometry_.np;
  if (plan_.rings[side]) return plan_.rings[side]->edge(k);
  return {plan_.maps[side].body, plan_.maps[side].edge(k)};
}

Point Witness::world(VertexId v, const Leg& leg, double parameter) const {
  const DisplacedPoint& p = geometry_.point(v);
  const Point at = place(leg.pose_of_body(geometry_.in_p(v), parameter), p.x, p.y);
  return {std::ldexp(at.x, -plan_.exponent), std::ldexp(at.y, -plan_.exponent)};
}

Point Witness::outward_normal(VertexId edge, const Leg& leg, double parameter) const {
  const DisplacedPoint &a = geometry_.point(edge), &b = geometry_.point(geometry_.next(edge));
  const Pose<double> pose = leg.pose_of_body(geometry_.in_p(edge), parameter);
  // The polygon lies to the left of its edges: outside is to the right.
  double x = b.y - a.y, y = -(b.x - a.x);
  const double c = pose.xx.v.mid, s = pose.xy.v.mid;
  const double size = length(x, y) * length(c, s);
  x /= size;
  y /= size;
  return {c * x - s * y, s * x + c * y};
}

Contact Witness::contact(const FoundContact& found, const Leg& leg) const {
  const ContactBracket bracket = contact_bracket(plan_, geometry_, inwards_, leg, found);
  Contact result = contact_at(found.vertex, found.edge, leg, bracket.lo, bracket.hi);
  result.grazing = bracket.grazing;
  return result;
}

Contact Witness::contact_at(VertexId v, VertexId e, const Leg& leg, double lo, double hi) const {
  Contact contact;
  contact.time = {leg.time(lo), leg.time(hi)};
  contact.vertex = vertex(v);
  contact.edge = edge(e);
  const double middle = lo + (hi - lo) / 2;
  contact.point = world(v, leg, middle);
  contact.normal = outward_normal(e, leg, middle);
  return contact;
}

double Witness::distance(VertexId v, VertexId edge, const Leg& leg, double t) const {
  const Point p = world(v, leg, t), a = world(edge, leg, t), b = world(geometry_.next(edge), leg, t);
  const double ex = b.x - a.x, ey = b.y - a.y, px = p.x - a.x, py = p.y - a.y;
  const double share = std::clamp((px * ex + py * ey) / (ex * ex + ey * ey), 0.0, 1.0);
  return length(px - share * ex, py - share * ey);
}

/// Of the other body.
VertexId Witness::nearest_edge(VertexId v, const Leg& leg, double t) const {
  const Role role = other(geometry_.role_of(v));
  const std::uint32_t first = geometry_.first(role), last = first + geometry_.count(role);
  VertexId nearest(first);
  double least = distance(v, nearest, leg, t);
  for (std::uint32_t k = first + 1; k < last; ++k) {
    const double d = distance(v, VertexId(k), leg, t);
    if (!(d < least)) continue;
    least = d;
    nearest = VertexId(k);
  }
  return nearest;
}

Contact Witness::contact_of_overlap(const StartOverlap& overlap, const Leg& leg, double t) const {
  if (!overlap.crossing) return contact_at(overlap.inside, nearest_edge(overlap.inside, leg, t), leg, t, t);
  const VertexId e = overlap.edge_p, f = overlap.edge_q;
  const std::pair<VertexId, VertexId> candidates[] = {{e, f}, {geometry_.next(e), f}, {f, e}, {geometry_.next(f), e}};
  const auto* best = std::min_element(std::begin(candidates), std::end(candidates), [&](const auto& a, const auto& b) {
    return distance(a.first, a.second, leg, t) < distance(b.first, b.second, leg, t);
  });
  return contact_at(best->first, best->second, leg, t, t);
}

}  // namespace taut
