#include "spacetime/box_separation.hpp"

#include <cmath>

namespace taut::internal::spacetime {
namespace {

/// Are the discs around the boxes disjoint?
bool discs_apart(double error, double r, const Path& relative, double radii) {
  Parabola gap = along({relative.x.a, relative.y.a}, relative);
  gap.a -= std::sqrt(gap.a) * (radii + error);
  return gap.a > 0 && gap.least(r) > 0;
}

/// Subtracts from the gap half a side of the moving box, whose component along the normal is `side`. The corner that is
/// nearest at the middle remains nearest unless the side rotates past the normal.
Parabola without_half(const Parabola& gap, const Parabola& side, double half, double swing) {
  if (std::fabs(side.a) > swing) return gap - (side.a > 0 ? half : -half) * side;
  return {gap.a - half * (std::fabs(side.a) + swing), gap.b, gap.c};
}

/// Does the direction n of the fixed box, which reaches `extent` from its centre, separate the two boxes?
bool separates(const RelativePose& relative_pose, double r, Vector n, double extent, const Box& moving,
               const Path& relative, const Path& side) {
  Parabola gap = along(n, relative);
  if (gap.a < 0) gap = -gap;
  gap.a -= extent + relative_pose.error;
  if (!(gap.a > 0)) return false;
  gap = without_half(gap, along(n, side), moving.half_length, relative_pose.swing);
  // n . turned(side) equals turned back(n) . side.
  gap = without_half(gap, along(-turned(n), side), moving.half_width, relative_pose.swing);
  return gap.a > 0 && gap.least(r) > 0;
}

bool separated(const RelativePose& relative_pose, double r, const Box& fixed, const Box& moving, const Path& relative) {
  const Path side = relative_pose.rotation * moving.along;
  return separates(relative_pose, r, turned(fixed.along), fixed.half_width, moving, relative, side) ||
         separates(relative_pose, r, fixed.along, fixed.half_length, moving, relative, side);
}

}  // namespace

bool apart(const Stretch& s, const Box& p, const Box& q) {
  const Path relative = s.in_p.place(q.centre, p.centre);
  return discs_apart(s.in_p.error, s.r, relative, p.radius + q.radius) || separated(s.in_p, s.r, p, q, relative) ||
         separated(s.in_q, s.r, q, p, s.in_q.place(p.centre, q.centre));
}

bool farther(const Stretch& s, const Box& p, const Box& q, Vector towards, double margin) {
  const Path relative = s.in_p.place(q.centre, p.centre);
  if (discs_apart(s.in_p.error + margin, s.r, relative, p.radius + q.radius)) return true;
  const double length = std::sqrt(dot(towards, towards));
  // The boxes' directions are unit vectors up to rounding, and so is this one: it must not be too long.
  constexpr double shorter = 1 - 0x1p-45;
  const double room = margin * (1 + 0x1p-44);
  if (length > 0) {
    const Vector n{towards.x / length * shorter, towards.y / length * shorter};
    const double extent =
        (std::fabs(dot(n, p.along)) * p.half_length + std::fabs(dot(n, turned(p.along))) * p.half_width) *
        (1 + 0x1p-45);
    if (separates(s.in_p, s.r, n, extent + room, q, relative, s.in_p.rotation * q.along)) return true;
  }
  const auto along_sides = [&](const RelativePose& relative_pose, const Box& fixed, const Box& moving,
                               const Path& path) {
    const Path side = relative_pose.rotation * moving.along;
    return separates(relative_pose, s.r, turned(fixed.along), fixed.half_width + room, moving, path, side) ||
           separates(relative_pose, s.r, fixed.along, fixed.half_length + room, moving, path, side);
  };
  return along_sides(s.in_p, p, q, relative) || along_sides(s.in_q, q, p, s.in_q.place(p.centre, q.centre));
}

namespace {

/// The part of a stretch around its middle. The omitted terms are third powers of time.
Stretch middle_part(const Stretch& s, double share) {
  Stretch part = s;
  part.r *= share;
  part.in_p.error -= s.rest * (1 - share * share * share);
  part.in_q.error -= s.rest * (1 - share * share * share);
  return part;
}

}  // namespace

bool apart_around_middle(const Stretch& s, double share, const Box& p, const Box& q) {
  return apart(middle_part(s, share), p, q);
}

bool farther_around_middle(const Stretch& s, double share, const Box& p, const Box& q, Vector towards, double margin) {
  return farther(middle_part(s, share), p, q, towards, margin);
}

double motion(const Stretch& s, const Box& p, const Box& q) {
  const Path relative = s.in_p.place(q.centre, p.centre);
  return relative.x.swing(s.r) + relative.y.swing(s.r) + s.in_p.swing * q.radius + s.rest;
}

bool misses(const Stretch& s, const RelativePose& relative_pose, Vector vertex, Vector from, Vector to, double margin) {
  const Vector edge = to - from;
  const Path relative = relative_pose.place(vertex, from);
  // The displacement contributes to the edge's direction, times the path, and to both points, along the edge, whose
  // coordinates are at most 1.
  const double error = relative_pose.error * l1_norm(edge) + displacement_room * (1 + relative_pose.reach);
  const double room = margin > 0 ? margin * l1_norm(edge) * (1 + 0x1p-45) : 0;
  const Parabola line = along(turned(edge), relative), ahead = along(edge, relative);
  const Parabola beyond{ahead.a - dot(edge, edge), ahead.b, ahead.c};
  return line.least(s.r) > error || (-line).least(s.r) > error + room || (-ahead).least(s.r) > error ||
         beyond.least(s.r) > error;
}

bool vertices_farther(const Stretch& s, Vector of_p, Vector of_q, double margin) {
  const Path relative = s.in_p.place(of_q, of_p);
  return discs_apart(s.in_p.error + margin, s.r, relative, 2 * displacement_room);
}

}  // namespace taut::internal::spacetime
