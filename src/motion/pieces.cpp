#include "motion/pieces.hpp"

#include <algorithm>
#include <cmath>

#include "motion/cosine_pieces.hpp"
#include "motion/pose.hpp"

namespace taut::internal {
namespace {

void drop_last_zeros(Coefficients& c) {
  while (!c.empty() && c.back() == 0) c.pop_back();
}

/// The same piece without zeros at the end of polynomials, and without an origin of constants, so that equal motions
/// look alike.
MotionPiece without_last_zeros(MotionPiece piece) {
  drop_last_zeros(piece.x);
  drop_last_zeros(piece.y);
  drop_last_zeros(piece.orbit.angle);
  for_each_polynomial(piece.rotation, drop_last_zeros);
  if (!varies(piece)) piece.origin = 0;
  return piece;
}

}  // namespace

namespace {

template <class Visit>
void for_each_given_between(const Motion& motion, double start, double end, const Visit& visit) {
  if (motion.pieces.empty()) return visit(MotionPiece{});
  for (const MotionPiece& given : motion.pieces) {
    const bool last = &given == &motion.pieces.back();
    if (given.until <= start && !last) continue;
    MotionPiece piece = without_last_zeros(given);
    const bool ends = last || given.until >= end;
    if (ends) piece.until = std::numeric_limits<double>::infinity();
    visit(std::move(piece));
    if (ends) break;
  }
}

}  // namespace

std::vector<MotionPiece> given_pieces_between(const Motion& motion, double start, double end) {
  std::vector<MotionPiece> out;
  for_each_given_between(motion, start, end, [&](MotionPiece&& piece) { out.push_back(std::move(piece)); });
  return out;
}

void for_each_piece_between(const Motion& motion, double start, double end,
                            const std::function<void(MotionPiece&&)>& visit) {
  double from = start;
  for_each_given_between(motion, start, end, [&](MotionPiece&& piece) {
    const double until = piece.until;
    if (std::holds_alternative<CosineRotation>(piece.rotation)) {
      for (MotionPiece& part : cut_at_extremes(piece, from, std::min(until, end))) visit(std::move(part));
    } else {
      visit(std::move(piece));
    }
    from = until;
  });
}

std::vector<MotionPiece> pieces_between(const Motion& motion, double start, double end) {
  std::vector<MotionPiece> out;
  for_each_piece_between(motion, start, end, [&](MotionPiece&& piece) { out.push_back(std::move(piece)); });
  return out;
}

const MotionPiece& piece_at(const std::vector<MotionPiece>& pieces, double t) {
  for (const MotionPiece& piece : pieces) {
    if (t < piece.until) return piece;
  }
  return pieces.back();
}

bool varies(const MotionPiece& piece) {
  return piece.x.size() > 1 || piece.y.size() > 1 || piece.orbit.angle.size() > 1 || varies(piece.rotation);
}

MotionPiece scaled(MotionPiece piece, int exponent) {
  for (double& c : piece.x) c = std::ldexp(c, exponent);
  for (double& c : piece.y) c = std::ldexp(c, exponent);
  for (Point* p : {&piece.pivot, &piece.orbit.centre}) *p = {std::ldexp(p->x, exponent), std::ldexp(p->y, exponent)};
  if (auto* follower = std::get_if<JointFollower>(&piece.rotation)) follower->exponent += exponent;
  return piece;
}

bool same_motion(const MotionPiece& a, const MotionPiece& b) {
  return a.x == b.x && a.y == b.y && (a.origin == b.origin || !varies(a)) && same_rotation(a.rotation, b.rotation) &&
         pivot_of(a) == pivot_of(b) && a.orbit.angle == b.orbit.angle &&
         (!orbits(a) || a.orbit.centre == b.orbit.centre);
}

double joint_gap(const MotionPiece& before, const MotionPiece& after, const AxisBox& polygon, double t) {
  const Pose<double> a = sharp_pose(before, t), b = sharp_pose(after, t);
  const double ox = b.ox.v.mid - a.ox.v.mid, oy = b.oy.v.mid - a.oy.v.mid;
  const double xx = b.xx.v.mid - a.xx.v.mid, xy = b.xy.v.mid - a.xy.v.mid;
  double gap = 0;
  for (const double x : {polygon.lo_x, polygon.hi_x}) {
    for (const double y : {polygon.lo_y, polygon.hi_y})
      gap = std::max(gap, length(ox + xx * x - xy * y, oy + xy * x + xx * y));
  }
  return gap;
}

namespace {

/// The sum of the terms' magnitudes: by so many units in the last place does rounding them change the value, at most.
double magnitude_of(const Coefficients& c, double t) {
  double sum = 0;
  for (std::size_t k = c.size(); k-- > 0;) sum = sum * std::fabs(t) + std::fabs(c[k]);
  return sum;
}

/// Of all that is added up to where a piece puts a corner of the polygon's bounds.
double magnitude_of(const MotionPiece& piece, const AxisBox& polygon, double t) {
  const Point c = pivot_of(piece);
  const double turned = std::max(std::fabs(polygon.lo_x), std::fabs(polygon.hi_x)) +
                        std::max(std::fabs(polygon.lo_y), std::fabs(polygon.hi_y)) + std::fabs(c.x) + std::fabs(c.y);
  t -= piece.origin;
  const auto* angle = std::get_if<AngleRotation>(&piece.rotation);
  const double turn = angle ? magnitude_of(angle->angle, t) : 0;
  const double moved = magnitude_of(piece.x, t) + magnitude_of(piece.y, t);
  if (!orbits(piece)) return moved + turned * (1 + turn);
  const Point& centre = piece.orbit.centre;
  const double radius = moved + turned + std::fabs(centre.x) + std::fabs(centre.y);
  return turned * (1 + turn) + radius * (2 + magnitude_of(piece.orbit.angle, t));
}

}  // namespace

double joint_room(const MotionPiece& before, const MotionPiece& after, const AxisBox& polygon, double t,
                  double extent) {
  return joint_tolerance * extent +
         joint_rounding * (magnitude_of(before, polygon, t) + magnitude_of(after, polygon, t));
}

}  // namespace taut::internal
