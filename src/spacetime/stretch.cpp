#include "spacetime/stretch.hpp"

#include <algorithm>

namespace taut::internal::spacetime {
namespace {

double coefficient(const Coefficients& c, int k) {
  return static_cast<std::size_t>(k) < c.size() ? c[static_cast<std::size_t>(k)] : 0.0;
}

double middle_of(const BallCoefficients<double>& c, int k) {
  return static_cast<std::size_t>(k) < c.size() ? c[static_cast<std::size_t>(k)].mid : 0.0;
}

void set_interval(Stretch& s, double start, double end) {
  s.middle = start + (end - start) / 2;
  s.r = std::max(end - s.middle, s.middle - start) * (1 + 0x1p-50);
}

/// Rounding in a polynomial's expansion about another point and in the sum of its bounds, relative to the sum of its
/// terms' magnitudes. For degree 16, each term passes through at most 2 * 16 + 8 operations, plus 2^-53 for its
/// coefficient and 16 for the distance to the new point.
constexpr double expansion_rounding = 0x1p-47;

/// Replaces c by the coefficients about h, and returns the sum of |c_k| r^k for k >= 3.
double expand(double* c, int n, double h, double r) {
  for (int k = 0; k + 1 < n; ++k) {
    for (int i = n - 2; i >= k; --i) c[i] += h * c[i + 1];
  }
  double rest = 0;
  for (int k = n - 1; k >= 3; --k) rest = r * (rest + std::fabs(c[k]));
  return rest * r * r;
}

/// A vector's two coordinates as polynomials, and the remainder of the first three terms.
struct Expanded {
  Path path;
  double rest = 0, error = 0;
};

/// The polynomials' coefficients begin at cx and cy, `stride` apart.
Expanded expanded(const double* cx, const double* cy, int stride, int n, double h, double r) {
  double x[max_degree + 1] = {}, y[max_degree + 1] = {};
  for (int k = 0; k < n; ++k) {
    x[k] = cx[k * stride];
    y[k] = cy[k * stride];
  }
  Expanded e;
  e.rest = e.error = expand(x, n, h, r) + expand(y, n, h, r);
  e.path = {{x[0], x[1], x[2]}, {y[0], y[1], y[2]}};
  return e;
}

double reach_of(const Path& p, double r) { return p.x.reach(r) + p.y.reach(r); }

/// The relative motion in one frame, before the shift of a body that does not rotate is included.
struct RawRelativePose {
  Path shift, rotation;
  double shift_error = 0, rotation_error = 0, scale_error = 0;
};

/// In the segment, a vertex is at v + offset, up to rounding.
RelativePose finish(const MotionSegment& segment, RawRelativePose raw, bool in_p, double r) {
  const Vector fixed{segment.offset(in_p).x, segment.offset(in_p).y},
      moving{segment.offset(!in_p).x, segment.offset(!in_p).y};
  raw.shift.x.a -= fixed.x;
  raw.shift.y.a -= fixed.y;
  if (moving.x != 0 || moving.y != 0) raw.shift = raw.shift + raw.rotation * moving;
  const double shift = l1_norm(fixed) + l1_norm(moving);
  // Bounds of lengths: of the undisplaced points, and of the shift.
  constexpr double points = 5;
  RelativePose out;
  out.shift = raw.shift;
  out.rotation = raw.rotation;
  out.swing = (raw.rotation.x.swing(r) + raw.rotation.y.swing(r) + raw.rotation_error) * (1 + 0x1p-40);
  out.reach = (reach_of(raw.shift, r) + shift + (points + shift) * (1 + reach_of(raw.rotation, r))) * (1 + 0x1p-40);
  // Each operation rounds by 2^-53 of a result, which is a sum of two coordinates at most: 2^-44 suffices for 200
  // operations.
  out.error = raw.shift_error + (points + shift) * raw.rotation_error + points * raw.scale_error + 0x1p-44 * out.reach;
  out.error = out.error * (1 + 0x1p-40) + underflow_slack;
  return out;
}

/// The pose in Q's frame, with `moving` the functions conj(x_Q) D, and `rotation` conj(x_P) x_Q.
RawRelativePose seen_from_q(const Path& moving, double error, const Path& rotation, double rotation_error) {
  RawRelativePose raw;
  raw.shift = {-moving.x, -moving.y};
  raw.rotation = conj(rotation);
  raw.shift_error = error;
  raw.rotation_error = rotation_error;
  return raw;
}

/// Expands functions i and i + 1 of the window's model.
Expanded from_model(const FrameModel& m, int i, double h, double r) {
  Expanded e = expanded(&m.c[0][i], &m.c[0][i + 1], FrameModel::functions, m.terms, h, r);
  e.error += m.error[i] + m.error[i + 1] + expansion_rounding * (m.size[i] + m.size[i + 1]);
  return e;
}

/// Expands functions i and i + 1 of a frame (1 and 2, or 3 and 4), by Taylor's formula with the second derivative's
/// bounds.
Expanded from_sample(const FrameSample& s, const FrameCurvature& b, int i, double r) {
  Expanded e;
  e.path = {{s.f[i], s.d[i], b.mid[i] / 2}, {s.f[i + 1], s.d[i + 1], b.mid[i + 1] / 2}};
  e.error = i == 1 ? s.error_a + r * (s.error_ad + r * b.error_a) : s.error_b + r * (s.error_bd + r * b.error_b);
  return e;
}

/// A bound of the difference between the frame's scale and 1.
double scale_error(const FrameSample& s, const FrameCurvature& b, double r) {
  return std::fabs(s.f[0] - 1) + s.error_0 +
         r * (std::fabs(s.d[0]) + s.error_0d + r * (std::fabs(b.mid[0]) + b.error_0));
}

/// Assembles the stretch from samples in both frames and from the bounds of their second derivatives.
void assemble(Stretch& out, const MotionSegment& segment, const FrameSample& pp, const FrameCurvature& second_pp,
              const FrameSample& qq, const FrameCurvature& second_qq) {
  const Expanded p = from_sample(pp, second_pp, 1, out.r), q = from_sample(qq, second_qq, 1, out.r);
  const Expanded rotation = from_sample(pp, second_pp, 3, out.r);
  RawRelativePose in_q = seen_from_q(q.path, q.error, rotation.path, rotation.error);
  in_q.scale_error = scale_error(qq, second_qq, out.r);
  out.in_p =
      finish(segment, {p.path, rotation.path, p.error, rotation.error, scale_error(pp, second_pp, out.r)}, true, out.r);
  out.in_q = finish(segment, in_q, false, out.r);
}

}  // namespace

TranslationPolynomial::TranslationPolynomial(const MotionSegment& segment) {
  x[0] = y[0] = magnitude[0] = 0;
  if (!segment.translation) return;
  size = segment.degree + 1;
  about = segment.about();
  if (segment.far()) {
    const auto way_x = segment.way(true).rounded<double>(), way_y = segment.way(false).rounded<double>();
    for (int k = 0; k < size; ++k) {
      x[k] = middle_of(way_x, k);
      y[k] = middle_of(way_y, k);
    }
  } else {
    for (int k = 1; k < size; ++k) {
      x[k] = coefficient(segment.q.x, k) - coefficient(segment.p.x, k);
      y[k] = coefficient(segment.q.y, k) - coefficient(segment.p.y, k);
    }
  }
  for (int k = 0; k < size; ++k) magnitude[k] = std::fabs(x[k]) + std::fabs(y[k]);
}

Stretch Stretch::of_translation(const MotionSegment& segment, const TranslationPolynomial& polynomial, double start,
                                double end) {
  Stretch out;
  set_interval(out, start, end);
  const double h = out.middle - polynomial.about;
  const Expanded e = expanded(polynomial.x, polynomial.y, 1, polynomial.size, h, out.r);
  const double farthest = std::fabs(h) + out.r;
  double terms = 0;
  for (int k = polynomial.size; k-- > 0;) terms = terms * farthest + polynomial.magnitude[k];
  const double error = e.error + expansion_rounding * terms;
  out.rest = e.rest;
  const Path rests{{1, 0, 0}, {}};
  out.in_p = finish(segment, {e.path, rests, error, 0, 0}, true, out.r);
  out.in_q = finish(segment, seen_from_q(e.path, error, rests, 0), false, out.r);
  return out;
}

Stretch Stretch::of_window(const MotionSegment& segment, FrameWindow& window, double start, double end) {
  Stretch out;
  set_interval(out, start, end);
  if (segment.bridge) {
    const FrameSample pp = window.at(out.middle, true), qq = window.at(out.middle, false);
    assemble(out, segment, pp, window.second(true), qq, window.second(false));
    return out;
  }
  const FrameModel& m = window.model();
  const double h = out.middle - m.middle;
  const Expanded p = from_model(m, 0, h, out.r), q = from_model(m, 2, h, out.r), rotation = from_model(m, 4, h, out.r);
  out.rest = std::max(p.rest, q.rest) + rotation.rest;
  out.in_p = finish(segment, {p.path, rotation.path, p.error, rotation.error, 0}, true, out.r);
  out.in_q = finish(segment, seen_from_q(q.path, q.error, rotation.path, rotation.error), false, out.r);
  return out;
}

Stretch Stretch::at_instant(const MotionSegment& segment, double t) {
  Stretch out;
  out.middle = t;
  const FrameValues<Real320> there = frame_values(segment, Ball<Real320>::exact(t));
  const auto sample = [](const std::array<Ball<Real320>, 5>& values) {
    std::array<Jet<double>, 5> rests;
    for (std::size_t i = 0; i < 5; ++i) {
      rests[i] = {detail::in_doubles(values[i]), Ball<double>::exact(0), Ball<double>::exact(0)};
    }
    return sample_of(rests);
  };
  assemble(out, segment, sample(there.for_pp), FrameCurvature{}, sample(there.for_qq), FrameCurvature{});
  return out;
}
Stretch Stretch::of_range(const MotionSegment& segment, const FrameWindow& window) {
  Stretch out;
  out.middle = window.start();
  FrameSample pp = window.range(true), qq = window.range(false);
  for (FrameSample* s : {&pp, &qq}) {
    for (double& slope : s->d) slope = 0;
    s->error_0d = s->error_ad = s->error_bd = 0;
  }
  assemble(out, segment, pp, FrameCurvature{}, qq, FrameCurvature{});
  return out;
}

}  // namespace taut::internal::spacetime
