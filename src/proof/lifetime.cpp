#include "proof/lifetime.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/budget.hpp"
#include "numeric/errors.hpp"
#include "numeric/quadratic_bound.hpp"
#include "numeric/stages.hpp"
#include "proof/format.hpp"
#include "scene/placement.hpp"
#include "taut/proof.hpp"

namespace taut::internal::proof {
namespace {

double below(double x) { return std::nextafter(x, -INFINITY); }
double above(double x) { return std::nextafter(x, INFINITY); }

/// Steps back in time that doubles may take before high precision is asked.
constexpr int subdivision_threshold = 1000;

}  // namespace

bool Lifetimes::at_stage(const Instant& i, Stage stage, PreciseTime& t) const {
  t = i.enclosure();
  return i.refine(segment(), geometry_, stage, t);
}

/// From a guess in root.lo: an interval in which f is strictly monotone and changes from `sign` to -`sign`.
bool Lifetimes::enclose(const FastFunction& f, int sign, Instant& root) {
  const double t = root.lo;
  const FrameSample& side = clock_.at(t, f.pp);
  const Bounded v = f.value(side), d = f.slope(side);
  const double flat = -sign * d.value - d.error;
  if (!(flat > 0)) return false;
  const ModelCell& cell = clock_.cell(t);
  const Bounded k = f.curvature(cell.curvature(f.pp));
  const double radius = 4 * (std::fabs(v.value) + v.error) / flat;
  const double slack = radius * (std::fabs(k.value) + k.error);
  if (!(slack <= flat / 2)) return false;
  // |f(t)| < slope * radius, so the root is inside, at t - f(t)/slope for some slope in [flat / 2, steep].
  const double steep = -sign * d.value + d.error + slack;
  const double most = sign * v.value + v.error, least = sign * v.value - v.error;
  const double after = most / (most > 0 ? flat - slack : steep), before = least / (least > 0 ? steep : flat - slack);
  const double room = 0x1p-50 * (std::fabs(before) + std::fabs(after));
  root.lo = below(t + (before - room));
  root.hi = above(t + (after + room));
  return root.lo >= cell.start && root.hi <= cell.end;
}

/// From t back towards the form's birth; t becomes how far it came. True if that is all the way.
bool Lifetimes::holds_back(const FastFunction& f, const SignedFunction& function, double& t) {
  const bool from_root = function.from_root;
  const double stop = function.birth.lo;
  for (int step = 0; step < subdivision_threshold; ++step) {
    checkpoint();
    const FrameSample& side = clock_.at(t, f.pp);
    const Bounded v = f.value(side), d = f.slope(side);
    const double a = function.sign * v.value - v.error;
    if (!(a > 0)) return false;
    if (t <= stop) return !from_root;
    double reached = t;
    for (const ModelCell* cell = &clock_.cell(below(t)); cell; cell = clock_.wider(*cell)) {
      if (cell->start >= reached) continue;
      const double limit = t - std::max(cell->start, stop);
      const Bounded k = f.curvature(cell->curvature(f.pp));
      const double slope = function.sign * d.value, second = function.sign * k.value;
      // Growing since its birth at a root.
      if (from_root && cell->start <= stop && slope - d.error - (second + k.error) * limit > 0) return true;
      const double h = positive_until(a, -slope - d.error, second - k.error, limit);
      const bool whole = h >= limit;
      reached = whole ? t - limit : std::min(reached, above(t - h));
      if (!whole || reached <= stop) break;
    }
    if (reached <= stop && !from_root) return true;
    if (!(reached < t)) return false;
    t = reached;
  }
  return false;
}

/// Before the root, the function certainly falls since `since`: up to the root, the sign is that at `since`.
bool Lifetimes::falls_to_root(const FastFunction& f, int sign, const Instant& root, double& since) {
  const double t = root.hi;
  const Bounded d = f.slope(clock_.at(t, f.pp));
  const ModelCell& cell = clock_.cell(below(t));
  const Bounded k = f.curvature(cell.curvature(f.pp));
  const double falling = -sign * d.value - d.error, turning = k.error - sign * k.value;
  if (!(falling > 0)) return false;
  const double limit = t - cell.start;
  const double length = turning > 0 ? std::min(limit, falling / turning * (1 - 0x1p-48)) : limit;
  since = std::max(above(t - length), cell.start);
  return since < root.lo;
}

bool Lifetimes::holds(const Corner& c, const Instant& until) {
  return holds({function(c.u, c.v, c.w), c.sign, c.birth, c.birth.concerns(c.u, c.v, c.w)}, until,
               until.concerns(c.u, c.v, c.w));
}

bool Lifetimes::holds(const SignedFunction& function, const Instant& until, bool own) {
  // What is certain in doubles is certain; the rest, from the birth on, is left to high precision.
  Instant rest = until;
  return holds_in_doubles(function, until, own, rest) || holds_precisely(function, rest, own && rest.event);
}

bool Lifetimes::holds_in_doubles(const SignedFunction& function, const Instant& until, bool own) {
  Instant rest = until;
  return holds_in_doubles(function, until, own, rest);
}

bool Lifetimes::holds_in_doubles(const SignedFunction& function, const Instant& until, bool own, Instant& rest) {
  const auto done = [&](const FastFunction& f) {
    double reached = rest.hi;
    if (own && rest.event) {
      if (!falls_to_root(f, function.sign, until, reached)) return false;
      if (function.birth.lo >= reached) return !function.from_root;
    }
    const double from = reached;
    if (holds_back(f, function, reached)) return true;
    if (reached < from) rest = Instant::exactly(reached);
    return false;
  };
  if (done(FastFunction::undisplaced(segment(), geometry_, function.function))) return true;
  // The first order in the displacement is that of an orientation.
  FastFunction first_order;
  return function.function.measure == Measure::orientation &&
         FastFunction::displacement_gradient(segment(), geometry_, function.function, first_order) && done(first_order);
}

bool Lifetimes::holds_precisely(const SignedFunction& function, const Instant& until, bool own) {
  const PreciseTriple f = precise(function.function);
  return *decide("whether a corner lasts until an event", [&](Stage stage) -> std::optional<bool> {
    PreciseTime birth, end;
    if (!at_stage(function.birth, stage, birth) || !at_stage(until, stage, end)) return std::nullopt;
    birth.stage = stage;
    if (!function.from_root) {
      const int s = f.sign_at(birth, stage);
      if (s == -function.sign) return false;
      if (s == 0) return std::nullopt;
    }
    const std::optional<PreciseTime> root = f.first_failure(function.sign, birth, until.hi);
    if (!root) return !own;
    // The first root since the birth: with its own vertices it must be the very instant, and an enclosure holds one.
    const std::optional<bool> before_root = end.is_first(*root);
    return own ? !before_root : before_root;
  });
}

bool Lifetimes::behind_at_roots(const CertificateFunction& line, double from, const Instant& until) const {
  const PreciseTriple f = precise(line), along = precise(line.along()), back = precise(line.back());
  const auto is_behind = [&](PreciseTime root, int sign) {
    return *decide("whether a vertex is behind the end of an edge", [&](Stage stage) -> std::optional<bool> {
      f.refine(sign, root, stage);
      const int a = along.sign_at(root, stage), b = back.sign_at(root, stage);
      if (a < 0 || b < 0) return true;
      return a > 0 && b > 0 ? std::optional(false) : std::nullopt;
    });
  };
  const bool own = until.concerns(line.a, line.b, line.c);
  const auto is_over = [&](PreciseTime root, int sign) {
    return *decide("which of two instants is first", [&](Stage stage) -> std::optional<bool> {
      PreciseTime end;
      if (!at_stage(until, stage, end)) return std::nullopt;
      f.refine(sign, root, stage);
      const std::optional<bool> before = root.is_first(end);
      // An enclosure of the event holds one root of its own form.
      return before ? std::optional(!*before) : own ? std::optional(true) : std::nullopt;
    });
  };
  PreciseTime at = PreciseTime::between(from, from);
  int sign = decide("on which side of a line a vertex is", [&](Stage stage) { return f.sign_at(at, stage); });
  while (const std::optional<PreciseTime> root = f.first_failure(sign, at, until.hi)) {
    if (until.event && is_over(*root, sign)) return true;
    if (!is_behind(*root, sign)) return false;
    at = *root;
    sign = -sign;
  }
  return true;
}

Instant Lifetimes::failure(const Corner& c, double about) {
  Instant root;
  root.event = true;
  root.u = c.u;
  root.v = c.v;
  root.w = c.w;
  root.sign = c.sign;
  root.lo = root.hi = about;
  const CertificateFunction t = function(c.u, c.v, c.w);
  if (!(about >= segment().start && about <= segment().end)) throw ProofError("an event is not within its segment");
  if (enclose(FastFunction::undisplaced(segment(), geometry_, t), c.sign, root) && root.hi <= segment().end)
    return root;
  const PreciseTriple f = precise(t);
  const double last = std::min(segment().end, about + nearness(segment().start, segment().end));
  const auto found = decide("the instant of an event", [&](Stage stage) -> std::optional<PreciseTime> {
    PreciseTime birth;
    if (!at_stage(c.birth, stage, birth)) return std::nullopt;
    birth.stage = stage;
    // The enclosure of the birth must end before the corner fails.
    if (!c.birth.concerns(c.u, c.v, c.w) && f.sign_at(birth, stage) != c.sign) return std::nullopt;
    if (auto first = f.first_failure(c.sign, birth, last)) return first;
    throw ProofError("a corner does not fail where the log says");
  });
  root.lo = found->floor();
  root.hi = std::min(found->ceiling(), segment().end);
  root.known = std::make_shared<const PreciseTime>(*found);
  return root;
}

Instant Lifetimes::tightened(Instant event) const {
  PreciseTime t;
  if (!at_stage(event, Stage::precise, t)) return event;
  event.lo = std::max(event.lo, t.floor());
  event.hi = std::min(event.hi, t.ceiling());
  return event;
}

bool Lifetimes::is_near(const Instant& event, double about) const {
  const double near = nearness(segment().start, segment().end);
  if (about - near <= event.lo && event.hi <= about + near) return true;
  const Instant tight = tightened(event);
  return tight.lo - near <= about && about <= tight.hi + near;
}

bool Lifetimes::in_order(const Instant& a, const Instant& b) {
  if (a.hi <= b.lo) return true;
  if (b.event && a.concerns(b.u, b.v, b.w)) return b.hi >= a.lo;
  return *decide("the order of two events", [&](Stage stage) -> std::optional<bool> {
    PreciseTime x, y;
    if (!at_stage(a, stage, x) || !at_stage(b, stage, y)) return std::nullopt;
    if (x.not_after(y)) return true;
    if (y.certainly_before(x)) return false;
    return std::nullopt;
  });
}

int Lifetimes::sign_at(const CertificateFunction& function, const Instant& now) {
  const FastFunction f = FastFunction::undisplaced(segment(), geometry_, function);
  const FrameSample& side = clock_.at(now.hi, f.pp);
  const Bounded v = f.value(side), d = f.slope(side);
  const ModelCell& cell = clock_.cell(now.hi);
  const double width = now.hi - now.lo;
  const Bounded k = f.curvature(cell.curvature(f.pp));
  const double drift = width * (std::fabs(d.value) + d.error + width * (std::fabs(k.value) + k.error));
  if (cell.start <= now.lo && std::fabs(v.value) > v.error + drift * (1 + 0x1p-40)) return v.value > 0 ? 1 : -1;
  PreciseTime instant = now.enclosure();
  if (const int s = internal::sign_at(segment(), geometry_, function, now, instant)) return s;
  throw Undecidable{"which of three vertices is between the others"};
}

VertexId Lifetimes::middle(const Instant& now) {
  return middle_of(geometry_, now.u, now.v, now.w,
                   [&](const CertificateFunction& function) { return sign_at(function, now); });
}

}  // namespace taut::internal::proof
