#include "sign/fast_function.hpp"

#include <algorithm>
#include <cmath>

#include "sign/vanishing.hpp"

namespace taut {
namespace {

/// Values and derivatives of the frame are wrong by 2^-49 of them, at least: so much more in a magnitude has room for
/// the displacement.
constexpr double displacement_as_rounding = 0x1p54 * displacement_room;

/// A vertex as the leg sees it.
Point seen(const Leg& leg, const DisplacedPoint& v, bool of_p) {
  const ExactVector& offset = leg.offset(of_p);
  return {v.x + offset.x, v.y + offset.y};
}

double size_of(const DisplacedPoint& v) { return std::fabs(v.x) + std::fabs(v.y); }

}  // namespace

FastFunction FastFunction::level_zero(const Leg& leg, const PairGeometry& g, const Form& form) {
  const DisplacedPoint &pa = g.point(form.a), &pb = g.point(form.b), &pc = g.point(form.c);
  const Point a = seen(leg, pa, form.pp), c = seen(leg, pc, !form.pp);
  FormPoints<double> points{pb.x - pa.x, pb.y - pa.y, a.x, a.y, c.x, c.y};
  points.measure(form.measure);
  FastFunction f;
  f.pp = form.pp;
  f.take(coefficients_on(leg, form.pp, points, 0.0));
  // The displacement of a short edge, or of a point near the origin, may be more than what it rounds.
  f.w = std::fabs(points.ex) + std::fabs(points.ey) + displacement_as_rounding;
  const double shift = leg.offset_size() + displacement_as_rounding;
  const double size_a = size_of(pa) + shift, size_c = size_of(pc) + shift;
  f.m0 = f.w * (leg.translation ? size_a + size_c : size_a);
  f.m34 = leg.translation ? 0 : f.w * size_c;
  f.floor_error = displacement_room * (size_a + size_c + f.w);
  return f;
}

bool FastFunction::level_one(const Leg& leg, const PairGeometry& g, const Form& form, FastFunction& f) {
  if (leg.bridge || !vanishes_before_displacement(leg, g, form)) return false;
  f = displacement_part(leg, g, form);
  return true;
}

FastFunction FastFunction::displacement_part(const Leg& leg, const PairGeometry& g, const Form& form) {
  const DisplacedPoint &pa = g.point(form.a), &pb = g.point(form.b), &pc = g.point(form.c);
  constexpr double up = 0x1p200;
  const Point a = seen(leg, pa, form.pp), c = seen(leg, pc, !form.pp);
  // What the displacement changes in the edge and in the points, each times the rest. The motion's terms have the edge
  // alone in them.
  FormPoints<double> edge{(pb.dx - pa.dx) * up, (pb.dy - pa.dy) * up, a.x, a.y, c.x, c.y};
  FormPoints<double> points{pb.x - pa.x, pb.y - pa.y, pa.dx * up, pa.dy * up, pc.dx * up, pc.dy * up};
  edge.measure(form.measure);
  points.measure(form.measure);
  if (form.measure == Measure::offset_x || form.measure == Measure::offset_y) edge.ex = edge.ey = 0;
  std::array<double, 5> sum = coefficients_on(leg, form.pp, edge, 0.0);
  const std::array<double, 5> more = coefficients_on(leg, form.pp, points, 0.0);
  for (const std::size_t i : {0, 3, 4}) sum[i] += more[i];
  const double w = std::fabs(points.ex) + std::fabs(points.ey), shift = leg.offset_size();
  const double size_a = size_of(pa) + shift, size_c = size_of(pc) + shift;
  const double way_a = std::fabs(points.ax) + std::fabs(points.ay), way_c = std::fabs(points.cx) + std::fabs(points.cy);
  FastFunction f;
  f.pp = form.pp;
  f.level1 = true;
  f.take(sum);
  f.w = std::fabs(edge.ex) + std::fabs(edge.ey);
  f.m0 = f.w * size_a + w * way_a;
  // And the square of it in the angle's coefficients, where points lie near the origin and edges are short.
  f.m34 = f.w * size_c + w * way_c + displacement_as_rounding * (1 + f.w) * (1 + way_c);
  if (leg.translation) {
    f.m0 += f.m34;
    f.m34 = 0;
  }
  // The square of the displacement, scaled once.
  f.floor_error = displacement_room * (1 + size_a + size_c + f.w) * (1 + f.w + way_a + way_c);
  return f;
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
