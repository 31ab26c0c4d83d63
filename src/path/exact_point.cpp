#include "path/exact_point.hpp"

#include <algorithm>
#include <cmath>

namespace taut::internal::path {
namespace {

AxisBox enlarged(const AxisBox& box) {
  const double margin =
      0x1p-48 * std::max({std::fabs(box.lo_x), std::fabs(box.lo_y), std::fabs(box.hi_x), std::fabs(box.hi_y)});
  return {box.lo_x - margin, box.lo_y - margin, box.hi_x + margin, box.hi_y + margin};
}

/// A line, or a point, in homogeneous coordinates.
struct Triple {
  Dyadic x, y, w;
};

Triple cross(const Triple& a, const Triple& b) {
  return {a.y * b.w - a.w * b.y, a.w * b.x - a.x * b.w, a.x * b.y - a.y * b.x};
}

Triple triple(const ExactPoint& p) { return {p.x, p.y, p.w}; }

/// The vector from a to b, times both weights.
Triple vector_between(const ExactPoint& a, const ExactPoint& b) {
  return {b.x * a.w - a.x * b.w, b.y * a.w - a.y * b.w, {}};
}

Dyadic dot(const Triple& u, const Triple& v) { return u.x * v.x + u.y * v.y; }

/// Of points on a line: is p not beyond a or b?
bool between(const ExactPoint& p, const ExactPoint& a, const ExactPoint& b) {
  return dot(vector_between(p, a), vector_between(p, b)).sign() <= 0;
}

}  // namespace

double nearest_quotient(const Dyadic& a, const Dyadic& b) {
  if (a.is_zero()) return 0;
  return RealTraits<RealMax>::to_double(first_bits<RealMax>(a) / first_bits<RealMax>(b));
}

ExactPoint ExactPoint::of(Dyadic x, Dyadic y) {
  const Point near{nearest_double(x), nearest_double(y)};
  return {std::move(x), std::move(y), Dyadic(1, 0), near};
}

ExactPoint ExactPoint::of(Dyadic x, Dyadic y, Dyadic w) {
  if (w.sign() < 0) return of(-x, -y, -w);
  const Point near{nearest_quotient(x, w), nearest_quotient(y, w)};
  return {std::move(x), std::move(y), std::move(w), near};
}

int turn_sign(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  const double left = (b.near.x - a.near.x) * (c.near.y - a.near.y),
               right = (b.near.y - a.near.y) * (c.near.x - a.near.x);
  // With s the largest coordinate, each of these is off by 2^-51 s at the most, each difference by 1.25 * 2^-50 s, each
  // product by 5.5 * 2^-50 s^2.
  const double size = std::max({std::fabs(a.near.x), std::fabs(a.near.y), std::fabs(b.near.x), std::fabs(b.near.y),
                                std::fabs(c.near.x), std::fabs(c.near.y)});
  if (std::fabs(left - right) > 0x1p-46 * size * size) return left > right ? 1 : -1;
  const Triple line = cross(triple(a), triple(b));
  return (line.x * c.x + line.y * c.y + line.w * c.w).sign();
}

bool same(const ExactPoint& a, const ExactPoint& b) { return a.x * b.w == b.x * a.w && a.y * b.w == b.y * a.w; }

std::optional<ExactPoint> line_meeting(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                                       const ExactPoint& d) {
  const Triple p = cross(cross(triple(a), triple(b)), cross(triple(c), triple(d)));
  if (p.w.is_zero()) return std::nullopt;
  return ExactPoint::of(p.x, p.y, p.w);
}

std::optional<ExactPoint> meeting_point(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                                        const ExactPoint& d) {
  if (turn_sign(a, b, c) * turn_sign(a, b, d) > 0 || turn_sign(c, d, a) * turn_sign(c, d, b) > 0) return std::nullopt;
  return line_meeting(a, b, c, d);
}

std::optional<ExactPoint> foot_point(const ExactPoint& p, const ExactPoint& a, const ExactPoint& b) {
  const Triple e = vector_between(a, b);
  const Dyadic along = dot(vector_between(a, p), e);
  if (along.sign() < 0 || dot(vector_between(b, p), e).sign() > 0) return std::nullopt;
  const Dyadic scale = p.w * dot(e, e);
  if (scale.is_zero()) return std::nullopt;
  return ExactPoint::of(a.x * scale + e.x * along, a.y * scale + e.y * along, a.w * scale);
}

ConvexRing without_repeated(const ConvexRing& ring) {
  ConvexRing kept;
  for (const ExactPoint& p : ring) {
    if (kept.empty() || !same(kept.back(), p)) kept.push_back(p);
  }
  while (kept.size() > 1 && same(kept.front(), kept.back())) kept.pop_back();
  return kept;
}

bool contains(const ConvexRing& ring, const ExactPoint& p) {
  if (ring.size() == 1) return same(ring[0], p);
  if (ring.size() == 2) return turn_sign(ring[0], ring[1], p) == 0 && between(p, ring[0], ring[1]);
  for (std::size_t k = 0; k < ring.size(); ++k) {
    if (turn_sign(ring[k], ring[(k + 1) % ring.size()], p) < 0) return false;
  }
  return true;
}

/// Corners that come twice in a row make no edge.
bool is_inside(const ConvexRing& ring, const ExactPoint& p) {
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const ExactPoint &a = ring[k], &b = ring[(k + 1) % ring.size()];
    if (turn_sign(a, b, p) <= 0 && !same(a, b)) return false;
  }
  return true;
}

ExactPoint rounded_middle(const ConvexRing& ring) {
  double x = 0, y = 0;
  for (const ExactPoint& p : ring) {
    x += p.near.x / static_cast<double>(ring.size());
    y += p.near.y / static_cast<double>(ring.size());
  }
  return ExactPoint::of(Dyadic::exact(x), Dyadic::exact(y));
}

AxisBox bounds_of(const ConvexRing& ring) {
  AxisBox box;
  for (const ExactPoint& p : ring) box.include(p.near);
  return enlarged(box);
}

AxisBox bounds_of(const ExactPoint& a, const ExactPoint& b) { return enlarged(AxisBox(a.near, b.near)); }

}  // namespace taut::internal::path
