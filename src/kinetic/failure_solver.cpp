#include "kinetic/failure_solver.hpp"

#include <algorithm>
#include <cmath>

#include "certificate/exact_line.hpp"
#include "certificate/search_from_end.hpp"
#include "numeric/errors.hpp"
#include "numeric/stages.hpp"
#include "scene/placement.hpp"
#include "tiling/root_faces.hpp"

namespace taut::internal {
namespace {

/// The number of cells beyond its own for which a new certificate is followed. Most certificates die early.
constexpr int cells_for_new = 1;

/// Is (u, v, w) the event's corner up to cyclic rotation?
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

PreciseTime& FailureSolver::precise_now(Now& now) {
  if (!now.precise) now.precise = PreciseTime::between(now.lo, now.hi);
  return *now.precise;
}

void FailureSolver::release(Certificate& c) {
  if (c.precise >= 0) pool_free_.push_back(c.precise);
  c.precise = -1;
}

void FailureSolver::holds_until(Certificate& c, double t) {
  release(c);
  c.come_after(t, segment().end);
}

void FailureSolver::set_isolated(Certificate& c, const PreciseTime& t) {
  precise_slot(c) = t;
  c.kind = RootKind::isolated;
  c.lo = t.floor();
  c.hi = std::min(t.ceiling(), segment().end);
  c.monotone_until = c.lo;  // nothing is known in doubles
}

void FailureSolver::start(Certificate& c, double t) {
  release(c);
  c.function = FastFunction::undisplaced(segment(), geometry_, function_of(c));
  c.kind = RootKind::not_before;
  c.lo = t;
  if (c.lo >= segment().end) return c.come_after(c.lo, segment().end);
  if (clock_.straight() && start_on_line(c, t)) return;
  const LocalExpansion now = fast_.expansion(c.function, c.lo);
  const int sign = now.value.sign();
  if (sign == 0) return advance_hard(c, c.lo);
  if (sign != c.sign) throw StructureError("a certificate is invalid where it is said to hold");
  if (!fast_.follow(c, now, c.lo)) advance_hard(c, c.lo);
}

/// Succeeds if the bounds of the line show that its sign at t is that of the certificate.
bool FailureSolver::start_on_line(Certificate& c, double t) {
  const FastLine line = fast_.line_of(c.function);
  const int sign = line.sign_over(t, t);
  if (sign == 0) return false;
  if (sign != c.sign) throw StructureError("a certificate is invalid where it is said to hold");
  return fast_.follow_line(c, line, t);
}

/// Succeeds if the bounds of the line determine the sign at `now`.
bool FailureSolver::start_on_line(Certificate& c, const Now& now) {
  const FastLine line = fast_.line_of(c.function);
  const int sign = line.sign_over(now.lo, now.hi);
  if (sign == 0) return false;
  c.sign = static_cast<std::int8_t>(sign);
  return fast_.follow_line(c, line, now.hi);
}

void FailureSolver::advance(Certificate& c) {
  if (c.kind == RootKind::not_before) return advance_from(c, c.lo);
  fast_.enclose(c);
  c.kind = RootKind::isolated;
}

/// The certificate is known to hold up to t.
void FailureSolver::advance_from(Certificate& c, double t) {
  if (t >= segment().end) return c.come_after(t, segment().end);
  const auto advance_by = [&](const LocalExpansion& now) {
    return now.value.sign() == c.sign && fast_.follow(c, now, t);
  };
  const LocalExpansion near = fast_.expansion_near(c.function, t);
  if (advance_by(near) || (near.t < t && advance_by(fast_.expansion(c.function, t)))) return;
  advance_hard(c, t);
}

void FailureSolver::advance_hard(Certificate& c, double t) {
  // In doubles, the slope may have a sign where the value has none. Exact lines need no more than the slope.
  if (!clock_.straight() && fast_.follow_from_zero(c, Instant::exactly(t), false)) return;
  if (!c.function.level1) {
    FastFunction next;
    if (FastFunction::displacement_gradient(segment(), geometry_, function_of(c), next)) {
      memory_.stages.add(Stage::first_order);
      const FastFunction before = c.function;
      c.function = next;
      const Bounded v = next.value(clock_.at(t, next.pp));
      if (c.sign * v.value > v.error) return advance_from(c, t);
      c.function = before;
    }
  }
  advance_precise(c, precise_of(c), PreciseTime::between(t, t));
}

/// Searches the rest of the segment at high precision. The certificate's sign holds just after `from`.
void FailureSolver::advance_precise(Certificate& c, const PreciseTriple& function, const PreciseTime& from) {
  if (pass_turn(c, from)) return memory_.stages.add(Stage::fixed);
  // Events may accumulate closer to the end of the segment than doubles can distinguish.
  const double t = from.last().floor();
  if (t >= segment().end) return holds_until(c, segment().end);
  const double to = clock_.cell(std::max(t, segment().start)).end;
  if (!advance_near_end(c, function, from, to)) advance_to(c, function, from, to);
}

void FailureSolver::advance_to(Certificate& c, const PreciseTriple& function, const PreciseTime& from, double to) {
  if (const auto found = function.first_failure(c.sign, from, to)) {
    set_isolated(c, *found);
  } else {
    holds_until(c, to);
  }
}

/// Towards an instant of infinite speed, cells become shorter and shorter. A search from that instant takes about as
/// long for the whole neighbourhood as for one cell.
bool FailureSolver::advance_near_end(Certificate& c, const PreciseTriple& function, const PreciseTime& from,
                                     double segment_end) {
  const double to = end_of_neighbourhood(segment(), from.last().floor());
  if (to <= segment_end || hopeless_near_end_) return false;
  try {
    advance_to(c, function, from, to);
    return true;
  } catch (const Undecidable&) {
    // The undecidable event is a later one, which may not matter.
    hopeless_near_end_ = true;
    return false;
  }
}

/// Where the function nearly touches zero, as for symmetric mechanisms, its extremum decides. The certificate's sign
/// holds just after `from`. Returns false if the extremum does not decide.
bool FailureSolver::pass_turn(Certificate& c, const PreciseTime& from) {
  if (c.function.level1 || from.floor() < segment().start || from.ceiling() > segment().end) return false;
  const std::optional<PlaceOfTurn> place = fast_.turn_near(c.function, from.floor());
  if (!place) return false;
  const auto found = precise_of(c).near_extremum(c.sign, from, place->at);
  if (!found) return false;
  if (found->failure) return isolate_on_segment(c, *found->failure);
  holds_until(c, place->until);
  return true;
}

/// Returns false if it is not known whether the failure comes on the segment.
bool FailureSolver::isolate_on_segment(Certificate& c, const PreciseTime& t) {
  const PreciseTime end = PreciseTime::between(segment().end, segment().end);
  if (end.certainly_before(t)) {
    holds_until(c, segment().end);
  } else if (t.not_after(end)) {
    set_isolated(c, t);
  } else {
    return false;
  }
  return true;
}

int FailureSolver::sign_now(const CertificateFunction& function, Now& now) {
  const FastFunction fast = FastFunction::undisplaced(segment(), geometry_, function);
  const int sign = clock_.straight() ? fast_.line_of(fast).sign_over(now.lo, now.hi)
                                     : fast_.sign_during(fast, fast_.expansion(fast, now.at), now.lo, now.hi, now.at);
  return sign != 0 ? sign : precise_sign(function, now);
}

int FailureSolver::precise_sign(const CertificateFunction& function, Now& now) {
  if (const int s = sign_at(segment(), geometry_, function, now, precise_now(now), &memory_)) return s;
  throw Undecidable{"two events at the same instant"};
}

void FailureSolver::start_at(Certificate& c, Now& now) {
  release(c);
  const CertificateFunction function = function_of(c);
  c.function = FastFunction::undisplaced(segment(), geometry_, function);
  c.kind = RootKind::not_before;
  if (now.concerns(c.u, c.v, c.w)) {
    c.sign = static_cast<std::int8_t>(same_order(now, c.u, c.v) ? -now.sign : now.sign);
    if (now.monotone_until > now.hi) return c.come_after(now.monotone_until, segment().end);
    if (fast_.follow_from_zero(c, now, true)) return;
    advance_precise(c, precise_of(c), precise_now(now).last());
    return;
  }
  if (start_in_doubles(c, now)) return;
  FastFunction next;
  if (FastFunction::displacement_gradient(segment(), geometry_, function, next)) {
    memory_.stages.add(Stage::first_order);
    std::swap(c.function, next);
    if (start_in_doubles(c, now)) return;
    std::swap(c.function, next);
  }
  c.sign = static_cast<std::int8_t>(precise_sign(function, now));
  if (!fast_.follow_from_zero(c, now, false)) advance_precise(c, precise_of(c), precise_now(now));
}

/// Uses the certificate's function as it stands. Returns false if that shows no sign at `now`.
bool FailureSolver::start_in_doubles(Certificate& c, const Now& now) {
  if (clock_.straight() && start_on_line(c, now)) return true;
  const LocalExpansion here = fast_.expansion(c.function, now.at);
  const int sign = fast_.sign_during(c.function, here, now.lo, now.hi, now.at);
  if (sign == 0) return false;
  c.sign = static_cast<std::int8_t>(sign);
  if (now.hi >= segment().end) {
    c.come_after(now.hi, segment().end);
  } else if (!fast_.follow(c, here, now.hi, cells_for_new)) {
    advance_from(c, now.hi);
  }
  return true;
}

// The order of two failures, and a failure as the current instant.

bool FailureSolver::known_before(const Certificate& a, const Certificate& b) const {
  if (a.hi < b.lo) return true;
  if (a.precise < 0 && b.precise < 0) return false;
  const auto at = [this](const Certificate& c) -> const PreciseTime& {
    return pool_[static_cast<std::size_t>(c.precise)];
  };
  if (b.precise < 0) return at(a).certainly_before(PreciseTime::between(b.lo, b.lo));
  if (a.precise < 0) return PreciseTime::between(a.hi, a.hi).certainly_before(at(b));
  return at(a).certainly_before(at(b));
}

/// Refines one certificate by one stage.
void FailureSolver::sharpen(Certificate& c, Stage stage) {
  if (c.precise < 0) precise_slot(c) = PreciseTime::between(c.lo, c.hi);
  PreciseTime& t = pool_[static_cast<std::size_t>(c.precise)];
  precise_of(c).refine(c.sign, t, stage);
  t.stage = std::max(t.stage, stage);  // what a stage could not improve now, it will not improve next time either
  c.lo = t.floor();
  c.hi = std::min(t.ceiling(), segment().end);
}

void FailureSolver::separate(Certificate& a, Certificate& b) {
  const auto stage_of = [this](const Certificate& c) {
    return c.precise < 0 ? Stage::doubles : pool_[static_cast<std::size_t>(c.precise)].stage;
  };
  const Stage stage = next_closer(std::min(stage_of(a), stage_of(b)));
  if (stage > last_stage) throw Undecidable{"the order of two events"};
  if (stage_of(a) < stage) sharpen(a, stage);
  if (stage_of(b) < stage) sharpen(b, stage);
}

bool FailureSolver::fails_by(Certificate& c, double t) {
  const Bounded v = c.function.value(clock_.at(t, c.function.pp));
  if (c.sign * v.value > v.error) return false;
  if (-c.sign * v.value > v.error) return true;
  const PreciseTriple f = precise_of(c);
  const auto sign = [&](Stage stage) { return f.sign_at(PreciseTime::between(t, t), stage); };
  return decide("whether an event falls on the end of the interval", sign) != c.sign;
}

VertexId FailureSolver::middle(VertexId u, VertexId v, VertexId w, Now& now) {
  return middle_of(geometry_, u, v, w, [&](const CertificateFunction& function) { return sign_now(function, now); });
}

Now FailureSolver::event(const Certificate& c) const {
  const double about = fast_.enclosed_about();
  Now now;
  now.lo = c.lo;
  now.hi = c.hi;
  now.at = about >= c.lo && about <= c.hi ? about : c.hi;
  now.event = true;
  now.u = c.u;
  now.v = c.v;
  now.w = c.w;
  now.sign = c.sign;
  now.monotone_until = c.monotone_until;
  now.precise = known_precisely(c);
  return now;
}

std::optional<PreciseTime> FailureSolver::known_precisely(const Certificate& c) const {
  if (c.precise < 0) return std::nullopt;
  return pool_[static_cast<std::size_t>(c.precise)];
}

void FailureSolver::tighten(Certificate& c) {
  const double few_ulps = 0x1p-54 * std::fabs(c.hi);
  if (c.hi - c.lo <= 8 * few_ulps) return;
  PreciseTime t = known_precisely(c).value_or(PreciseTime::between(c.lo, c.hi));
  if (!precise_of(c).refine(c.sign, t, Stage::precise, few_ulps)) return;
  c.lo = std::max(c.lo, t.floor());
  c.hi = std::min(c.hi, t.ceiling());
}

}  // namespace taut::internal
