#include "kinetic/failure_solver.hpp"

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "numeric/quadratic_bound.hpp"
#include "pair/placement.hpp"
#include "sign/fast_line.hpp"
#include "tiling/root_faces.hpp"

namespace taut {
namespace {

/// A double certainly below (above) a finite x, a unit or two in the last place away: without std::nextafter's cases.
double below(double x) { return x - (std::fabs(x) * 0x1p-52 + 0x1p-1060); }
double above(double x) { return x + (std::fabs(x) * 0x1p-52 + 0x1p-1060); }

/// The sign of a value that may still change by `drift`; 0 if unknown.
int sign_of(const Bounded& v, double drift) {
  return std::fabs(v.value) > v.error + drift ? (v.value > 0 ? 1 : -1) : 0;
}

/// How many cells beyond its own a new certificate is followed. Most die before long.
constexpr int cells_for_new = 1;

/// Is (u, v, w) the event's corner up to turning around?
bool same_order(const Now& now, VertexId u, VertexId v) {
  return (u == now.u && v == now.v) || (u == now.v && v == now.w) || (u == now.w && v == now.u);
}

}  // namespace

PreciseTime& FailureSolver::precise_slot(Certificate& c) {
  if (c.precise < 0) {
    if (pool_free_.empty()) {
      c.precise = static_cast<std::int32_t>(pool_.size());
      pool_.emplace_back();
    } else {
      c.precise = pool_free_.back();
      pool_free_.pop_back();
    }
  }
  return pool_[static_cast<std::size_t>(c.precise)];
}

PreciseTime& FailureSolver::precise_now(Now& now) const {
  if (!now.precise) {
    now.precise = now.pool >= 0 ? pool_[static_cast<std::size_t>(now.pool)] : PreciseTime::between(now.lo, now.hi);
  }
  return *now.precise;
}

void FailureSolver::release(Certificate& c) {
  if (c.precise >= 0) pool_free_.push_back(c.precise);
  c.precise = -1;
}

void FailureSolver::set_not_before(Certificate& c, double t) {
  c.kind = FailureKind::not_before;
  c.lo = t >= leg().end ? never : t;
}

void FailureSolver::set_isolated(Certificate& c, const PreciseTime& t) {
  precise_slot(c) = t;
  c.kind = FailureKind::isolated;
  c.lo = t.floor();
  c.hi = std::min(t.ceiling(), leg().end);
  c.monotone_until = c.lo;  // nothing is known in doubles
}

FailureSolver::Course FailureSolver::course(const FastFunction& f, double t) {
  return course_with(f, clock_.at(t, f.pp), t);
}

FailureSolver::Course FailureSolver::course_near(const FastFunction& f, double t) {
  double at;
  const FrameSample& side = clock_.shortly_before(t, f.pp, at);
  return course_with(f, side, at);
}

FailureSolver::Course FailureSolver::course_with(const FastFunction& f, const FrameSample& side, double t) {
  Course now;
  now.t = t;
  now.value = f.value(side);
  now.slope = f.slope(side);
  const ClockCell& cell = clock_.cell(t);
  now.local = cell.sharp;
  if (now.local) now.bend = f.bend(side);
  take_bounds(f, now, cell);
  return now;
}

/// Those that hold all over the cell.
void FailureSolver::take_bounds(const FastFunction& f, Course& course, const ClockCell& cell) const {
  course.cell = cell;
  if (course.local) {
    course.third = f.third(cell.third(f.pp));
  } else {
    course.third = 0;
    course.bend = f.curvature(cell.curvature(f.pp));
  }
}

void FailureSolver::start(Certificate& c, double t) {
  release(c);
  c.function = FastFunction::level_zero(leg(), geometry_, form_of(c));
  c.kind = FailureKind::not_before;
  c.lo = t;
  if (c.lo >= leg().end) return set_not_before(c, c.lo);
  if (clock_.straight() && start_on_line(c, t)) return;
  const Course now = course(c.function, c.lo);
  const int sign = sign_of(now.value, 0);
  if (sign == 0) return advance_hard(c, c.lo);
  if (sign != c.sign) throw StructureError("a certificate is invalid where it is said to hold");
  if (!advance_along(c, now, c.lo)) advance_hard(c, c.lo);
}

void FailureSolver::advance(Certificate& c) {
  if (c.kind == FailureKind::not_before) return advance_from(c, c.lo);
  refine_fast(c);
  c.kind = FailureKind::isolated;
}

/// The certificate is known to hold up to t.
void FailureSolver::advance_from(Certificate& c, double t) {
  if (t >= leg().end) return set_not_before(c, t);
  const auto advance_by = [&](const Course& now) {
    return sign_of(now.value, 0) == c.sign && advance_along(c, now, t);
  };
  const Course near = course_near(c.function, t);
  if (advance_by(near) || (near.t < t && advance_by(course(c.function, t)))) return;
  advance_hard(c, t);
}

/// A function that stays positive to the end of a cell: how far it does by the bounds of the wider cells around, so
/// many of them at most.
double FailureSolver::positive_beyond(const Certificate& c, const Course& now, double value, int cells) {
  const FastFunction& f = c.function;
  const double slope = c.sign * now.slope.value - now.slope.error, bend = c.sign * now.bend.value - now.bend.error;
  double reached = now.cell.end;
  const auto wider = [&](const ClockPlace& cell) { return now.local ? clock_.outlook(cell) : clock_.wider(cell); };
  for (const ClockCell* wide = wider(now.cell); wide; wide = wider(*wide)) {
    if (wide->end <= reached) continue;
    const double limit = wide->end - now.t;
    double least_bend;
    if (now.local) {
      least_bend = bend - f.third(wide->third(f.pp)) * limit * one_third;
    } else {
      const Bounded k = f.curvature(wide->curvature(f.pp));
      least_bend = c.sign * k.value - k.error;
    }
    if (!positive_throughout(value, slope, least_bend, limit)) {
      return std::max(reached, below(now.t + positive_until(value, slope, least_bend, limit)));
    }
    reached = wide->end;
    if (--cells == 0) break;
  }
  return reached;
}

double FailureSolver::lasts(const Certificate& c, const Course& now, double least) const {
  const double slope = c.sign * now.slope.value - now.slope.error, bend = c.sign * now.bend.value - now.bend.error;
  return positive_until(least, slope, bend, now.third, now.cell.end - now.t);
}

/// The certificate's sign holds for `lasting` from now.t on, where its value is `least` at least, and perhaps longer.
/// False if that is not much longer than until t, by which doubles cannot tell more, or not those about now.t.
bool FailureSolver::holds_on(Certificate& c, const Course& now, double t, double least, double lasting, int cells) {
  const double limit = now.cell.end - now.t;
  if (lasting >= limit) {  // never true of a NaN
    set_not_before(c, positive_beyond(c, now, least, cells));
    return true;
  }
  const double next = below(now.t + lasting);
  // Where the motion is singular, bounds are loose and steps short: one search at high precision is quicker than those.
  const bool good = now.cell.sharp || leg().bridge;
  if (!(next > t + (good ? 0x1p-46 : 0x1p-8) * limit + (t - now.t))) return false;
  set_not_before(c, next);
  return true;
}

/// Brackets the failure, which is known to come after `from`, if the function certainly falls to it from now.t or
/// `from`, whichever is later.
bool FailureSolver::isolate(Certificate& c, const Course& now, double from) {
  const double sign = c.sign, t = now.t;
  const double limit = now.cell.end - t;
  const double most = sign * now.value.value + now.value.error;
  const double slope = sign * now.slope.value + now.slope.error;
  const double bend = sign * now.bend.value + now.bend.error + now.third * limit * (1 + 0x1p-40);
  if (!(slope < 0)) return false;
  const double h = most > 0 ? negative_from(most, slope, bend) : 0;
  const double falls = bend > 0 ? std::min(limit, -slope / bend * (1 - 0x1p-48)) : limit;
  if (!(h < falls)) return false;
  c.kind = FailureKind::bracketed;
  c.lo = from;
  c.hi = std::min(above(t + h), leg().end);
  c.monotone_until = falls == limit ? now.cell.end : below(t + falls);
  return true;
}

/// The certificate is known to hold at now.t, and up to t, which is not before that. False if that is about all that
/// can be said with `now`.
bool FailureSolver::advance_along(Certificate& c, const Course& now, double t, int cells) {
  ++counts_.fast;
  const double least = c.sign * now.value.value - now.value.error;
  const double h = lasts(c, now, least);
  if (h < now.cell.end - now.t && isolate(c, now, std::max(t, below(now.t + h)))) return true;
  return holds_on(c, now, t, least, h, cells);
}

/// The certificate's sign was found in high precision at `instant`, where in doubles the function may be zero: it was
/// just born, and another one fails at the same instant, or it did so itself. If it certainly rises or falls there,
/// doubles are good enough to go on.
bool FailureSolver::advance_from_zero(Certificate& c, const Now& instant) {
  if (instant.hi >= leg().end) return false;
  Course now = course(c.function, instant.hi);
  const double width = instant.hi - instant.lo;
  if (!widen(c.function, now, instant.lo, instant.hi)) return false;
  // Over [instant.lo, instant.hi] the slope is within its bounds here and what the bend adds to them.
  const double drift = now.slope_change(width);
  const double slope = c.sign * now.slope.value, error = now.slope.error + drift;
  if (slope > error) return holds_on(c, now, now.t, 0, lasts(c, now, 0));
  if (-slope > error && !instant.concerns(c.u, c.v, c.w) && isolate(c, now, instant.lo)) {
    c.kind = FailureKind::isolated;
    // Reports show this enclosure: where doubles see little, as near t = 0, high precision is worth its price.
    return c.hi - c.lo <= 0x1p-44 * std::fabs(c.hi);
  }
  return false;
}

/// Encloses an isolated failure within a few ulps, if doubles can. Most cells have a polynomial that is as good as the
/// function: a narrow interval about its root, once certified, leaves one step of the general way.
void FailureSolver::refine_fast(Certificate& c) {
  if (!narrow(c)) newton(c);
}

/// Takes [m - r, m + r] for the enclosure, where m is a root of the cell's polynomial found without bounds, if the
/// certificate's function has its root there: it has if |f(m)| is less than r times the least slope. Then one step of
/// Newton's. False if the enclosure may still be far wider than doubles allow.
bool FailureSolver::narrow(Certificate& c) {
  const double middle = c.lo + (c.hi - c.lo) / 2;
  const ClockCell& cell = clock_.cell(middle);
  if (!cell.sharp || cell.start > c.lo || cell.end < c.hi) return false;
  const double m = c.function.root_of(cell.model, middle);
  const double radius = 0x1p-34 * (cell.end - cell.start);
  if (!(m - radius > c.lo && m + radius < c.hi)) return false;
  const Course here = course(c.function, m);
  const double flat = -c.sign * here.slope.value - here.slope.error - here.slope_change(radius);
  if (!(std::fabs(here.value.value) + here.value.error < flat * radius * (1 - 0x1p-40))) return false;
  c.lo = m - radius;
  c.hi = m + radius;
  return newton_step(c, here);
}

/// Interval Newton. The slope's bounds are taken anew in each step, over the enclosure at hand: bounds of the first
/// enclosure would leave it converging linearly.
void FailureSolver::newton(Certificate& c) {
  for (int step = 0; step < 30; ++step) {
    const double width = c.hi - c.lo, m = c.lo + width / 2;
    if (!(width > 0x1p-50 * std::fabs(m))) return;
    if (newton_step(c, course(c.function, m)) || !(c.hi - c.lo < 0.75 * width)) return;
  }
}

/// With the function's course at an instant in the enclosure, about its middle. Where the slope's bounds include zero,
/// the sign there cuts the enclosure in two. True if what is left is about what the value's error makes of it.
bool FailureSolver::newton_step(Certificate& c, const Course& here) {
  enclosed_about_ = here.t;
  const double sign = c.sign, m = here.t, reach = std::max(m - c.lo, c.hi - m);
  const double spread = here.slope.error + here.slope_change(reach);
  const double steep = -sign * here.slope.value + spread, flat = -sign * here.slope.value - spread;
  const double lo_value = sign * here.value.value - here.value.error;
  const double hi_value = sign * here.value.value + here.value.error;
  if (flat > 0) {
    const double lo = m + lo_value / (lo_value > 0 ? steep : flat);
    const double hi = m + hi_value / (hi_value > 0 ? flat : steep);
    const double slack = 0x1p-51 * (std::fabs(lo) + std::fabs(hi)) + 0x1p-50 * (std::fabs(lo - m) + std::fabs(hi - m));
    c.lo = std::max(c.lo, lo - slack);
    c.hi = std::min(c.hi, hi + slack);
    return c.hi - c.lo <= 4 * (here.value.error / flat + slack);
  }
  if (lo_value > 0) {
    c.lo = m;
  } else if (hi_value < 0) {
    c.hi = m;
  }
  return false;
}

void FailureSolver::advance_hard(Certificate& c, double t) {
  if (!c.function.level1) {
    FastFunction next;
    if (FastFunction::level_one(leg(), geometry_, form_of(c), next)) {
      ++counts_.level1;
      const FastFunction before = c.function;
      c.function = next;
      const Bounded v = next.value(clock_.at(t, next.pp));
      if (c.sign * v.value > v.error) return advance_from(c, t);
      c.function = before;
    }
  }
  advance_precise(c, precise_of(c), PreciseTime::between(t, t));
}

/// Searches the rest of the segment at high precision; the certificate's sign holds just after `from`.
void FailureSolver::advance_precise(Certificate& c, const PreciseTriple& function, const PreciseTime& from) {
  ++counts_.precise;
  // Events may crowd closer to the end of the leg than doubles can tell.
  const double t = from.last().floor();
  if (t >= leg().end) return set_not_before(c, leg().end);
  const double to = clock_.cell(std::max(t, leg().start)).end;
  if (const auto found = function.first_failure(c.sign, from, to)) {
    set_isolated(c, *found);
  } else {
    release(c);
    set_not_before(c, to);
  }
}

/// Takes the bend over a cell that reaches back to `start` and on to `end`; false if there is none.
bool FailureSolver::widen(const FastFunction& f, Course& course, double start, double end) {
  while (course.cell.start > start || course.cell.end < end) {
    const ClockCell* cell = clock_.wider(course.cell);
    if (!cell) return false;
    take_bounds(f, course, *cell);
  }
  return true;
}

/// The sign over [now.lo, now.hi], where `course` is taken at now.at.
int FailureSolver::sign_during(const FastFunction& f, const Course& course, const Now& now) {
  const double reach = std::max(now.hi - now.at, now.at - now.lo);
  if (!(reach > 0)) return sign_of(course.value, 0);
  if (course.cell.start > now.lo || course.cell.end < now.hi) {
    Course wide = course;
    return widen(f, wide, now.lo, now.hi) ? sign_during(f, wide, now) : 0;
  }
  const double steepest = std::fabs(course.slope.value) + course.slope.error + course.slope_change(reach);
  return sign_of(course.value, reach * steepest * (1 + 0x1p-40));
}

int FailureSolver::sign_now(const Form& form, Now& now) {
  const FastFunction fast = FastFunction::level_zero(leg(), geometry_, form);
  if (const int s =
          clock_.straight() ? line_of(fast).sign_over(now.lo, now.hi) : sign_during(fast, course(fast, now.at), now))
    return s;
  return precise_sign(form, now);
}

int FailureSolver::precise_sign(const Form& form, Now& now) {
  ++counts_.precise;
  if (const int s = sign_at(leg(), geometry_, form, now, precise_now(now))) return s;
  throw Undecidable{"two events at the same instant"};
}

void FailureSolver::start_at(Certificate& c, Now& now) {
  release(c);
  const Form form = form_of(c);
  c.function = FastFunction::level_zero(leg(), geometry_, form);
  c.kind = FailureKind::not_before;
  if (now.concerns(c.u, c.v, c.w)) {
    c.sign = static_cast<std::int8_t>(same_order(now, c.u, c.v) ? -now.sign : now.sign);
    if (now.monotone_until > now.hi) return set_not_before(c, now.monotone_until);
    if (advance_from_zero(c, now)) return;
    advance_precise(c, precise_of(c), precise_now(now).last());
    return;
  }
  if (start_in_doubles(c, now)) return;
  FastFunction next;
  if (FastFunction::level_one(leg(), geometry_, form, next)) {
    ++counts_.level1;
    std::swap(c.function, next);
    if (start_in_doubles(c, now)) return;
    std::swap(c.function, next);
  }
  c.sign = static_cast<std::int8_t>(precise_sign(form, now));
  if (!advance_from_zero(c, now)) advance_precise(c, precise_of(c), precise_now(now));
}

/// By the certificate's function as it stands, if that shows a sign at the present.
bool FailureSolver::start_in_doubles(Certificate& c, const Now& now) {
  if (clock_.straight() && start_on_line(c, now)) return true;
  const Course here = course(c.function, now.at);
  const int sign = sign_during(c.function, here, now);
  if (sign == 0) return false;
  c.sign = static_cast<std::int8_t>(sign);
  if (now.hi >= leg().end) {
    set_not_before(c, now.hi);
  } else if (!advance_along(c, here, now.hi, cells_for_new)) {
    advance_from(c, now.hi);
  }
  return true;
}

}  // namespace taut
