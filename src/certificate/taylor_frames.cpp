#include "certificate/taylor_frames.hpp"

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <utility>

#include "numeric/budget.hpp"

namespace taut::internal {
namespace {

/// The number of models kept. Then a new one replaces the oldest.
constexpr std::size_t most_kept = 64;
template <class T>
T& keep(std::vector<T>& kept, std::size_t& next, T made) {
  if (kept.size() < most_kept) return kept.emplace_back(std::move(made));
  next = (next + 1) % most_kept;
  return kept[next] = std::move(made);
}

/// The work as PreciseFunction counts it.
constexpr std::uint64_t work_of_frames = 900;

/// The nearest multiple of 2^e, unless that is finer than the resolution of the number.
template <class Real>
Real on_grid(const Real& x, int e) {
  constexpr int spare = 32;
  const double size = RealTraits<Real>::magnitude(x);
  if (size > 0 && std::ilogb(size) - e > static_cast<int>(RealTraits<Real>::bits) - spare) return x;
  return ldexp(round(ldexp(x, -e)), e);
}

/// Estimates, from the growth of the coefficients, how far the functions are from their nearest singularity in the
/// complex plane. The result r means about 2^(r/4). It is an integer, which is the same on every machine.
template <class Real>
int radius_in_quarters(const FrameOf<ModelSeries<Real>>& functions) {
  constexpr int none = INT_MIN, far = 4000;
  std::array<int, model_degree + 1> exponents;
  exponents.fill(none);
  for (const auto* some : {&functions.for_pp, &functions.for_qq}) {
    for (const ModelSeries<Real>& f : *some) {
      for (std::size_t k = 1; k <= model_degree; ++k) {
        const double size = RealTraits<Real>::magnitude(f.c[k].mid);
        if (!std::isfinite(size)) return -far;
        if (size > 0) exponents[k] = std::max(exponents[k], std::ilogb(size));
      }
    }
  }
  // Within this distance, the later terms do not exceed one of the first few, some of which may vanish.
  constexpr int few = model_degree / 2;
  int radius = far;
  for (int k = few + 1; k <= model_degree; ++k) {
    const int of_k = exponents[static_cast<std::size_t>(k)];
    int above_first = -far;
    for (int j = 1; j <= few && of_k != none; ++j) {
      const int of_j = exponents[static_cast<std::size_t>(j)];
      if (of_j != none) above_first = std::max(above_first, 4 * (of_j - of_k) / (k - j));
    }
    if (above_first > -far) radius = std::min(radius, above_first);
  }
  return std::max(radius, -far);
}

/// Converts quarters to a number. The fractional powers of two need not be accurate.
double from_quarters(int quarters) {
  constexpr double parts[] = {1, 1.189, 1.414, 1.682};
  return std::ldexp(parts[quarters & 3], (quarters - (quarters & 3)) / 4);
}

/// Are the last terms, computed in doubles, about as sharp as they are at full precision? They are if no terms cancel
/// that doubles round.
template <class Real>
bool are_sharp(const FrameOf<ModelSeries<double>>& over, const FrameOf<ModelSeries<Real>>& about_middle) {
  constexpr double loose = 4;
  double largest = 0, widest = 0;
  for (std::size_t i = 0; i < 5; ++i) {
    for (const auto* f : {&about_middle.for_pp[i], &about_middle.for_qq[i]})
      largest = std::max(largest, RealTraits<Real>::magnitude(f->c[model_degree].mid));
    for (const auto* f : {&over.for_pp[i], &over.for_qq[i]}) widest = std::max(widest, f->c[model_degree].rad);
  }
  return widest <= loose * largest;  // never true of a NaN
}

template <class Real, class OtherReal>
void take_last_terms(FrameOf<ModelSeries<Real>>& model, const FrameOf<ModelSeries<OtherReal>>& over) {
  const auto take = [](ModelSeries<Real>& to, const ModelSeries<OtherReal>& from) {
    const Ball<OtherReal>& last = from.c[model_degree];
    to.c[model_degree] = Ball<Real>(Real(last.mid), last.rad);
  };
  for (std::size_t i = 0; i < 5; ++i) {
    take(model.for_pp[i], over.for_pp[i]);
    take(model.for_qq[i], over.for_qq[i]);
  }
}

/// Completes the model about its place to a distance of 2^e, within the segment, and over the whole ball. The last
/// terms are ranges, for which a few digits suffice.
template <class Real>
void complete(TaylorFrame<Real>& model, const MotionSegment& segment, int e, const Ball<Real>& t) {
  const Real reach = ldexp(Real(1), e);
  model.reach = std::ldexp(1.0, e);
  model.lo = std::min<Real>(t.lower(), std::max<Real>(Real(segment.start), model.middle - reach));
  model.hi = std::max<Real>(t.upper(), std::min<Real>(Real(segment.end), model.middle + reach));
  const FrameOf<ModelSeries<double>> rough =
      frame_series(segment, Ball<double>::between(double_floor(model.lo), double_above(model.hi)));
  if (are_sharp(rough, model.about_middle)) return take_last_terms(model.about_middle, rough);
  take_last_terms(model.about_middle, frame_series(segment, Ball<Real>::between(model.lo, model.hi)));
}

/// A model reaches several times as far as the ball, but no farther than a share of the distance to the nearest
/// singularity of the motion. Beyond that, its remainder exceeds all its other terms.
constexpr int levels_beyond_ball = 3, level_of_share = -2;
/// The level 2^e is at least the half width.
int finest_level(double half) { return std::ilogb(half) + 1; }

/// Makes a model about a place on the grid near the ball. `note` is called with each place that was tried and its
/// radius. Returns false if all of them are too close to a singularity of the motion for a ball of this length.
template <class Real, class Note>
bool make_around(TaylorFrame<Real>& model, const MotionSegment& segment, const Ball<Real>& t, int levels,
                 const Note& note) {
  const int finest = finest_level(t.rad);
  for (int e = finest + levels; e >= finest;) {
    model.middle = std::clamp<Real>(on_grid(t.mid, e - 1), Real(segment.start), Real(segment.end));
    model.about_middle = frame_series(segment, Ball<Real>(model.middle, 0.0));
    const double radius = from_quarters(radius_in_quarters(model.about_middle));
    const int most = std::ilogb(radius) + level_of_share;
    if (e <= most) {
      complete(model, segment, e, t);
      return true;
    }
    note(RealTraits<Real>::to_double(model.middle), radius);
    e = std::min(most, e - 1);
  }
  return false;
}

}  // namespace

template <class Real>
const FrameOf<SeriesFromEnd<Real>>& FramesFromEnd<Real>::terms(const MotionSegment& segment, double end,
                                                               double direction) {
  if (end_ != end || direction_ != direction) {
    count_work(work_of_frames);
    terms_ = frame_series(segment, TimeFromEnd<Real>{end, direction, Ball<Real>::exact(0)});
    end_ = end;
    direction_ = direction;
  }
  return terms_;
}

template <class Real>
const FrameValues<Real>& FramesFromEnd<Real>::last(const MotionSegment& segment, double end, double direction,
                                                   double farthest) {
  for (const Last& known : last_) {
    if (known.farthest == farthest && known.end == end && known.direction == direction) return known.frame;
  }
  count_work(work_of_frames);
  const Ball<Real> over = Ball<Real>::between(std::min(farthest, 0.0), std::max(farthest, 0.0));
  const auto series = frame_series(segment, TimeFromEnd<Real>{end, direction, over});
  Last made{end, direction, farthest, {}};
  for (std::size_t i = 0; i < 5; ++i) {
    made.frame.for_pp[i] = series.for_pp[i].c[last_from_end];
    made.frame.for_qq[i] = series.for_qq[i].c[last_from_end];
  }
  return keep(last_, next_, std::move(made)).frame;
}

void TaylorFrames::clear() {
  const auto clear = [](auto& kept) {
    kept.models.clear();
    kept.from_end.reset();
  };
  std::apply([&](auto&... kept) { (clear(kept), ...); }, kept_);
  limits_.clear();
}

bool TaylorFrames::is_too_long(double middle, double half) const {
  const double radius = std::ldexp(1.0, finest_level(half) - level_of_share);
  return std::any_of(limits_.begin(), limits_.end(),
                     [&](const Limit& known) { return radius > known.radius + std::fabs(known.at - middle); });
}

template <class Real>
const TaylorFrame<Real>* TaylorFrames::make(const MotionSegment& segment, const Ball<Real>& t, Reach reach) {
  if (is_too_long(RealTraits<Real>::to_double(t.mid), t.rad)) return nullptr;
  TaylorFrame<Real> made;
  made.number = ++made_;
  const auto note = [this](double at, double radius) { keep(limits_, next_limit_, Limit{at, radius}); };
  if (!make_around(made, segment, t, reach == Reach::once ? 0 : levels_beyond_ball, note)) return nullptr;
  auto& [models, next, from_end] = std::get<Kept<Real>>(kept_);
  return &keep(models, next, std::move(made));
}
#define TAUT_INSTANTIATE(Real)                                                                          \
  template const TaylorFrame<Real>* TaylorFrames::make(const MotionSegment&, const Ball<Real>&, Reach); \
  template class FramesFromEnd<Real>;
TAUT_FOR_EACH_PRECISION(TAUT_INSTANTIATE)
#undef TAUT_INSTANTIATE

}  // namespace taut::internal
