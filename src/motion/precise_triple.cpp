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

/// A search in s, the root of the distance from a singular end of the leg (see TimeFromEnd).
template <class Real>
class SearchFromEnd {
 public:
  SearchFromEnd(const PreciseFunction<Real>& f, double end, double direction)
      : f_(f), end_(end), direction_(direction) {}

  Jet<Real> operator()(const Ball<Real>& s) const { return f_(TimeFromEnd<Real>{end_, direction_, s}); }

  /// As PreciseTriple::first_failure does, at this precision. Throws PrecisionExhausted.
  std::optional<PreciseTime> first_failure(int sign, const RealMax& from, double to, int stage) const {
    const Ball<Real> first = root_of_distance(from), last = root_of_distance(RealMax(to));
    const Real a = first.lower(), b = last.upper();
    // The search starts a little before `from`, unless that is the end itself.
    if (first.rad > 0 && (*this)(first).v.sign() != sign) throw PrecisionExhausted{};
    auto root = first_sign_change<Real>(*this, sign, a, b);
    if (!root) return std::nullopt;
    taut::refine(*this, sign, *root);
    const Ball<RealMax> lo = time_at(root->lo), hi = time_at(root->hi);
    // What the search found within the rounding of `to` may be beyond.
    if (hi.upper() > RealMax(to)) throw PrecisionExhausted{};
    return PreciseTime{lo.lower(), hi.upper(), stage};
  }

 private:
  Ball<Real> root_of_distance(const RealMax& t) const {
    const RealMax distance = (t - RealMax(end_)) * RealMax(direction_);
    if (distance == 0) return Ball<Real>::exact(0);
    Ball<RealMax> root = sqrt(Ball<RealMax>(distance, 0.0));
    Ball<Real> s(Real(root.mid * RealMax(direction_)), 0.0);
    s.rad = detail::inflate(root.rad + RealTraits<RealMax>::magnitude(root.mid) * (4 * unit_roundoff<Real>()));
    return s;
  }
  Ball<RealMax> time_at(const Real& s) const {
    const Ball<RealMax> exact(RealMax(s), 0.0);
    return Ball<RealMax>::exact(end_) + exact * exact * direction_;
  }

  const PreciseFunction<Real>& f_;
  double end_, direction_;
};

/// Searches that touch a singular end of the leg take the way that makes the motion smooth there.
template <class Real>
std::optional<std::optional<PreciseTime>> search_at_ends(const Leg& leg, const PreciseFunction<Real>& f, int sign,
                                                         const PreciseTime& from, double to, int stage) {
  const double near = (leg.end - leg.start) / 16;
  try {
    if (to - leg.start <= near && leg.singular_at(leg.start))
      return SearchFromEnd<Real>(f, leg.start, 1).first_failure(sign, from.hi, to, stage);
    if (RealMax(leg.end) - from.hi <= RealMax(near) && leg.singular_at(leg.end))
      return SearchFromEnd<Real>(f, leg.end, -1).first_failure(sign, from.hi, to, stage);
  } catch (const PrecisionExhausted&) {
  }
  return std::nullopt;
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
        if (const auto answer = search_at_ends(leg_, f, sign, from, to, stage)) return *answer;
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

bool PreciseTriple::refine(int sign, PreciseTime& t, int stage, double enough) const {
  if (t.stage >= stage) return true;
  return with_stage(stage, [&](auto zero) {
    using Real = decltype(zero);
    const PreciseFunction<Real> f(leg_, geometry_, triple_, measure_);
    RootEnclosure<Real> root{Real(t.lo), Real(t.hi)};
    try {
      taut::refine(f, sign, root, enough);
    } catch (const PrecisionExhausted&) {
      return false;
    }
    t = {RealMax(root.lo), RealMax(root.hi), stage};
    return true;
  });
}

}  // namespace taut
