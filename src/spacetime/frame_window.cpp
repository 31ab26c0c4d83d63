#include "spacetime/frame_window.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace taut::internal::spacetime {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// The largest motion of the frame in a window that is treated by ranges alone.
constexpr double rough_motion = 0x1p-16;

/// The remainder is proportional to the ninth power of a window's length. That of the next window is acceptable if it
/// changes by a half.
constexpr double cautious = 0.95;
/// The factors by which a window that was too long is shortened at once, and by which the length of the next one may
/// grow.
constexpr double shortened_most = 0x1p-12, shortened_least = 0.75, grown_most = 2;

}  // namespace

FrameWindow::FrameWindow(const MotionSegment& segment, double start, double limit, double length)
    : segment_(&segment), start_(start), end_(limit), cached_(unknown) {
  if (segment.bridge) {
    make_bridge();
    return;
  }
  for (double share = length;;
       share *= std::clamp(cautious * model_.fitting_share(), shortened_most, shortened_least)) {
    end_ = start + share < limit ? start + share : limit;
    const bool shortest = !(start + share / 2 > start);
    if (shortest) end_ = std::min(limit, std::nextafter(start, std::numeric_limits<double>::infinity()));
    if (make_smooth()) return;
    smooth_ = false;
    if (make_range() || shortest) return;
    smooth_ = true;
  }
}

double FrameWindow::fitting_length() const {
  const double share = smooth_ ? std::clamp(cautious * model_.fitting_share(), 0.5, grown_most) : grown_most;
  return share * length();
}

/// Evaluates value and slope at t from the frame itself: a bridge is short, and rare.
void FrameWindow::make_bridge() {
  const Frame<double> f = frame(*segment_, Ball<double>::between(start_, end_));
  second_pp_ = curvature_of(f.for_pp);
  second_qq_ = curvature_of(f.for_qq);
}

bool FrameWindow::make_range() {
  const Frame<double> f = frame(*segment_, Ball<double>::between(start_, end_));
  pp_ = sample_of(f.for_pp);
  qq_ = sample_of(f.for_qq);
  for (const FrameSample* s : {&pp_, &qq_}) {
    const auto rough = [s](int i, int k) {
      return rough_motion * (1 + std::fmin(std::fabs(s->f[i]), std::fabs(s->f[k])));
    };
    if (!(s->error_0 <= rough(0, 0) && s->error_a <= rough(1, 2) && s->error_b <= rough(3, 4))) return false;
  }
  return true;
}

bool FrameWindow::make_smooth() {
  model_ = FrameModel::over(*segment_, start_, end_);
  if (!model_.sharp() || !model_.straight()) return false;
  second_pp_ = curvature_of(model_, 0);
  second_qq_ = curvature_of(model_, 2);
  return true;
}

void FrameWindow::evaluate(double t) {
  cached_ = t;
  if (segment_->bridge) {
    const Frame<double> f = frame(*segment_, Ball<double>::exact(t));
    pp_ = sample_of(f.for_pp);
    qq_ = sample_of(f.for_qq);
    return;
  }
  double value[FrameModel::functions], slope[FrameModel::functions];
  model_.evaluate(t, value, slope);
  const auto fill = [&](FrameSample& s, int varying) {
    s.f[0] = 1;
    for (int i = 1; i < 5; ++i) {
      const int k = i < 3 ? varying + i - 1 : i + 1;
      s.f[i] = value[k];
      s.d[i] = slope[k];
    }
    add_errors(model_, varying, s);
  };
  fill(pp_, 0);
  fill(qq_, 2);
}

}  // namespace taut::internal::spacetime
