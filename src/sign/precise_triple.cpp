#include "sign/precise_triple.hpp"

#include <algorithm>
#include <array>

#include "base/errors.hpp"
#include "numeric/first_told.hpp"
#include "numeric/root_isolation.hpp"
#include "pair/placement.hpp"

namespace taut {
namespace {

template <class Real>
Ball<Real> as_ball(const PreciseTime& t) {
  const RealMax lo = t.lo(), hi = t.hi(), middle = (lo + hi) / 2;
  Ball<Real> b(Real(middle), 0.0);
  const double half = RealTraits<RealMax>::magnitude(RealMax(hi - lo));
  b.rad = detail::inflate(half + RealTraits<RealMax>::magnitude(middle) * (4 * unit_roundoff<Real>()));
  return b;
}

/// The number at this precision; where that would round it, a search from there on might start beyond a root.
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
    auto root = search(sign, a, b);
    if (!root) return std::nullopt;
    // The search starts a little before `from`, unless that is the end itself. Where the function falls over an
    // interval with `from` in it, the root comes after; an interval before it says nothing.
    if (first.rad > 0 && !(root->hi > first.upper())) throw PrecisionExhausted{};
    taut::refine(*this, sign, *root);
    const Ball<RealMax> lo = time_at(root->lo), hi = time_at(root->hi);
    // What the search found within the rounding of `to` may be beyond.
    if (hi.upper() > RealMax(to)) throw PrecisionExhausted{};
    // The rounding of what is near the start must not reach beyond it, where the function is another one.
    return PreciseTime{std::max<RealMax>(lo.lower(), from), hi.upper(), stage};
  }

 private:
  /// The function by its Taylor polynomials about the end: one for each range of magnitudes of s, made when it is asked
  /// for, so that what it leaves out is small beside the first terms, by which ties are decided. Ranges of the function
  /// itself are far worse there, where terms cancel; far from the end they are the better ones.
  class Expanded {
   public:
    Expanded(const SearchFromEnd& whole, const Real& farthest)
        : whole_(whole), farthest_(whole.direction_ > 0 ? farthest : Real(-farthest)) {}

    Jet<Real> operator()(const Ball<Real>& s) const {
      const Jet<Real> near_end = polynomial_range(about_end(s), s);
      if (near_end.v.sign() != 0 || near_end.d.sign() != 0) return near_end;
      const Jet<Real> direct = whole_(s);
      return direct.v.sign() != 0 || direct.d.sign() != 0 ? direct : near_end;
    }
    Ball<Real> value(const Ball<Real>& s) const {
      const Ball<Real> near_end = polynomial_value(about_end(s), s);
      return near_end.sign() != 0 ? near_end : whole_(s).v;
    }

   private:
    BallPolynomial<Real> about_end(const Ball<Real>& s) const {
      const Real reach = whole_.direction_ > 0 ? s.upper() : Real(-s.lower());
      std::size_t level = 0;
      Real farthest = farthest_;
      while (level + 1 < levels && reach < farthest * step) {
        farthest = farthest * step;
        ++level;
      }
      if (!terms_) terms_ = whole_.f_.terms_from_end(whole_.end_, whole_.direction_);
      if (!last_[level]) {
        const Ball<Real> to(whole_.direction_ > 0 ? farthest : Real(-farthest), 0.0);
        last_[level] = whole_.f_.last_term_from_end(whole_.end_, whole_.direction_, to);
      }
      BallPolynomial<Real> p = *terms_;
      p.push_back(*last_[level]);
      return p;
    }

    static constexpr std::size_t levels = 24;  ///< beyond them the last one does
    static constexpr double step = 0x1p-4;

    const SearchFromEnd& whole_;
    Real farthest_;  ///< from the end
    mutable std::optional<BallPolynomial<Real>> terms_;
    mutable std::array<std::optional<Ball<Real>>, levels> last_;  ///< the terms that differ
  };

