// The search for a root near a singular end of a segment.
//
// A segment ends where a cosine reaches 1 or -1, and terms like sqrt(t) cancel there, which ranges in time do not show.
// In s, the square root of the distance from that end (see TimeFromEnd), the motion is smooth. So doubles nearly always
// suffice, and where only the displacement decides, Taylor polynomials about the end do.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "certificate/precise_function.hpp"
#include "certificate/precise_time.hpp"
#include "numeric/root_isolation.hpp"

namespace taut::internal {

/// The number of intervals that a search may examine. In doubles, a search succeeds soon, or it sees only terms that
/// cancel.
template <class Real>
inline constexpr int search_budget = std::is_same_v<Real, double> ? 100 : 200000;

/// Searches a certificate function, or a function combined from several (see LineMargin and VertexMargin).
template <class Real, class Function = PreciseFunction<Real>>
class SearchFromEnd {
 public:
  SearchFromEnd(const Function& f, double end, double direction) : f_(f), end_(end), direction_(direction) {}

  Jet<Real> operator()(const Ball<Real>& s) const { return f_(TimeFromEnd<Real>{end_, direction_, s}); }

  /// Like PreciseTriple::first_failure, at this precision. Throws PrecisionExhausted.
  std::optional<PreciseTime> first_failure(int sign, const RealMax& from, double to, Stage stage) const {
    const Ball<Real> first = root_of_distance(from), last = root_of_distance(RealMax(to));
    const auto root = search(sign, first.lower(), last.upper());
    if (!root) return std::nullopt;
    // The search starts a little before `from`, unless that is the end itself. If the function falls over an interval
    // that contains `from`, the root comes after `from`; an interval before it shows nothing.
    if (first.rad > 0 && !(root->hi > first.upper())) throw PrecisionExhausted{};
    const Ball<RealMax> lo = time_at(root->lo), hi = time_at(root->hi);
    // A root found within the rounding of `to` may be beyond it.
    if (hi.upper() > RealMax(to)) throw PrecisionExhausted{};
    // Rounding near the start must not extend beyond it, where the function is another one.
    return PreciseTime{std::max<RealMax>(lo.lower(), from), hi.upper(), stage};
  }
  /// Shrinks an isolating enclosure, but not below the width `enough`. Throws PrecisionExhausted.
  PreciseTime refined(int sign, const PreciseTime& t, Stage stage, double enough) const {
    RootEnclosure<Real> root{root_of_distance(t.lo()).lower(), root_of_distance(t.hi()).upper()};
    const double farthest = RealTraits<Real>::magnitude(direction_ > 0 ? root.hi : root.lo);
    internal::refine(Expanded(*this, direction_ > 0 ? root.hi : root.lo), sign, root, enough / (2 * farthest));
    // Bounds rounded outwards may be beyond the enclosure.
    const RealMax lo = std::max<RealMax>(time_at(root.lo).lower(), t.lo());
    const RealMax hi = std::min<RealMax>(time_at(root.hi).upper(), t.hi());
    if (hi < lo) throw PrecisionExhausted{};
    return PreciseTime{lo, hi, stage};
  }

 private:
  /// The function by its Taylor polynomials about the end. There is one for each range of magnitudes of s, computed on
  /// first use, so that its remainder is small relative to the first terms, which decide ties. Ranges of the function
  /// itself are far worse there, because terms cancel. If the remainder is large nevertheless, far from the end,
  /// polynomials in time about places nearby decide.
  class Expanded {
   public:
    Expanded(const SearchFromEnd& whole, const Real& farthest) : whole_(whole), farthest_(in_few_bits(farthest)) {}

    Jet<Real> decisive_range(const Ball<Real>& s) const {
      const Jet<Real> range = whole_.f_.decisive_range(reaching(s), s);
      if (is_decisive(range, s) || !is_far_for_its_length(s) || !is_hidden_by_last(polynomial_, range.v, s))
        return range;
      return whole_.by_time(s);
    }
    Ball<Real> telling_value(const Ball<Real>& s) const {
      const Ball<Real> near_end = polynomial_value(reaching(s), s);
      return near_end.sign() != 0 || !is_hidden_by_last(polynomial_, near_end, s) ? near_end : whole_(s).v;
    }
    std::optional<BallPolynomial<Real>> expansion(const Ball<Real>& s) const {
      return internal::expanded(reaching(s), Ball<Real>(s.mid, 0.0));
    }
    /// All ranges are expansions about the middle.
    bool is_expanded(const Ball<Real>&) const { return true; }

   private:
    /// Polynomials in time reach several times as far as requested, and must not reach the end.
    static bool is_far_for_its_length(const Ball<Real>& s) {
      return s.rad > 0 && 64 * s.rad < RealTraits<Real>::magnitude(s.mid);
    }
    /// The polynomial that is valid for all of s.
    const BallPolynomial<Real>& reaching(const Ball<Real>& s) const {
      const Real reach = whole_.direction_ > 0 ? s.upper() : Real(-s.lower());
      std::size_t level = 0;
      double farthest = farthest_;
      while (level + 1 < levels && reach < Real(farthest * step)) {
        farthest *= step;
        ++level;
      }
      if (level == level_) return polynomial_;
      if (level_ == levels) {
        polynomial_ = whole_.f_.terms_from_end(whole_.end_, whole_.direction_);
        polynomial_.push_back({});
      }
      if (!last_[level]) {
        last_[level] = whole_.f_.last_term_from_end(whole_.end_, whole_.direction_, whole_.direction_ * farthest);
      }
      polynomial_[polynomial_.size - 1] = *last_[level];
      level_ = level;
      return polynomial_;
    }

