// The search for a root near a singular end of a segment.
//
// Where a cosine reaches 1 or -1 a segment ends, and terms like sqrt(t) cancel there, which ranges in time do not show.
// In s, the root of the distance from that end (see TimeFromEnd), the motion is smooth: so doubles nearly always do,
// and where only the displacement tells, Taylor polynomials about the end.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "numeric/root_isolation.hpp"
#include "sign/kept_searches.hpp"
#include "sign/precise_function.hpp"
#include "sign/precise_time.hpp"

namespace taut::internal {

/// Where a search of a form is kept, if it is.
struct KeptSearch {
  KeptSearches* searches = nullptr;
  CertificateFunction function{};
};

/// How many intervals a search may look at. In doubles it succeeds soon, or terms that cancel are all that it sees.
template <class Real>
inline constexpr int search_budget = std::is_same_v<Real, double> ? 100 : 200000;

/// Of a form, or of what is made of forms (see LineMargin and VertexMargin).
template <class Real, class Function = PreciseFunction<Real>>
class SearchFromEnd {
 public:
  SearchFromEnd(const Function& f, double end, double direction, const KeptSearch& kept = {})
      : f_(f), end_(end), direction_(direction), kept_(kept) {}

  Jet<Real> operator()(const Ball<Real>& s) const { return f_(TimeFromEnd<Real>{end_, direction_, s}); }

  /// As PreciseTriple::first_failure does, at this precision. Throws PrecisionExhausted.
  std::optional<PreciseTime> first_failure(int sign, const RealMax& from, double to, Stage stage) const {
    const Ball<Real> first = root_of_distance(from), last = root_of_distance(RealMax(to));
    const auto root = search({kept_.function, sign, from, to, direction_ > 0 ? 1 : -1}, first.lower(), last.upper());
    if (!root) return std::nullopt;
    // The search starts a little before `from`, unless that is the end itself. Where the function falls over an
    // interval with `from` in it, the root comes after; an interval before it says nothing.
    if (first.rad > 0 && !(root->hi > first.upper())) throw PrecisionExhausted{};
    const Ball<RealMax> lo = time_at(root->lo), hi = time_at(root->hi);
    // What the search found within the rounding of `to` may be beyond.
    if (hi.upper() > RealMax(to)) throw PrecisionExhausted{};
    // The rounding of what is near the start must not reach beyond it, where the function is another one.
    return PreciseTime{std::max<RealMax>(lo.lower(), from), hi.upper(), stage};
  }
  /// Shrinks an isolating enclosure, no further than to the width `enough`. Throws PrecisionExhausted.
  PreciseTime refined(int sign, const PreciseTime& t, Stage stage, double enough) const {
    RootEnclosure<Real> root{root_of_distance(t.lo()).lower(), root_of_distance(t.hi()).upper()};
    const double farthest = RealTraits<Real>::magnitude(direction_ > 0 ? root.hi : root.lo);
    taut::refine(Expanded(*this, direction_ > 0 ? root.hi : root.lo), sign, root, enough / (2 * farthest));
    // What was rounded outwards may be beyond the enclosure.
    const RealMax lo = std::max<RealMax>(time_at(root.lo).lower(), t.lo());
    const RealMax hi = std::min<RealMax>(time_at(root.hi).upper(), t.hi());
    if (hi < lo) throw PrecisionExhausted{};
    return PreciseTime{lo, hi, stage};
  }

 private:
  /// The function by its Taylor polynomials about the end: one for each range of magnitudes of s, made when it is asked
  /// for, so that what it leaves out is small beside the first terms, by which ties are decided. Ranges of the function
  /// itself are far worse there, where terms cancel. Where much is left out nevertheless, far from the end, polynomials
  /// in time about places nearby tell.
  class Expanded {
   public:
    Expanded(const SearchFromEnd& whole, const Real& farthest) : whole_(whole), farthest_(in_few_bits(farthest)) {}

    Jet<Real> telling_range(const Ball<Real>& s) const {
      const Jet<Real> range = whole_.f_.telling_range(reaching(s), s);
      if (tells(range, s) || !is_far_for_its_length(s) || !is_hidden_by_last(polynomial_, range.v, s)) return range;
      return whole_.by_time(s);
    }
    Ball<Real> telling_value(const Ball<Real>& s) const {
      const Ball<Real> near_end = polynomial_value(reaching(s), s);
      return near_end.sign() != 0 || !is_hidden_by_last(polynomial_, near_end, s) ? near_end : whole_(s).v;
    }
    std::optional<BallPolynomial<Real>> expansion(const Ball<Real>& s) const {
      return taut::expanded(reaching(s), Ball<Real>(s.mid, 0.0));
    }
    /// Ranges about the middle they all are.
    bool is_expanded(const Ball<Real>&) const { return true; }

   private:
    /// Polynomials in time reach several times as far as they are asked for, and must not reach the end.
    static bool is_far_for_its_length(const Ball<Real>& s) {
      return s.rad > 0 && 64 * s.rad < RealTraits<Real>::magnitude(s.mid);
    }
    /// Good for all of s.
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

