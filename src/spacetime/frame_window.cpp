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
    if (make_range() || shortest || is_as_good_as_an_instant()) return;
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
  return roughness() <= 1;
}

/// The largest error of the ranges, relative to that of the largest motion that is treated by them.
double FrameWindow::roughness() const {
  double most = 0;
  for (const FrameSample* s : {&pp_, &qq_}) {
    const auto add = [&](double error, int i, int k) {
      const double share = error / (rough_motion * (1 + std::fmin(std::fabs(s->f[i]), std::fabs(s->f[k]))));
      most = share < INFINITY ? std::fmax(most, share) : INFINITY;
    };
    add(s->error_0, 0, 0);
    add(s->error_a, 1, 2);
    add(s->error_b, 3, 4);
  }
  return most;
}

/// Right before a dead point of a mechanism, only a box of values is known: shorter windows are no better.
bool FrameWindow::is_as_good_as_an_instant() {
  if (std::isnan(instant_roughness_)) {
    FrameWindow instant = *this;
    instant.end_ = std::min(end_, std::nextafter(start_, std::numeric_limits<double>::infinity()));
    instant.make_range();
    instant_roughness_ = instant.roughness();
  }
  return instant_roughness_ > 1 && instant_roughness_ < INFINITY && roughness() <= 2 * instant_roughness_;
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
