// The first change of sign of a twice differentiable function, certified.
#pragma once

#include <optional>
#include <vector>

#include "numeric/budget.hpp"
#include "numeric/jet.hpp"
#include "numeric/root_count.hpp"

namespace taut::internal {

/// A stage could not decide at its precision; a more precise one may.
struct PrecisionExhausted {};

/// Exactly one root lies in [lo, hi], the function is strictly monotone there, and changes sign.
template <class Real>
struct RootEnclosure {
  Real lo, hi;
};

namespace detail {

/// In units of checkpoint(), in addition to the work of the function.
constexpr std::uint64_t work_of_step = 9;

/// The range over a ball. If the function offers a cheaper one, it is only as sharp as is needed to decide its sign or
/// that of its slope.
template <class Function, class Real>
Jet<Real> range_of(const Function& f, const Ball<Real>& t) {
  if constexpr (requires { f.decisive_range(t); }) {
    return f.decisive_range(t);
  } else {
    return f(t);
  }
}

/// The value alone, by a cheaper method where the function has one.
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

/// Is the function's range so tight that a value at the middle would not improve it, as for polynomials about the
/// middle?
template <class Function, class Real>
bool is_expanded(const Function& f, const Ball<Real>& t) {
  if constexpr (requires { f.is_expanded(t); }) {
    return f.is_expanded(t);
  } else {
    return false;
  }
}

/// The information that the signs of derivatives give about an interval outside of which some signs are known.
template <class Real>
struct ParentBounds {
  enum : unsigned char { nothing, excluded, one_root, cuts } decided = nothing;
  Real cut[2];  ///< the places at which to cut the interval, in order
  int cut_count = 0;
};

/// Determines whether the interval contains no root or one root, or where to cut it, if ranges show neither. `sign`
/// holds just after `lo`.
template <class Function, class Real>
ParentBounds<Real> parent_bounds(const Function& f, int sign, const Real& lo, const Real& hi, const Ball<Real>& whole) {
  ParentBounds<Real> seen;
  if constexpr (requires { f.expansion(whole); }) {
    const auto polynomial = f.expansion(whole);
    if (!polynomial) return seen;
    const Ball<Real> middle(whole.mid, 0.0);
    const RootCount<Real> count(*polynomial, Ball<Real>(lo, 0.0) - middle, Ball<Real>(hi, 0.0) - middle);
    const int most = count.most(sign);
    const int at_end = most == 1 ? value_of(f, Ball<Real>(hi, 0.0)).sign() : 0;
    if (most == 0 || at_end == sign) {
      seen.decided = ParentBounds<Real>::excluded;
      return seen;
    }
    // The neighbourhood of the cluster encloses a single root, too, far better.
    if (const auto cluster = count.cluster()) {
      for (const double side : {-1.0, 1.0}) {
        const Real place = whole.mid + cluster->centre + Real(side * cluster->radius);
        const Real cut = RealTraits<Real>::near(place, cluster->radius);
        if (lo < cut && cut < hi) seen.cut[seen.cut_count++] = cut;
      }
    }
    if (seen.cut_count > 0) {
      seen.decided = ParentBounds<Real>::cuts;
    } else if (at_end == -sign) {
      seen.decided = ParentBounds<Real>::one_root;
    }
  }
  return seen;
}

/// The sign over [a, b] by the best of three forms of the range: direct, mean value, and second order about the middle.
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

/// Cuts an interval into halves.
struct Halves {
  template <class Real>
  Real operator()(const Real& lo, const Real& hi) const {
    return (lo + hi) / 2;
  }
};
/// Cuts by orders of magnitude. For functions whose scale may be any power of their argument near zero, where zero does
/// not lie inside the interval.
struct Magnitudes {
  template <class Real>
  Real operator()(const Real& lo, const Real& hi) const {
    constexpr double step = 0x1p-16;
    if (hi > 0 && lo < hi * (step * step)) return hi * step;
    if (lo < 0 && hi > lo * (step * step)) return lo * step;
    return (lo + hi) / 2;
  }
};

/// Does a search make progress? If a function is so small that its value decides but no range does, such as a function
/// that is constant except for cancelling terms, all intervals have to be as short as the first one. Near a root of any
/// order, they grow. Towards an instant where the motion is nearly infinitely fast, they shrink, scale by scale, and
/// grow behind it.
class Progress {
 public:
  /// Records that an interval of this length is done, and that `left` is left. Returns false if there is no hope.
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