  /// In doubles it succeeds soon, or terms that cancel are all that it sees.
  static constexpr int few = 100;
  std::optional<RootEnclosure<Real>> search(int sign, const Real& a, const Real& b) const {
    if constexpr (!std::is_same_v<Real, double>) {
      return first_sign_change<Real>(Expanded(*this, direction_ > 0 ? b : a), sign, a, b, Magnitudes{});
    } else {
      return first_sign_change<Real>(*this, sign, a, b, Magnitudes{}, few);
    }
  }
  Ball<Real> root_of_distance(const RealMax& t) const {
    if (t == RealMax(end_)) return Ball<Real>::exact(0);
    const Ball<RealMax> distance = (Ball<RealMax>(t, 0.0) - Ball<RealMax>::exact(end_)) * direction_;
    const double rounded = RealTraits<RealMax>::magnitude(distance.mid) * (4 * unit_roundoff<Real>());
    return sqrt(Ball<Real>(Real(distance.mid), detail::inflate(distance.rad + rounded))) * direction_;
  }
  Ball<RealMax> time_at(const Real& s) const {
    const Ball<RealMax> exact(RealMax(s), 0.0);
    return Ball<RealMax>::exact(end_) + exact * exact * direction_;
  }

  const PreciseFunction<Real>& f_;
  double end_, direction_;
};

/// How near to a singular end of the leg a search is made from there.
double reach_of_end(const Leg& leg) { return (leg.end - leg.start) / 16; }

/// From which end of the leg, if it is singular there, a search is made: 1 from the start, -1 from the end, 0 if the
/// motion is smooth enough over [from, to].
int singular_end(const Leg& leg, const PreciseTime& from, double to) {
  if (to <= leg.start + reach_of_end(leg) && leg.singular_at(leg.start)) return 1;
  if (from.floor() >= leg.end - reach_of_end(leg) && leg.singular_at(leg.end)) return -1;
  return 0;
}

/// Where a search from `from` to `to` comes near a singular end, or leaves it: there it is made in two parts.
std::optional<double> division(const Leg& leg, const PreciseTime& from, double to) {
  for (const bool at_start : {true, false}) {
    if (!leg.singular_at(at_start ? leg.start : leg.end)) continue;
    const double cut = at_start ? leg.start + reach_of_end(leg) : leg.end - reach_of_end(leg);
    if (from.ceiling() < cut && cut < to) return cut;
  }
  return std::nullopt;
}

/// Nothing if this precision does not tell.
template <class Real>
std::optional<std::optional<PreciseTime>> search_from_end(const Leg& leg, const PreciseFunction<Real>& f, int end,
                                                          int sign, const PreciseTime& from, double to, int stage) {
  try {
    return SearchFromEnd<Real>(f, end > 0 ? leg.start : leg.end, end).first_failure(sign, from.hi(), to, stage);
  } catch (const PrecisionExhausted&) {
    return std::nullopt;
  }
}

/// The slope over an enclosure in doubles, if it is known well enough for Newton's steps to gain many bits each.
std::optional<Ball<double>> steady_slope(const PreciseFunction<double>& f, const RealMax& lo, const RealMax& hi) {
  const Ball<double> slope = f(Ball<double>::between(double_floor(lo), double_above(hi))).d;
  if (slope.rad <= 0x1p-24 * std::fabs(slope.mid)) return slope;
  return std::nullopt;
}

}  // namespace

/// The function as a line, if it is one and nothing underflows.
const ExactLine* PreciseTriple::line() const {
  if (!ExactLine::fits(leg_)) return nullptr;
  if (!line_) line_.emplace(leg_, geometry_, form_);
  return line_->exact() ? &*line_ : nullptr;
}

/// The function about an instant given by sums of doubles, if it is of use there.
std::optional<TieForm> PreciseTriple::near(const PreciseTime& t) const {
  if (!memory_ || !t.has_sums()) return std::nullopt;
  const TieFrame* const frame = memory_->ties.around(t.floor(), t.ceiling());
  if (!frame) return std::nullopt;
  return TieForm(*frame, leg_, geometry_, form_);
}

template <class Real>
void PreciseTriple::refine_root(const PreciseFunction<Real>& f, int sign, RootEnclosure<Real>& root,
                                double enough) const {
  const PreciseFunction<double> rough(leg_, geometry_, form_);
  if (const auto slope = steady_slope(rough, RealMax(root.lo), RealMax(root.hi))) {
    refine_with_slope(f, *slope, sign, root, enough);
  } else {
    taut::refine(f, sign, root, enough);
  }
}

