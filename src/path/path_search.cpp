#include "path/path_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "numeric/budget.hpp"
#include "path/tight_features.hpp"

namespace taut::internal::path {
namespace {

JointValues sum(const JointValues& a, const JointValues& b) {
  JointValues c{};
  for (std::size_t k = 0; k < c.size(); ++k) c[k] = a[k] + b[k];
  return c;
}

JointValues difference(const JointValues& a, const JointValues& b) {
  JointValues c{};
  for (std::size_t k = 0; k < c.size(); ++k) c[k] = a[k] - b[k];
  return c;
}

}  // namespace

PathSearch::PathSearch(const PathProblem& problem, const PathOptions& options, const JointSpace& space,
                       const WayChecker& checker, const Reach* reach)
    : problem_(problem),
      options_(options),
      space_(space),
      checker_(checker),
      goal_(problem, space),
      tree_(problem, space, options.tolerance, reach),
      channel_(tree_) {}

/// The start as the cell sees it, perhaps a period on.
std::optional<JointValues> PathSearch::start_in(const JointCell& box) const {
  JointValues found = problem_.start;
  for (std::size_t k = 0; k < space_.dimension(); ++k) {
    const Joint& joint = problem_.linkage.joints[k];
    const double period = problem_.periodic[k] ? joint.hi - joint.lo : 0;
    const auto inside = [&](double v) { return std::fabs(v - box.middle[k]) <= box.half[k]; };
    if (inside(found[k])) continue;
    if (inside(found[k] + period)) {
      found[k] += period;
    } else if (inside(found[k] - period)) {
      found[k] -= period;
    } else {
      return std::nullopt;
    }
  }
  return found;
}

bool PathSearch::accept(std::vector<JointValues> way, PathAnswer& answer) {
  std::vector<JointValues> shorter = checker_.shortened(way);
  if (checker_.proves(shorter)) {
    way = std::move(shorter);
  } else if (!checker_.proves(way)) {
    return false;
  }
  answer.outcome = PathOutcome::path;
  answer.waypoints = std::move(way);
  return true;
}

/// To the nearest combination that is the goal.
bool PathSearch::try_straight(PathAnswer& answer) {
  JointCell all = tree_.box(tree_.root());
  std::vector<JointValues> targets;
  if (!problem_.goal_outside) {
    all.middle = problem_.start;
    for (std::size_t k = 0; k < space_.dimension(); ++k) {
      const Joint& joint = problem_.linkage.joints[k];
      // From the start, half a period to either side; else as far as the range goes.
      all.half[k] = problem_.periodic[k] ? (joint.hi - joint.lo) / 2
                                         : std::max(joint.hi - problem_.start[k], problem_.start[k] - joint.lo);
    }
    if (const auto goal = goal_.point_in(all)) targets.push_back(*goal);
  } else if (const auto goal = goal_.point_in({problem_.start, {}})) {
    targets.push_back(*goal);
  }
  return std::any_of(targets.begin(), targets.end(), [&](const JointValues& goal) {
    if (!checker_.passes(problem_.start, goal, true)) return false;
    return accept({problem_.start, goal}, answer);
  });
}

/// Remembered, since chains have much in common. Cells between which nothing passes are noted.
bool PathSearch::passes(CellId from, CellId to, const JointValues& a, const JointValues& b, bool exactly) {
  const auto [place, is_new] = passed_.try_emplace(std::pair(from, to), false);
  if (is_new) place->second = checker_.passes(a, b, exactly);
  if (!place->second) failed_ = {from, to};
  return place->second;
}

/// From the sample of each cell to that of the next one: straight, or by a point that both have in common.
bool PathSearch::try_chain(const Chain& chain, PathAnswer& answer) {
  failed_ = {no_cell, no_cell};
  if (!std::all_of(chain.begin(), chain.end(), [&](CellId id) { return tree_.sample_free(id); })) return false;
  const std::optional<JointValues> goal = goal_.point_in(tree_.box(chain.back()));
  if (!goal) return false;
  const auto is_free = [&](CellId id) { return tree_[id].state == CellState::free; };
  JointValues offset = difference(problem_.start, *start_in(tree_.box(chain.front())));
  JointValues at = sum(tree_.sample(chain.front()), offset);
  if (!is_free(chain.front()) && !passes(no_cell, chain.front(), problem_.start, at, true)) return false;
  std::vector<JointValues> way = {problem_.start, at};
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    const CellId from = chain[i], to = chain[i + 1];
    const CommonPoint common = *tree_.common_point(from, to);
    const JointValues between = sum(common.at, offset);
    offset = sum(offset, common.shift);
    const JointValues next = sum(tree_.sample(to), offset);
    const bool known = is_free(from) && is_free(to);
    if (known || !passes(from, to, at, next, false)) {
      if (!known && !(passes(to, from, at, between, false) && checker_.passes(between, next, false))) return false;
      way.push_back(between);
    }
    way.push_back(next);
    at = next;
  }
  const JointValues last = sum(*goal, offset);
  if (!is_free(chain.back()) && !passes(chain.back(), no_cell, at, last, true)) return false;
  way.push_back(last);
  return accept(std::move(way), answer);
}

