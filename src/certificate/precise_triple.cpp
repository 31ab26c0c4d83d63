#include "certificate/precise_triple.hpp"

#include <algorithm>
#include <cmath>

#include "certificate/precise_root.hpp"
#include "geometry/displacement.hpp"
#include "numeric/errors.hpp"
#include "numeric/root_isolation.hpp"
#include "numeric/stages.hpp"
#include "scene/placement.hpp"

namespace taut::internal {
namespace {

/// A root known more precisely than this was not rounded before the displacement, and suffices to decide ties.
constexpr double all_but_displacement = 0x1p-16 * displacement_unit;

/// The slope over an enclosure in doubles, if it is known well enough that each Newton step gains many bits.
std::optional<Ball<double>> steady_slope(const PreciseFunction<double>& f, const RealMax& lo, const RealMax& hi) {
  const Ball<double> slope = f(Ball<double>::between(double_floor(lo), double_above(hi))).d;
  if (slope.rad <= 0x1p-24 * std::fabs(slope.mid)) return slope;
  return std::nullopt;
}

}  // namespace

/// The function as a line, if it is one and nothing underflows.
const ExactLine* PreciseTriple::line() const {
  if (!ExactLine::fits(segment_)) return nullptr;
  if (!line_) line_.emplace(segment_, geometry_, function_);
  return line_->exact() ? &*line_ : nullptr;
}

/// The frame about an instant given by sums of doubles, if it is useful there. At a double, the frame itself costs less
/// than polynomials about it.
const FrameExpansion* PreciseTriple::frame_near(const PreciseTime& t) const {
  if (!memory_ || !t.has_sums()) return nullptr;
  const double lo = t.floor(), hi = t.ceiling();
  return lo < hi ? memory_->expansions.around(lo, hi) : memory_->expansions.known(lo, hi);
}

/// The function's root within reach of such an instant, if one of the known roots determines it. Before more is tried,
/// any accuracy suffices.
const RootOfExpansion* PreciseTriple::root_near(const PreciseTime& t, Stage stage) const {
  if (!memory_ || !t.has_sums()) return nullptr;
  const FrameExpansion* const frame = memory_->expansions.known(t.floor(), t.ceiling());
  const double enough = stage == Stage::relative ? INFINITY : all_but_displacement;
  return frame ? memory_->functions.root_near(*frame, segment_, geometry_, function_, enough) : nullptr;
}

/// The function is monotone over the whole reach.
int PreciseTriple::sign_near_root(const PreciseTime& t, Stage stage) const {
  const RootOfExpansion* const root = root_near(t, stage);
  if (!root) return 0;
  const std::optional<bool> is_first = t.is_first(root->at);
  return !is_first ? 0 : *is_first ? -root->slope_sign : root->slope_sign;
}

/// Computes the root in fixed-point numbers. Other roots may be determined from it afterwards.
std::optional<PreciseTime> PreciseTriple::root_of_expansion(int sign, const PreciseTime& t, Stage stage,
                                                            double enough) const {
  const FrameExpansion* const frame = frame_near(t);
  if (!frame) return std::nullopt;
  const auto root = memory_->functions.of(*frame, segment_, geometry_, function_).root(sign, stage, enough);
  if (root && enough == 0) memory_->functions.note_root(*frame, segment_, geometry_, function_, *root);
  return root;
}

/// Refines a root known near an extremum to the precision of fixed-point numbers.
PreciseTime PreciseTriple::sharpened(int sign, PreciseTime t) const {
  if (const auto sharp = root_of_expansion(sign, t, Stage::precise, 0)) return *sharp;
  t.stage = Stage::precise;
  return t;
}

template <class Real>
void PreciseTriple::refine_root(const PreciseFunction<Real>& f, int sign, RootEnclosure<Real>& root,
                                double enough) const {
  const PreciseFunction<double> rough(segment_, geometry_, function_);
  if (const auto slope = steady_slope(rough, RealMax(root.lo), RealMax(root.hi))) {
    refine_with_slope(f, *slope, sign, root, enough);
  } else {
    internal::refine(f, sign, root, enough);
  }
}

template <class Real>
std::optional<RootEnclosure<Real>> PreciseTriple::sign_change(const PreciseFunction<Real>& f, int sign,
                                                              const PreciseTime& from, double to) const {
  const Real a = exactly<Real>(from.hi());
  auto root = first_sign_change<Real>(f, sign, a, Real(to));
  if (root) refine_root(f, sign, *root, 0);
  return root;
}

int PreciseTriple::sign_at(const PreciseTime& t, Stage stage) const {
  if (stage <= Stage::precise) {
    const int sign = sign_near_root(t, stage);
    if (sign != 0 || stage == Stage::relative) return decided_by(Stage::relative, sign);
  }
  if (t.has_sums()) {
    const ExactLine* const exact = line();
    if (const int sign = exact ? exact->sign_over(t) : 0) return decided_by(Stage::exact, sign);
    if (stage == Stage::precise) {
      const FrameExpansion* const frame = frame_near(t);
      const int sign = frame ? memory_->functions.of(*frame, segment_, geometry_, function_).sign_over(t) : 0;
      if (sign != 0) return decided_by(Stage::fixed, sign);
    }
  }
  return decided_by(stage, with_stage(stage, [&](auto zero) {
                      using Real = decltype(zero);
                      return function<Real>().telling_value(ball_of<Real>(t)).sign();
                    }));
}

/// For a function that is a line: the time of its sign change.
PreciseTriple::LineFailure PreciseTriple::line_failure(int sign, const PreciseTime& from, double to) const {
  if (from.stage > Stage::precise) return {};
  const ExactLine* const exact = line();
  if (!exact) return {};
  // The sign holds just after `from`.
  if (exact->slope_sign() != -sign) return {true, std::nullopt};
  const std::optional<PreciseTime> root = exact->root(Stage::precise);
  if (!root) return {};
  const ShortSum end(to);
  if (root->sum_lo().compare(end) > 0) return {true, std::nullopt};
  return {root->sum_hi().compare(end) <= 0, root};
}

/// Requires that `sign` holds just after `from`.
std::optional<PreciseTriple::NearExtremum> PreciseTriple::near_extremum(int sign, const PreciseTime& from,
                                                                        double about) const {
  const FrameExpansion* const frame = memory_ ? memory_->expansions.around(about, about) : nullptr;
  if (!frame) return std::nullopt;
  const FixedPointExpansion& expansion = memory_->functions.of(*frame, segment_, geometry_, function_);
  const auto extremum = expansion.extremum();
  if (!extremum) return std::nullopt;
  const bool valley = extremum->second_sign == sign;
  if (extremum->value_sign == extremum->second_sign) return valley ? std::optional(NearExtremum{}) : std::nullopt;
  const auto before = expansion.root_near(*extremum, -1, Stage::relative),
             after = expansion.root_near(*extremum, 1, Stage::relative);
  if (!before || !after) return std::nullopt;
  // In a valley, the sign holds before the first root and after the second one; on a hill, between the two. As it holds
  // just after `from`, that is not before the first root of a hill, and comparison with a valley's roots shows on which
  // side of them it is.
  if (!valley) return from.certainly_before(*after) ? std::optional(NearExtremum{after}) : std::nullopt;
  if (before->certainly_before(from)) return NearExtremum{};
  return from.certainly_before(*before) ? std::optional(NearExtremum{before}) : std::nullopt;
}

/// For the case in which doubles show neither value nor slope, but a second derivative that keeps its sign. An example
/// is a vertex that leaves a corner along an edge's line.
std::optional<PreciseTriple::NearExtremum> PreciseTriple::extremum_ahead(int sign, const PreciseTime& from,
                                                                         double to) const {
  const double start = from.floor();
  if (from.stage > Stage::precise || start < segment_.start || !(start < to)) return std::nullopt;
  const PreciseFunction<double> rough(segment_, geometry_, function_);
  const Jet<double> here = rough(Ball<double>::exact(start));
  if (here.v.sign() != 0 || here.d.sign() != 0 || here.dd.sign() == 0) return std::nullopt;
  if (rough(Ball<double>::between(start, to)).dd.sign() == 0) return std::nullopt;
  return near_extremum(sign, from, std::clamp(start - here.d.mid / here.dd.mid, start, to));
}

std::optional<PreciseTime> PreciseTriple::first_failure(int sign, const PreciseTime& from, double to) const {
  if (const LineFailure line = line_failure(sign, from, to); decided_by(Stage::exact, line.known)) return line.time;
  if (const auto ahead = extremum_ahead(sign, from, to)) {
    const PreciseTime end = PreciseTime::between(to, to);
    const bool none = !ahead->failure || end.certainly_before(*ahead->failure);
    if (decided_by(Stage::fixed, none)) return std::nullopt;
    if (decided_by(Stage::fixed, ahead->failure->not_after(end))) return sharpened(sign, *ahead->failure);
  }
  if (const auto cut = division(segment_, from, to)) {
    if (auto first = first_failure(sign, from, *cut)) return first;
    PreciseTime rest = PreciseTime::between(*cut, *cut);
    rest.stage = from.stage;
    return first_failure(sign, rest, to);
  }
  const int end = singular_end(segment_, from, to);
  if (end != 0 && from.stage <= Stage::precise) {
    // In the square root of the distance, the motion is so smooth that doubles nearly always suffice. They include the
    // displacement: at the end itself, where much is exact, they may decide cases that only the displacement decides.
    const PreciseFunction<double> f(segment_, geometry_, function_);
    if (const auto answer = search_from_end<double>(segment_, f, end, sign, from, to, Stage::doubles)) {
      return *decided_by(Stage::first_order, answer);
    }
  }
  const auto search = [&](auto zero, Stage stage) -> std::optional<PreciseTime> {
    using Real = decltype(zero);
    const PreciseFunction<Real> f = function<Real>();
    if (end != 0) {
      if (const auto answer = search_from_end<Real>(segment_, f, end, sign, from, to, stage)) return *answer;
    }
    const auto root = sign_change(f, sign, from, to);
    if (!root) return std::nullopt;
    return PreciseTime{RealMax(root->lo), RealMax(root->hi), stage};
  };
  const auto counted = [&](auto zero, Stage stage) {
    auto answer = search(zero, stage);
    decided_by(stage, true);
    return answer;
  };
  const auto found = at_some_stage(counted, from.stage);
  if (!found) throw Undecidable{"the failure time of a certificate"};
  return *found;
}

bool PreciseTriple::refine(int sign, PreciseTime& t, Stage stage, double enough) const {
  if (t.stage >= stage) return true;
  if (stage <= Stage::precise) {
    const RootOfExpansion* const root = root_near(t, stage);
    if (root && root->slope_sign == -sign) {
      t = root->at;
      t.stage = stage;
      return decided_by(Stage::relative, true);
    }
    if (stage == Stage::relative) return false;
  }
  if (stage == Stage::precise) {
    const ExactLine* const exact = line();
    if (const auto root = exact && exact->slope_sign() != 0 ? exact->root(stage, enough) : std::nullopt) {
      t = *decided_by(Stage::exact, root);
      return true;
    }
    if (const auto root = root_of_expansion(sign, t, stage, enough)) {
      t = *decided_by(Stage::fixed, root);
      return true;
    }
  }
  return with_stage(stage, [&](auto zero) {
    using Real = decltype(zero);
    const PreciseFunction<Real> f = function<Real>();
    try {
      if (const int end = singular_end(segment_, t, t.ceiling())) {
        t = SearchFromEnd<Real>(f, end > 0 ? segment_.start : segment_.end, end).refined(sign, t, stage, enough);
      } else {
        RootEnclosure<Real> root = enclosure<Real>(t);
        refine_root(f, sign, root, enough);
        t = PreciseTime(RealMax(root.lo), RealMax(root.hi), stage);
      }
    } catch (const PrecisionExhausted&) {
      return false;
    }
    return decided_by(stage, true);
  });
}

}  // namespace taut::internal
