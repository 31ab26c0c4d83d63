#include "certificate/frame_range.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/budget.hpp"

namespace taut::internal {
namespace {

/// The number of parts of a segment whose ranges are computed separately. For curved motions, the range over the whole
/// segment would be too wide.
int parts_of(const MotionSegment& segment) {
  if (segment.bridge || (segment.translation && segment.degree <= 1)) return 1;
  return segment.translation ? std::max(8, 2 * segment.degree) : 16;
}

constexpr int most_halvings = 6;

/// The start of part k of several.
double part_begin(double from, double to, int k, int parts) { return k == parts ? to : from + (to - from) * k / parts; }

/// The range within r of the middle by Taylor's formula.
Ball<double> second_order(const Jet<double>& middle, const Ball<double>& second, double r) {
  const Ball<double> step(0, r), half_square = Ball<double>::between(0, r * r / 2 * (1 + 0x1p-50));
  return middle.v + middle.d * step + second * half_square;
}

const Ball<double>& tighter(const Ball<double>& a, const Ball<double>& b) { return b.rad < a.rad ? b : a; }

double known_or(double bound, double otherwise) { return std::isnan(bound) ? otherwise : bound; }

}  // namespace

FrameRange FrameRange::over_part(const MotionSegment& segment, double from, double to) {
  count_work(segment.translation ? 8 : 24);
  const Ball<double> whole = Ball<double>::between(from, to);
  const Frame<double> over = unshifted_frame(segment, whole),
                      middle = unshifted_frame(segment, Ball<double>::exact(whole.mid));
  FrameRange range;
  for (std::size_t i = 0; i < 5; ++i) {
    const auto bound = [i, &whole](Side& side, const std::array<Jet<double>, 5>& m,
                                   const std::array<Jet<double>, 5>& o) {
      const Ball<double> v = tighter(o[i].v, second_order(m[i], o[i].dd, whole.rad));
      // Exceeds the radius by the rounding of the ends.
      const double reach = v.rad * (1 + 0x1p-50) + std::fabs(v.mid) * 0x1p-52;
      side.lo[i] = known_or(v.mid - reach, -INFINITY);
      side.hi[i] = known_or(v.mid + reach, INFINITY);
    };
    bound(range.pp_, middle.for_pp, over.for_pp);
    bound(range.qq_, middle.for_qq, over.for_qq);
  }
  return range;
}

FrameRange FrameRange::around_instants(const MotionSegment& segment, double from, double to) {
  const int parts = parts_of(segment);
  FrameRange seen = over_part(segment, from, from);
  for (int k = 1; k <= parts; ++k) {
    const double t = part_begin(from, to, k, parts);
    seen.include(over_part(segment, t, t));
  }
  return seen;
}

/// For a curved motion, the range over a long part is too wide. Parts are halved until their ranges are close to the
/// range observed at some instants.
FrameRange FrameRange::over(const MotionSegment& segment, double from, double to) {
  const int parts = parts_of(segment);
  if (parts == 1) return over_part(segment, from, to);
  const FrameRange seen = around_instants(segment, from, to);
  const FrameRange fair = seen.widened(0x1p-3);
  FrameRange range = seen;
  for (int k = 0; k < parts; ++k) {
    range.cover(segment, part_begin(from, to, k, parts), part_begin(from, to, k + 1, parts), fair, most_halvings);
  }
  return range;
}

void FrameRange::cover(const MotionSegment& segment, double from, double to, const FrameRange& fair, int halvings) {
  const FrameRange part = over_part(segment, from, to);
  const double middle = from + (to - from) / 2;
  if (halvings == 0 || fair.contains(part) || !(from < middle && middle < to)) return include(part);
  cover(segment, from, middle, fair, halvings - 1);
  cover(segment, middle, to, fair, halvings - 1);
}

double FrameRange::left_at(const MotionSegment& segment, double from) const {
  const double least = 0x1p-12 * (segment.end - from);
  double reached = from, step = segment.end - from;
  // Steps have to be short only where the motion comes close to the border.
  for (bool on = false; reached < segment.end && step >= least;) {
    const double to = std::min(reached + step, segment.end);
    const bool inside = contains(over_part(segment, reached, to));
    if (inside) reached = to;
    if (!inside || on) step *= inside ? 2 : 0.5;
    on = inside;
  }
  return reached < segment.end ? reached : INFINITY;
}

FrameRange FrameRange::widened(double share) const {
  FrameRange wide = *this;
  for (Side* side : {&wide.pp_, &wide.qq_}) {
    for (int i = 0; i < 5; ++i) {
      const double room = share * (side->hi[i] - side->lo[i]) + 0x1p-45 * std::max(-side->lo[i], side->hi[i]);
      side->lo[i] -= known_or(room, 0);
      side->hi[i] += known_or(room, 0);
    }
  }
  return wide;
}

void FrameRange::include(const FrameRange& other) {
  const auto merge = [](Side& a, const Side& b) {
    for (int i = 0; i < 5; ++i) {
      a.lo[i] = std::min(a.lo[i], b.lo[i]);
      a.hi[i] = std::max(a.hi[i], b.hi[i]);
    }
  };
  merge(pp_, other.pp_);
  merge(qq_, other.qq_);
}

bool FrameRange::contains(const FrameRange& other) const {
  const auto holds = [](const Side& a, const Side& b) {
    for (int i = 0; i < 5; ++i) {
      if (!(a.lo[i] <= b.lo[i] && b.hi[i] <= a.hi[i])) return false;
    }
    return true;
  };
  return holds(pp_, other.pp_) && holds(qq_, other.qq_);
}

bool FrameRange::keeps_sign(const PairGeometry& g, const CertificateFunction& function, int sign) const {
  const DisplacedPoint &a = g.point(function.a), &b = g.point(function.b), &c = g.point(function.c);
  // No body's coordinates are shifted here, and the frames rotate.
  FunctionPoints<double> p{b.x - a.x, b.y - a.y, a.x, a.y, c.x, c.y};
  p.measure(function.measure);
  const std::array<double, 5> f = function_coefficients(function.pp, p);
  const double w = std::fabs(p.ex) + std::fabs(p.ey);
  const double size_a = w * (std::fabs(a.x) + std::fabs(a.y)), size_c = w * (std::fabs(c.x) + std::fabs(c.y));
  const double size[5] = {size_a, w, w, size_c, size_c};
  const Side& range = function.pp ? pp_ : qq_;
  double least = 0, error = 0, reach = 1;
  for (int i = 0; i < 5; ++i) {
    const double v = sign * f[static_cast<std::size_t>(i)], lo = range.lo[i], hi = range.hi[i],
                 farthest = std::max(-lo, hi);
    least += v > 0 ? v * lo : v * hi;
    error += size[i] * farthest;
    reach += farthest;
  }
  // 2^-48 covers the rounding, the second term the displacement.
  return least > 0x1p-48 * error + 0x1p10 * displacement_room * reach;
}

}  // namespace taut::internal
