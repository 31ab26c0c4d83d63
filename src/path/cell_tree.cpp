#include "path/cell_tree.hpp"

#include <algorithm>
#include <cmath>

namespace taut::internal::path {
namespace {

/// Cells are never smaller, whatever the tolerance.
constexpr std::int64_t least_side = whole_side >> 40;

}  // namespace

CellTree::CellTree(const PathProblem& problem, const JointSpace& space, double tolerance, const Reach* reach)
    : problem_(problem),
      space_(space),
      tolerance_(tolerance),
      reach_(reach),
      dimension_(problem.linkage.joints.size()) {
  add_root();
}

void CellTree::add_root() {
  TreeCell root;
  for (std::size_t k = 0; k < dimension_; ++k) root.side[k] = whole_side;
  root.open = std::make_unique<OpenPairs>(space_.all_open());
  cells_.push_back(std::move(root));
  evaluate(0);
}

void CellTree::evaluate(CellId id) {
  TreeCell& cell = cells_[id];
  const JointCell around = box(id);
  cell.sample = around.middle;
  if (reach_ && !reach_->may_hold(around)) {
    cell.state = CellState::colliding;
    return;
  }
  if (cell.open) cell.state = space_.evaluate(around, *cell.open, &cell.sample);
  for (std::size_t k = 0; k < dimension_; ++k)
    cell.sample[k] = std::clamp(cell.sample[k], value(k, cell.lo[k]), value(k, cell.lo[k] + cell.side[k]));
  if (cell.state == CellState::undecided) {
    cell.sample_free = space_.is_free(cell.sample, *cell.open);
    if (!cell.sample_free && space_.collides_deeply(around, *cell.open)) cell.state = CellState::colliding;
  }
  if (cell.state == CellState::free) cell.open.reset();
  if (!reach_) return;
  // Ways by samples are to stay within.
  if (cell.state == CellState::free) cell.sample = reach_->middle_in(around);
  cell.sample_free = cell.sample_free && reach_->may_hold({cell.sample, {}});
}

double CellTree::value(std::size_t joint, std::int64_t units) const {
  const Joint& j = problem_.linkage.joints[joint];
  if (units == whole_side) return j.hi;
  return j.lo + (j.hi - j.lo) * (static_cast<double>(units) * 0x1p-48);
}

JointCell CellTree::box(CellId id) const {
  const TreeCell& cell = cells_[id];
  JointCell box;
  for (std::size_t k = 0; k < dimension_; ++k) {
    const double lo = value(k, cell.lo[k]), hi = value(k, cell.lo[k] + cell.side[k]);
    box.middle[k] = lo + (hi - lo) / 2;
    const double rounding = 0x1p-50 * (std::fabs(lo) + std::fabs(hi));
    box.half[k] = std::max(hi - box.middle[k], box.middle[k] - lo) + rounding;
    if (problem_.linkage.joints[k].lo == problem_.linkage.joints[k].hi) box.half[k] = 0;
  }
  return box;
}

std::optional<std::size_t> CellTree::widest(CellId id) const {
  const TreeCell& cell = cells_[id];
  std::array<double, max_joints> effect{};
  if (cell.open) effect = space_.effect(box(id), *cell.open);
  // A free cell has no edges open, nor one in which a body stays deep inside another one. The first is divided to find
  // where in it the goal is, the second for a proof's sake: across the longest side.
  if (cell.state != CellState::undecided && effect == std::array<double, max_joints>{}) {
    for (std::size_t k = 0; k < dimension_; ++k) effect[k] = static_cast<double>(cell.side[k]);
  }
  std::optional<std::size_t> widest;
  for (std::size_t k = 0; k < dimension_; ++k) {
    const bool divisible = static_cast<double>(cell.side[k]) * 0x1p-48 > tolerance_ && cell.side[k] > least_side;
    if (!divisible || !(effect[k] > 0)) continue;
    if (!widest || effect[k] > effect[*widest]) widest = k;
  }
  return widest;
}

bool CellTree::divide(CellId id) {
  const std::optional<std::size_t> axis = widest(id);
  if (!axis) {
    cells_[id].is_least = true;
    return false;
  }
  const auto first = static_cast<CellId>(cells_.size());
  const std::unique_ptr<OpenPairs> open = std::move(cells_[id].open);
  const std::vector<CellId> around = std::move(cells_[id].neighbours);
  cells_[id].neighbours.clear();
  for (const CellId other : around) std::erase(cells_[other].neighbours, id);
  for (const CellId half : {first, first + 1}) add_half(id, half, *axis, open.get());
  cells_[id].axis = static_cast<std::uint8_t>(*axis);
  cells_[id].children = first;
  for (const CellId half : {first, first + 1}) {
    for (const CellId other : around) join(half, other);
  }
  join(first, first + 1);
  return true;
}

void CellTree::add_half(CellId whole, CellId half, std::size_t axis, const OpenPairs* open) {
  TreeCell child;
  child.lo = cells_[whole].lo;
  child.side = cells_[whole].side;
  child.side[axis] /= 2;
  if (half % 2 == 0) child.lo[axis] += child.side[axis];
  child.parent = whole;
  child.depth = cells_[whole].depth + 1;
  child.state = cells_[whole].state;
  if (open) child.open = std::make_unique<OpenPairs>(*open);
  cells_.push_back(std::move(child));
  evaluate(half);
}

void CellTree::join(CellId a, CellId b) {
  if (cells_[a].state == CellState::colliding || cells_[b].state == CellState::colliding) return;
  if (!are_neighbours(a, b)) return;
  cells_[a].neighbours.push_back(b);
  cells_[b].neighbours.push_back(a);
}

bool CellTree::are_neighbours(CellId a, CellId b) const {
  const TreeCell &first = cells_[a], &second = cells_[b];
  if (share_face(first.lo, first.side, second.lo, second.side)) return true;
  for (std::size_t k = 0; k < dimension_; ++k) {
    if (!problem_.periodic[k]) continue;
    for (const std::int64_t turn : {whole_side, -whole_side}) {
      CellSides lo = second.lo;
      lo[k] += turn;
      if (share_face(first.lo, first.side, lo, second.side)) return true;
    }
  }
  return false;
}

/// In all directions but one they overlap by more than a point; in that one they may just touch.
bool CellTree::share_face(const CellSides& lo_a, const CellSides& side_a, const CellSides& lo_b,
                          const CellSides& side_b) const {
  int touching = 0;
  for (std::size_t k = 0; k < dimension_; ++k) {
    const std::int64_t lo = std::max(lo_a[k], lo_b[k]), hi = std::min(lo_a[k] + side_a[k], lo_b[k] + side_b[k]);
    if (lo > hi) return false;
    if (lo == hi && ++touching > 1) return false;
  }
  return true;
}

/// At most one joint is crossed at its end: faces are in common, not corners.
std::vector<CellFace> CellTree::faces(CellId a, CellId b) const {
  const TreeCell &first = cells_[a], &second = cells_[b];
  std::vector<CellFace> found;
  const auto add = [&](std::size_t crossed, std::int64_t shift) {
    CellSides lo = second.lo;
    if (shift != 0) lo[crossed] += shift;
    if (!share_face(first.lo, first.side, lo, second.side)) return;
    CellFace face{{}, {}, crossed, shift};
    for (std::size_t k = 0; k < dimension_; ++k) {
      face.lo[k] = std::max(first.lo[k], lo[k]);
      face.side[k] = std::min(first.lo[k] + first.side[k], lo[k] + second.side[k]) - face.lo[k];
      if (face.side[k] == 0) face.axis = k;
    }
    found.push_back(face);
  };
  if (a != b) add(0, 0);
  for (std::size_t k = 0; k < dimension_; ++k) {
    if (!problem_.periodic[k]) continue;
    add(k, whole_side);
    if (a != b) add(k, -whole_side);
  }
  return found;
}

std::optional<CommonPoint> CellTree::common_point(CellId a, CellId b) const {
  const std::vector<CellFace> all = faces(a, b);
  if (all.empty()) return std::nullopt;
  const CellFace& face = all.front();
  CommonPoint common;
  for (std::size_t k = 0; k < dimension_; ++k) common.at[k] = value(k, face.lo[k] + face.side[k] / 2);
  if (face.shift != 0) {
    const Joint& joint = problem_.linkage.joints[face.axis];
    common.shift[face.axis] = face.shift > 0 ? joint.hi - joint.lo : joint.lo - joint.hi;
  }
  return common;
}

}  // namespace taut::internal::path
