// The first change of sign of a twice differentiable function, certified.
#pragma once

#include <array>
#include <optional>

#include "numeric/jet.hpp"

namespace taut {

/// A stage could not decide at its precision; a more precise one may.
struct PrecisionExhausted {};

/// Exactly one root lies in [lo, hi], the function is strictly monotone there, and changes sign.
template <class Real>
struct RootEnclosure {
  Real lo, hi;
};

namespace detail {

/// The range over [a, b] by the better of three forms: direct, mean value, and second order about the middle.
template <class Real>
int sign_over(const Jet<Real>& wide, const Jet<Real>& at_middle, double reach) {
  if (const int s = wide.v.sign()) return s;
  using B = Ball<Real>;
  const B step(Real(0), reach);
  if (const int s = (at_middle.v + wide.d * step).sign()) return s;
  const double half_square = reach * reach / 2 * (1 + 0x1p-50);
  const B square(Real(half_square / 2), half_square / 2 * (1 + 0x1p-50));
  return (at_middle.v + at_middle.d * step + wide.dd * square).sign();
}

}  // namespace detail

/// The first root in (a, b] at which the sign changes from `sign`, which holds just after a.
/// Nothing if there is none: then the sign holds on (a, b]. Throws PrecisionExhausted.
/// The idea: exclude the sign change over an interval, or certify monotonicity, or halve.
template <class Real, class Function>
std::optional<RootEnclosure<Real>> first_sign_change(const Function& f, int sign, const Real& a, const Real& b) {
  using B = Ball<Real>;
  struct Interval {
    Real lo, hi;
  };
  // Halving depth first: at most one interval waits per level, and there are no more levels than bits.
  constexpr std::size_t room = 2 * RealTraits<Real>::bits + 64;
  std::array<Interval, room> todo;
  std::size_t waiting = 0;
  todo[waiting++] = {a, b};
  const double tiny =
      unit_roundoff<Real>() * 64 * (RealTraits<Real>::magnitude(a) + RealTraits<Real>::magnitude(b) + 0x1p-900);
  for (int budget = 200000; waiting > 0; --budget) {
    if (budget == 0) throw PrecisionExhausted{};
    const Interval i = todo[--waiting];
    if (!(i.hi > i.lo)) continue;
    const B whole = B::between(i.lo, i.hi);
    const Jet<Real> wide = f(whole);
    if (wide.v.sign() == sign) continue;
    const Jet<Real> middle = f(B(whole.mid, 0.0));
    if (detail::sign_over(wide, middle, whole.rad) == sign) continue;
    const int slope = wide.d.sign();
    if (slope == sign) continue;  // it moves away from zero, and started with `sign`
    if (slope == -sign) {
      const int at_end = f(B(i.hi, 0.0)).v.sign();
      if (at_end == sign) continue;
      if (at_end == -sign) return RootEnclosure<Real>{i.lo, i.hi};
    }
    if (!(RealTraits<Real>::magnitude(Real(i.hi - i.lo)) > tiny)) throw PrecisionExhausted{};
    const Real middle_point = whole.mid;
    if (waiting + 2 > room) throw PrecisionExhausted{};
    todo[waiting++] = {middle_point, i.hi};
    todo[waiting++] = {i.lo, middle_point};
  }
  return std::nullopt;
}

/// Shrinks an enclosure by interval Newton steps until they gain no more.
/// `sign` is the sign before the root.
template <class Real, class Function>
void refine(const Function& f, int sign, RootEnclosure<Real>& r) {
  using B = Ball<Real>;
  for (int step = 0; step < 4000; ++step) {
    const B whole = B::between(r.lo, r.hi);
    const B slope = f(whole).d;
    const B value = f(B(whole.mid, 0.0)).v;
    const Real before = r.hi - r.lo;
    bool halved = false;
    if (const int s = value.sign()) {
      (s == sign ? r.lo : r.hi) = whole.mid;
      halved = true;
    }
    if (slope.sign() != 0) {
      const B newton = B(whole.mid, 0.0) - value / slope;
      const Real lo = newton.lower(), hi = newton.upper();
      if (lo > r.lo) r.lo = lo;
      if (hi < r.hi) r.hi = hi;
    }
    if (r.hi < r.lo) throw PrecisionExhausted{};
    const Real after = r.hi - r.lo;
    if (!halved && !(after < before * 0.75)) return;
    if (RealTraits<Real>::magnitude(after) <= unit_roundoff<Real>() * 8 * RealTraits<Real>::magnitude(r.hi)) return;
  }
}

}  // namespace taut
