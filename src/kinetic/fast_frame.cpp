#include "kinetic/fast_frame.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/exact_sum.hpp"

namespace taut {
namespace {

FastSide fast_side(const std::array<Jet<double>, 5>& j) {
  FastSide s{};
  for (int i = 0; i < 5; ++i) {
    s.f[i] = j[i].v.mid;
    s.d[i] = j[i].d.mid;
  }
  const auto size = [](const Ball<double>& b) { return std::fabs(b.mid); };
  s.size_0 = size(j[0].v);
  s.size_a = size(j[1].v) + size(j[2].v);
  s.size_b = size(j[3].v) + size(j[4].v);
  s.size_0d = size(j[0].d);
  s.size_ad = size(j[1].d) + size(j[2].d);
  s.size_bd = size(j[3].d) + size(j[4].d);
  s.error_0 = j[0].v.rad;
  s.error_a = j[1].v.rad + j[2].v.rad;
  s.error_b = j[3].v.rad + j[4].v.rad;
  s.error_0d = j[0].d.rad;
  s.error_ad = j[1].d.rad + j[2].d.rad;
  s.error_bd = j[3].d.rad + j[4].d.rad;
  return s;
}

FastCurvature fast_curvature(const std::array<Jet<double>, 5>& j) {
  FastCurvature c{};
  for (int i = 0; i < 5; ++i) {
    c.mid[i] = j[i].dd.mid;
    c.rad[i] = j[i].dd.rad;
    if (!(c.rad[i] < INFINITY) || !std::isfinite(c.mid[i])) {
      c.mid[i] = 0;
      c.rad[i] = INFINITY;
    }
  }
  return c;
}

/// A vertex as the leg sees it: the shift of a body that does not turn is part of its coordinates.
Point seen(const Leg& leg, const DisplacedPoint& v, bool of_p) {
  if (of_p && leg.shift_p) return {v.x - leg.shift.x, v.y - leg.shift.y};
  if (!of_p && leg.shift_q) return {v.x + leg.shift.x, v.y + leg.shift.y};
  return {v.x, v.y};
}

double coefficient(const Coefficients& c, std::size_t k) { return k < c.size() ? c[k] : 0.0; }

/// Is (b - a) x (c - a + D(t)) the zero polynomial? D's constant part is the shift.
bool vanishes(const Leg& leg, const DisplacedPoint& a, const DisplacedPoint& b, const DisplacedPoint& c, bool pp) {
  const double side = pp ? 1 : -1;
  // a x b + (b - a) x c with c shifted: see MixedTriple; the shift of P is minus that of Q.
  ExactSum<32> constant;
  constant.add_product(a.x, b.y);
  constant.subtract_product(a.y, b.x);
  const double xs[3] = {c.x, side * leg.shift.x, side * leg.shift.x_low};
  const double ys[3] = {c.y, side * leg.shift.y, side * leg.shift.y_low};
  for (int i = 0; i < 3; ++i) {
    constant.add_product(b.x, ys[i]);
    constant.subtract_product(a.x, ys[i]);
    constant.subtract_product(b.y, xs[i]);
    constant.add_product(a.y, xs[i]);
  }
  if (!constant.is_zero()) return false;
  const std::size_t n = std::max({leg.p.x.size(), leg.p.y.size(), leg.q.x.size(), leg.q.y.size()});
  for (std::size_t k = 1; k < n; ++k) {
    ExactSum<16> sum;
    for (const bool of_q : {false, true}) {
      const double x = coefficient(of_q ? leg.q.x : leg.p.x, k), y = coefficient(of_q ? leg.q.y : leg.p.y, k);
      const double s = of_q ? 1 : -1;
      sum.add_product(b.x, s * y);
      sum.subtract_product(a.x, s * y);
      sum.subtract_product(b.y, s * x);
      sum.add_product(a.y, s * x);
    }
    if (!sum.is_zero()) return false;
  }
  return true;
}

}  // namespace

FastFunction FastFunction::level_zero(const Leg& leg, const PairGeometry& g, const MixedTriple& triple,
                                      Measure measure) {
  const DisplacedPoint &pa = g.point(triple.a), &pb = g.point(triple.b), &pc = g.point(triple.c);
  double ex = pb.x - pa.x, ey = pb.y - pa.y;
  if (measure == Measure::projection) {
    const double turn = ex;
    ex = ey;
    ey = -turn;
  }
  const Point a = seen(leg, pa, triple.pp), c = seen(leg, pc, !triple.pp);
  const double side = triple.pp ? 1 : -1;
  FastFunction f;
  f.pp = triple.pp;
  f.a[1] = -ey * side;
  f.a[2] = ex * side;
  f.w = std::fabs(ex) + std::fabs(ey);
  const double shift = leg.shift_p || leg.shift_q ? std::fabs(leg.shift.x) + std::fabs(leg.shift.y) : 0;
  const double size_a = std::fabs(pa.x) + std::fabs(pa.y) + shift, size_c = std::fabs(pc.x) + std::fabs(pc.y) + shift;
  if (leg.translation) {
    f.a[0] = ex * (c.y - a.y) - ey * (c.x - a.x);
    f.a[3] = f.a[4] = 0;
    f.m34 = 0;
    f.m0 = f.w * (size_a + size_c);
  } else {
    f.a[0] = ey * a.x - ex * a.y;
    f.a[3] = ex * c.y - ey * c.x;
    f.a[4] = (ex * c.x + ey * c.y) * side;
    f.m0 = f.w * size_a;
    f.m34 = f.w * size_c;
  }
  f.floor_error = 0x1p-150 * (size_a + size_c + f.w);
  return f;
}

bool FastFunction::level_one(const Leg& leg, const PairGeometry& g, const MixedTriple& triple, FastFunction& f) {
  if (!leg.translation) return false;
  const DisplacedPoint &pa = g.point(triple.a), &pb = g.point(triple.b), &pc = g.point(triple.c);
  if (!vanishes(leg, pa, pb, pc, triple.pp)) return false;
  constexpr double up = 0x1p200;
  const double ex = pb.x - pa.x, ey = pb.y - pa.y;
  const double dex = (pb.dx - pa.dx) * up, dey = (pb.dy - pa.dy) * up;
  const double dcx = (pc.dx - pa.dx) * up, dcy = (pc.dy - pa.dy) * up;
  const Point a = seen(leg, pa, triple.pp), c = seen(leg, pc, !triple.pp);
  const double side = triple.pp ? 1 : -1;
  f.pp = triple.pp;
  f.level1 = true;
  f.a[0] = dex * (c.y - a.y) - dey * (c.x - a.x) + ex * dcy - ey * dcx;
  f.a[1] = -dey * side;
  f.a[2] = dex * side;
  f.a[3] = f.a[4] = f.m34 = 0;
  f.w = std::fabs(dex) + std::fabs(dey);
  const double shift = std::fabs(leg.shift.x) + std::fabs(leg.shift.y);
  const double size = std::fabs(pa.x) + std::fabs(pa.y) + std::fabs(pc.x) + std::fabs(pc.y) + 2 * shift;
  f.m0 = f.w * size + (std::fabs(ex) + std::fabs(ey)) * (std::fabs(dcx) + std::fabs(dcy));
  f.floor_error = 0x1p-150 * (size + f.w) * (1 + f.w);
  return true;
}

void LegClock::evaluate(double t) {
  const Frame<double> f = frame(*leg_, Ball<double>::exact(t));
  pp_ = fast_side(f.for_pp);
  qq_ = fast_side(f.for_qq);
  cached_t_ = t;
}

/// Enough segments that the frame turns by little in each; only speed depends on the choice.
std::size_t LegClock::choose_segments() const {
  if (linear_ || leg_->bridge) return 1;
  if (leg_->translation) return 16;
  constexpr int samples = 32;
  double turn = 0;
  for (int i = 0; i < samples; ++i) {
    const double t = leg_->start + (leg_->end - leg_->start) * ((i + 0.5) / samples);
    const Frame<double> f = frame(*leg_, Ball<double>::exact(t));
    double speed = 0;
    for (const auto* side : {&f.for_pp, &f.for_qq}) {
      for (int k = 1; k < 5; ++k) {
        const double scale = k < 3 ? std::fabs((*side)[1].v.mid) + std::fabs((*side)[2].v.mid) + 1e-3 : 1.0;
        const double d = std::fabs((*side)[k].d.mid) / scale;
        if (std::isfinite(d)) speed = std::max(speed, d);
      }
    }
    turn += speed * (leg_->end - leg_->start) / samples;
  }
  return static_cast<std::size_t>(std::clamp(turn * 8, 8.0, 20000.0));
}

void LegClock::reset(const Leg& leg) {
  leg_ = &leg;
  linear_ = leg.translation && leg.degree <= 1;
  evaluate(leg.start);
  const std::size_t n = choose_segments();
  boundaries_.clear();
  for (std::size_t i = 0; i <= n; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(n);
    const double b = i == n ? leg.end : leg.start + (leg.end - leg.start) * share;
    if (boundaries_.empty() || b > boundaries_.back()) boundaries_.push_back(b);
  }
  if (boundaries_.size() < 2) boundaries_.push_back(leg.end);
  boundaries_.back() = leg.end;
  curvature_pp_.clear();
  curvature_qq_.clear();
  for (std::size_t i = 0; i + 1 < boundaries_.size(); ++i) {
    const Frame<double> f = frame(leg, Ball<double>::between(boundaries_[i], boundaries_[i + 1]));
    curvature_pp_.push_back(fast_curvature(f.for_pp));
    curvature_qq_.push_back(fast_curvature(f.for_qq));
  }
}

std::size_t LegClock::segment(double t) const {
  const std::size_t n = boundaries_.size() - 1;
  const double span = boundaries_[n] - boundaries_[0];
  auto i = span > 0 ? static_cast<std::size_t>(std::max(0.0, (t - boundaries_[0]) / span * static_cast<double>(n))) : 0;
  i = std::min(i, n - 1);
  while (i > 0 && t < boundaries_[i]) --i;
  while (i + 1 < n && t >= boundaries_[i + 1]) ++i;
  return i;
}

}  // namespace taut
