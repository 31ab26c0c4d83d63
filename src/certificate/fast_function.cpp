#include "certificate/fast_function.hpp"

#include <algorithm>
#include <cmath>

#include "certificate/certificate_function.hpp"

namespace taut::internal {
namespace {

/// Values and derivatives of the frame have a relative error of at least 2^-49. Increasing a magnitude by this much
/// leaves room for the displacement.
constexpr double displacement_as_rounding = 0x1p54 * displacement_room;

/// A vertex in the coordinates of the segment.
Point seen(const MotionSegment& segment, const DisplacedPoint& v, bool of_p) {
  const ExactVector& offset = segment.offset(of_p);
  return {v.x + offset.x, v.y + offset.y};
}

double size_of(const DisplacedPoint& v) { return std::fabs(v.x) + std::fabs(v.y); }

}  // namespace

FastFunction FastFunction::undisplaced(const MotionSegment& segment, const PairGeometry& g,
                                       const CertificateFunction& function) {
  const DisplacedPoint &pa = g.point(function.a), &pb = g.point(function.b), &pc = g.point(function.c);
  const Point a = seen(segment, pa, function.pp), c = seen(segment, pc, !function.pp);
  FunctionPoints<double> points{pb.x - pa.x, pb.y - pa.y, a.x, a.y, c.x, c.y};
  points.measure(function.measure);
  FastFunction f;
  f.pp = function.pp;
  f.take(coefficients_on(segment, function.pp, points, 0.0));
  // The displacement of a short edge, or of a point near the origin, may exceed its rounding error.
  f.w = std::fabs(points.ex) + std::fabs(points.ey) + displacement_as_rounding;
  const double shift = segment.offset_size() + displacement_as_rounding;
  const double size_a = size_of(pa) + shift, size_c = size_of(pc) + shift;
  f.m0 = f.w * (segment.translation ? size_a + size_c : size_a);
  f.m34 = segment.translation ? 0 : f.w * size_c;
  f.floor_error = displacement_room * (size_a + size_c + f.w);
  return f;
}

bool FastFunction::displacement_gradient(const MotionSegment& segment, const PairGeometry& g,
                                         const CertificateFunction& function, FastFunction& f) {
  if (segment.bridge || !vanishes_before_displacement(segment, g, function)) return false;
  f = displacement_part(segment, g, function);
  return true;
}

FastFunction FastFunction::displacement_part(const MotionSegment& segment, const PairGeometry& g,
                                             const CertificateFunction& function) {
  const DisplacedPoint &pa = g.point(function.a), &pb = g.point(function.b), &pc = g.point(function.c);
  constexpr double up = 0x1p200;
  const Point a = seen(segment, pa, function.pp), c = seen(segment, pc, !function.pp);
  // The displacement's change of the edge and of the points, each multiplied by the other factor. The motion's terms
  // contain the edge alone.
  FunctionPoints<double> edge{(pb.dx - pa.dx) * up, (pb.dy - pa.dy) * up, a.x, a.y, c.x, c.y};
  FunctionPoints<double> points{pb.x - pa.x, pb.y - pa.y, pa.dx * up, pa.dy * up, pc.dx * up, pc.dy * up};
  edge.measure(function.measure);
  points.measure(function.measure);
  if (function.measure == Measure::offset_x || function.measure == Measure::offset_y) edge.ex = edge.ey = 0;
  std::array<double, 5> sum = coefficients_on(segment, function.pp, edge, 0.0);
  const std::array<double, 5> more = coefficients_on(segment, function.pp, points, 0.0);
  for (const std::size_t i : {0, 3, 4}) sum[i] += more[i];
  const double w = std::fabs(points.ex) + std::fabs(points.ey), shift = segment.offset_size();
  const double size_a = size_of(pa) + shift, size_c = size_of(pc) + shift;
  const double way_a = std::fabs(points.ax) + std::fabs(points.ay), way_c = std::fabs(points.cx) + std::fabs(points.cy);
  FastFunction f;
  f.pp = function.pp;
  f.level1 = true;
  f.take(sum);
  f.w = std::fabs(edge.ex) + std::fabs(edge.ey);
  f.m0 = f.w * size_a + w * way_a;
  // Also add the square of the displacement in the angle's coefficients, where points lie near the origin and edges are
  // short.
  f.m34 = f.w * size_c + w * way_c + displacement_as_rounding * (1 + f.w) * (1 + way_c);
  if (segment.translation) {
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
  // Steps to the root of the second-order expansion about h, which differs from the root of the polynomial in the third
  // order.
  for (int step = 0; step < 6; ++step) {
    double value = 0, slope = 0, half_second = 0;
    for (int k = model.terms; k-- > 0;) {
      half_second = half_second * h + slope;
      slope = slope * h + value;
      value = value * h + c[k];
    }
    const double discriminant = slope * slope - 4 * half_second * value;
    const double change =
        discriminant > 0 ? 2 * value / (slope + std::copysign(std::sqrt(discriminant), slope)) : value / slope;
    h -= change;
    if (!(std::fabs(change) > 0x1p-14 * model.radius)) break;
  }
  return model.middle + h;
}

}  // namespace taut::internal