    /// A bound slightly above the magnitude: searches that begin or end near each other share their polynomials.
    static double in_few_bits(const Real& s) {
      const double most = RealTraits<Real>::magnitude(s);
      if (!(most > 0x1p-900)) return 0x1p-900;
      const int unit = std::ilogb(most) - 5;
      return std::ldexp(std::ceil(std::ldexp(most, -unit)), unit);
    }

    static constexpr std::size_t levels = 48;  ///< beyond them, the last level is used
    static constexpr double step = 0x1p-2;

    const SearchFromEnd& whole_;
    double farthest_;                     ///< distance from the end
    mutable std::size_t level_ = levels;  ///< of the polynomial; `levels` if there is none
    mutable BallPolynomial<Real> polynomial_;
    mutable std::array<std::optional<Ball<Real>>, levels> last_;  ///< the last terms, which differ between levels
  };

  /// The root, as tight as this precision allows.
  std::optional<RootEnclosure<Real>> search(int sign, const Real& a, const Real& b) const {
    if constexpr (std::is_same_v<Real, double>) {
      auto root = first_sign_change<Real>(*this, sign, a, b, Magnitudes{}, search_budget<Real>);
      if (root && !is_sharp(*root)) internal::refine(*this, sign, *root);
      return root;
    } else {
      const Expanded expanded(*this, direction_ > 0 ? b : a);
      auto root = first_sign_change<Real>(expanded, sign, a, b, Magnitudes{});
      if (root) internal::refine(expanded, sign, *root);
      if (root && !is_sharp(*root)) internal::refine(*this, sign, *root);
      return root;
    }
  }
  Ball<Real> root_of_distance(const RealMax& t) const {
    if (t == RealMax(end_)) return Ball<Real>::exact(0);
    const Ball<RealMax> distance = (Ball<RealMax>(t, 0.0) - Ball<RealMax>::exact(end_)) * direction_;
    const double rounded = RealTraits<RealMax>::magnitude(distance.mid) * (4 * unit_roundoff<Real>());
    return sqrt(Ball<Real>(Real(distance.mid), detail::inflate(distance.rad + rounded))) * direction_;
  }
  /// The range over a ball of s, computed from the function's range in time.
  Jet<Real> by_time(const Ball<Real>& s) const {
    const Jet<Real> f = f_.decisive_range(Ball<Real>::exact(end_) + s * s * direction_);
    const Ball<Real> step = s * (2 * direction_);
    return {f.v, f.d * step, f.dd * step * step + f.d * (2 * direction_)};
  }
  Ball<RealMax> time_at(const Real& s) const {
    const Ball<RealMax> exact(RealMax(s), 0.0);
    return Ball<RealMax>::exact(end_) + exact * exact * direction_;
  }

  const Function& f_;
  double end_, direction_;
};

/// The distance from a singular end of the segment within which a search starts from that end.
inline double reach_of_end(const MotionSegment& segment) { return (segment.end - segment.start) / 16; }

/// The time up to which a search from `from` on is made from a singular end; `from` itself if it is not.
inline double end_of_neighbourhood(const MotionSegment& segment, double from) {
  const double reach = reach_of_end(segment);
  if (from >= segment.end - reach && segment.singular_at(segment.end)) return segment.end;
  if (from < segment.start + reach && segment.singular_at(segment.start)) return segment.start + reach;
  return from;
}

/// The singular end of the segment from which a search is made: 1 from the start, -1 from the end, 0 if the motion is
/// smooth enough over [from, to].
inline int singular_end(const MotionSegment& segment, const PreciseTime& from, double to) {
  if (to <= segment.start + reach_of_end(segment) && segment.singular_at(segment.start)) return 1;
  if (from.floor() >= segment.end - reach_of_end(segment) && segment.singular_at(segment.end)) return -1;
  return 0;
}

/// The time at which a search from `from` to `to` comes near a singular end, or leaves it. The search is divided there.
inline std::optional<double> division(const MotionSegment& segment, const PreciseTime& from, double to) {
  for (const bool at_start : {true, false}) {
    if (!segment.singular_at(at_start ? segment.start : segment.end)) continue;
    const double cut = at_start ? segment.start + reach_of_end(segment) : segment.end - reach_of_end(segment);
    if (from.ceiling() < cut && cut < to) return cut;
  }
  return std::nullopt;
}

/// Nothing if this precision does not decide.
template <class Real, class Function>
std::optional<std::optional<PreciseTime>> search_from_end(const MotionSegment& segment, const Function& f, int end,
                                                          int sign, const PreciseTime& from, double to, Stage stage) {
  try {
    const SearchFromEnd<Real, Function> search(f, end > 0 ? segment.start : segment.end, end);
    return search.first_failure(sign, from.hi(), to, stage);
  } catch (const PrecisionExhausted&) {
    return std::nullopt;
  }
}

}  // namespace taut::internal
