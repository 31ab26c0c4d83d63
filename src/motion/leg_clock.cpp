#include "motion/leg_clock.hpp"

#include <algorithm>
#include <cmath>

namespace taut {
namespace {

FastSide fast_side(const std::array<Jet<double>, 5>& j) {
  FastSide s{};
  for (int i = 0; i < 5; ++i) {
    s.f[i] = j[i].v.mid;
    s.d[i] = j[i].d.mid;
  }
  const auto size = [](const Ball<double>& b) { return std::fabs(b.mid); };
  s.size_0 = size(j[0].v);
  s.size_a = size(j[1].v) + size(j[2].v);
  s.size_b = size(j[3].v) + size(j[4].v);
  s.size_0d = size(j[0].d);
  s.size_ad = size(j[1].d) + size(j[2].d);
  s.size_bd = size(j[3].d) + size(j[4].d);
  s.error_0 = j[0].v.rad;
  s.error_a = j[1].v.rad + j[2].v.rad;
  s.error_b = j[3].v.rad + j[4].v.rad;
  s.error_0d = j[0].d.rad;
  s.error_ad = j[1].d.rad + j[2].d.rad;
  s.error_bd = j[3].d.rad + j[4].d.rad;
  return s;
}

FastCurvature fast_curvature(const std::array<Jet<double>, 5>& j) {
  FastCurvature c{};
  for (int i = 0; i < 5; ++i) {
    c.mid[i] = j[i].dd.mid;
    c.rad[i] = j[i].dd.rad;
    if (!(c.rad[i] < INFINITY) || !std::isfinite(c.mid[i])) {
      c.mid[i] = 0;
      c.rad[i] = INFINITY;
    }
  }
  return c;
}

}  // namespace

void LegClock::evaluate_exactly(double t) {
  const Frame<double> f = frame(*leg_, Ball<double>::exact(t));
  pp_ = fast_side(f.for_pp);
  qq_ = fast_side(f.for_qq);
}

namespace {

/// Shorter cells than this share of the leg lie at a singular instant.
constexpr int deepest = 40;

/// Two functions of a model as one row of a side: `at` is 1 or 3.
void fill(FastSide& s, int at, const FrameModel& m, int i, double t) {
  for (int k = 0; k < 2; ++k) m.evaluate(i + k, t, s.f[at + k], s.d[at + k]);
}

void measure(FastSide& s, const FrameModel& m, int moving) {
  s.f[0] = 1;
  s.d[0] = 0;
  s.size_0 = 1;
  s.size_0d = s.error_0 = s.error_0d = 0;
  s.size_a = std::fabs(s.f[1]) + std::fabs(s.f[2]);
  s.size_b = std::fabs(s.f[3]) + std::fabs(s.f[4]);
  s.size_ad = std::fabs(s.d[1]) + std::fabs(s.d[2]);
  s.size_bd = std::fabs(s.d[3]) + std::fabs(s.d[4]);
  s.error_a = m.error[moving] + m.error[moving + 1];
  s.error_ad = m.error_d[moving] + m.error_d[moving + 1];
  s.error_b = m.error[4] + m.error[5];
  s.error_bd = m.error_d[4] + m.error_d[5];
}

FastCurvature curvature_of(const FrameModel& m, int moving) {
  FastCurvature c{};
  const int source[4] = {moving, moving + 1, 4, 5};
  for (int k = 0; k < 4; ++k) {
    c.mid[k + 1] = m.bend[source[k]];
    c.rad[k + 1] = m.bend_rad[source[k]];
  }
  return c;
}

}  // namespace

void LegClock::reset(const Leg& leg) {
  leg_ = &leg;
  cached_ = false;
  level_ = 0;
  index_ = 0;
  last_start_ = last_end_ = 0;
  keys_.fill(0);
}

/// The same number for the same instant at every level, and growing with the index.
double LegClock::boundary(int level, std::uint64_t index) const {
  if (index == std::uint64_t{1} << level) return leg_->end;
  return leg_->start + (leg_->end - leg_->start) * std::ldexp(static_cast<double>(index), -level);
}

std::uint64_t LegClock::index_of(int level, double t) const {
  const std::uint64_t last = (std::uint64_t{1} << level) - 1;
  const double share = (t - leg_->start) / (leg_->end - leg_->start);
  const double guess = std::ldexp(share, level);
  std::uint64_t i = guess > 0 ? static_cast<std::uint64_t>(std::min(guess, static_cast<double>(last))) : 0;
  while (i > 0 && t < boundary(level, i)) --i;
  while (i < last && t >= boundary(level, i + 1)) ++i;
  return i;
}

void LegClock::make(ClockCell& cell) {
  cell.leaf = true;
  cell.sharp = false;
  if (leg_->bridge) {
    const Frame<double> f = frame(*leg_, Ball<double>::between(0, 1));
    cell.pp = fast_curvature(f.for_pp);
    cell.qq = fast_curvature(f.for_qq);
    return;
  }
  cell.model = FrameModel::over(*leg_, cell.start, cell.end);
  cell.sharp = cell.model.sharp();
  const bool divisible = cell.level < deepest && boundary(cell.level + 1, 2 * cell.index + 1) > cell.start &&
                         boundary(cell.level + 1, 2 * cell.index + 1) < cell.end;
  cell.leaf = !divisible || (cell.sharp && cell.model.straight()) || cell.model.hopeless();
  cell.pp = curvature_of(cell.model, 0);
  cell.qq = curvature_of(cell.model, 2);
}

const ClockCell& LegClock::at_level(int level, std::uint64_t index) {
  const std::uint64_t key = (std::uint64_t{1} << level) + index;
  const std::size_t slot = slot_of(key);
  ClockCell& cell = cells_[slot];
  if (keys_[slot] != key) {
    keys_[slot] = key;
    cell.level = level;
    cell.index = index;
    cell.start = boundary(level, index);
    cell.end = boundary(level, index + 1);
    make(cell);
  }
  return cell;
}

const ClockCell& LegClock::cell(double t) {
  if (t >= last_start_ && t < last_end_) return at_level(level_, index_);
  const ClockCell& found = find_leaf(t);
  level_ = found.level;
  index_ = found.index;
  last_start_ = found.start;
  last_end_ = found.end;
  return found;
}

/// The largest leaf around t. The way starts at the smallest cell around it and the leaf last found, which is no leaf
/// (or that very leaf): everything larger is none either.
const ClockCell& LegClock::find_leaf(double t) {
  int level = level_;
  std::uint64_t index = index_of(level, t), last = index_;
  for (; index != last; index /= 2, last /= 2) --level;
  const ClockCell* cell = &at_level(level, index);
  while (!cell->leaf) {
    ++level;
    cell = &at_level(level, index_of(level, t));
  }
  return *cell;
}

const ClockCell* LegClock::wider(const ClockCell& cell) {
  return cell.level > 0 ? &at_level(cell.level - 1, cell.index / 2) : nullptr;
}

void LegClock::evaluate(double t) {
  cached_t_ = t;
  cached_ = true;
  const ClockCell& here = cell(t);
  if (!here.sharp) return evaluate_exactly(t);
  const FrameModel& m = here.model;
  fill(pp_, 1, m, 0, t);
  fill(qq_, 1, m, 2, t);
  fill(pp_, 3, m, 4, t);
  for (int k = 3; k < 5; ++k) {
    qq_.f[k] = pp_.f[k];
    qq_.d[k] = pp_.d[k];
  }
  measure(pp_, m, 0);
  measure(qq_, m, 2);
}

}  // namespace taut
