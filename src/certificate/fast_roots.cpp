#include "certificate/fast_roots.hpp"

#include <algorithm>
#include <cmath>

#include "certificate/exact_line.hpp"
#include "certificate/instant.hpp"
#include "numeric/quadratic_bound.hpp"

namespace taut::internal {
namespace {

/// A double certainly below (above) a finite x, by a unit or two in the last place. It avoids the special cases of
/// std::nextafter.
double below(double x) { return x - (std::fabs(x) * 0x1p-52 + 0x1p-1060); }
double above(double x) { return x + (std::fabs(x) * 0x1p-52 + 0x1p-1060); }

/// The sign of a value that may still change by `drift`; 0 if unknown.
int sign_of(const Bounded& v, double drift) {
  return std::fabs(v.value) > v.error + drift ? (v.value > 0 ? 1 : -1) : 0;
}

}  // namespace

LocalExpansion FastRoots::expansion(const FastFunction& f, double t) {
  return expansion_with(f, clock_.at(t, f.pp), t);
}

LocalExpansion FastRoots::expansion_near(const FastFunction& f, double t) {
  double at;
  const FrameSample& side = clock_.shortly_before(t, f.pp, at);
  return expansion_with(f, side, at);
}

LocalExpansion FastRoots::expansion_with(const FastFunction& f, const FrameSample& side, double t) {
  LocalExpansion now;
  now.t = t;
  now.value = f.value(side);
  now.slope = f.slope(side);
  const ModelCell& cell = clock_.cell(t);
  now.local = cell.sharp;
  if (now.local) now.second = f.second(side);
  take_bounds(f, now, cell);
  return now;
}

/// Takes the bounds that hold over the whole cell.
void FastRoots::take_bounds(const FastFunction& f, LocalExpansion& expansion, const ModelCell& cell) const {
  expansion.cell = cell;
  if (expansion.local) {
    expansion.third = f.third(cell.third(f.pp));
  } else {
    expansion.third = 0;
    expansion.second = f.curvature(cell.curvature(f.pp));
  }
}

/// Given a function that stays positive to the end of a cell: the time up to which it is positive by the bounds of the
/// wider cells around it, at most `cells` of them.
double FastRoots::positive_beyond(const Root& r, const LocalExpansion& now, double value, int cells) {
  const FastFunction& f = r.function;
  const double slope = r.sign * now.slope.value - now.slope.error,
               second = r.sign * now.second.value - now.second.error;
  if (now.local) {
    if (const FrameThird* all = clock_.third_throughout(f.pp)) {
      const double most = above(segment().end - now.t);
      const double length = now.cell.end - now.cell.start, inside = now.cell.end - now.t;
      const double h = positive_over(value, slope, second, f.third(*all), inside, length, most, cells);
      return h < most ? std::max(now.cell.end, below(now.t + h)) : segment().end;
    }
  }
  double reached = now.cell.end;
  const auto wider = [&](const ModelPlace& cell) {
    return now.local ? clock_.parent_bounds(cell) : clock_.wider(cell);
  };
  for (const ModelCell* wide = wider(now.cell); wide; wide = wider(*wide)) {
    if (wide->end <= reached) continue;
    const double limit = wide->end - now.t;
    double least_second;
    if (now.local) {
      least_second = second - f.third(wide->third(f.pp)) * limit * one_third;
    } else {
      const Bounded k = f.curvature(wide->curvature(f.pp));
      least_second = r.sign * k.value - k.error;
    }
    if (!positive_throughout(value, slope, least_second, limit)) {
      return std::max(reached, below(now.t + positive_until(value, slope, least_second, limit)));
    }
    reached = wide->end;
    if (--cells == 0) break;
  }
  return reached;
}

double FastRoots::lasts(const Root& r, const LocalExpansion& now, double least) const {
  const double slope = r.sign * now.slope.value - now.slope.error,
               second = r.sign * now.second.value - now.second.error;
  return positive_until(least, slope, second, now.third, now.cell.end - now.t);
}

/// The root's sign holds for `lasting` from now.t on, where its value is at least `least`, and perhaps longer. Returns
/// false if that is not much later than t. Then doubles, or at least those about now.t, cannot show more.
bool FastRoots::holds_on(Root& r, const LocalExpansion& now, double t, double least, double lasting, int cells) {
  const double limit = now.cell.end - now.t;
  if (lasting >= limit) {  // never true of a NaN
    r.come_after(positive_beyond(r, now, least, cells), segment().end);
    return true;
  }
  const double next = below(now.t + lasting);
  // Where the function falls like a high power, or the motion is singular and bounds are loose, steps become short and
  // number thousands. One search at high precision is quicker.
  const bool good = now.cell.sharp || segment().bridge;
  if (!(next > t + (good ? 0x1p-10 : 0x1p-8) * limit + (t - now.t))) return false;
  r.come_after(next, segment().end);
  return true;
}

/// Brackets the root, which is known to come after `from`, if the function certainly falls to it from the later of
/// now.t and `from`.
bool FastRoots::isolate(Root& r, const LocalExpansion& now, double from) {
  const double sign = r.sign, t = now.t;
  const double limit = now.cell.end - t;
  const double most = sign * now.value.value + now.value.error;
  const double slope = sign * now.slope.value + now.slope.error;
  const double second = sign * now.second.value + now.second.error + now.third * limit * (1 + 0x1p-40);
  if (!(slope < 0)) return false;
  const double h = most > 0 ? negative_from(most, slope, second) : 0;
  const double falls = second > 0 ? std::min(limit, -slope / second * (1 - 0x1p-48)) : limit;
  if (!(h < falls)) return false;
  r.kind = RootKind::bracketed;
  r.lo = from;
  r.hi = std::min(above(t + h), segment().end);
  r.monotone_until = falls == limit ? now.cell.end : below(t + falls);
  return true;
}

bool FastRoots::follow(Root& r, const LocalExpansion& now, double t, int cells) {
  counts_.add(Stage::doubles);
  const double least = r.sign * now.value.value - now.value.error;
  const double h = lasts(r, now, least);
  if (h < now.cell.end - now.t && isolate(r, now, std::max(t, below(now.t + h)))) return true;
  return holds_on(r, now, t, least, h, cells) || isolate_across(r, now, t);
}

/// A root at the end of a cell, as is common for symmetric motions, lies inside a wider cell.
bool FastRoots::isolate_across(Root& r, const LocalExpansion& now, double t) {
  const double end = now.cell.end;
  if (!now.local || end >= segment().end || !(end - t < 0x1p-20 * (end - now.cell.start))) return false;
  LocalExpansion wide = now;
  return widen(r.function, wide, now.t, above(end)) && isolate(r, wide, t);
}

bool FastRoots::follow_from_zero(Root& r, const Instant& instant, bool own) {
  if (instant.hi >= segment().end) return false;
  LocalExpansion now = expansion(r.function, instant.hi);
  const double width = instant.hi - instant.lo;
  if (!widen(r.function, now, instant.lo, instant.hi)) return false;
  // Over [instant.lo, instant.hi], the slope is within its bounds here plus the change due to the second derivative.
  const double drift = now.slope_change(width);
  const double slope = r.sign * now.slope.value, error = now.slope.error + drift;
  if (slope > error) {
    const double h = lasts(r, now, 0);
    // If the function has not risen above the error of its value by then, the next step would be as short, and so on.
    const bool rises = (slope - error) * h > 4 * now.value.error || h > 0x1p-8 * (now.cell.end - now.t);
    return rises && holds_on(r, now, now.t, 0, h);
  }
  if (-slope > error && !own && isolate(r, now, instant.lo)) {
    // Reports show this enclosure. It is as short as doubles can make it, or is refined when needed; an exact line does
    // that at once.
    const bool short_enough = r.hi - r.lo <= 0x1p-44 * std::fabs(r.hi);
    if (short_enough) r.kind = RootKind::isolated;
    return short_enough || !clock_.straight();
  }
  return false;
}

std::optional<PlaceOfTurn> FastRoots::turn_near(const FastFunction& f, double t) {
  LocalExpansion now = expansion(f, t);
  const double start = now.cell.start, end = now.cell.end;
  if (!now.local || !(std::fabs(now.second.value) > 2 * now.second.error)) return std::nullopt;
  // The second step starts where slopes are small.
  for (int step = 0; step < 2; ++step) {
    const double at = now.t - now.slope.value / now.second.value;
    if (!(at >= start && at < end && std::fabs(at - t) < 0x1p-8 * (end - start))) return std::nullopt;
    now = expansion(f, at);
  }
  // The second derivative keeps its sign for this long, and has kept it since t.
  const double steady = 0.5 * (std::fabs(now.second.value) - now.second.error), least = 0x1p-6 * (end - start);
  const double lasting = steady > now.third * (end - start) ? end - start : steady / now.third;
  if (!(lasting > least)) return std::nullopt;
  return PlaceOfTurn{now.t, std::min(end, now.t + lasting * (1 - 0x1p-40))};
}

/// Encloses a bracketed root within a few ulps, if doubles can. Most cells have a polynomial that is as good as the
/// function. Once a narrow interval about the polynomial's root is certified, one step of the general method remains.
void FastRoots::enclose(Root& r) {
  if (!narrow(r)) newton(r);
}

/// Takes an interval about m as the enclosure, where m is a root of the cell's polynomial found without bounds. The
/// function has its root in the interval if |f(m)| is less than the radius times the least slope. One Newton step
/// follows. Returns false if the enclosure may still be far wider than doubles allow.
bool FastRoots::narrow(Root& r) {
  const double middle = r.lo + (r.hi - r.lo) / 2;
  const ModelCell& cell = clock_.cell(middle);
  if (!cell.sharp || cell.start > r.lo || cell.end < r.hi) return false;
  const double m = r.function.root_of(cell.model, middle);
  // The ends of the interval are rounded. Far from time 0, that is not negligible relative to the radius.
  const double radius = 0x1p-34 * (cell.end - cell.start), rounding = 0x1p-52 * std::fabs(m);
  if (!(m - radius > r.lo && m + radius < r.hi && radius > rounding)) return false;
  const LocalExpansion here = expansion(r.function, m);
  const double flat = -r.sign * here.slope.value - here.slope.error - here.slope_change(radius + rounding);
  if (!(std::fabs(here.value.value) + here.value.error < flat * (radius - rounding) * (1 - 0x1p-40))) return false;
  r.lo = m - radius;
  r.hi = m + radius;
  return newton_step(r, here);
}

/// Interval Newton. The slope's bounds are recomputed in each step over the current enclosure: with bounds of the first
/// enclosure, it would converge only linearly.
void FastRoots::newton(Root& r) {
  for (int step = 0; step < 30; ++step) {
    const double width = r.hi - r.lo, m = r.lo + width / 2;
    if (!(width > 0x1p-50 * std::fabs(m))) return;
    if (newton_step(r, expansion(r.function, m)) || !(r.hi - r.lo < 0.75 * width)) return;
  }
}

/// Uses the function's expansion at an instant in the enclosure, near its middle. Where the slope's bounds include
/// zero, the sign there halves the enclosure. Returns true if the remaining width is about the contribution of the
/// value's error.
bool FastRoots::newton_step(Root& r, const LocalExpansion& here) {
  enclosed_about_ = here.t;
  const double sign = r.sign, m = here.t, reach = std::max(m - r.lo, r.hi - m);
  const double spread = here.slope.error + here.slope_change(reach);
  const double steep = -sign * here.slope.value + spread, flat = -sign * here.slope.value - spread;
  const double lo_value = sign * here.value.value - here.value.error;
  const double hi_value = sign * here.value.value + here.value.error;
  if (flat > 0) {
    const double lo = m + lo_value / (lo_value > 0 ? steep : flat);
    const double hi = m + hi_value / (hi_value > 0 ? flat : steep);
    const double slack = 0x1p-51 * (std::fabs(lo) + std::fabs(hi)) + 0x1p-50 * (std::fabs(lo - m) + std::fabs(hi - m));
    r.lo = std::max(r.lo, lo - slack);
    r.hi = std::min(r.hi, hi + slack);
    return r.hi - r.lo <= 4 * (here.value.error / flat + slack);
  }
  if (lo_value > 0) {
    r.lo = m;
  } else if (hi_value < 0) {
    r.hi = m;
  }
  return false;
}

/// Takes the second derivative over a cell that reaches back to `start` and on to `end`; returns false if there is
/// none.
bool FastRoots::widen(const FastFunction& f, LocalExpansion& expansion, double start, double end) {
  while (expansion.cell.start > start || expansion.cell.end < end) {
    const ModelCell* cell = clock_.wider(expansion.cell);
    if (!cell) return false;
    take_bounds(f, expansion, *cell);
  }
  return true;
}

int FastRoots::sign_during(const FastFunction& f, const LocalExpansion& expansion, double lo, double hi, double at) {
  const double reach = std::max(hi - at, at - lo);
  if (!(reach > 0)) return sign_of(expansion.value, 0);
  if (expansion.cell.start > lo || expansion.cell.end < hi) {
    LocalExpansion wide = expansion;
    return widen(f, wide, lo, hi) ? sign_during(f, wide, lo, hi, at) : 0;
  }
  const double steepest = std::fabs(expansion.slope.value) + expansion.slope.error + expansion.slope_change(reach);
  return sign_of(expansion.value, reach * steepest * (1 + 0x1p-40));
}

FastLine FastRoots::line_of(const FastFunction& f) const {
  return {f, clock_.straight_side(), clock_.straight_middle()};
}

bool FastRoots::follow_line(Root& r, const FastLine& line, double t) {
  counts_.add(Stage::doubles);
  if (line.holds(r.sign, t, segment().end)) {
    r.come_after(segment().end, segment().end);
    return true;
  }
  double lo, hi;
  if (!line.root(r.sign, lo, hi) || !(hi < segment().end)) return false;
  r.kind = RootKind::isolated;
  r.lo = std::max(lo, t);
  r.hi = hi;
  r.monotone_until = segment().end;
  return true;
}

}  // namespace taut::internal
