#include "sign/witness.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/pose.hpp"

namespace taut {
namespace {

/// The origin and the x-axis of a pose, rounded.
struct ReportedPose {
  Vector origin{0, 0}, axis{1, 0};

  ReportedPose() = default;
  explicit ReportedPose(const Pose<double>& pose)
      : origin{pose.ox.v.mid, pose.oy.v.mid}, axis{pose.xx.v.mid, pose.xy.v.mid} {}
  Vector place(Vector v) const { return origin + axis * v; }
};

/// Of the frame that the pair's legs are seen from.
ReportedPose frame_of(const MotionChain& common, double t) {
  if (common.empty()) return {};
  Pose<double> pose = sharp_pose(common[0].at(t), t);
  for (std::size_t k = 1; k < common.size(); ++k) pose = compose(pose, sharp_pose(common[k].at(t), t));
  return ReportedPose(pose);
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

Vector Witness::in_frame(VertexId v, const Leg& leg, double parameter) const {
  const DisplacedPoint& p = geometry_.point(v);
  return ReportedPose(leg.pose_of_body(geometry_.in_p(v), parameter)).place({p.x, p.y});
}

Point Witness::world(Vector v, const Leg& leg, double parameter) const {
  const Vector at = plan_.common.empty() ? v : frame_of(plan_.common, leg.time(parameter)).place(v);
  return {std::ldexp(at.x, -plan_.exponent), std::ldexp(at.y, -plan_.exponent)};
}

Point Witness::outward_normal(VertexId edge, const Leg& leg, double parameter) const {
  const DisplacedPoint &a = geometry_.point(edge), &b = geometry_.point(geometry_.next(edge));
  const Vector axis = ReportedPose(leg.pose_of_body(geometry_.in_p(edge), parameter)).axis;
  // The polygon lies to the left of its edges: outside is to the right.
  const double x = b.y - a.y, y = -(b.x - a.x), size = length(x, y) * length(axis.x, axis.y);
  const Vector normal = axis * Vector{x / size, y / size};
  const Vector turned = plan_.common.empty() ? normal : frame_of(plan_.common, leg.time(parameter)).axis * normal;
  return {turned.x, turned.y};
}

Contact Witness::contact(const FoundContact& found, const Leg& leg, Passage passage) const {
  const ContactBracket bracket = contact_bracket(plan_, geometry_, inwards_, leg, found, passage);
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
  const Vector p = in_frame(v, leg, t), a = in_frame(edge, leg, t), b = in_frame(geometry_.next(edge), leg, t);
  const Vector along = b - a, way = p - a;
  const double share = std::clamp(dot(way, along) / dot(along, along), 0.0, 1.0);
  return length(way.x - share * along.x, way.y - share * along.y);
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
