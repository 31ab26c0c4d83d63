#include "spacetime/at_pose.hpp"

#include <algorithm>
#include <cmath>

namespace taut::internal::spacetime {
namespace {

/// Directions of boxes are unit vectors up to this factor, and so are their products with the rotation.
constexpr double about_unit = 1 + 0x1p-40;

/// Tests the discs around the boxes, then the sides of both.
bool posed_apart(const QAtPose& at_pose, const Box& p, const Box& q) {
  const Vector relative = at_pose.at(q.centre) - p.centre;
  const double room = (p.radius + q.radius + at_pose.error) * about_unit;
  if (dot(relative, relative) > room * room * about_unit) return true;
  const Vector along = at_pose.rotation * q.along;
  const double c = std::fabs(dot(p.along, along)), s = std::fabs(dot(turned(p.along), along));
  // Errors of directions and products are multiplied by the sizes of the boxes. The error of Q's own is within that of
  // the pose.
  const double e = at_pose.error + 0x1p-48 * (p.radius + q.radius);
  const auto beyond = [&](Vector n, double fixed, double other) {
    return std::fabs(dot(n, relative)) > (fixed + other + e) * about_unit;
  };
  return beyond(p.along, p.half_length, c * q.half_length + s * q.half_width) ||
         beyond(turned(p.along), p.half_width, s * q.half_length + c * q.half_width) ||
         beyond(along, q.half_length, c * p.half_length + s * p.half_width) ||
         beyond(turned(along), q.half_width, s * p.half_length + c * p.half_width);
}

/// The orientation of a, b, c, points with an error of at most e each; 0 if it is not certain.
int certain_turn(Vector a, Vector b, Vector c, double e) {
  const Vector u = b - a, v = c - a;
  const double left = u.x * v.y, right = u.y * v.x, det = left - right;
  // Each difference has an error of 2 e and is rounded once, relative to itself and to the coordinates, which e covers.
  const double d = 2.125 * e;
  const double bound = 0x1p-50 * (std::fabs(left) + std::fabs(right)) + d * (l1_norm(u) + l1_norm(v)) + 2 * d * d;
  return det > bound ? 1 : -det > bound ? -1 : 0;
}

EdgesCross edges_cross_at(const QAtPose& at_pose, Vector a, Vector b, Vector c, Vector d) {
  const double e = at_pose.error + 0x1p-150;
  const int ac = certain_turn(a, b, c, e), ad = certain_turn(a, b, d, e);
  if (ac != 0 && ac == ad) return EdgesCross::no;
  const int ca = certain_turn(c, d, a, e), cb = certain_turn(c, d, b, e);
  if (ca != 0 && ca == cb) return EdgesCross::no;
  return ac != 0 && ad != 0 && ca != 0 && cb != 0 ? EdgesCross::yes : EdgesCross::unknown;
}

Vector place_of(const DisplacedPoint& p) { return {p.x, p.y}; }

}  // namespace

EdgesCross edges_cross(const QAtPose& at_pose, const PairGeometry& g, VertexId of_p, VertexId of_q) {
  return edges_cross_at(at_pose, place_of(g.point(of_p)), place_of(g.point(g.next(of_p))),
                        at_pose.at(place_of(g.point(of_q))), at_pose.at(place_of(g.point(g.next(of_q)))));
}

EdgesCross PoseSearch::edges_cross(const QAtPose& at_pose, const PairGeometry& g, const Hierarchy& p,
                                   const Hierarchy& q) {
  EdgesCross all = EdgesCross::no;
  todo_.assign(1, {0, 0});
  while (!todo_.empty()) {
    const auto [i, j] = todo_.back();
    todo_.pop_back();
    const BoxNode &a = p.node(i), &b = q.node(j);
    if (posed_apart(at_pose, a.box, b.box)) continue;
    if (a.count == 1 && b.count == 1) {
      const EdgesCross cross = spacetime::edges_cross(at_pose, g, VertexId(a.first), VertexId(g.np + b.first));
      if (cross == EdgesCross::yes) return cross;
      if (cross == EdgesCross::unknown) all = cross;
    } else if (divides_first(a, b)) {
      todo_.emplace_back(a.left, j);
      todo_.emplace_back(a.right, j);
    } else {
      todo_.emplace_back(i, b.left);
      todo_.emplace_back(i, b.right);
    }
  }
  return all;
}

}  // namespace taut::internal::spacetime
