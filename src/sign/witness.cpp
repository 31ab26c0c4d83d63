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

/// The pose of P or Q on a leg; on a bridge that after it, which differs by rounding only.
Pose<double> pose_on(const Leg& leg, bool of_p, double parameter) {
  if (leg.bridge) return pose(of_p ? leg.p_next : leg.q_next, Ball<double>::exact(leg.joint));
  return pose(of_p ? leg.p : leg.q, Ball<double>::exact(parameter));
}

}  // namespace

VertexRef Witness::vertex(VertexId v) const {
  const BodyMap& m = plan_.maps[geometry_.in_p(v) ? 0 : 1];
  return {m.body, m.vertex(geometry_.in_p(v) ? v.value : v.value - geometry_.np)};
}

EdgeRef Witness::edge(VertexId v) const {
  const BodyMap& m = plan_.maps[geometry_.in_p(v) ? 0 : 1];
  return {m.body, m.edge(geometry_.in_p(v) ? v.value : v.value - geometry_.np)};
}

Point Witness::world(VertexId v, const Leg& leg, double parameter) const {
  const DisplacedPoint& p = geometry_.point(v);
  const Point at = place(pose_on(leg, geometry_.in_p(v), parameter), p.x, p.y);
  return {std::ldexp(at.x, -plan_.exponent), std::ldexp(at.y, -plan_.exponent)};
}

Point Witness::outward_normal(VertexId edge, const Leg& leg, double parameter) const {
  const DisplacedPoint &a = geometry_.point(edge), &b = geometry_.point(geometry_.next(edge));
  const Pose<double> pose = pose_on(leg, geometry_.in_p(edge), parameter);
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

Contact Witness::contact_of_crossing(VertexId e, VertexId f, const Leg& leg, double t) const {
  const auto distance = [&](VertexId v, VertexId edge) {
    const Point p = world(v, leg, t), a = world(edge, leg, t), b = world(geometry_.next(edge), leg, t);
    const double ex = b.x - a.x, ey = b.y - a.y, px = p.x - a.x, py = p.y - a.y;
    const double share = std::clamp((px * ex + py * ey) / (ex * ex + ey * ey), 0.0, 1.0);
    return length(px - share * ex, py - share * ey);
  };
  const std::pair<VertexId, VertexId> candidates[] = {{e, f}, {geometry_.next(e), f}, {f, e}, {geometry_.next(f), e}};
  const auto* best = std::min_element(std::begin(candidates), std::end(candidates), [&](const auto& a, const auto& b) {
    return distance(a.first, a.second) < distance(b.first, b.second);
  });
  return contact_at(best->first, best->second, leg, t, t);
}

}  // namespace taut
