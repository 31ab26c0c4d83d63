#include "motion/taylor_model_cache.hpp"

#include <algorithm>
#include <cmath>

#include "motion/uniform_rotation.hpp"
#include "numeric/budget.hpp"

namespace taut::internal {
namespace {

FrameSample evaluate_exactly(const MotionSegment& segment, double t, int first) {
  const Frame<double> f = frame(segment, Ball<double>::exact(t));
  return sample_of(first == 0 ? f.for_pp : f.for_qq);
}

/// In units of checkpoint(), in addition to its model.
constexpr std::uint64_t work_of_cell = 11;

/// Cells shorter than this share of the segment are at a singular instant.
constexpr int deepest = 40;

/// Steps from values in the middle of a cell use bounds of the third order, which do not require short cells.
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

void TaylorModelCache::reset(const MotionSegment& segment) {
  segment_ = &segment;
  even_ = segment.uniform_rotation();
  steady_ = even_ && even_->is_steady();
  if (steady_) {
    pp_steady_ = even_->third(segment, true, segment.start, segment.end);
    qq_steady_ = even_->third(segment, false, segment.start, segment.end);
  }
  straight_ = is_straight(segment);
  if (straight_) {
    straight_middle_ = segment.start + (segment.end - segment.start) / 2;
    straight_side_ = evaluate_exactly(segment, straight_middle_, 0);
  }
  pp_.known = qq_.known = false;
  level_ = 0;
  index_ = 0;
  last_ = nullptr;
  stored_ = straight_cell_made_ = false;
}

void TaylorModelCache::Store::clear() {
  pp_samples.first = 0;
  qq_samples.first = 2;
  pp_samples.at.fill(NAN);
  qq_samples.at.fill(NAN);
  keys.fill(0);
  parent_bounds_known.fill(false);
  deep_used = false;
}

bool TaylorModelCache::Store::holds(std::size_t slot, std::uint64_t wanted) {
  if (slot >= own && !deep_used) {
    if (!deep) deep.reset(new Deep);  // not initialized, either
    deep->keys.fill(0);
    deep->parent_bounds_keys.fill(0);
    deep_used = true;
  }
  return key(slot) == wanted;
}

/// The same number for the same instant at every level, increasing with the index.
double TaylorModelCache::boundary(int level, std::uint64_t index) const {
  if (index == std::uint64_t{1} << level) return segment_->end;
  return segment_->start + (segment_->end - segment_->start) * std::ldexp(static_cast<double>(index), -level);
}

std::uint64_t TaylorModelCache::index_of(int level, double t) const {
  const std::uint64_t last = (std::uint64_t{1} << level) - 1;
  const double share = (t - segment_->start) / (segment_->end - segment_->start);
  const double guess = std::ldexp(share, level);
  std::uint64_t i = guess > 0 ? static_cast<std::uint64_t>(std::min(guess, static_cast<double>(last))) : 0;
  while (i > 0 && t < boundary(level, i)) --i;
  while (i < last && t >= boundary(level, i + 1)) ++i;
  return i;
}

void TaylorModelCache::make(ModelCell& cell) {
  cell.leaf = true;
  cell.ahead = 0;
  cell.sharp = cell.widest = false;
  if (segment_->bridge) {
    const Frame<double> f = frame(*segment_, Ball<double>::between(0, 1));
    cell.pp = curvature_of(f.for_pp);
    cell.qq = curvature_of(f.for_qq);
    return;
  }
  cell.model = FrameModel::over(*segment_, cell.start, cell.end);
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

/// An underestimate rather than an overestimate, and only as far as ends of cells are certainly distinct.
int TaylorModelCache::levels_ahead(const ModelCell& cell) const {
  const double least = 0x1p-48 * std::max(std::fabs(cell.start), std::fabs(cell.end));
  int ahead = std::max(1, -std::ilogb(cell.model.fitting_share(slack_of_steps)) - 1);
  while (ahead > 1 && (cell.level + ahead > deepest || !(std::ldexp(cell.end - cell.start, -ahead) > least))) --ahead;
  return ahead;
}

const ModelCell& TaylorModelCache::whole_segment() {
  if (!straight_cell_made_) {
    if (!straight_cell_) straight_cell_ = std::make_unique<ModelCell>();
    place(*straight_cell_, 0, 0);
    make(*straight_cell_);
    straight_cell_->leaf = true;
    straight_cell_made_ = true;
  }
  return *straight_cell_;
}

const ModelCell& TaylorModelCache::at_level(int level, std::uint64_t index) {
  if (straight_) return whole_segment();
  const std::uint64_t key = (std::uint64_t{1} << level) + index;
  const std::size_t slot = slot_of(key);
  if (!stored_) {
    reserve_cells();
    store_->clear();
    stored_ = true;
  }
  const bool held = store_->holds(slot, key);
  ModelCell& cell = store_->cell(slot);
  if (!held) {
    checkpoint(work_of_cell);
    if (&cell == last_) last_ = nullptr;
    store_->key(slot) = 0;
    place(cell, level, index);
    make(cell);
    store_->key(slot) = key;
  }
  return cell;
}

void TaylorModelCache::release() {
  store_.reset();
  last_ = nullptr;
  stored_ = false;
  if (even_) even_->release();
}

void TaylorModelCache::place(ModelCell& cell, int level, std::uint64_t index) const {
  cell.level = level;
  cell.index = index;
  cell.start = boundary(level, index);
  cell.end = boundary(level, index + 1);
}

const ModelCell& TaylorModelCache::find_cell(double t) {
  const ModelCell& found = find_leaf(t);
  level_ = found.level;
  index_ = found.index;
  last_ = &found;
  return found;
}

/// A leaf around t, approximately the largest one, which mostly is as large as the one found last. If it is not found
/// at once, the descent starts below the smallest cell around t and the last leaf, which is not a leaf (or at that very
/// leaf).
const ModelCell& TaylorModelCache::find_leaf(double t) {
  int level = level_;
  std::uint64_t index = index_of(level, t), last = index_;
  if (index != last) {
    const ModelCell& next = at_level(level, index);
    if (next.widest) return next;
  }
  for (; index != last; index /= 2, last /= 2) --level;
  if (level < level_) ++level;
  const ModelCell* cell = &at_level(level, index_of(level, t));
  while (!cell->leaf) {
    level += cell->ahead;
    cell = &at_level(level, index_of(level, t));
  }
  return *cell;
}

const ModelCell* TaylorModelCache::wider(const ModelPlace& cell) {
  return cell.level > 0 ? &at_level(cell.level - 1, cell.index / 2) : nullptr;
}

const ModelCell* TaylorModelCache::parent_bounds(const ModelPlace& cell) {
  if (cell.level == 0) return nullptr;
  const int level = cell.level - 1;
  const std::uint64_t index = cell.index / 2, key = (std::uint64_t{1} << level) + index;
  if (key >= own && even_) return &uniform_parent_bounds(level, index);
  const std::size_t slot = slot_of(key);
  if (key >= own || store_->keys[slot] == key) return &at_level(level, index);
  ModelCell& wide = store_->cells[slot];
  if (!store_->parent_bounds_known[slot]) {
    make_parent_bounds(wide, level, index);
    store_->parent_bounds_known[slot] = true;
  }
  return &wide;
}

const ModelCell& TaylorModelCache::uniform_parent_bounds(int level, std::uint64_t index) {
  const std::uint64_t key = (std::uint64_t{1} << level) + index;
  const auto slot = static_cast<std::size_t>((key * 0x9e3779b97f4a7c15u) >> (64 - even_bits));
  Store::Deep& deep = *store_->deep;
  ModelCell& wide = deep.all_parent_bounds[slot];
  if (deep.parent_bounds_keys[slot] != key) {
    make_parent_bounds(wide, level, index);
    deep.parent_bounds_keys[slot] = key;
  }
  return wide;
}

void TaylorModelCache::make_parent_bounds(ModelCell& wide, int level, std::uint64_t index) const {
  place(wide, level, index);
  wide.leaf = wide.sharp = wide.widest = false;
  wide.ahead = 1;
  if (even_) {
    wide.pp_third = even_->third(*segment_, true, wide.start, wide.end);
    wide.qq_third = even_->third(*segment_, false, wide.start, wide.end);
  } else {
    const auto over = frame_to_third_order(*segment_, Ball<double>::between(wide.start, wide.end));
    wide.pp_third = third_of(over.for_pp);
    wide.qq_third = third_of(over.for_qq);
  }
}

void TaylorModelCache::evaluate(double t, Side& side) {
  // Set to known only at the end, because the search for the cell may be interrupted.
  side.known = false;
  const ModelCell& here = cell(t);
  if (here.sharp) {
    internal::evaluate(here.model, t, side.first, side.functions);
  } else {
    side.functions = evaluate_exactly(*segment_, t, side.first);
  }
  side.t = t;
  side.known = true;
}

const FrameSample& TaylorModelCache::shortly_before(double t, bool pp, double& at) {
  const ModelCell& here = cell(t);
  if (!here.sharp || straight_) return this->at(at = t, pp);
  SampleGrid& known = pp || segment_->translation ? store_->pp_samples : store_->qq_samples;
  const double step = (here.end - here.start) * (1.0 / samples);
  const int k = std::min(static_cast<int>((t - here.start) / step), samples - 1);
  const auto slot = static_cast<std::size_t>(k);
  at = std::min(here.start + k * step, t);
  if (known.at[slot] != at) {
    known.at[slot] = at;
    internal::evaluate(here.model, at, known.first, known.functions[slot]);
  }
  return known.functions[slot];
}

}  // namespace taut::internal
