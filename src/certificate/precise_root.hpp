// Instants at one precision, and the first root there of functions combined from certificate functions and a margin,
// which no cache keeps.
#pragma once

#include "certificate/search_from_end.hpp"

namespace taut::internal {

template <class Real>
Ball<Real> ball_of(const PreciseTime& t) {
  const RealMax lo = t.lo(), hi = t.hi(), middle = (lo + hi) / 2;
  Ball<Real> b(Real(middle), 0.0);
  const double half = RealTraits<RealMax>::magnitude(RealMax(hi - lo));
  b.rad = detail::inflate(half + RealTraits<RealMax>::magnitude(middle) * (4 * unit_roundoff<Real>()));
  return b;
}

/// The number at this precision. Throws if it would be rounded, because a search from the rounded number might start
/// beyond a root.
template <class Real>
Real exactly(const RealMax& x) {
  const Real rounded(x);
  if (RealMax(rounded) != x) throw PrecisionExhausted{};
  return rounded;
}

/// An enclosure at this precision, rounded outwards.
template <class Real>
RootEnclosure<Real> enclosure(const PreciseTime& t) {
  const auto around = [](const RealMax& x) {
    const Real rounded(x);
    return Ball<Real>(rounded, RealMax(rounded) == x ? 0 : detail::inflate(2 * detail::rounding(rounded)));
  };
  return {around(t.lo()).lower(), around(t.hi()).upper()};
}

/// The first change of sign in (from.hi, to], where `sign` holds just after `from`. Throws PrecisionExhausted.
template <class Real, class Function>
std::optional<PreciseTime> first_change(const MotionSegment& segment, const Function& f, int sign,
                                        const PreciseTime& from, double to, Stage stage) {
  if (const auto cut = division(segment, from, to)) {
    if (auto first = first_change<Real>(segment, f, sign, from, *cut, stage)) return first;
    return first_change<Real>(segment, f, sign, PreciseTime::between(*cut, *cut), to, stage);
  }
  if (const int end = singular_end(segment, from, to)) {
    if (const auto decided = search_from_end<Real>(segment, f, end, sign, from, to, stage)) return *decided;
  }
  auto root = first_sign_change<Real>(f, sign, exactly<Real>(from.hi()), Real(to), Halves{}, search_budget<Real>);
  if (!root) return std::nullopt;
  refine(f, sign, *root);
  return PreciseTime{RealMax(root->lo), RealMax(root->hi), stage};
}

/// Shrinks an isolating enclosure; `sign` is the sign before the root. Throws PrecisionExhausted.
template <class Real, class Function>
PreciseTime refined_change(const MotionSegment& segment, const Function& f, int sign, const PreciseTime& t,
                           Stage stage) {
  if (const int end = singular_end(segment, t, t.ceiling())) {
    return SearchFromEnd<Real, Function>(f, end > 0 ? segment.start : segment.end, end).refined(sign, t, stage, 0);
  }
  RootEnclosure<Real> root = enclosure<Real>(t);
  refine(f, sign, root);
  return PreciseTime{RealMax(root.lo), RealMax(root.hi), stage};
}

}  // namespace taut::internal