    /// A little more than the magnitude: searches that begin or end near each other share what they go by.
    static double in_few_bits(const Real& s) {
      const double most = RealTraits<Real>::magnitude(s);
      if (!(most > 0x1p-900)) return 0x1p-900;
      const int unit = std::ilogb(most) - 5;
      return std::ldexp(std::ceil(std::ldexp(most, -unit)), unit);
    }

    static constexpr std::size_t levels = 48;  ///< beyond them the last one does
    static constexpr double step = 0x1p-2;

    const SearchFromEnd& whole_;
    double farthest_;                     ///< from the end
    mutable std::size_t level_ = levels;  ///< of the polynomial; `levels` if there is none
    mutable BallPolynomial<Real> polynomial_;
    mutable std::array<std::optional<Ball<Real>>, levels> last_;  ///< the terms that differ between levels
  };

  /// The root, as sharp as this precision has it.
  std::optional<RootEnclosure<Real>> search(const KeptSearches::Key& key, const Real& a, const Real& b) const {
    const int sign = key.sign;
    if constexpr (std::is_same_v<Real, double>) {
      auto root = first_sign_change<Real>(*this, sign, a, b, Magnitudes{}, search_budget<Real>);
      if (root && !is_sharp(*root)) taut::refine(*this, sign, *root);
      return root;
    } else {
      const Expanded expanded(*this, direction_ > 0 ? b : a);
      const auto refined = [&](RootEnclosure<Real>& root) {
        taut::refine(expanded, sign, root);
        if (!is_sharp(root)) taut::refine(*this, sign, root);
      };
      return sharp_root(kept_.searches, key, expanded, a, b, Magnitudes{}, refined);
    }
  }
  Ball<Real> root_of_distance(const RealMax& t) const {
    if (t == RealMax(end_)) return Ball<Real>::exact(0);
    const Ball<RealMax> distance = (Ball<RealMax>(t, 0.0) - Ball<RealMax>::exact(end_)) * direction_;
    const double rounded = RealTraits<RealMax>::magnitude(distance.mid) * (4 * unit_roundoff<Real>());
    return sqrt(Ball<Real>(Real(distance.mid), detail::inflate(distance.rad + rounded))) * direction_;
  }
  /// Over a ball of s by the function's range in time.
  Jet<Real> by_time(const Ball<Real>& s) const {
    const Jet<Real> f = f_.telling_range(Ball<Real>::exact(end_) + s * s * direction_);
    const Ball<Real> step = s * (2 * direction_);
    return {f.v, f.d * step, f.dd * step * step + f.d * (2 * direction_)};
  }
  Ball<RealMax> time_at(const Real& s) const {
    const Ball<RealMax> exact(RealMax(s), 0.0);
    return Ball<RealMax>::exact(end_) + exact * exact * direction_;
  }

  const Function& f_;
  double end_, direction_;
  KeptSearch kept_;
};

/// How near to a singular end of the segment a search is made from there.
inline double reach_of_end(const MotionSegment& segment) { return (segment.end - segment.start) / 16; }

/// Up to when a search from that instant on is made from a singular end; the instant itself if it is not.
inline double end_of_neighbourhood(const MotionSegment& segment, double from) {
  const double reach = reach_of_end(segment);
  if (from >= segment.end - reach && segment.singular_at(segment.end)) return segment.end;
  if (from < segment.start + reach && segment.singular_at(segment.start)) return segment.start + reach;
  return from;
}

/// From which end of the segment, if it is singular there, a search is made: 1 from the start, -1 from the end, 0 if
/// the motion is smooth enough over [from, to].
inline int singular_end(const MotionSegment& segment, const PreciseTime& from, double to) {
  if (to <= segment.start + reach_of_end(segment) && segment.singular_at(segment.start)) return 1;
  if (from.floor() >= segment.end - reach_of_end(segment) && segment.singular_at(segment.end)) return -1;
  return 0;
}

/// Where a search from `from` to `to` comes near a singular end, or leaves it: there it is made in two parts.
inline std::optional<double> division(const MotionSegment& segment, const PreciseTime& from, double to) {
  for (const bool at_start : {true, false}) {
    if (!segment.singular_at(at_start ? segment.start : segment.end)) continue;
    const double cut = at_start ? segment.start + reach_of_end(segment) : segment.end - reach_of_end(segment);
    if (from.ceiling() < cut && cut < to) return cut;
  }
  return std::nullopt;
}

/// Nothing if this precision does not tell.
template <class Real, class Function>
std::optional<std::optional<PreciseTime>> search_from_end(const MotionSegment& segment, const Function& f, int end,
                                                          int sign, const PreciseTime& from, double to, Stage stage,
                                                          const KeptSearch& kept = {}) {
  try {
    const SearchFromEnd<Real, Function> search(f, end > 0 ? segment.start : segment.end, end, kept);
    return search.first_failure(sign, from.hi(), to, stage);
  } catch (const PrecisionExhausted&) {
    return std::nullopt;
  }
}

}  // namespace taut::internal