  static constexpr double few = 0x1p18;  ///< more intervals than a search has steps for
  static constexpr int many = 1024;
  double shortest_ = 0, longest_ = 0;  ///< the longest since the last interval that was shorter than all before
  int alike_ = 0;
};

/// Roots that ranges separate require only a few halvings. After this many, the signs of derivatives are evaluated.
inline constexpr int halvings_without_parent_bounds = 3;

/// Searches for the first root in (a, b] at which a function's sign changes.
template <class Real>
class SignChangeSearch {
 public:
  /// `sign` is the sign of the function just after a. At most `budget` intervals are examined.
  void begin(int sign, const Real& a, const Real& b, int budget = 200000) {
    sign_ = sign;
    lo_ = a;
    end_ = b;
    ends_.assign(1, b);
    tiny_ = unit_roundoff<Real>() * 64 * (RealTraits<Real>::magnitude(a) + RealTraits<Real>::magnitude(b) + 0x1p-900);
    budget_ = budget;
    progress_ = Progress();
    narrowed_ = 0;
    root_.reset();
    exhausted_ = false;
  }
  /// The root, isolated. Nothing if there is none: then the sign holds on (a, b]. Throws PrecisionExhausted.
  template <class Function, class Cut = Halves>
  std::optional<RootEnclosure<Real>> run(const Function& f, const Cut& cut = {}) {
    // Depth first from the left.
    for (; !ends_.empty() && !root_ && !exhausted_; --budget_) {
      if (budget_ == 0) throw PrecisionExhausted{};
      checkpoint(detail::work_of_step);
      const bool excluded = evaluate(f, cut);
      if (excluded) leave();
    }
    if (exhausted_) throw PrecisionExhausted{};
    return root_;
  }

 private:
  /// Examines the first remaining interval. Returns true if the sign holds in it. Otherwise the interval is cut, or it
  /// contains the root.
  template <class Function, class Cut>
  bool evaluate(const Function& f, const Cut& cut) {
    using B = Ball<Real>;
    const Real hi = ends_.back();
    if (!(hi > lo_)) return true;
    const B whole = B::about_short_middle(lo_, hi);
    const Jet<Real> wide = detail::range_of(f, whole);
    const int slope = wide.d.sign();
    // If the slope has the same sign, the function moves away from zero.
    if (wide.v.sign() == sign_ || slope == sign_) return true;
    if (!detail::is_expanded(f, whole) &&
        detail::sign_over(wide, detail::range_of(f, B(whole.mid, 0.0)), whole.rad) == sign_)
      return true;
    if (slope == -sign_) {
      const int at_end = detail::value_of(f, B(hi, 0.0)).sign();
      if (at_end == -sign_) root_ = RootEnclosure<Real>{lo_, hi};
      if (at_end != 0) return at_end == sign_;
    }
    exhausted_ = exhausted_ || !(RealTraits<Real>::magnitude(Real(hi - lo_)) > tiny_);
    if (exhausted_) return false;
    if (++narrowed_ > halvings_without_parent_bounds) {
      const auto seen = detail::parent_bounds(f, sign_, lo_, hi, whole);
      if (seen.decided == seen.one_root) root_ = RootEnclosure<Real>{lo_, hi};
      for (int i = seen.cut_count; i-- > 0;) ends_.push_back(seen.cut[i]);
      if (seen.decided != seen.nothing) return seen.decided == seen.excluded;
    }
    ends_.push_back(RealTraits<Real>::near(cut(lo_, hi), RealTraits<Real>::magnitude(Real(hi - lo_))));
    return false;
  }
  void leave() {
    const Real hi = ends_.back();
    exhausted_ =
        !progress_.goes_on(RealTraits<Real>::magnitude(Real(hi - lo_)), RealTraits<Real>::magnitude(Real(end_ - hi)));
    lo_ = hi;
    ends_.pop_back();
  }

  int sign_ = 0;
  Real lo_{}, end_{};       ///< everything before `lo_` is done
  std::vector<Real> ends_;  ///< of the remaining intervals, the first one last
  double tiny_ = 0;
  int budget_ = 0, narrowed_ = 0;
  Progress progress_;
  std::optional<RootEnclosure<Real>> root_;
  bool exhausted_ = false;
};

/// The search with a buffer that outlives the call, so that the event loop allocates nothing.
template <class Real, class Function, class Cut = Halves>
std::optional<RootEnclosure<Real>> first_sign_change(const Function& f, int sign, const Real& a, const Real& b,
                                                     const Cut& cut = {}, int budget = 200000) {
  thread_local SignChangeSearch<Real> search;
  search.begin(sign, a, b, budget);
  return search.run(f, cut);
}

/// Is the enclosure as short as possible, with ends only a few units in the last place apart?
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
    checkpoint(detail::work_of_step);
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

/// Like refine(), where the slope over the whole enclosure is known to at least a few digits. Each step needs one
/// value, and gains as many bits as are known of the slope, down to the error of the value itself.
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

}  // namespace taut::internal
