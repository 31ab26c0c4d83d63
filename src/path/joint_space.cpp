#include "path/joint_space.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

#include "numeric/budget.hpp"
#include "path/conditions.hpp"

namespace taut::internal::path {
namespace {

/// A segment is divided so often, and into so many parts, before the search gives up.
constexpr int most_halvings = 24;
constexpr int most_parts = 4096;

/// All joints of a segment move at once: one rate instead of one for each joint.
JointModel collapsed(JointModel z) {
  Vector sum;
  for (const Vector& r : z.rate) sum = sum + r;
  z.rate = {};
  z.rate[0] = sum;
  z.error += 0x1p-50 * z.reach();
  return z;
}

JointCell point_at(const JointValues& values) { return {values, {}}; }

}  // namespace

JointSpace::JointSpace(const PathProblem& problem, double clearance) : problem_(problem), pairs_(problem.linkage) {
  for (const auto& pair : pairs_.pairs()) {
    cells_.emplace_back(*pair, clearance * pairs_.scale());
    bodies_.push_back(pair->bodies);
  }
  const std::optional<Mechanism>& mechanism = problem.linkage.scene.mechanism;
  for (std::size_t k = 0; k < dimension(); ++k)
    drives_[k] = mechanism && is_joint_of(*mechanism, problem.linkage.joints[k].name);
}

OpenPairs JointSpace::all_open() const {
  OpenPairs all(cells_.size());
  for (std::uint32_t i = 0; i < all.size(); ++i) all[i].first = i;
  return all;
}

CellState JointSpace::evaluate(const JointCell& cell, OpenPairs& open, JointValues* best) const {
  if (pairs_.may_lock(cell).anywhere) return CellState::undecided;
  thread_local std::vector<Condition> conditions;
  conditions.clear();
  std::size_t left = 0;
  for (std::size_t i = 0; i < open.size(); ++i) {
    auto& [pair, features] = open[i];
    const PoseModel pose = pairs_.between(pairs_[pair], cell);
    const CellState state = cells_[pair].evaluate(pose, features, nullptr, best ? &conditions : nullptr);
    if (state == CellState::colliding) {
      open = {std::pair(pair, std::move(features))};
      return state;
    }
    if (state == CellState::free) continue;
    if (left != i) open[left] = std::move(open[i]);
    ++left;
  }
  open.resize(left);
  if (left == 0) return CellState::free;
  if (!best) return CellState::undecided;
  const JointConditions all = decide(conditions);
  if (all.exclude_each_other) return CellState::colliding;
  for (std::size_t k = 0; k < dimension(); ++k) (*best)[k] = cell.middle[k] + all.best[k] * cell.half[k];
  return CellState::undecided;
}

bool JointSpace::collides_deeply(const JointCell& cell, OpenPairs& open) const {
  if (pairs_.may_lock(cell).anywhere) return false;
  for (auto& [pair, features] : open) {
    if (!cells_[pair].find_deep(pairs_.between(pairs_[pair], cell), features)) continue;
    open = {std::pair(pair, std::move(features))};
    return true;
  }
  return false;
}

std::optional<CellReason> JointSpace::why(const JointCell& cell, OpenPairs open) const {
  CellReason reason;
  for (auto& [pair, features] : open) {
    Collision collision;
    const std::size_t before = reason.conditions.size();
    const PoseModel pose = pairs_.between(pairs_[pair], cell);
    if (cells_[pair].evaluate(pose, features, &collision, &reason.conditions) == CellState::colliding)
      return CellReason{pair, collision, {}, {}};
    for (std::size_t i = before; i < reason.conditions.size(); ++i) reason.conditions[i].pair = pair;
  }
  const JointConditions all = decide(reason.conditions);
  if (!all.exclude_each_other) return std::nullopt;
  reason.weights = all.weights;
  return reason;
}

bool JointSpace::is_free(const JointValues& at, const OpenPairs& among) const {
  OpenPairs open = among;
  return evaluate(point_at(at), open) == CellState::free;
}

double JointSpace::share_of_range(const JointCell& cell, std::size_t joint) const {
  const Joint& range = linkage().joints[joint];
  return range.hi > range.lo ? cell.half[joint] / (range.hi - range.lo) : 0;
}

std::array<double, max_joints> JointSpace::effect_on(std::uint32_t pair, const JointCell& cell,
                                                     const OpenFeatures& features) const {
  const PoseModel pose = pairs_.between(pairs_[pair], cell);
  PoseModel rest = pose;
  std::array<PoseModel, max_joints> held;
  held.fill(pose);
  JointCell all_held = cell;
  for (std::size_t k = 0; k < dimension(); ++k) {
    if (!drives_[k] || !pairs_.follows(pairs_[pair], k)) continue;
    JointCell one_held = cell;
    one_held.half[k] = all_held.half[k] = 0;
    held[k] = pairs_.between(pairs_[pair], one_held);
    rest = pairs_.between(pairs_[pair], all_held);
  }
  return cells_[pair].effect(pose, rest, held, features);
}

std::array<double, max_joints> JointSpace::effect(const JointCell& cell, const OpenPairs& open) const {
  std::array<double, max_joints> sum{};
  if (const MayLock lock = pairs_.may_lock(cell); lock.anywhere) {
    for (std::size_t k = 0; k < dimension(); ++k) sum[k] = lock.joints[k] ? share_of_range(cell, k) : 0;
    return sum;
  }
  for (const auto& [pair, features] : open) {
    const std::array<double, max_joints> one = effect_on(pair, cell, features);
    for (std::size_t k = 0; k < dimension(); ++k) {
      if (pairs_.follows(pairs_[pair], k)) sum[k] = std::max(sum[k], one[k]);
    }
  }
  return sum;
}

/// False if bodies collide in all of the segment. Pairs that are shown to be free are no longer open; where the
/// mechanism may lock, none is, and smaller parts of the segment are looked at.
bool JointSpace::is_free_between(const JointCell& segment, OpenPairs& open) const {
  if (pairs_.may_lock(segment).anywhere) return true;
  OpenPairs left;
  for (auto& [pair, features] : open) {
    const PoseModel pose = pairs_.between(pairs_[pair], segment);
    const CellState state = cells_[pair].evaluate({collapsed(pose.shift), collapsed(pose.rotation)}, features);
    if (state == CellState::colliding) return false;
    if (state == CellState::undecided) left.emplace_back(pair, std::move(features));
  }
  open = std::move(left);
  return true;
}

/// The larger parts first, each after its middle: what is not free shows soon. Rounding of the joint values themselves
/// is bounded roughly: this finds ways, and check() proves them.
bool JointSpace::is_free(const JointValues& a, const JointValues& b) const {
  struct Part {
    double from, to;
    int halvings;
    OpenPairs open;
  };
  const auto at = [&](double s) {
    JointValues v{};
    for (std::size_t k = 0; k < dimension(); ++k) v[k] = a[k] + s * (b[k] - a[k]);
    return v;
  };
  std::deque<Part> parts;
  parts.push_back({0, 1, 0, all_open()});
  for (int n = 0; !parts.empty(); ++n) {
    checkpoint();
    Part part = std::move(parts.front());
    parts.pop_front();
    if (part.halvings > most_halvings || n > most_parts) return false;
    const double middle = (part.from + part.to) / 2;
    if (!is_free(at(middle), part.open)) return false;
    const JointValues from = at(part.from), to = at(part.to);
    JointCell segment = point_at(at(middle));
    for (std::size_t k = 0; k < dimension(); ++k) {
      // Larger by what rounds, to the side to which the segment goes.
      const double rounding = 0x1p-50 * (std::fabs(a[k]) + std::fabs(b[k]));
      const double half = std::max(std::fabs(to[k] - segment.middle[k]), std::fabs(from[k] - segment.middle[k]));
      segment.half[k] = a[k] == b[k] ? 0 : std::copysign(half + rounding, b[k] - a[k]);
    }
    if (!is_free_between(segment, part.open)) return false;
    if (part.open.empty()) continue;
    parts.push_back({part.from, middle, part.halvings + 1, part.open});
    parts.push_back({middle, part.to, part.halvings + 1, std::move(part.open)});
  }
  return true;
}

}  // namespace taut::internal::path
