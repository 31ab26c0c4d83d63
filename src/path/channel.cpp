#include "path/channel.hpp"

#include <algorithm>

#include "numeric/budget.hpp"

namespace taut::internal::path {

void Channel::add_seed(Side side, CellId cell) { find_anew(side, cell, true); }

/// Was it found, and not reached yet?
bool Channel::waits(Side side, CellId id) {
  const ReachMark& m = mark(side, id);
  return tree_[id].is_leaf() && !m.is_reached && (m.is_seed || m.from != no_cell);
}

/// Free cells first, then those with a free sample, then the others: of each kind the larger ones first. Cells that are
/// not divided any more come last.
std::size_t Channel::rank(CellId id) {
  const TreeCell& cell = tree_[id];
  if (cell.state == CellState::free) return 0;
  constexpr std::size_t doubtful = 200, last = 400;
  static_assert(doubtful > 40 * max_joints);
  return cell.is_least ? last : cell.depth + (tree_.sample_free(id) ? 1 : doubtful);
}

void Channel::queue(Side side, CellId id) {
  Front& front = fronts_[index(side)];
  const std::size_t r = rank(id);
  if (front.queues.size() <= r) front.queues.resize(r + 1);
  front.queues[r].push_back(id);
  front.first = std::min(front.first, r);
}

std::optional<std::size_t> Channel::next_rank(Side side) {
  Front& front = fronts_[index(side)];
  for (std::size_t& r = front.first; r < front.queues.size(); ++r) {
    std::deque<CellId>& queue_of_rank = front.queues[r];
    while (!queue_of_rank.empty()) {
      const CellId id = queue_of_rank.front();
      if (waits(side, id) && rank(id) == r) return r;
      queue_of_rank.pop_front();
    }
  }
  return std::nullopt;
}

/// Takes the first cell of the queues, and finds its neighbours.
CellId Channel::reach_next(Side side) {
  Front& front = fronts_[index(side)];
  std::deque<CellId>& queue_of_rank = front.queues[*next_rank(side)];
  const CellId id = queue_of_rank.front();
  queue_of_rank.pop_front();
  mark(side, id).is_reached = true;
  ++front.reached;
  for (const CellId neighbour : tree_[id].neighbours) {
    ReachMark& m = mark(side, neighbour);
    if (m.is_reached || m.is_seed || m.from != no_cell) continue;
    m.from = id;
    queue(side, neighbour);
  }
  return id;
}

std::optional<std::vector<CellId>> Channel::find() {
  for (;;) {
    checkpoint();
    const std::optional<std::size_t> of_start = next_rank(Side::start), of_goal = next_rank(Side::goal);
    // The one that has run out has reached all that it can.
    if (!of_start || !of_goal) return std::nullopt;
    const bool start_first = *of_start != *of_goal ? *of_start < *of_goal : fronts_[0].reached <= fronts_[1].reached;
    const Side side = start_first ? Side::start : Side::goal;
    const CellId id = reach_next(side);
    const ReachMark& m = mark(other(side), id);
    if (m.is_reached || m.is_seed) return chain_through(id);
  }
}

std::vector<CellId> Channel::chain_through(CellId meeting) {
  std::vector<CellId> chain;
  for (CellId id = meeting;; id = mark(Side::start, id).from) {
    chain.push_back(id);
    if (mark(Side::start, id).is_seed) break;
  }
  std::reverse(chain.begin(), chain.end());
  for (CellId id = meeting; !mark(Side::goal, id).is_seed;) {
    id = mark(Side::goal, id).from;
    chain.push_back(id);
  }
  return chain;
}

std::vector<CellId> Channel::forget(Side side, CellId id) {
  if (!mark(side, id).is_reached) return {};
  std::vector<CellId> lost, todo = {id};
  while (!todo.empty()) {
    const CellId cell = todo.back();
    todo.pop_back();
    mark(side, cell).is_reached = false;
    --fronts_[index(side)].reached;
    for (const CellId neighbour : tree_[cell].neighbours) {
      ReachMark& m = mark(side, neighbour);
      if (m.from != cell) continue;
      m.from = no_cell;
      lost.push_back(neighbour);
      if (m.is_reached) todo.push_back(neighbour);
    }
  }
  return lost;
}

/// It may hold a seed, or be next to what is reached.
void Channel::find_anew(Side side, CellId id, bool is_seed) {
  if (!tree_[id].is_leaf() || tree_[id].state == CellState::colliding) return;
  ReachMark& m = mark(side, id);
  m = {is_seed, false, no_cell};
  if (!is_seed) {
    const std::vector<CellId>& around = tree_[id].neighbours;
    const auto reached = std::find_if(around.begin(), around.end(), [&](CellId n) { return mark(side, n).is_reached; });
    if (reached == around.end()) return;
    m.from = *reached;
  }
  queue(side, id);
}

}  // namespace taut::internal::path
