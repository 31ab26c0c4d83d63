#include "motion/frame_sample.hpp"

#include <algorithm>
#include <cmath>

namespace taut::internal {
namespace {

/// A bound of the rounding of a sum of five products, as a share of each.
constexpr double sample_rounding = 0x1p-49;

double error_of(const Ball<double>& b) { return b.rad + sample_rounding * std::fabs(b.mid); }

double rounding_of(double x, double y) { return sample_rounding * (std::fabs(x) + std::fabs(y)); }

}  // namespace

FrameSample sample_of(const std::array<Jet<double>, 5>& j) {
  FrameSample s{};
  for (std::size_t i = 0; i < 5; ++i) {
    s.f[i] = j[i].v.mid;
    s.d[i] = j[i].d.mid;
  }
  s.error_0 = error_of(j[0].v);
  s.error_a = error_of(j[1].v) + error_of(j[2].v);
  s.error_b = error_of(j[3].v) + error_of(j[4].v);
  s.error_0d = error_of(j[0].d);
  s.error_ad = error_of(j[1].d) + error_of(j[2].d);
  s.error_bd = error_of(j[3].d) + error_of(j[4].d);
  return s;
}

FrameCurvature curvature_of(const std::array<Jet<double>, 5>& j) {
  FrameCurvature c{};
  double error[5];
  for (std::size_t i = 0; i < 5; ++i) {
    const bool known = j[i].dd.rad < INFINITY && std::isfinite(j[i].dd.mid);
    c.mid[i] = known ? j[i].dd.mid : 0;
    error[i] = known ? error_of(j[i].dd) : INFINITY;
  }
  c.error_0 = error[0];
  c.error_a = error[1] + error[2];
  c.error_b = error[3] + error[4];
  return c;
}

void evaluate(const FrameModel& m, double t, int first, FrameSample& s) {
  double value[4], slope[4];
  m.evaluate(t, first, value, slope, s.dd);
  s.f[0] = 1;
  s.d[0] = 0;
  for (int k = 0; k < 4; ++k) {
    s.f[k + 1] = value[k];
    s.d[k + 1] = slope[k];
  }
  add_errors(m, first, s);
  s.error_add = m.error_dd[first] + m.error_dd[first + 1] + rounding_of(s.dd[0], s.dd[1]);
  s.error_bdd = m.error_dd[4] + m.error_dd[5] + rounding_of(s.dd[2], s.dd[3]);
}

void add_errors(const FrameModel& m, int first, FrameSample& s) {
  s.error_0 = sample_rounding;
  s.error_0d = 0;
  s.error_a = m.error[first] + m.error[first + 1] + rounding_of(s.f[1], s.f[2]);
  s.error_b = m.error[4] + m.error[5] + rounding_of(s.f[3], s.f[4]);
  s.error_ad = m.error_d[first] + m.error_d[first + 1] + rounding_of(s.d[1], s.d[2]);
  s.error_bd = m.error_d[4] + m.error_d[5] + rounding_of(s.d[3], s.d[4]);
}

FrameCurvature curvature_of(const FrameModel& m, int first) {
  FrameCurvature c{};
  const int source[4] = {first, first + 1, 4, 5};
  double error[4];
  for (int k = 0; k < 4; ++k) {
    c.mid[k + 1] = m.second[source[k]];
    error[k] = m.second_rad[source[k]] + sample_rounding * std::fabs(c.mid[k + 1]);
  }
  c.error_a = error[0] + error[1];
  c.error_b = error[2] + error[3];
  return c;
}

FrameThird third_of(const FrameModel& m, int first) {
  return {{m.third[first], m.third[first + 1], m.third[4], m.third[5]}};
}

FrameEvaluator::FrameEvaluator(const MotionSegment& segment) {
  const double length = segment.end - segment.start;
  looks_ = {frame_values(segment, Ball<double>::exact(segment.start + 0.3127 * length)),
            frame_values(segment, Ball<double>::exact(segment.start + 0.7841 * length))};
}

bool FrameEvaluator::differs_from_zero(bool pp, const std::array<Ball<double>, 5>& c) const {
  return std::any_of(looks_.begin(), looks_.end(), [&](const FrameValues<double>& look) {
    const std::array<Ball<double>, 5>& f = pp ? look.for_pp : look.for_qq;
    Ball<double> sum = f[0] * c[0];
    for (std::size_t i = 1; i < c.size(); ++i) sum = sum + f[i] * c[i];
    return sum.sign() != 0;
  });
}

}  // namespace taut::internal
