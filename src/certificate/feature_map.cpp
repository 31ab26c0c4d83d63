#include "certificate/feature_map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/pose.hpp"

namespace taut::internal {
namespace {

/// The origin and the x-axis of a pose, rounded.
struct ReportedPose {
  Vector origin{0, 0}, axis{1, 0};

  ReportedPose() = default;
  explicit ReportedPose(const Pose<double>& pose)
      : origin{pose.ox.v.mid, pose.oy.v.mid}, axis{pose.xx.v.mid, pose.xy.v.mid} {}
  Vector place(Vector v) const { return origin + axis * v; }
};

/// The pose of the frame in which the pair's segments are expressed.
ReportedPose frame_of(const MotionChain& common, double t) {
  if (common.empty()) return {};
  Pose<double> pose = sharp_pose(common[0].at(t), t);
  for (std::size_t k = 1; k < common.size(); ++k) pose = compose(pose, sharp_pose(common[k].at(t), t));
  return ReportedPose(pose);
}

}  // namespace

VertexRef FeatureMap::vertex(VertexId v) const {
  const std::size_t side = index_of(geometry_.role_of(v));
  const std::uint32_t k = geometry_.in_p(v) ? v.value : v.value - geometry_.np;
  return bodies_.rings[side]->vertex(k);
}

EdgeRef FeatureMap::edge(VertexId v) const {
  const std::size_t side = index_of(geometry_.role_of(v));
  const std::uint32_t k = geometry_.in_p(v) ? v.value : v.value - geometry_.np;
  return bodies_.rings[side]->edge(k);
}

Vector FeatureMap::in_frame(VertexId v, const MotionSegment& segment, double parameter) const {
  const DisplacedPoint& p = geometry_.point(v);
  return ReportedPose(segment.pose_of_body(geometry_.in_p(v), parameter)).place({p.x, p.y});
}

Point FeatureMap::world(Vector v, const MotionSegment& segment, double parameter) const {
  const Vector at = bodies_.common.empty() ? v : frame_of(bodies_.common, segment.time(parameter)).place(v);
  return {std::ldexp(at.x, -bodies_.exponent), std::ldexp(at.y, -bodies_.exponent)};
}

Point FeatureMap::outward_normal(VertexId edge, const MotionSegment& segment, double parameter) const {
  const DisplacedPoint &a = geometry_.point(edge), &b = geometry_.point(geometry_.next(edge));
  const Vector axis = ReportedPose(segment.pose_of_body(geometry_.in_p(edge), parameter)).axis;
  // The polygon lies to the left of its edges: outside is to the right.
  const double x = b.y - a.y, y = -(b.x - a.x), size = length(x, y) * length(axis.x, axis.y);
  const Vector normal = axis * Vector{x / size, y / size};
  const Vector turned =
      bodies_.common.empty() ? normal : frame_of(bodies_.common, segment.time(parameter)).axis * normal;
  return {turned.x, turned.y};
}

Contact FeatureMap::contact(const FoundContact& found, const MotionSegment& segment, Passage passage) const {
  const ContactBracket bracket = contact_bracket(bodies_, geometry_, offset_, segment, found, passage);
  Contact result = contact_at(found.vertex, found.edge, segment, bracket.lo, bracket.hi);
  result.grazing = bracket.grazing;
  return result;
}

Contact FeatureMap::contact_at(VertexId v, VertexId e, const MotionSegment& segment, double lo, double hi) const {
  Contact contact;
  contact.time = {segment.time(lo), segment.time(hi)};
  contact.vertex = vertex(v);
  contact.edge = edge(e);
  const double middle = lo + (hi - lo) / 2;
  contact.point = world(v, segment, middle);
  contact.normal = outward_normal(e, segment, middle);
  return contact;
}

double FeatureMap::distance(VertexId v, VertexId edge, const MotionSegment& segment, double t) const {
  const Vector p = in_frame(v, segment, t), a = in_frame(edge, segment, t),
               b = in_frame(geometry_.next(edge), segment, t);
  const Vector along = b - a, way = p - a;
  const double share = std::clamp(dot(way, along) / dot(along, along), 0.0, 1.0);
  return length(way.x - share * along.x, way.y - share * along.y);
}

/// The nearest edge of the other body.
VertexId FeatureMap::nearest_edge(VertexId v, const MotionSegment& segment, double t) const {
  const Role role = other(geometry_.role_of(v));
  const std::uint32_t first = geometry_.first(role), last = first + geometry_.count(role);
  VertexId nearest(first);
  double least = distance(v, nearest, segment, t);
  for (std::uint32_t k = first + 1; k < last; ++k) {
    const double d = distance(v, VertexId(k), segment, t);
    if (!(d < least)) continue;
    least = d;
    nearest = VertexId(k);
  }
  return nearest;
}

Contact FeatureMap::contact_of_overlap(const StartOverlap& overlap, const MotionSegment& segment, double t) const {
  if (!overlap.crossing) return contact_at(overlap.inside, nearest_edge(overlap.inside, segment, t), segment, t, t);
  const VertexId e = overlap.edge_p, f = overlap.edge_q;
  const std::pair<VertexId, VertexId> candidates[] = {{e, f}, {geometry_.next(e), f}, {f, e}, {geometry_.next(f), e}};
  const auto* best = std::min_element(std::begin(candidates), std::end(candidates), [&](const auto& a, const auto& b) {
    return distance(a.first, a.second, segment, t) < distance(b.first, b.second, segment, t);
  });
  return contact_at(best->first, best->second, segment, t, t);
}

}  // namespace taut::internal
