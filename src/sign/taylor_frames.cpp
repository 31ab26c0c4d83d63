#include "sign/taylor_frames.hpp"

#include <algorithm>
#include <cmath>

#include "base/interruption.hpp"

namespace taut {
namespace {

/// As PreciseFunction counts what it makes.
constexpr std::uint64_t work_of_frames = 1100;

/// The nearest multiple of 2^e, unless that is finer than the number resolves.
template <class Real>
Real on_grid(const Real& x, int e) {
  constexpr int spare = 32;
  const double size = RealTraits<Real>::magnitude(x);
  if (size > 0 && std::ilogb(size) - e > static_cast<int>(RealTraits<Real>::bits) - spare) return x;
  return ldexp(round(ldexp(x, -e)), e);
}

/// About a place on the grid, as far as the leg goes, or the ball.
template <class Real>
TaylorFrame<Real> model_around(const Leg& leg, const Ball<Real>& t, std::uint64_t number) {
  const int e = std::ilogb(t.rad) + 1;
  const Real start(leg.start), end(leg.end), reach = ldexp(Real(1), e + 3);
  const Real middle = std::clamp<Real>(on_grid(t.mid, e + 2), start, end);
  const Real lo = std::min<Real>(t.lower(), std::max<Real>(start, middle - reach));
  const Real hi = std::max<Real>(t.upper(), std::min<Real>(end, middle + reach));
  TaylorFrame<Real> made{lo, hi, middle, std::ldexp(1.0, e + 3), number, {}};
  made.about_middle = frame_series(leg, Ball<Real>(middle, 0.0));
  const FrameOf<ModelSeries<Real>> over = frame_series(leg, Ball<Real>::between(lo, hi));
  for (std::size_t i = 0; i < 5; ++i) {
    made.about_middle.for_pp[i].c[model_degree] = over.for_pp[i].c[model_degree];
    made.about_middle.for_qq[i].c[model_degree] = over.for_qq[i].c[model_degree];
  }
  return made;
}

}  // namespace

template <class Real>
const FrameOf<SeriesFromEnd<Real>>& FramesFromEnd<Real>::terms(const Leg& leg, double end, double direction) {
  if (end_ != end || direction_ != direction) {
    count_work(work_of_frames);
    terms_ = frame_series(leg, TimeFromEnd<Real>{end, direction, Ball<Real>::exact(0)});
    end_ = end;
    direction_ = direction;
  }
  return terms_;
}

template <class Real>
const FrameValues<Real>& FramesFromEnd<Real>::last(const Leg& leg, double end, double direction, double farthest) {
  for (const Last& known : last_) {
    if (known.farthest == farthest && known.end == end && known.direction == direction) return known.frame;
  }
  count_work(work_of_frames);
  const Ball<Real> over = Ball<Real>::between(std::min(farthest, 0.0), std::max(farthest, 0.0));
  const auto series = frame_series(leg, TimeFromEnd<Real>{end, direction, over});
  Last made{end, direction, farthest, {}};
  for (std::size_t i = 0; i < 5; ++i) {
    made.frame.for_pp[i] = series.for_pp[i].c[last_from_end];
    made.frame.for_qq[i] = series.for_qq[i].c[last_from_end];
  }
  if (last_.size() < most_kept) return last_.emplace_back(made).frame;
  next_ = (next_ + 1) % most_kept;
  return (last_[next_] = made).frame;
}

void TaylorFrames::clear() {
  const auto clear = [](auto& kept) {
    kept.models.clear();
    kept.from_end.reset();
  };
  std::apply([&](auto&... kept) { (clear(kept), ...); }, kept_);
}

template <class Real>
const TaylorFrame<Real>& TaylorFrames::make(const Leg& leg, const Ball<Real>& t) {
  auto& [models, next, from_end] = std::get<Kept<Real>>(kept_);
  if (models.size() < most_kept) return models.emplace_back(model_around(leg, t, ++made_));
  next = (next + 1) % most_kept;
  return models[next] = model_around(leg, t, ++made_);
}
#define TAUT_INSTANTIATE(Real)                                                         \
  template const TaylorFrame<Real>& TaylorFrames::make(const Leg&, const Ball<Real>&); \
  template class FramesFromEnd<Real>;
TAUT_FOR_EACH_PRECISION(TAUT_INSTANTIATE)
#undef TAUT_INSTANTIATE

}  // namespace taut