bool PathSearch::can_be_divided(CellId id) const {
  return id != no_cell && tree_[id].is_leaf() && !tree_[id].is_least && tree_[id].state == CellState::undecided;
}

/// Of the cells of the chain whose samples are not free, the largest ones; of those between which no segment passes,
/// the larger one; else any.
Chain PathSearch::doubtful_in(const Chain& chain) {
  Chain doubtful;
  for (const CellId id : chain) {
    if (!can_be_divided(id) || tree_.sample_free(id)) continue;
    if (!doubtful.empty() && tree_[id].depth < tree_[doubtful.front()].depth) doubtful.clear();
    if (doubtful.empty() || tree_[id].depth == tree_[doubtful.front()].depth) doubtful.push_back(id);
  }
  if (!doubtful.empty()) return doubtful;
  std::array<CellId, 2> ends = failed_;
  const auto depth = [&](CellId id) { return can_be_divided(id) ? tree_[id].depth : UINT32_MAX; };
  if (depth(ends[1]) < depth(ends[0])) std::swap(ends[0], ends[1]);
  if (can_be_divided(ends[0])) return {ends[0]};
  std::copy_if(chain.begin(), chain.end(), std::back_inserter(doubtful), [&](CellId id) { return can_be_divided(id); });
  return doubtful;
}

/// Divides what is doubtful in the chain. False if nothing can be divided.
bool PathSearch::divide_some_of(const Chain& chain) {
  const auto is_seed = [&](CellId half, Channel::Side side) {
    const JointCell box = tree_.box(half);
    return side == Channel::Side::start ? start_in(box).has_value() : goal_.may_meet(box);
  };
  const Chain doubtful = doubtful_in(chain);
  for (const CellId id : doubtful) channel_.divide(id, is_seed);
  if (!doubtful.empty()) return true;
  // Perhaps whether the last one holds a goal is not known.
  const CellId last = chain.back();
  if (tree_[last].is_least || goal_.point_in(tree_.box(last))) return false;
  channel_.divide(last, is_seed);
  return true;
}

/// Of the cells in which nothing free is known, the one with the least room between two sides; if there is none, the
/// first one that is undecided.
void PathSearch::set_tight(const Chain& chain, PathAnswer& answer) const {
  double least = INFINITY;
  for (const CellId id : chain) {
    if (tree_[id].state != CellState::undecided || (answer.tight && tree_[id].sample_free)) continue;
    TightPlace tight;
    const JointCell box = tree_.box(id);
    if (space_.pairs().may_lock(box).anywhere) continue;
    tight.values = tree_.sample(id);
    for (std::size_t k = 0; k < tight.size.size(); ++k) tight.size[k] = 2 * box.half[k];
    const OpenPairs& open = *tree_[id].open;
    tight.features = tight_features(space_, tight.values, open);
    tight.pair = space_.of_scene()[open.front().first];
    if (!tight.features.empty()) {
      const TightFeatures& nearest = tight.features.front();
      tight.pair = {std::min(nearest.vertex.body, nearest.edge.body), std::max(nearest.vertex.body, nearest.edge.body)};
    }
    const double room = tight.features.size() == 2 && !tree_[id].sample_free
                            ? tight.features[0].distance + tight.features[1].distance
                            : INFINITY;
    if (answer.tight && !(room < least)) continue;
    least = room;
    answer.tight = std::move(tight);
  }
}

