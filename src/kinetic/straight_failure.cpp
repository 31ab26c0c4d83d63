// Certificates on straight translations, whose functions are lines: one division encloses the failure.
#include <algorithm>

#include "base/errors.hpp"
#include "kinetic/failure_solver.hpp"
#include "sign/fast_line.hpp"
#include "tiling/root_faces.hpp"

namespace taut {

FastLine FailureSolver::line_of(const FastFunction& f) const {
  return {f, clock_.straight_side(), clock_.straight_middle()};
}

/// If the line's bounds tell that its sign at t is the certificate's.
bool FailureSolver::start_on_line(Certificate& c, double t) {
  const FastLine line = line_of(c.function);
  const int sign = line.sign_over(t, t);
  if (sign == 0) return false;
  if (sign != c.sign) throw StructureError("a certificate is invalid where it is said to hold");
  return follow_line(c, line, t);
}

/// If they tell the sign at the present.
bool FailureSolver::start_on_line(Certificate& c, const Now& now) {
  const FastLine line = line_of(c.function);
  const int sign = line.sign_over(now.lo, now.hi);
  if (sign == 0) return false;
  c.sign = static_cast<std::int8_t>(sign);
  return follow_line(c, line, now.hi);
}

/// The certificate holds at t, and up to it. False if it is not certain whether it fails on the leg.
bool FailureSolver::follow_line(Certificate& c, const FastLine& line, double t) {
  ++counts_.fast;
  if (line.holds(c.sign, t, leg().end)) {
    set_not_before(c, leg().end);
    return true;
  }
  double lo, hi;
  if (!line.root(c.sign, lo, hi) || !(hi < leg().end)) return false;
  c.kind = FailureKind::isolated;
  c.lo = std::max(lo, t);
  c.hi = hi;
  c.monotone_until = leg().end;
  return true;
}

}  // namespace taut
