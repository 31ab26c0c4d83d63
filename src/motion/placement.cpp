#include "motion/placement.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace taut {
namespace {

/// The sweep runs along (1, tilt).
constexpr double tilt = 0.4390625173;

}  // namespace

std::string not_decided(const Undecidable& limit) {
  return fmt::format("not decided at {} bits: {}", precision_ladder[std::size(precision_ladder) - 1], limit.what);
}

Placement::Placement(const PairGeometry& geometry, const Leg& leg, double t) : geometry_(&geometry), leg_(&leg), t_(t) {
  const Frame<double> f = frame(leg, Ball<double>::exact(t));
  const std::uint32_t n = geometry.size();
  positions_.resize(n + 4);
  keys_.resize(n + 4);
  const double ax = f.for_pp[1].v.mid, ay = f.for_pp[2].v.mid, c = f.for_pp[3].v.mid, s = f.for_pp[4].v.mid;
  const double px = leg.offset_p.x, py = leg.offset_p.y, qx = leg.offset_q.x, qy = leg.offset_q.y;
  pose_p_ = {1, 0, px, py};
  pose_q_ = {c, s, ax + (c * qx - s * qy), ay + (s * qx + c * qy)};
  double lo_x = INFINITY, lo_y = INFINITY, hi_x = -INFINITY, hi_y = -INFINITY, local = 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    const DisplacedPoint& v = geometry.points[i];
    Point& p = positions_[i];
    if (i < geometry.np) {
      p = {v.x + px, v.y + py};
    } else {
      const double x = v.x + qx, y = v.y + qy;
      p = {ax + (c * x - s * y), ay + (s * x + c * y)};
    }
    local = std::max({local, std::fabs(v.x), std::fabs(v.y)});
    lo_x = std::min(lo_x, p.x);
    hi_x = std::max(hi_x, p.x);
    lo_y = std::min(lo_y, p.y);
    hi_y = std::max(hi_y, p.y);
  }
  // Rounding: each coordinate is a sum of at most five terms, each at most `size`, after at most six operations; the
  // displacement is far below. The frame's own error is added.
  const double far_x = std::fabs(px) + std::fabs(qx), far_y = std::fabs(py) + std::fabs(qy);
  const double size = local + far_x + far_y + std::fabs(ax) + std::fabs(ay);
  const double frame_error = std::max(f.for_pp[1].v.rad, f.for_pp[2].v.rad) +
                             (f.for_pp[3].v.rad + f.for_pp[4].v.rad) * (local + far_x + far_y);
  error_ = 16 * 0x1p-53 * size + frame_error + 0x1p-150;
  // A box around everything, with irregular corners.
  const double w = std::max({hi_x - lo_x, hi_y - lo_y, 1e-3 * size}), x0 = lo_x, y0 = lo_y;
  positions_[n] = {x0 - 5.137 * w, y0 - 4.871 * w};
  positions_[n + 1] = {x0 + 7.213 * w, y0 - 5.377 * w};
  positions_[n + 2] = {x0 + 6.911 * w, y0 + 7.093 * w};
  positions_[n + 3] = {x0 - 5.653 * w, y0 + 6.759 * w};
  for (std::uint32_t i = 0; i < n + 4; ++i) keys_[i] = positions_[i].x + tilt * positions_[i].y;
  key_error_ = 4 * error_ + 32 * 0x1p-53 * (size + 20 * w);
}