bool PathSearch::may_lock(CellId id) const {
  return tree_[id].state == CellState::undecided && space_.pairs().may_lock(tree_.box(id)).anywhere;
}

/// The leaves to which a chain of cells that were not shown to collide leads from the start.
std::vector<char> PathSearch::reached() const {
  std::vector<char> reached(tree_.size());
  std::vector<CellId> todo;
  for (CellId id = 0; id < tree_.size(); ++id) {
    reached[id] = tree_[id].is_leaf() && tree_[id].state != CellState::colliding && start_in(tree_.box(id));
    if (reached[id]) todo.push_back(id);
  }
  while (!todo.empty()) {
    const CellId id = todo.back();
    todo.pop_back();
    for (const CellId next : tree_[id].neighbours) {
      if (!std::exchange(reached[next], 1)) todo.push_back(next);
    }
  }
  return reached;
}

/// Is there a chain from the start to a cell in which the mechanism may lock? Beyond it, the mechanism may be in
/// another pose than the one that cells are about.
bool PathSearch::reaches_lock() const {
  const std::vector<DrivenLoops>& loops = space_.linkage().loops;
  if (std::none_of(loops.begin(), loops.end(), [](const DrivenLoops& l) { return l.region != nullptr; })) return false;
  const std::vector<char> reached = this->reached();
  for (CellId id = 0; id < tree_.size(); ++id) {
    if (reached[id] && may_lock(id)) return true;
  }
  return false;
}

void PathSearch::run(PathAnswer& answer) {
  if (try_straight(answer)) return;
  if (tree_[tree_.root()].state == CellState::colliding) {
    answer.outcome = PathOutcome::none;
    return;
  }
  channel_.add_seed(Channel::Side::start, tree_.root());
  if (goal_.may_meet(tree_.box(tree_.root()))) channel_.add_seed(Channel::Side::goal, tree_.root());
  for (;;) {
    checkpoint();
    report_parts("cells", tree_.size());
    if (tree_.size() >= options_.max_cells) throw Interrupted{"limit of cells reached"};
    const std::optional<Chain> chain = channel_.find();
    if (!chain) {
      answer.outcome = reaches_lock() ? PathOutcome::undecided : PathOutcome::none;
      if (answer.outcome == PathOutcome::undecided)
        answer.reason =
            "no chain of cells leads to the goal, but one to cells in which the mechanism may lock, or go on in "
            "another way";
      return;
    }
    if (try_chain(*chain, answer)) return;
    if (divide_some_of(*chain)) continue;
    answer.outcome = PathOutcome::undecided;
    answer.reason = "there are cells as small as the tolerance that would connect the start and the goal";
    if (std::any_of(chain->begin(), chain->end(), [&](CellId id) { return may_lock(id); }))
      answer.reason += "; in some of them, the mechanism may lock, or does not get there";
    set_tight(*chain, answer);
    return;
  }
}

std::vector<EnvelopeCell> PathSearch::cells(PathOutcome outcome) const {
  std::vector<EnvelopeCell> all;
  const std::vector<char> reached = outcome == PathOutcome::none ? this->reached() : std::vector<char>(tree_.size());
  for (CellId id = 0; id < tree_.size(); ++id) {
    const TreeCell& cell = tree_[id];
    if (!cell.is_leaf()) continue;
    EnvelopeCell done;
    done.state = cell.state;
    if (cell.open && !cell.open->empty()) done.pair = space_.of_scene()[cell.open->front().first];
    const JointCell box = tree_.box(id);
    done.may_lock = may_lock(id);
    done.reached = reached[id] != 0;
    for (std::size_t k = 0; k < space_.dimension(); ++k) {
      const Joint& joint = problem_.linkage.joints[k];
      done.lo[k] = std::max(joint.lo, box.middle[k] - box.half[k]);
      done.hi[k] = std::min(joint.hi, box.middle[k] + box.half[k]);
    }
    all.push_back(done);
  }
  return all;
}

}  // namespace taut::internal::path