int PreciseTriple::sign_at(const PreciseTime& t, int stage) const {
  if (t.has_sums()) {
    const ExactLine* const exact = line();
    if (const int sign = exact ? exact->sign_over(t) : 0) return told_by(Stage::exact, sign);
    if (stage == 0) {
      const std::optional<TieForm> tie = near(t);
      if (const int sign = tie ? tie->sign_over(t) : 0) return told_by(Stage::fixed, sign);
    }
  }
  return told_by(stage_of_precision(stage), with_stage(stage, [&](auto zero) {
                   using Real = decltype(zero);
                   return function<Real>().value(as_ball<Real>(t)).sign();
                 }));
}

/// Of a function that is a line: when it changes its sign.
PreciseTriple::LineFailure PreciseTriple::line_failure(int sign, const PreciseTime& from, double to) const {
  if (from.stage > 0) return {};
  const ExactLine* const exact = line();
  if (!exact) return {};
  // The sign holds just after `from`.
  if (exact->slope_sign() != -sign) return {true, std::nullopt};
  const std::optional<PreciseTime> root = exact->root(0);
  if (!root) return {};
  const ShortSum end(to);
  if (root->sum_lo().compare(end) > 0) return {true, std::nullopt};
  return {root->sum_hi().compare(end) <= 0, root};
}

std::optional<PreciseTime> PreciseTriple::first_failure(int sign, const PreciseTime& from, double to) const {
  if (const LineFailure line = line_failure(sign, from, to); told_by(Stage::exact, line.known)) return line.time;
  if (const auto cut = division(leg_, from, to)) {
    if (auto first = first_failure(sign, from, *cut)) return first;
    PreciseTime rest = PreciseTime::between(*cut, *cut);
    rest.stage = from.stage;
    return first_failure(sign, rest, to);
  }
  const int end = singular_end(leg_, from, to);
  if (end != 0 && from.stage <= 0) {
    // In the distance's root the motion is so smooth that doubles nearly always do.
    const PreciseFunction<double> f(leg_, geometry_, form_);
    if (const auto answer = search_from_end(leg_, f, end, sign, from, to, -1)) {
      return *told_by(Stage::doubles, answer);
    }
  }
  const auto search = [&](auto zero, int stage) -> std::optional<PreciseTime> {
    using Real = decltype(zero);
    const PreciseFunction<Real> f = function<Real>();
    if (end != 0) {
      if (const auto answer = search_from_end(leg_, f, end, sign, from, to, stage)) return *answer;
    }
    auto root = first_sign_change<Real>(f, sign, exactly<Real>(from.hi()), Real(to));
    if (!root) return std::nullopt;
    refine_root(f, sign, *root, 0);
    return PreciseTime{RealMax(root->lo), RealMax(root->hi), stage};
  };
  const auto counted = [&](auto zero, int stage) {
    auto answer = search(zero, stage);
    told_by(stage_of_precision(stage), true);
    return answer;
  };
  const auto found = at_some_stage(counted, std::max(from.stage, 0));
  if (!found) throw Undecidable{"the failure time of a certificate"};
  return *found;
}

bool PreciseTriple::refine(int sign, PreciseTime& t, int stage, double enough) const {
  if (t.stage >= stage) return true;
  if (stage == 0) {
    const ExactLine* const exact = line();
    if (const auto root = exact && exact->slope_sign() != 0 ? exact->root(stage, enough) : std::nullopt) {
      t = *told_by(Stage::exact, root);
      return true;
    }
    const std::optional<TieForm> tie = near(t);
    if (const auto root = tie ? tie->root(sign, stage, enough) : std::nullopt) {
      t = *told_by(Stage::fixed, root);
      return true;
    }
  }
  return with_stage(stage, [&](auto zero) {
    using Real = decltype(zero);
    const PreciseFunction<Real> f = function<Real>();
    RootEnclosure<Real> root = enclosure<Real>(t);
    try {
      refine_root(f, sign, root, enough);
    } catch (const PrecisionExhausted&) {
      return false;
    }
    t = PreciseTime(RealMax(root.lo), RealMax(root.hi), stage);
    return told_by(stage_of_precision(stage), true);
  });
}

}  // namespace taut