int Placement::orientation(VertexId a, VertexId b, VertexId c) const {
  const std::uint32_t np = geometry_->np, n = size();
  const auto owner = [np, n](VertexId v) { return v.value < np ? 0 : (v.value < n ? 1 : 2); };
  const int oa = owner(a);
  const bool rigid = oa == owner(b) && oa == owner(c) && oa != 2;
  const Point &pa = positions_[a.value], &pb = positions_[b.value], &pc = positions_[c.value];
  const double ux = pb.x - pa.x, uy = pb.y - pa.y, vx = pc.x - pa.x, vy = pc.y - pa.y;
  const double left = ux * vy, right = uy * vx, det = left - right;
  const double e = error_ + 0x1p-52 * (std::fabs(pa.x) + std::fabs(pa.y));
  const double bound = 0x1p-50 * (std::fabs(left) + std::fabs(right)) +
                       2.5 * e * (std::fabs(ux) + std::fabs(uy) + std::fabs(vx) + std::fabs(vy)) + 16 * e * e;
  if (det > bound) return 1;
  if (-det > bound) return -1;
  if (rigid) {
    if (const int s = geometry_->rigid_orientation(a, b, c)) return s;
    throw Undecidable{"three vertices of one body are collinear even after the displacement"};
  }
  return precise_orientation(a, b, c);
}

bool Placement::before(VertexId a, VertexId b) const {
  const double d = keys_[a.value] - keys_[b.value];
  if (d > key_error_) return false;
  if (-d > key_error_) return true;
  if (a == b) return false;
  ++precise_calls_;
  if (const int s = order_at<Real320>(a, b)) return s < 0;
  if (const int s = order_at<Real640>(a, b)) return s < 0;
  if (const int s = order_at<Real960>(a, b)) return s < 0;
  throw Undecidable{"the order of two vertices along the sweep"};
}

template <>
const Frame<Real320>& Placement::frame_at<Real320>() const {
  if (!frame320_) frame320_ = frame(*leg_, Ball<Real320>::exact(t_));
  return *frame320_;
}
template <>
const Frame<Real640>& Placement::frame_at<Real640>() const {
  if (!frame640_) frame640_ = frame(*leg_, Ball<Real640>::exact(t_));
  return *frame640_;
}
template <>
const Frame<Real960>& Placement::frame_at<Real960>() const {
  if (!frame960_) frame960_ = frame(*leg_, Ball<Real960>::exact(t_));
  return *frame960_;
}

template <class Real>
void Placement::position(VertexId v, const Frame<Real>& f, Ball<Real>& x, Ball<Real>& y) const {
  using B = Ball<Real>;
  if (v.value >= size()) {
    x = B::exact(positions_[v.value].x);
    y = B::exact(positions_[v.value].y);
    return;
  }
  const DisplacedPoint& p = geometry_->points[v.value];
  const bool of_p = v.value < geometry_->np;
  B px = B::exact(p.x) + B::exact(p.dx), py = B::exact(p.y) + B::exact(p.dy);
  add_offset(*leg_, of_p, px, py);
  if (of_p) {
    x = px;
    y = py;
    return;
  }
  const B &c = f.for_pp[3].v, &sine = f.for_pp[4].v;
  x = f.for_pp[1].v + c * px - sine * py;
  y = f.for_pp[2].v + sine * px + c * py;
}

template <class Real>
int Placement::orientation_at(VertexId a, VertexId b, VertexId c) const {
  const Frame<Real>& f = frame_at<Real>();
  Ball<Real> ax, ay, bx, by, cx, cy;
  position(a, f, ax, ay);
  position(b, f, bx, by);
  position(c, f, cx, cy);
  return ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)).sign();
}

template <class Real>
int Placement::order_at(VertexId a, VertexId b) const {
  const Frame<Real>& f = frame_at<Real>();
  Ball<Real> ax, ay, bx, by;
  position(a, f, ax, ay);
  position(b, f, bx, by);
  return ((ax - bx) + (ay - by) * tilt).sign();
}

int Placement::precise_orientation(VertexId a, VertexId b, VertexId c) const {
  ++precise_calls_;
  if (const int s = orientation_at<Real320>(a, b, c)) return s;
  if (const int s = orientation_at<Real640>(a, b, c)) return s;
  if (const int s = orientation_at<Real960>(a, b, c)) return s;
  throw Undecidable{"the orientation of three vertices"};
}

}  // namespace taut
