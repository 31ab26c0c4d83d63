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

void LegClock::evaluate_exactly(double t) {
  const Frame<double> f = frame(*leg_, Ball<double>::exact(t));
  pp_ = fast_side(f.for_pp);
  qq_ = fast_side(f.for_qq);
}

namespace {

/// Value and slope of two polynomials about the same middle.
struct PairValue {
  double x, y, dx, dy;
};
PairValue horner(const double* x, const double* y, double h) {
  PairValue r{x[model_degree - 1], y[model_degree - 1], 0, 0};
  for (int k = model_degree - 1; k-- > 0;) {
    r.dx = r.dx * h + r.x;
    r.x = r.x * h + x[k];
    r.dy = r.dy * h + r.y;
    r.y = r.y * h + y[k];
  }
  return r;
}

void fill(FastSide& s, const PairValue& a, const PairValue& b, const double* error, const double* error_d,
          double error_b, double error_bd) {
  s.f[0] = 1;
  s.d[0] = 0;
  s.f[1] = a.x;
  s.f[2] = a.y;
  s.f[3] = b.x;
  s.f[4] = b.y;
  s.d[1] = a.dx;
  s.d[2] = a.dy;
  s.d[3] = b.dx;
  s.d[4] = b.dy;
  s.size_0 = 1;
  s.size_0d = s.error_0 = s.error_0d = 0;
  s.size_a = std::fabs(a.x) + std::fabs(a.y);
  s.size_b = std::fabs(b.x) + std::fabs(b.y);
  s.size_ad = std::fabs(a.dx) + std::fabs(a.dy);
  s.size_bd = std::fabs(b.dx) + std::fabs(b.dy);
  s.error_a = *error;
  s.error_ad = *error_d;
  s.error_b = error_b;
  s.error_bd = error_bd;
}

}  // namespace

void LegClock::evaluate(double t) {
  cached_t_ = t;
  cached_ = true;
  if (leg_->bridge) return evaluate_exactly(t);
  const Model& m = model(segment(t));
  if (!m.sharp) return evaluate_exactly(t);
  const double h = t - m.middle;
  const PairValue a = horner(m.c[0], m.c[1], h), c = horner(m.c[2], m.c[3], h), b = horner(m.c[4], m.c[5], h);
  fill(pp_, a, b, m.error, m.error_d, m.error[2], m.error_d[2]);
  fill(qq_, c, b, m.error + 1, m.error_d + 1, m.error[2], m.error_d[2]);
}

namespace {

/// Bounds of one function over a segment of half width r, from its series at the middle and over the segment.
struct FunctionModel {
  double error = 0, error_d = 0, bend = 0, bend_rad = 0;
};

FunctionModel bound_function(const ModelSeries& at_middle, const ModelSeries& over, double r, double size_t,
                             double* coefficients) {
  constexpr int n = model_degree;
  FunctionModel f;
  double size = 0, size_d = 0, power = 1, power_d = 0, power_dd = 0;  // r^k, k r^(k-1), k (k-1) r^(k-2)
  for (int k = 0; k <= n; ++k) {
    const Ball<double>& c = k < n ? at_middle.c[k] : over.c[n];
    const double whole = k < n ? std::fabs(c.mid) : 0.0;
    const double unknown = k < n ? c.rad : std::fabs(c.mid) + c.rad;
    if (k < n) coefficients[k] = c.mid;
    f.error += unknown * power;
    f.error_d += unknown * power_d;
    size += whole * power;
    size_d += whole * power_d;
    if (k == 2) f.bend = 2 * c.mid;
    f.bend_rad += (k == 2 ? unknown : whole + unknown) * power_dd;
    power_dd = k >= 1 ? (k + 1.0) * k * std::pow(r, k - 1) : 0.0;
    power_d = (k + 1) * power;
    power *= r;
  }
  // Horner rounds 2 n times; h = t - middle rounds once, relative to the size of t: a shift of the instant.
  const double shift = size_t * 0x1p-52;
  f.error += 0x1p-53 * (2 * n + 4) * size + shift * (size_d + f.error_d);
  f.error_d += 0x1p-53 * (3 * n + 4) * size_d + shift * (std::fabs(f.bend) + f.bend_rad);
  f.error = f.error * (1 + 0x1p-40) + underflow_slack;
  f.error_d = f.error_d * (1 + 0x1p-40) + underflow_slack;
  f.bend_rad = (f.bend_rad + 0x1p-50 * std::fabs(f.bend)) * (1 + 0x1p-40) + underflow_slack;
  return f;
}

}  // namespace

