#include "sign/fast_function.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/exact_sum.hpp"
#include "sign/form.hpp"
#include "sign/vanishing.hpp"

namespace taut {
namespace {

/// A vertex as the leg sees it.
Point seen(const Leg& leg, const DisplacedPoint& v, bool of_p) {
  const ExactVector& offset = leg.offset(of_p);
  return {v.x + offset.x, v.y + offset.y};
}

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
  // The displacement of a short edge may be more than what it rounds: the room counts for where that meets a long way.
  f.w = std::fabs(ex) + std::fabs(ey) + 0x1p54 * displacement_room;
  const double shift = leg.offset_size();
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
  f.floor_error = displacement_room * (size_a + size_c + f.w);
  return f;
}

bool FastFunction::level_one(const Leg& leg, const PairGeometry& g, const MixedTriple& triple, FastFunction& f) {
  if (leg.bridge) return false;
  const DisplacedPoint &pa = g.point(triple.a), &pb = g.point(triple.b), &pc = g.point(triple.c);
  if (leg.translation ? !vanishes(leg, pa, pb, pc, triple.pp) : !vanishes_before_displacement(leg, g, triple)) {
    return false;
  }
  constexpr double up = 0x1p200;
  const Point a = seen(leg, pa, triple.pp), c = seen(leg, pc, !triple.pp);
  // What the displacement changes in the edge and in the points, each times the rest.
  const FormPoints<double> edge{(pb.dx - pa.dx) * up, (pb.dy - pa.dy) * up, a.x, a.y, c.x, c.y};
  const FormPoints<double> points{pb.x - pa.x, pb.y - pa.y, pa.dx * up, pa.dy * up, pc.dx * up, pc.dy * up};
  const double w = std::fabs(points.ex) + std::fabs(points.ey), shift = leg.offset_size();
  const double size_a = std::fabs(pa.x) + std::fabs(pa.y) + shift, size_c = std::fabs(pc.x) + std::fabs(pc.y) + shift;
  const double way_a = std::fabs(points.ax) + std::fabs(points.ay), way_c = std::fabs(points.cx) + std::fabs(points.cy);
  f.pp = triple.pp;
  f.level1 = true;
  f.w = std::fabs(edge.ex) + std::fabs(edge.ey);
  const auto first = form_coefficients(triple.pp, edge), second = form_coefficients(triple.pp, points);
  f.a[1] = first[1];
  f.a[2] = first[2];
  if (leg.translation) {
    f.a[0] = edge.ex * (c.y - a.y) - edge.ey * (c.x - a.x) + points.ex * (points.cy - points.ay) -
             points.ey * (points.cx - points.ax);
    f.a[3] = f.a[4] = f.m34 = 0;
    f.m0 = f.w * (size_a + size_c) + w * (way_a + way_c);
  } else {
    f.a[0] = first[0] + second[0];
    f.a[3] = first[3] + second[3];
    f.a[4] = first[4] + second[4];
    f.m0 = f.w * size_a + w * way_a;
    f.m34 = f.w * size_c + w * way_c;
  }
  // The square of the displacement, scaled once.
  f.floor_error = displacement_room * (1 + size_a + size_c + f.w) * (1 + f.w + way_a + way_c);
  return true;
}

double FastFunction::root_of(const FrameModel& model, double t) const {
  const Lanes way = load_lanes(a + 1), angle = load_lanes(a + 3);
  double c[model_degree];
  for (int k = 0; k < model.terms; ++k) {
    const double* f = model.c[k];
    const Lanes sum = way * load_lanes(f + (pp ? 0 : 2)) + angle * load_lanes(f + 4);
    c[k] = sum[0] + sum[1];
  }
  c[0] += a[0];
  double h = t - model.middle;
  // By the root of the second order about h, whose distance from the polynomial's is of the third order.
  for (int step = 0; step < 6; ++step) {
    double value = 0, slope = 0, half_bend = 0;
    for (int k = model.terms; k-- > 0;) {
      half_bend = half_bend * h + slope;
      slope = slope * h + value;
      value = value * h + c[k];
    }
    const double discriminant = slope * slope - 4 * half_bend * value;
    const double change =
        discriminant > 0 ? 2 * value / (slope + std::copysign(std::sqrt(discriminant), slope)) : value / slope;
    h -= change;
    if (!(std::fabs(change) > 0x1p-14 * model.radius)) break;
  }
  return model.middle + h;
}

}  // namespace taut
