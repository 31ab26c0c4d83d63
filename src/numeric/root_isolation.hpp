// The first change of sign of a twice differentiable function, certified.
#pragma once

#include <optional>
#include <vector>

#include "base/interruption.hpp"
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

/// The range over a ball; no sharper than telling its sign or its slope's needs, where the function has such a one.
template <class Function, class Real>
Jet<Real> range_of(const Function& f, const Ball<Real>& t) {
  if constexpr (requires { f.telling_range(t); }) {
    return f.telling_range(t);
  } else {
    return f(t);
  }
}

/// The value alone, where the function has a cheaper way to it.
template <class Function, class Real>
Ball<Real> value_of(const Function& f, const Ball<Real>& t) {
  if constexpr (requires { f.telling_value(t); }) {
    return f.telling_value(t);
  } else if constexpr (requires { f.value(t); }) {
    return f.value(t);
  } else {
    return f(t).v;
  }
}

/// Is the function's range one that no value at the middle would improve, as those of polynomials about it are?
template <class Function, class Real>
bool is_expanded(const Function& f, const Ball<Real>& t) {
  if constexpr (requires { f.is_expanded(t); }) {
    return f.is_expanded(t);
  } else {
    return false;
  }
}

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

/// Where to cut an interval in two.
struct Halves {
  template <class Real>
  Real operator()(const Real& lo, const Real& hi) const {
    return (lo + hi) / 2;
  }
};
/// For functions whose scale may be any power of their argument near zero, which does not lie inside the interval:
/// orders of magnitude at a time.
struct Magnitudes {
  template <class Real>
  Real operator()(const Real& lo, const Real& hi) const {
    constexpr double step = 0x1p-16;
    if (hi > 0 && lo < hi * (step * step)) return hi * step;
    if (lo < 0 && hi > lo * (step * step)) return lo * step;
    return (lo + hi) / 2;
  }
};

/// Does a search get on? Where a function is so small that its value decides and no range does, as one that is constant
/// but for what cancels, all intervals have to be as short as the first one. Near a root of whatever order they grow;
/// towards an instant where the motion is nearly infinitely fast they shrink, scale by scale, and grow behind it.
class Progress {
 public:
  /// An interval of this length is done, and `left` is left. False if there is no hope.
  bool goes_on(double length, double left) {
    if (!(left > few * length) || length < shortest_) {
      start(length);
    } else if (length > longest_) {
      alike_ = 0;
      longest_ = length;
    }
    return ++alike_ < many;
  }

 private:
  void start(double length) {
    alike_ = 0;
    shortest_ = longest_ = length;
  }

  static constexpr double few = 0x1p18;  ///< more than a search has steps for
  static constexpr int many = 1024;
  double shortest_ = 0, longest_ = 0;  ///< the longest since the last that was shorter than any before
  int alike_ = 0;
};

/// The first root in (a, b] at which the sign changes from `sign`, which holds just after a.
/// Nothing if there is none: then the sign holds on (a, b]. Throws PrecisionExhausted.
/// The idea: exclude the sign change over an interval, or certify monotonicity, or cut in two, `budget` times at most.
template <class Real, class Function, class Cut = Halves>
std::optional<RootEnclosure<Real>> first_sign_change(const Function& f, int sign, const Real& a, const Real& b,
                                                     const Cut& cut = {}, int budget = 200000) {
  using B = Ball<Real>;
  // Depth first from the left: `lo` is where everything before is done, `ends` the right ends of what is left. The
  // buffer outlives the call, so that the event loop allocates nothing.
  thread_local std::vector<Real> ends;
  ends.assign(1, b);
  Real lo = a;
  const double tiny =
      unit_roundoff<Real>() * 64 * (RealTraits<Real>::magnitude(a) + RealTraits<Real>::magnitude(b) + 0x1p-900);
  Progress progress;
  for (; !ends.empty(); --budget) {
    if (budget == 0) throw PrecisionExhausted{};
    interruption_point();
    const Real hi = ends.back();
    bool excluded = !(hi > lo);
    if (!excluded) {
      const B whole = B::about_short_middle(lo, hi);
      const Jet<Real> wide = detail::range_of(f, whole);
      const int slope = wide.d.sign();
      // A slope of the same sign leads away from zero.
      excluded = wide.v.sign() == sign || slope == sign ||
                 (!detail::is_expanded(f, whole) &&
                  detail::sign_over(wide, detail::range_of(f, B(whole.mid, 0.0)), whole.rad) == sign);
      if (!excluded && slope == -sign) {
        const int at_end = detail::value_of(f, B(hi, 0.0)).sign();
        if (at_end == -sign) return RootEnclosure<Real>{lo, hi};
        excluded = at_end == sign;
      }
      if (!excluded) {
        if (!(RealTraits<Real>::magnitude(Real(hi - lo)) > tiny)) throw PrecisionExhausted{};
        ends.push_back(RealTraits<Real>::near(cut(lo, hi), RealTraits<Real>::magnitude(Real(hi - lo))));
        continue;
      }
    }
    if (!progress.goes_on(RealTraits<Real>::magnitude(Real(hi - lo)), RealTraits<Real>::magnitude(Real(b - hi))))
      throw PrecisionExhausted{};
    lo = hi;
    ends.pop_back();
  }
  return std::nullopt;
}

/// No shorter one is to be had: its ends are but a few units in the last place apart.
template <class Real>
bool is_sharp(const RootEnclosure<Real>& r) {
  using Traits = RealTraits<Real>;
  return Traits::magnitude(Real(r.hi - r.lo)) <= unit_roundoff<Real>() * 8 * Traits::magnitude(r.hi);
}

/// Shrinks an enclosure by interval Newton steps until they gain no more, or it is no wider than `enough`.
/// `sign` is the sign before the root.
template <class Real, class Function>
void refine(const Function& f, int sign, RootEnclosure<Real>& r, double enough = 0) {
  using B = Ball<Real>;
  for (int step = 0; step < 4000; ++step) {
    interruption_point();
    const B whole = B::about_short_middle(r.lo, r.hi);
    const B slope = detail::range_of(f, whole).d;
    const B value = detail::value_of(f, B(whole.mid, 0.0));
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
    if (RealTraits<Real>::magnitude(after) <= enough || is_sharp(r)) return;
  }
}

/// The same where the slope over the whole enclosure is known to a few digits at least: each step needs one value, and
/// gains as many bits as the slope has, down to what the value's own error allows.
template <class Real, class Function>
void refine_with_slope(const Function& f, const Ball<double>& slope, int sign, RootEnclosure<Real>& r,
                       double enough = 0) {
  using B = Ball<Real>;
  const B steep(RealTraits<Real>::from_double(slope.mid), slope.rad);
  for (int step = 0; step < 64; ++step) {
    const Real before = r.hi - r.lo;
    const Real middle = RealTraits<Real>::near((r.lo + r.hi) / 2, RealTraits<Real>::magnitude(before));
    const B value = detail::value_of(f, B(middle, 0.0));
    if (const int s = value.sign()) (s == sign ? r.lo : r.hi) = middle;
    const B newton = B(middle, 0.0) - value / steep;
    const Real lo = newton.lower(), hi = newton.upper();
    if (lo > r.lo) r.lo = lo;
    if (hi < r.hi) r.hi = hi;
    if (r.hi < r.lo) throw PrecisionExhausted{};
    const double width = RealTraits<Real>::magnitude(Real(r.hi - r.lo));
    if (width <= enough || !(width < 0x1p-10 * RealTraits<Real>::magnitude(before)) || is_sharp(r)) return;
  }
}

}  // namespace taut
