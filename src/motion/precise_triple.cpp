#include "motion/precise_triple.hpp"

#include "motion/placement.hpp"
#include "numeric/root_isolation.hpp"

namespace taut {
namespace {

template <class Real>
Ball<Real> as_ball(const PreciseTime& t) {
  const RealMax middle = (t.lo + t.hi) / 2;
  Ball<Real> b(Real(middle), 0.0);
  const double half = RealTraits<RealMax>::magnitude(RealMax(t.hi - t.lo));
  b.rad = detail::inflate(half + RealTraits<RealMax>::magnitude(middle) * (4 * unit_roundoff<Real>()));
  return b;
}

}  // namespace

int PreciseTriple::sign_at(const PreciseTime& t, int stage) const {
  return with_stage(stage, [&](auto zero) {
    using Real = decltype(zero);
    return PreciseFunction<Real>(leg_, geometry_, triple_, measure_).value(as_ball<Real>(t)).sign();
  });
}

std::optional<PreciseTime> PreciseTriple::first_failure(int sign, const PreciseTime& from, double to) const {
  for (int stage = 0; stage < precise_stages; ++stage) {
    if (stage < from.stage) continue;
    try {
      return with_stage(stage, [&](auto zero) -> std::optional<PreciseTime> {
        using Real = decltype(zero);
        const PreciseFunction<Real> f(leg_, geometry_, triple_, measure_);
        auto root = first_sign_change<Real>(f, sign, Real(from.hi), Real(to));
        if (!root) return std::nullopt;
        taut::refine(f, sign, *root);
        return PreciseTime{RealMax(root->lo), RealMax(root->hi), stage};
      });
    } catch (const PrecisionExhausted&) {
    }
  }
  throw Undecidable{"the failure time of a certificate"};
}

bool PreciseTriple::refine(int sign, PreciseTime& t, int stage) const {
  if (t.stage >= stage) return true;
  return with_stage(stage, [&](auto zero) {
    using Real = decltype(zero);
    const PreciseFunction<Real> f(leg_, geometry_, triple_, measure_);
    RootEnclosure<Real> root{Real(t.lo), Real(t.hi)};
    try {
      taut::refine(f, sign, root);
    } catch (const PrecisionExhausted&) {
      return false;
    }
    t = {RealMax(root.lo), RealMax(root.hi), stage};
    return true;
  });
}

}  // namespace taut
