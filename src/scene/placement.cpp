#include "scene/placement.hpp"

#include <cmath>
#include <iterator>
#include <type_traits>

#include "numeric/budget.hpp"
#include "numeric/errors.hpp"
#include "numeric/stages.hpp"

namespace taut::internal {
namespace {

/// The sweep runs along (1, tilt).
constexpr double tilt = 0.4390625173;
/// In units of checkpoint().
constexpr std::uint64_t work_of_precise = 16;
static_assert(1 + tilt * tilt < Placement::steepest_key * Placement::steepest_key);

}  // namespace

Placement::Placement(const PairGeometry& geometry, const MotionSegment& segment, double t, Positions positions)
    : geometry_(&geometry), segment_(&segment), t_(t) {
  const Frame<double> f = frame(segment, Ball<double>::exact(t));
  set_poses(f);
  set_bounds(f);
  if (positions == Positions::tabulated) tabulate();
}

void Placement::set_poses(const Frame<double>& f) {
  const double ax = f.for_pp[1].v.mid, ay = f.for_pp[2].v.mid, c = f.for_pp[3].v.mid, s = f.for_pp[4].v.mid;
  const double qx = segment_->offset_q.x, qy = segment_->offset_q.y;
  pose_p_ = {1, 0, segment_->offset_p.x, segment_->offset_p.y};
  pose_q_ = {c, s, ax + (c * qx - s * qy), ay + (s * qx + c * qy)};
  before_turn_ = {qx, qy};
  after_turn_ = {ax, ay};
}

double Placement::key_at(const Point& p) { return p.x + tilt * p.y; }

void Placement::tabulate() {
  const std::uint32_t n = size() + 4;
  std::vector<Point> positions(n);
  keys_.resize(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    positions[i] = compute(VertexId(i));
    keys_[i] = key_at(positions[i]);
  }
  positions_ = std::move(positions);
}

/// The box around everything, and the bounds of errors that follow from its size.
void Placement::set_bounds(const Frame<double>& f) {
  const DisplacedPolygon &p = *geometry_->p(), &q = *geometry_->q();
  AxisBox all;
  const auto include = [&all](const DisplacedPolygon& polygon, const RoundedPose& pose) {
    if (polygon.points.empty()) return;
    for (const double x : {polygon.bounds.lo_x, polygon.bounds.hi_x}) {
      for (const double y : {polygon.bounds.lo_y, polygon.bounds.hi_y}) {
        all.include(pose.x + (pose.c * x - pose.s * y), pose.y + (pose.s * x + pose.c * y));
      }
    }
  };
  include(p, pose_p_);
  include(q, pose_q_);
  // Rounding: each coordinate is a sum of at most five terms, each at most `size`, after at most six operations; the
  // displacement is far below. The frame's own error is added.
  const double local = std::max(p.largest, q.largest);
  const double far_x = std::fabs(pose_p_.x) + std::fabs(before_turn_.x);
  const double far_y = std::fabs(pose_p_.y) + std::fabs(before_turn_.y);
  const double size = local + far_x + far_y + std::fabs(after_turn_.x) + std::fabs(after_turn_.y);
  const double frame_error = std::max(f.for_pp[1].v.rad, f.for_pp[2].v.rad) +
                             (f.for_pp[3].v.rad + f.for_pp[4].v.rad) * (local + far_x + far_y);
  error_ = 16 * 0x1p-53 * size + frame_error + displacement_room;
  // A box around everything, with irregular corners, which are far enough out for what rounding adds.
  const double w = std::max({all.hi_x - all.lo_x, all.hi_y - all.lo_y, 1e-3 * size}), x0 = all.lo_x, y0 = all.lo_y;
  corners_ = {{{x0 - 5.137 * w, y0 - 4.871 * w},
               {x0 + 7.213 * w, y0 - 5.377 * w},
               {x0 + 6.911 * w, y0 + 7.093 * w},
               {x0 - 5.653 * w, y0 + 6.759 * w}}};
  double far = 0;
  for (const Point& v : corners_) far = std::max({far, std::fabs(v.x), std::fabs(v.y)});
  coarse_bound_ = orientation_bound(8 * far * far, 8 * far, far);
  key_error_ = 4 * error_ + 32 * 0x1p-53 * (size + 20 * w);
}

/// Of the determinant of two differences of positions: from the sum of its products' sizes, of the differences' sizes,
/// and the largest coordinate of the point from which they are taken.
double Placement::orientation_bound(double products, double differences, double coordinate) const {
  const double e = error_ + 0x1p-51 * coordinate;
  return 0x1p-50 * products + 2.5 * e * differences + 16 * e * e;
}

int Placement::orientation(VertexId a, VertexId b, VertexId c) const {
  const Point pa = approximate(a), pb = approximate(b), pc = approximate(c);
  const double ux = pb.x - pa.x, uy = pb.y - pa.y, vx = pc.x - pa.x, vy = pc.y - pa.y;
  const double left = ux * vy, right = uy * vx, det = left - right;
  if (det > coarse_bound_) return 1;
  if (-det > coarse_bound_) return -1;
  return close_orientation(a, b, c);
}

/// Where the bound for the largest distances does not decide.
int Placement::close_orientation(VertexId a, VertexId b, VertexId c) const {
  const std::uint32_t np = geometry_->np, n = size();
  const auto owner = [np, n](VertexId v) { return v.value < np ? 0 : (v.value < n ? 1 : 2); };
  const int oa = owner(a);
  const bool rigid = oa == owner(b) && oa == owner(c) && oa != 2;
  const Point pa = approximate(a), pb = approximate(b), pc = approximate(c);
  const double ux = pb.x - pa.x, uy = pb.y - pa.y, vx = pc.x - pa.x, vy = pc.y - pa.y;
  const double left = ux * vy, right = uy * vx, det = left - right;
  const double bound = orientation_bound(std::fabs(left) + std::fabs(right),
                                         std::fabs(ux) + std::fabs(uy) + std::fabs(vx) + std::fabs(vy),
                                         std::max(std::fabs(pa.x), std::fabs(pa.y)));
  if (det > bound) return 1;
  if (-det > bound) return -1;
  if (rigid) {
    if (const int s = geometry_->rigid_orientation(a, b, c)) return s;
    throw Undecidable{"three vertices of one body are collinear even after the displacement"};
  }
  return precise_orientation(a, b, c);
}

int Placement::precise_orientation(VertexId a, VertexId b, VertexId c) const {
  // Turned so that the least is first, and mirrored so that the greatest is last.
  while (b < a || c < a) std::tie(a, b, c) = std::tuple(b, c, a);
  const bool mirrored = c < b;
  if (mirrored) std::swap(b, c);
  if (held_signs_.empty()) held_signs_.resize(signs_to_hold);
  const std::size_t place = a.value * std::size_t{0x9e3779b1} + b.value * std::size_t{0x85ebca77} + c.value;
  HeldSign& held = held_signs_[(place >> 7 ^ place) % signs_to_hold];
  if (held.a != a || held.b != b || held.c != c) {
    const int sign = precise_sign("the orientation of three vertices", [&](auto zero) {
      using N = decltype(zero);
      N ax, ay, bx, by, cx, cy;
      position(a, ax, ay);
      position(b, bx, by);
      position(c, cx, cy);
      return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
    });
    held = {a, b, c, sign};
  }
  return mirrored ? -held.sign : held.sign;
}

bool Placement::before(VertexId a, VertexId b) const {
  const double d = key(a) - key(b);
  if (d > key_error_) return false;
  if (-d > key_error_) return true;
  if (a == b) return false;
  return precise_sign("the order of two vertices along the sweep", [&](auto zero) {
           using N = decltype(zero);
           N ax, ay, bx, by;
           position(a, ax, ay);
           position(b, bx, by);
           return (ax - bx) + (ay - by) * N::exact(tilt);
         }) < 0;
}

template <class N>
const Placement::PoseIn<N>& Placement::pose_in() const {
  auto& pose = std::get<std::optional<PoseIn<N>>>(poses_);
  if (pose) return *pose;
  if constexpr (std::is_same_v<N, FixedBall>) {
    const PoseIn<Ball<Real320>>& from = pose_in<Ball<Real320>>();
    pose = {FixedBall::of(from.x), FixedBall::of(from.y), FixedBall::of(from.c), FixedBall::of(from.s)};
  } else {
    const auto f = frame_values(*segment_, N::exact(t_)).for_pp;
    pose = {f[1], f[2], f[3], f[4]};
  }
  return *pose;
}

template <class N>
void Placement::position(VertexId v, N& x, N& y) const {
  if constexpr (std::is_same_v<N, FixedBall>) {
    if (held_.empty()) held_.resize(places_to_hold);
    Held& held = held_[v.value % places_to_hold];
    if (held.vertex != v) {
      held.vertex = VertexId();
      find_position(v, held.x, held.y);
      held.vertex = v;
    }
    x = held.x;
    y = held.y;
  } else {
    find_position(v, x, y);
  }
}

template <class N>
void Placement::find_position(VertexId v, N& x, N& y) const {
  if (v.value >= size()) {
    x = N::exact(corners_[v.value - size()].x);
    y = N::exact(corners_[v.value - size()].y);
    return;
  }
  const DisplacedPoint& p = geometry_->point(v);
  const bool of_p = v.value < geometry_->np;
  N px = N::exact(p.x) + N::exact(p.dx), py = N::exact(p.y) + N::exact(p.dy);
  add_offset(*segment_, of_p, px, py);
  if (of_p) {
    x = px;
    y = py;
    return;
  }
  const PoseIn<N>& pose = pose_in<N>();
  x = pose.x + pose.c * px - pose.s * py;
  y = pose.y + pose.s * px + pose.c * py;
}

template <class Quantity>
int Placement::precise_sign(const char* what, const Quantity& quantity) const {
  count_work(work_of_precise);
  const auto decided_by = [this](Stage stage, int sign) {
    if (sign != 0) stages_.add(stage);
    return sign;
  };
  if (const int s = decided_by(Stage::fixed, quantity(FixedBall()).sign())) return s;
  return decide(what, [&](Stage stage) {
    const auto sign = [&](auto zero) { return quantity(Ball<decltype(zero)>()).sign(); };
    return decided_by(stage, with_stage(stage, sign));
  });
}

}  // namespace taut::internal
