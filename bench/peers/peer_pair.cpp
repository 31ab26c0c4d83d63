#include "peers/peer_pair.hpp"

#include <algorithm>
#include <cmath>

#include "taut/pose.hpp"

namespace taut::bench {
namespace {

struct Box {
  Point lo{INFINITY, INFINITY}, hi{-INFINITY, -INFINITY};
  double side() const { return std::max(hi.x - lo.x, hi.y - lo.y); }
  Point middle() const { return {(lo.x + hi.x) / 2, (lo.y + hi.y) / 2}; }
};

Box box_of(const Polygon& polygon) {
  Box box;
  for (const Point& p : polygon) {
    box.lo = {std::min(box.lo.x, p.x), std::min(box.lo.y, p.y)};
    box.hi = {std::max(box.hi.x, p.x), std::max(box.hi.y, p.y)};
  }
  return box;
}

double twice_area(const Polygon& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

PeerShape shape_of(const Polygon& polygon, const Point& middle, double scale) {
  PeerShape shape;
  for (const Point& p : polygon) shape.outline.push_back({(p.x - middle.x) * scale, (p.y - middle.y) * scale});
  if (twice_area(shape.outline) < 0) std::reverse(shape.outline.begin(), shape.outline.end());
  for (const Point& p : shape.outline) shape.radius = std::max(shape.radius, std::hypot(p.x, p.y));
  shape.triangles = triangulate(shape.outline);
  shape.pieces = convex_pieces(shape.outline, peer_vertices);
  return shape;
}

/// a b and conj(a) b, as complex numbers.
Point times(const Point& a, const Point& b) { return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; }
Point conj_times(const Point& a, const Point& b) { return times({a.x, -a.y}, b); }

const Motion& motion_of(const Contest& contest, std::size_t body, double t) {
  if (body == 0 || contest.plans.empty()) return contest.scene.bodies[body].motion;
  const auto last = static_cast<double>(contest.plans.size() - 1);
  return contest.plans[static_cast<std::size_t>(std::clamp(std::floor(t), 0.0, last))];
}

/// Rests, or follows polynomials of degree 1 in one piece.
bool moves_straight(const Motion& motion) {
  if (motion.pieces.empty()) return true;
  if (motion.pieces.size() > 1) return false;
  const MotionPiece& piece = motion.pieces[0];
  return std::holds_alternative<NoRotation>(piece.rotation) && piece.x.size() <= 2 && piece.y.size() <= 2;
}

}  // namespace

PeerPair::PeerPair(const Contest& contest) : contest_(contest) {
  const std::vector<Body>& bodies = contest.scene.bodies;
  fixed_body_ = bodies[0].polygon.size() >= bodies[1].polygon.size() ? 0 : 1;
  const Polygon &fixed = bodies[fixed_body_].polygon, &moving = bodies[1 - fixed_body_].polygon;
  const Box fixed_box = box_of(fixed), moving_box = box_of(moving);
  middle_[0] = fixed_box.middle();
  middle_[1] = moving_box.middle();
  scale_ = peer_size / std::max(fixed_box.side(), moving_box.side());
  fixed_ = shape_of(fixed, middle_[0], scale_);
  moving_ = shape_of(moving, middle_[1], scale_);
}

RelativePose PeerPair::pose(double t) const {
  const BodyPose a = pose_at(motion_of(contest_, fixed_body_, t), t);
  const BodyPose b = pose_at(motion_of(contest_, 1 - fixed_body_, t), t);
  const Point turn = conj_times(a.axis, b.axis);
  const Point origin = conj_times(a.axis, {b.origin.x - a.origin.x, b.origin.y - a.origin.y});
  const Point middle = times(turn, middle_[1]);
  return {(origin.x + middle.x - middle_[0].x) * scale_, (origin.y + middle.y - middle_[0].y) * scale_, turn.x, turn.y};
}

std::vector<double> sample_times(const Contest& contest, int steps) {
  const double start = contest.scene.start, end = contest.scene.end;
  std::vector<double> times;
  for (int k = 0; k <= steps; ++k) times.push_back(start + (end - start) * k / steps);
  return times;
}

bool is_straight(const Contest& contest) {
  return contest.plans.empty() && moves_straight(contest.scene.bodies[0].motion) &&
         moves_straight(contest.scene.bodies[1].motion);
}

}  // namespace taut::bench
