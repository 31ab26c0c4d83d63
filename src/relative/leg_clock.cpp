#include "relative/leg_clock.hpp"

#include <algorithm>
#include <cmath>

#include "base/interruption.hpp"
#include "relative/even_turn.hpp"

namespace taut {
namespace {

FrameSample evaluate_exactly(const Leg& leg, double t, int first) {
  const Frame<double> f = frame(leg, Ball<double>::exact(t));
  return sample_of(first == 0 ? f.for_pp : f.for_qq);
}

/// In units of interruption_point(), beside its model.
constexpr std::uint64_t work_of_cell = 11;

/// Shorter cells than this share of the leg lie at a singular instant.
constexpr int deepest = 40;

/// Steps from values in the middle of a cell go by bounds of the third order, which do not ask for short cells.
constexpr double slack_of_steps = 4;

FrameThird third_of(const std::array<ThirdSeries, 5>& over) {
  FrameThird third{};
  for (std::size_t i = 0; i < 4; ++i) {
    const ThirdSeries& f = over[i + 1];
    const double most = f.terms > 3 ? 6 * f.c[3].magnitude() * (1 + 0x1p-40) : 0;
    third.most[i] = most >= 0 ? most : INFINITY;
  }
  return third;
}

}  // namespace

void LegClock::reset(const Leg& leg) {
  leg_ = &leg;
  even_ = leg.even_turn();
  steady_ = even_ && even_->is_steady();
  if (steady_) {
    pp_steady_ = even_->third(leg, true, leg.start, leg.end);
    qq_steady_ = even_->third(leg, false, leg.start, leg.end);
  }
  straight_ = is_straight(leg);
  if (straight_) {
    straight_middle_ = leg.start + (leg.end - leg.start) / 2;
    straight_side_ = evaluate_exactly(leg, straight_middle_, 0);
  }
  pp_.known = qq_.known = false;
  level_ = 0;
  index_ = 0;
  last_ = nullptr;
  stored_ = straight_cell_made_ = false;
}

void LegClock::Store::clear() {
  pp_marks.first = 0;
  qq_marks.first = 2;
  pp_marks.at.fill(NAN);
  qq_marks.at.fill(NAN);
  keys.fill(0);
  outlook_known.fill(false);
  deep_used = false;
}

bool LegClock::Store::holds(std::size_t slot, std::uint64_t wanted) {
  if (slot >= own && !deep_used) {
    if (!deep) deep.reset(new Deep);  // not touched, either
    deep->keys.fill(0);
    deep->outlook_keys.fill(0);
    deep_used = true;
  }
  return key(slot) == wanted;
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
  cell.ahead = 0;
  cell.sharp = cell.widest = false;
  if (leg_->bridge) {
    const Frame<double> f = frame(*leg_, Ball<double>::between(0, 1));
    cell.pp = curvature_of(f.for_pp);
    cell.qq = curvature_of(f.for_qq);
    return;
  }
  cell.model = FrameModel::over(*leg_, cell.start, cell.end);
  cell.sharp = cell.model.sharp();
  const bool divisible = cell.level < deepest && boundary(cell.level + 1, 2 * cell.index + 1) > cell.start &&
                         boundary(cell.level + 1, 2 * cell.index + 1) < cell.end;
  cell.leaf = !divisible || (cell.sharp && cell.model.straight(slack_of_steps)) || cell.model.hopeless();
  cell.ahead = cell.leaf ? 0 : levels_ahead(cell);
  cell.widest = cell.leaf && cell.sharp && cell.model.barely_sharp();
  cell.pp = curvature_of(cell.model, 0);
  cell.qq = curvature_of(cell.model, 2);
  cell.pp_third = third_of(cell.model, 0);
  cell.qq_third = third_of(cell.model, 2);
}

/// Rather too few than too many, and only as far as ends of cells are certainly apart.
int LegClock::levels_ahead(const ClockCell& cell) const {
  const double least = 0x1p-48 * std::max(std::fabs(cell.start), std::fabs(cell.end));
  int ahead = std::max(1, -std::ilogb(cell.model.fitting_share(slack_of_steps)) - 1);
  while (ahead > 1 && (cell.level + ahead > deepest || !(std::ldexp(cell.end - cell.start, -ahead) > least))) --ahead;
  return ahead;
}

const ClockCell& LegClock::whole_leg() {
  if (!straight_cell_made_) {
    place(straight_cell_, 0, 0);
    make(straight_cell_);
    straight_cell_.leaf = true;
    straight_cell_made_ = true;
  }
  return straight_cell_;
}

const ClockCell& LegClock::at_level(int level, std::uint64_t index) {
  if (straight_) return whole_leg();
  const std::uint64_t key = (std::uint64_t{1} << level) + index;
  const std::size_t slot = slot_of(key);
  if (!stored_) {
    reserve_cells();
    store_->clear();
    stored_ = true;
  }
  const bool held = store_->holds(slot, key);
  ClockCell& cell = store_->cell(slot);
  if (!held) {
    interruption_point(work_of_cell);
    if (&cell == last_) last_ = nullptr;
    store_->key(slot) = 0;
    place(cell, level, index);
    make(cell);
    store_->key(slot) = key;
  }
  return cell;
}

void LegClock::place(ClockCell& cell, int level, std::uint64_t index) const {
  cell.level = level;
  cell.index = index;
  cell.start = boundary(level, index);
  cell.end = boundary(level, index + 1);
}

const ClockCell& LegClock::find_cell(double t) {
  const ClockCell& found = find_leaf(t);
  level_ = found.level;
  index_ = found.index;
  last_ = &found;
  return found;
}

/// A leaf around t, about the largest one, which is mostly as large as the one last found. If that is not seen at once,
/// the way starts below the smallest cell around t and that one, which is no leaf (or at that very leaf).
const ClockCell& LegClock::find_leaf(double t) {
  int level = level_;
  std::uint64_t index = index_of(level, t), last = index_;
  if (index != last) {
    const ClockCell& next = at_level(level, index);
    if (next.widest) return next;
  }
  for (; index != last; index /= 2, last /= 2) --level;
  if (level < level_) ++level;
  const ClockCell* cell = &at_level(level, index_of(level, t));
  while (!cell->leaf) {
    level += cell->ahead;
    cell = &at_level(level, index_of(level, t));
  }
  return *cell;
}

const ClockCell* LegClock::wider(const ClockPlace& cell) {
  return cell.level > 0 ? &at_level(cell.level - 1, cell.index / 2) : nullptr;
}

const ClockCell* LegClock::outlook(const ClockPlace& cell) {
  if (cell.level == 0) return nullptr;
  const int level = cell.level - 1;
  const std::uint64_t index = cell.index / 2, key = (std::uint64_t{1} << level) + index;
  if (key >= own && even_) return &even_outlook(level, index);
  const std::size_t slot = slot_of(key);
  if (key >= own || store_->keys[slot] == key) return &at_level(level, index);
  ClockCell& wide = store_->cells[slot];
  if (!store_->outlook_known[slot]) {
    make_outlook(wide, level, index);
    store_->outlook_known[slot] = true;
  }
  return &wide;
}

const ClockCell& LegClock::even_outlook(int level, std::uint64_t index) {
  const std::uint64_t key = (std::uint64_t{1} << level) + index;
  const auto slot = static_cast<std::size_t>((key * 0x9e3779b97f4a7c15u) >> (64 - even_bits));
  Store::Deep& deep = *store_->deep;
  ClockCell& wide = deep.outlooks[slot];
  if (deep.outlook_keys[slot] != key) {
    make_outlook(wide, level, index);
    deep.outlook_keys[slot] = key;
  }
  return wide;
}

void LegClock::make_outlook(ClockCell& wide, int level, std::uint64_t index) const {
  place(wide, level, index);
  wide.leaf = wide.sharp = wide.widest = false;
  wide.ahead = 1;
  if (even_) {
    wide.pp_third = even_->third(*leg_, true, wide.start, wide.end);
    wide.qq_third = even_->third(*leg_, false, wide.start, wide.end);
  } else {
    const auto over = frame_to_third_order(*leg_, Ball<double>::between(wide.start, wide.end));
    wide.pp_third = third_of(over.for_pp);
    wide.qq_third = third_of(over.for_qq);
  }
}

void LegClock::evaluate(double t, Side& side) {
  // Known once it is: looking for the cell can be interrupted.
  side.known = false;
  const ClockCell& here = cell(t);
  if (here.sharp) {
    taut::evaluate(here.model, t, side.first, side.functions);
  } else {
    side.functions = evaluate_exactly(*leg_, t, side.first);
  }
  side.t = t;
  side.known = true;
}

const FrameSample& LegClock::shortly_before(double t, bool pp, double& at) {
  const ClockCell& here = cell(t);
  if (!here.sharp || straight_) return this->at(at = t, pp);
  Marks& known = pp || leg_->translation ? store_->pp_marks : store_->qq_marks;
  const double step = (here.end - here.start) * (1.0 / marks);
  const int k = std::min(static_cast<int>((t - here.start) / step), marks - 1);
  const auto slot = static_cast<std::size_t>(k);
  at = std::min(here.start + k * step, t);
  if (known.at[slot] != at) {
    known.at[slot] = at;
    taut::evaluate(here.model, at, known.first, known.functions[slot]);
  }
  return known.functions[slot];
}

}  // namespace taut
