#include "path/portals.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

#include "numeric/budget.hpp"

namespace taut::internal::path {

Portals::Portals(const PathProblem& problem, const CellTree& tree, const JointMetric& metric, const Goal& goal)
    : problem_(problem), tree_(tree), metric_(metric), goal_(goal), dimension_(problem.linkage.joints.size()) {
  at_.resize(tree.size());
  for (CellId a = 0; a < tree.size(); ++a) {
    if (!tree[a].is_leaf() || tree[a].state == CellState::colliding) continue;
    for (const CellFace& face : tree.faces(a, a)) add(face, a, a);
    for (const CellId b : tree[a].neighbours) {
      if (b < a) continue;
      for (const CellFace& face : tree.faces(a, b)) add(face, a, b);
    }
  }
}

void Portals::add(const CellFace& face, CellId a, CellId b) {
  Piece piece{face, {a, b}, {}};
  for (std::size_t k = 0; k < dimension_; ++k) {
    piece.box[0].lo[k] = tree_.value(k, face.lo[k]);
    piece.box[0].hi[k] = tree_.value(k, face.lo[k] + face.side[k]);
  }
  piece.box[1] = piece.box[0];
  const double there = tree_.value(face.axis, face.lo[face.axis] - face.shift);
  piece.box[1].lo[face.axis] = piece.box[1].hi[face.axis] = there;
  const auto id = static_cast<std::uint32_t>(pieces_.size());
  at_[a].push_back({id, 0});
  at_[b].push_back({id, 1});
  pieces_.push_back(piece);
  ++size_;
}

void Portals::remove(std::uint32_t id) {
  pieces_[id].is_in_use = false;
  for (const CellId cell : pieces_[id].cell) std::erase_if(at_[cell], [&](const Seen& s) { return s.piece == id; });
  --size_;
}

ValueBox Portals::box_of(CellId cell) const {
  const JointCell c = tree_.box(cell);
  ValueBox box;
  for (std::size_t k = 0; k < dimension_; ++k) {
    box.lo[k] = c.middle[k] - c.half[k];
    box.hi[k] = c.middle[k] + c.half[k];
  }
  return box;
}

/// What the cell has in common with the box, a period more or less included.
std::vector<ValueBox> Portals::shifted_into(CellId cell, const ValueBox& box) const {
  const ValueBox around = box_of(cell);
  std::vector<ValueBox> found = {around};
  for (std::size_t k = 0; k < dimension_; ++k) {
    const Joint& joint = problem_.linkage.joints[k];
    const double period = problem_.periodic[k] ? joint.hi - joint.lo : 0;
    std::vector<ValueBox> next;
    for (const ValueBox& b : found) {
      for (const double shift : {0.0, period, -period}) {
        ValueBox part = b;
        part.lo[k] = std::max(b.lo[k], box.lo[k] + shift);
        part.hi[k] = std::min(b.hi[k], box.hi[k] + shift);
        if (part.lo[k] <= part.hi[k]) next.push_back(part);
        if (period == 0) break;
      }
    }
    found = std::move(next);
  }
  return found;
}

std::vector<ValueBox> Portals::starts_in(CellId cell) const { return shifted_into(cell, ValueBox::of(problem_.start)); }

std::vector<ValueBox> Portals::goals_in(CellId cell) const {
  if (problem_.goal_outside) {
    if (goal_.may_meet(tree_.box(cell))) return {box_of(cell)};
    return {};
  }
  ValueBox goal;
  for (std::size_t k = 0; k < dimension_; ++k) {
    const auto& range = problem_.goal[k];
    goal.lo[k] = range ? (*range)[0] : -INFINITY;
    goal.hi[k] = range ? (*range)[1] : INFINITY;
  }
  return shifted_into(cell, goal);
}

/// Through the face that it came in by: a way that stays on that face is shorter, and need not leave the other cell.
bool Portals::is_back(const Crossing& in, const Seen& out) const {
  const Piece &a = pieces_[in.piece], &b = pieces_[out.piece];
  const std::size_t axis = a.face.axis;
  return a.cell[1 - in.into] == b.cell[1 - out.side] && axis == b.face.axis &&
         a.box[in.into].lo[axis] == b.box[out.side].lo[axis];
}

/// Dijkstra's algorithm. What is reached are crossings: having come into a cell by a piece.
Portals::Reached Portals::search(End from_end, double enough) const {
  const End to = from_end == End::start ? End::goal : End::start;
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  Reached found;
  found.nodes.resize(2 * pieces_.size());
  std::vector<std::optional<std::vector<ValueBox>>> ends(at_.size());
  const auto leave = [&](CellId cell, const ValueBox& from, double length, std::uint32_t before) {
    if (!ends[cell]) ends[cell] = ends_in(to, cell);
    for (const ValueBox& end : *ends[cell]) {
      const double whole = length + metric_.least(from, end);
      if (!(whole < found.length)) continue;
      found.length = whole;
      found.last = before;
      found.cell = cell;
    }
    for (const Seen& s : at_[cell]) {
      // Through it into the other cell, but not back.
      const std::uint32_t next = 2 * s.piece + (1 - s.side);
      if (before != UINT32_MAX && is_back({before / 2, static_cast<std::uint8_t>(before % 2)}, s)) continue;
      const double whole = length + metric_.least(from, box(s));
      if (!(whole < found.nodes[next].length) || !(whole < enough)) continue;
      found.nodes[next] = {whole, before, cell};
      queue.push({whole, next});
    }
  };
  for (CellId cell = 0; cell < at_.size(); ++cell) {
    if (!tree_[cell].is_leaf() || tree_[cell].state == CellState::colliding) continue;
    for (const ValueBox& end : ends_in(from_end, cell)) leave(cell, end, 0, UINT32_MAX);
  }
  while (!queue.empty()) {
    checkpoint();
    const auto [length, id] = queue.top();
    queue.pop();
    if (length > found.nodes[id].length) continue;
    const Piece& piece = pieces_[id / 2];
    leave(piece.cell[id % 2], piece.box[id % 2], length, id);
  }
  return found;
}

/// A crossing into one cell, on the way from the start, is one into the other cell, on the way from the goal.
std::optional<Portals::Chain> Portals::shortest(double enough) {
  // Sums of so few numbers are rounded by less.
  constexpr double down = 1 - 0x1p-30;
  const Reached found = search(End::start, enough / down);
  if (!(found.length * down < enough)) return std::nullopt;
  const Reached back = search(End::goal, enough / down);
  Chain chain{found.length * down, {found.cell}, {}};
  for (std::uint32_t id = found.last; id != UINT32_MAX; id = found.nodes[id].before) {
    chain.crossings.push_back({id / 2, static_cast<std::uint8_t>(id % 2)});
    chain.cells.push_back(found.nodes[id].from);
  }
  std::reverse(chain.crossings.begin(), chain.crossings.end());
  std::reverse(chain.cells.begin(), chain.cells.end());
  for (std::uint32_t p = 0; p < pieces_.size(); ++p) {
    const double through = std::min(found.nodes[2 * p].length + back.nodes[2 * p + 1].length,
                                    found.nodes[2 * p + 1].length + back.nodes[2 * p].length);
    if (pieces_[p].is_in_use && through * down >= enough) remove(p);
  }
  return chain;
}

/// Each piece is passed where the straight segment between its neighbours would pass it, or as near to there as the
/// piece goes; a few rounds of that come close to the shortest.
std::vector<JointValues> Portals::way_through(const Chain& chain) const {
  const std::size_t n = chain.crossings.size();
  std::vector<ValueBox> boxes;  // unwrapped
  JointValues offset{};
  const std::vector<ValueBox> starts = starts_in(chain.cells.front());
  const auto moved = [&](ValueBox b) {
    for (std::size_t k = 0; k < dimension_; ++k) {
      b.lo[k] += offset[k];
      b.hi[k] += offset[k];
    }
    return b;
  };
  // The start may be in the cell twice: take the nearer one.
  const ValueBox first = n > 0 ? pieces_[chain.crossings[0].piece].box[1 - chain.crossings[0].into] : ValueBox();
  ValueBox start = starts.front();
  for (const ValueBox& s : starts) {
    if (n > 0 && metric_.least(s, first) < metric_.least(start, first)) start = s;
  }
  for (std::size_t k = 0; k < dimension_; ++k) offset[k] = problem_.start[k] - start.lo[k];
  for (const Crossing& c : chain.crossings) {
    const Piece& piece = pieces_[c.piece];
    boxes.push_back(moved(piece.box[1 - c.into]));
    const std::size_t axis = piece.face.axis;
    offset[axis] += piece.box[1 - c.into].lo[axis] - piece.box[c.into].lo[axis];
  }
  std::vector<JointValues> way = {problem_.start};
  for (const ValueBox& b : boxes) {
    JointValues at{};
    for (std::size_t k = 0; k < dimension_; ++k) at[k] = b.lo[k] + (b.hi[k] - b.lo[k]) / 2;
    way.push_back(at);
  }
  // In the last cell, the goal's nearest value.
  std::optional<ValueBox> target;
  for (const ValueBox& g : goals_in(chain.cells.back())) {
    const ValueBox there = moved(g);
    if (!target || metric_.least(ValueBox::of(way.back()), there) < metric_.least(ValueBox::of(way.back()), *target))
      target = there;
  }
  const auto into = [&](JointValues at, const ValueBox& b) {
    for (std::size_t k = 0; k < dimension_; ++k) at[k] = std::clamp(at[k], b.lo[k], b.hi[k]);
    return at;
  };
  way.push_back(into(way.back(), *target));
  for (int round = 0; round < 16; ++round) {
    for (std::size_t i = 1; i <= n; ++i) {
      const JointValues &a = way[i - 1], &b = way[i + 1];
      const std::size_t axis = pieces_[chain.crossings[i - 1].piece].face.axis;
      const double d = b[axis] - a[axis];
      const double t = d != 0 ? std::clamp((boxes[i - 1].lo[axis] - a[axis]) / d, 0.0, 1.0) : 0.5;
      JointValues at{};
      for (std::size_t k = 0; k < dimension_; ++k) at[k] = a[k] + t * (b[k] - a[k]);
      way[i] = into(at, boxes[i - 1]);
    }
    way[n + 1] = into(way[n], *target);
  }
  return way;
}

std::size_t Portals::longest_side(const Piece& piece) const {
  std::size_t longest = 0;
  double most = -1;
  for (std::size_t k = 0; k < dimension_; ++k) {
    const double side = metric_.weights()[k] * (piece.box[0].hi[k] - piece.box[0].lo[k]);
    if (piece.face.side[k] < 2 || !(side > most)) continue;
    most = side;
    longest = k;
  }
  return longest;
}

double Portals::extent(const Piece& piece) const { return metric_.length(piece.box[0].lo, piece.box[0].hi); }

double Portals::largest() const {
  double most = 0;
  for (const Piece& piece : pieces_) {
    if (piece.is_in_use) most = std::max(most, extent(piece));
  }
  return most;
}

bool Portals::refine(double least) {
  bool any = false;
  const auto n = static_cast<std::uint32_t>(pieces_.size());
  for (std::uint32_t p = 0; p < n; ++p) {
    if (!pieces_[p].is_in_use || !(extent(pieces_[p]) > 0) || extent(pieces_[p]) < least) continue;
    const Piece whole = pieces_[p];
    const std::size_t k = longest_side(whole);
    if (whole.face.side[k] < 2) continue;
    remove(p);
    CellFace half = whole.face;
    half.side[k] /= 2;
    add(half, whole.cell[0], whole.cell[1]);
    half.lo[k] += half.side[k];
    half.side[k] = whole.face.side[k] - half.side[k];
    add(half, whole.cell[0], whole.cell[1]);
    any = true;
  }
  return any;
}

std::vector<CellId> Portals::undecided_above(double least) const {
  std::vector<CellId> found;
  for (CellId cell = 0; cell < at_.size(); ++cell) {
    const TreeCell& c = tree_[cell];
    if (!c.is_leaf() || c.state != CellState::undecided || c.is_least || at_[cell].empty()) continue;
    const ValueBox around = box_of(cell);
    if (metric_.length(around.lo, around.hi) > least) found.push_back(cell);
  }
  return found;
}

/// What half of a divided cell has of the piece.
void Portals::hand_on(const Seen& seen, CellId half) {
  if (tree_[half].state == CellState::colliding) return;
  const Piece whole = pieces_[seen.piece];
  CellFace part = whole.face;
  const TreeCell& cell = tree_[half];
  for (std::size_t k = 0; k < dimension_; ++k) {
    const std::int64_t moved = k == part.axis && seen.side == 1 ? part.shift : 0;
    const std::int64_t lo = std::max(part.lo[k], cell.lo[k] + moved),
                       hi = std::min(part.lo[k] + part.side[k], cell.lo[k] + cell.side[k] + moved);
    if (lo > hi || (lo == hi && k != part.axis)) return;
    part.lo[k] = lo;
    part.side[k] = hi - lo;
  }
  add(part, seen.side == 0 ? half : whole.cell[0], seen.side == 1 ? half : whole.cell[1]);
}

void Portals::divided(CellId cell) {
  at_.resize(tree_.size());
  const CellId first = tree_[cell].children, second = first + 1;
  while (!at_[cell].empty()) {
    // A piece that the cell sees from both sides is handed on twice.
    const Seen seen = at_[cell].back();
    for (const CellId half : {first, second}) hand_on(seen, half);
    remove(seen.piece);
  }
  if (tree_[first].state == CellState::colliding || tree_[second].state == CellState::colliding) return;
  add(tree_.faces(first, second).front(), first, second);
}

}  // namespace taut::internal::path
