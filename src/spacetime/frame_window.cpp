#include "spacetime/frame_window.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace taut::spacetime {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

FrameSample sample_of(const std::array<Jet<double>, 5>& j) {
  FrameSample s{};
  for (int i = 0; i < 5; ++i) {
    s.f[i] = j[i].v.mid;
    s.d[i] = j[i].d.mid;
    s.error[i] = j[i].v.rad;
    s.error_d[i] = j[i].d.rad;
  }
  return s;
}

FrameBend bend_of(const std::array<Jet<double>, 5>& j) {
  FrameBend b{};
  for (int i = 0; i < 5; ++i) {
    b.mid[i] = j[i].dd.mid;
    b.rad[i] = j[i].dd.rad;
  }
  return b;
}

/// How little the frame must move in a window that is treated by ranges alone.
constexpr double rough_motion = 0x1p-16;

}  // namespace

FrameWindow::FrameWindow(const Leg& leg, double start, double limit, double length)
    : leg_(&leg), start_(start), end_(limit), cached_(unknown) {
  if (leg.bridge) {
    make_bridge();
    return;
  }
  for (double share = length;; share /= 2) {
    end_ = start + share < limit ? start + share : limit;
    const bool shortest = !(start + share / 2 > start);
    if (shortest) end_ = std::min(limit, std::nextafter(start, std::numeric_limits<double>::infinity()));
    if (make_smooth()) return;
    smooth_ = false;
    if (make_range() || shortest) return;
    smooth_ = true;
  }
}

/// Value and slope at t, from the frame itself: a bridge is short, and rare.
void FrameWindow::make_bridge() {
  const Frame<double> f = frame(*leg_, Ball<double>::between(start_, end_));
  bend_pp_ = bend_of(f.for_pp);
  bend_qq_ = bend_of(f.for_qq);
}

bool FrameWindow::make_range() {
  const Frame<double> f = frame(*leg_, Ball<double>::between(start_, end_));
  pp_ = sample_of(f.for_pp);
  qq_ = sample_of(f.for_qq);
  for (const FrameSample* s : {&pp_, &qq_}) {
    for (int i = 0; i < 5; ++i) {
      if (!(s->error[i] <= rough_motion * (1 + std::fabs(s->f[i])))) return false;
    }
  }
  return true;
}

bool FrameWindow::make_smooth() {
  model_ = FrameModel::over(*leg_, start_, end_);
  if (!model_.sharp() || !model_.straight()) return false;
  for (int k = 0; k < FrameModel::functions; ++k) {
    const bool of_q = k == 2 || k == 3;
    const int i = k < 2 ? k + 1 : k - 1;
    if (!of_q) bend_pp_.mid[i] = model_.bend[k], bend_pp_.rad[i] = model_.bend_rad[k];
    if (k >= 2) bend_qq_.mid[i] = model_.bend[k], bend_qq_.rad[i] = model_.bend_rad[k];
  }
  return true;
}

void FrameWindow::evaluate(double t) {
  cached_ = t;
  if (leg_->bridge) {
    const Frame<double> f = frame(*leg_, Ball<double>::exact(t));
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
      s.error[i] = model_.error[k];
      s.error_d[i] = model_.error_d[k];
    }
  };
  fill(pp_, 0);
  fill(qq_, 2);
}

}  // namespace taut::spacetime
