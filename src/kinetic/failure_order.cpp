// The order of two failures, and a failure as the current instant.
#include <algorithm>
#include <cmath>

#include "kinetic/failure_solver.hpp"
#include "numeric/errors.hpp"
#include "numeric/first_decisive.hpp"
#include "scene/placement.hpp"

namespace taut::internal {

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