void LegClock::make_bridge_model(Model& m) {
  const Frame<double> f = frame(*leg_, Ball<double>::between(0, 1));
  m.curvature_pp = fast_curvature(f.for_pp);
  m.curvature_qq = fast_curvature(f.for_qq);
}

void LegClock::make_model(std::size_t i) {
  Model& m = models_[i];
  m.ready = true;
  if (leg_->bridge) return make_bridge_model(m);
  const Ball<double> segment = Ball<double>::between(boundaries_[i], boundaries_[i + 1]);
  m.middle = segment.mid;
  const FrameOf<ModelSeries> at_middle = frame_series(*leg_, Ball<double>::exact(m.middle));
  const FrameOf<ModelSeries> over = frame_series(*leg_, segment);
  m.curvature_pp = m.curvature_qq = FastCurvature{};
  const double size_t = std::fabs(m.middle) + segment.rad;
  m.sharp = true;
  for (int k = 0; k < 6; ++k) {
    const bool second = k == 2 || k == 3;
    const std::size_t index = static_cast<std::size_t>(k < 2 ? k + 1 : (k < 4 ? k - 1 : k - 1));
    const auto& point = second ? at_middle.for_qq[index] : at_middle.for_pp[index];
    const auto& wide = second ? over.for_qq[index] : over.for_pp[index];
    const FunctionModel f = bound_function(point, wide, segment.rad, size_t, m.c[k]);
    double &error = m.error[k / 2], &error_d = m.error_d[k / 2];
    error = (k % 2 ? error : 0) + f.error;
    error_d = (k % 2 ? error_d : 0) + f.error_d;
    // Comparisons that a NaN fails: where the motion is singular there is no model.
    const double fair =
        0x1p-46 * (std::fabs(m.c[k][0]) + std::fabs(m.c[k][1]) * (segment.rad + 0x1p-6 * size_t)) + 0x1p-46;
    const double fair_d = 0x1p-42 * (1 + std::fabs(m.c[k][1])) / std::min(1.0, segment.rad);
    m.sharp = m.sharp && f.error <= fair && f.error_d <= fair_d;
    const bool known = std::isfinite(f.bend) && f.bend_rad < INFINITY;
    const double mid = known ? f.bend : 0, rad = known ? f.bend_rad : INFINITY;
    if (!second) m.curvature_pp.mid[index] = mid, m.curvature_pp.rad[index] = rad;
    if (k >= 2) m.curvature_qq.mid[index] = mid, m.curvature_qq.rad[index] = rad;
  }
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

void LegClock::make_segments(std::size_t n) {
  boundaries_.clear();
  for (std::size_t i = 0; i <= n; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(n);
    const double b = i == n ? leg_->end : leg_->start + (leg_->end - leg_->start) * share;
    if (boundaries_.empty() || b > boundaries_.back()) boundaries_.push_back(b);
  }
  if (boundaries_.size() < 2) boundaries_.push_back(leg_->end);
  boundaries_.back() = leg_->end;
  models_.assign(boundaries_.size() - 1, Model());
  const double span = leg_->end - leg_->start;
  segments_per_time_ = span > 0 ? static_cast<double>(models_.size()) / span : 0;
}

/// Looks at a few segments inside the leg (its ends may be singular).
bool LegClock::models_are_sharp() {
  const std::size_t n = models_.size();
  for (const std::size_t i : {n / 4, n / 2, (3 * n) / 4}) {
    if (!model(i).sharp) return false;
  }
  return true;
}

void LegClock::reset(const Leg& leg) {
  leg_ = &leg;
  linear_ = leg.translation && leg.degree <= 1;
  cached_ = false;
  std::size_t n = choose_segments();
  make_segments(n);
  if (leg.bridge || linear_) return;
  for (int halvings = 0; halvings < 4 && !models_are_sharp(); ++halvings) make_segments(n *= 2);
}

std::size_t LegClock::segment(double t) const {
  const std::size_t n = models_.size();
  if (n == 1) return 0;
  const double guess = (t - boundaries_[0]) * segments_per_time_;
  std::size_t i = guess > 0 ? static_cast<std::size_t>(guess) : 0;
  i = std::min(i, n - 1);
  while (i > 0 && t < boundaries_[i]) --i;
  while (i + 1 < n && t >= boundaries_[i + 1]) ++i;
  return i;
}

}  // namespace taut
