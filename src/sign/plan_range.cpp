#include "sign/plan_range.hpp"

#include <algorithm>
#include <cmath>

#include "base/interruption.hpp"

namespace taut {
namespace {

/// Parts of a leg whose ranges are taken one by one: of curved motions, the range over the whole leg would be too wide.
int parts_of(const Leg& leg) {
  if (leg.bridge || (leg.translation && leg.degree <= 1)) return 1;
  return leg.translation ? std::max(8, 2 * leg.degree) : 16;
}

constexpr int most_halvings = 6;

/// Where part k of several begins.
double part_begin(double from, double to, int k, int parts) { return k == parts ? to : from + (to - from) * k / parts; }

/// The range within r of the middle by Taylor's formula.
Ball<double> second_order(const Jet<double>& middle, const Ball<double>& bend, double r) {
  const Ball<double> step(0, r), half_square = Ball<double>::between(0, r * r / 2 * (1 + 0x1p-50));
  return middle.v + middle.d * step + bend * half_square;
}

const Ball<double>& tighter(const Ball<double>& a, const Ball<double>& b) { return b.rad < a.rad ? b : a; }

double known_or(double bound, double otherwise) { return std::isnan(bound) ? otherwise : bound; }

}  // namespace

PlanRange PlanRange::over_part(const Leg& leg, double from, double to) {
  count_work(leg.translation ? 8 : 24);
  const Ball<double> whole = Ball<double>::between(from, to);
  const Frame<double> over = unshifted_frame(leg, whole), middle = unshifted_frame(leg, Ball<double>::exact(whole.mid));
  PlanRange range;
  for (std::size_t i = 0; i < 5; ++i) {
    const auto bound = [i, &whole](Side& side, const std::array<Jet<double>, 5>& m,
                                   const std::array<Jet<double>, 5>& o) {
      const Ball<double> v = tighter(o[i].v, second_order(m[i], o[i].dd, whole.rad));
      // More than the radius by what the ends round.
      const double reach = v.rad * (1 + 0x1p-50) + std::fabs(v.mid) * 0x1p-52;
      side.lo[i] = known_or(v.mid - reach, -INFINITY);
      side.hi[i] = known_or(v.mid + reach, INFINITY);
    };
    bound(range.pp_, middle.for_pp, over.for_pp);
    bound(range.qq_, middle.for_qq, over.for_qq);
  }
  return range;
}

PlanRange PlanRange::around_instants(const Leg& leg, double from, double to) {
  const int parts = parts_of(leg);
  PlanRange seen = over_part(leg, from, from);
  for (int k = 1; k <= parts; ++k) {
    const double t = part_begin(from, to, k, parts);
    seen.include(over_part(leg, t, t));
  }
  return seen;
}

/// Of a curved motion, the range over a long part is too wide: parts are halved until what they say is near what the
/// motion is seen to do at some instants.
PlanRange PlanRange::over(const Leg& leg, double from, double to) {
  const int parts = parts_of(leg);
  if (parts == 1) return over_part(leg, from, to);
  const PlanRange seen = around_instants(leg, from, to);
  const PlanRange fair = seen.widened(0x1p-3);
  PlanRange range = seen;
  for (int k = 0; k < parts; ++k) {
    range.cover(leg, part_begin(from, to, k, parts), part_begin(from, to, k + 1, parts), fair, most_halvings);
  }
  return range;
}

void PlanRange::cover(const Leg& leg, double from, double to, const PlanRange& fair, int halvings) {
  const PlanRange part = over_part(leg, from, to);
  const double middle = from + (to - from) / 2;
  if (halvings == 0 || fair.contains(part) || !(from < middle && middle < to)) return include(part);
  cover(leg, from, middle, fair, halvings - 1);
  cover(leg, middle, to, fair, halvings - 1);
}

double PlanRange::left_at(const Leg& leg, double from) const {
  const double least = 0x1p-12 * (leg.end - from);
  double reached = from, step = leg.end - from;
  // Steps have to be short only where the motion comes close to the border.
  for (bool on = false; reached < leg.end && step >= least;) {
    const double to = std::min(reached + step, leg.end);
    const bool inside = contains(over_part(leg, reached, to));
    if (inside) reached = to;
    if (!inside || on) step *= inside ? 2 : 0.5;
    on = inside;
  }
  return reached < leg.end ? reached : INFINITY;
}

PlanRange PlanRange::widened(double share) const {
  PlanRange wide = *this;
  for (Side* side : {&wide.pp_, &wide.qq_}) {
    for (int i = 0; i < 5; ++i) {
      const double room = share * (side->hi[i] - side->lo[i]) + 0x1p-45 * std::max(-side->lo[i], side->hi[i]);
      side->lo[i] -= known_or(room, 0);
      side->hi[i] += known_or(room, 0);
    }
  }
  return wide;
}

void PlanRange::include(const PlanRange& other) {
  const auto merge = [](Side& a, const Side& b) {
    for (int i = 0; i < 5; ++i) {
      a.lo[i] = std::min(a.lo[i], b.lo[i]);
      a.hi[i] = std::max(a.hi[i], b.hi[i]);
    }
  };
  merge(pp_, other.pp_);
  merge(qq_, other.qq_);
}

bool PlanRange::contains(const PlanRange& other) const {
  const auto holds = [](const Side& a, const Side& b) {
    for (int i = 0; i < 5; ++i) {
      if (!(a.lo[i] <= b.lo[i] && b.hi[i] <= a.hi[i])) return false;
    }
    return true;
  };
  return holds(pp_, other.pp_) && holds(qq_, other.qq_);
}

bool PlanRange::keeps_sign(const PairGeometry& g, const Form& form, int sign) const {
  const DisplacedPoint &a = g.point(form.a), &b = g.point(form.b), &c = g.point(form.c);
  // No body's coordinates are shifted here, and the frames turn.
  FormPoints<double> p{b.x - a.x, b.y - a.y, a.x, a.y, c.x, c.y};
  p.measure(form.measure);
  const std::array<double, 5> f = form_coefficients(form.pp, p);
  const double w = std::fabs(p.ex) + std::fabs(p.ey);
  const double size_a = w * (std::fabs(a.x) + std::fabs(a.y)), size_c = w * (std::fabs(c.x) + std::fabs(c.y));
  const double size[5] = {size_a, w, w, size_c, size_c};
  const Side& range = form.pp ? pp_ : qq_;
  double least = 0, error = 0, reach = 1;
  for (int i = 0; i < 5; ++i) {
    const double v = sign * f[static_cast<std::size_t>(i)], lo = range.lo[i], hi = range.hi[i],
                 farthest = std::max(-lo, hi);
    least += v > 0 ? v * lo : v * hi;
    error += size[i] * farthest;
    reach += farthest;
  }
  // 2^-48 covers the rounding; the rest the displacement.
  return least > 0x1p-48 * error + 0x1p10 * displacement_room * reach;
}

}  // namespace taut
