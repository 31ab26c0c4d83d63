// The path of a link of a robot, in windows of time.
#include <cmath>

#include "numeric/budget.hpp"
#include "solver/robot_search.hpp"
#include "spacetime/box_separation.hpp"

namespace taut::internal {

using spacetime::Stretch;
using spacetime::UniformSegment;

namespace {

/// A window is divided as long as the link's box over it is this many times longer than at rest, and more than this
/// number of bodies are in it; up to a depth.
constexpr double long_window = 3;
constexpr std::size_t crowd = 4;
constexpr int deepest_window = 30;
/// Where any contact will do, windows are sampled in their middle and divided while the link's box over them is at
/// least this many times longer than at rest, up to a depth.
constexpr double sampled_window = 2;
constexpr int deepest_sample = 4;
/// The maximum number of free places in a row that show a path to be free.
constexpr int most_places = 8;

/// Where a piece takes its origin, without its rotation about a pivot, and a bound of the error of either coordinate.
struct Place {
  double x, y, error;
};

Place place_of(const MotionPiece& piece, double t) {
  const Ball<double> since = time_since(Ball<double>::exact(t), piece.origin);
  const double x0 = coefficient(piece.x, 0), x1 = coefficient(piece.x, 1);
  const double y0 = coefficient(piece.y, 0), y1 = coefficient(piece.y, 1);
  const double speed = std::fabs(x1) + std::fabs(y1);
  const double rounded = 0x1p-50 * (std::fabs(x0) + std::fabs(y0) + speed * std::fabs(since.mid));
  return {x0 + x1 * since.mid, y0 + y1 * since.mid, rounded + speed * since.rad};
}

}  // namespace

/// Is a disc certainly in free cells on the line from `from` on? A cheap test; a negative result has no meaning.
bool RobotSearch::is_free(Vector from, Vector way, double radius) const {
  const double length = std::max(std::fabs(way.x), std::fabs(way.y));
  double gone = 0;
  for (int i = 0; i < most_places; ++i) {
    const double share = length > 0 ? gone / length : 0;
    const double room = cells_.room(from.x + share * way.x, from.y + share * way.y) - radius;
    if (!(room > 0)) return false;
    gone += room;
    if (gone >= length) return true;
  }
  return false;
}

bool RobotSearch::roams_free(Vector from, Vector way) const {
  if (links_.size() > 1) return false;
  const double rounded = 0x1p-45 * (l1_norm(from) + l1_norm(way));
  return is_free(from, way, states_[0].reach * (1 + 0x1p-40) + rounded);
}

/// Is the link certainly in free cells all the way, however it turns? A cheap test to be made first; a negative result
/// has no meaning.
bool RobotSearch::roams_free(std::size_t link, double from, double to) const {
  const PieceChain& chain = states_[link].chain;
  const Place begin = place_of(chain.front(), from), end = place_of(chain.front(), to);
  // What hangs on the outermost piece is in a disc about its origin.
  double around = states_[link].reach + begin.error + end.error;
  for (const MotionPiece& piece : chain) {
    around += 2 * l1_norm({piece.pivot.x, piece.pivot.y});
    if (&piece == &chain.front()) continue;
    for (const double t : {from, to}) {
      const Place p = place_of(piece, t);
      around += std::fabs(p.x) + std::fabs(p.y) + p.error;
    }
  }
  around = around * (1 + 0x1p-40) +
           0x1p-45 * (std::fabs(begin.x) + std::fabs(begin.y) + std::fabs(end.x) + std::fabs(end.y));
  return is_free({begin.x, begin.y}, {end.x - begin.x, end.y - begin.y}, around);
}

/// Does an edge of the link certainly cross one of the map at an instant of the window, or is a vertex certainly
/// inside? A cheap test to be made first; a negative result has no meaning.
bool RobotSearch::crosses(std::size_t link, const UniformSegment& segment, double t, const Window& window) {
  const Stretch instant = segment.instant(t);
  if (!find_near(link, instant, &window)) return false;
  const spacetime::QAtPose pose = spacetime::QAtPose::of(instant);
  crossed_ = 0;
  if (others_.size() == 1 && around(states_[link], pose) == FreeCells::Cell::covered) return true;
  for (const spacetime::Other& other : others_) {
    const Hierarchy& mover = *states_[link].tree;
    if (posed_.edges_cross(pose, *other.geometry, *other.tree, mover) == spacetime::EdgesCross::yes) return true;
    ++crossed_;
  }
  return false;
}

/// Leaves the window's bodies out that the link certainly misses in it. Is any left?
bool RobotSearch::narrowed(std::size_t link, const UniformSegment& segment, Window& window) {
  LinkState& state = states_[link];
  spacetime::UniformStretch even = segment.stretch(window.from, window.to);
  if (!find_near(link, even.everywhere(), window.depth > 0 ? &window : nullptr)) return false;
  window.first = state.nearby.size();
  for (const int body : near_) {
    const spacetime::Box& other = body_trees_[static_cast<std::size_t>(body)]->node(0).box;
    if (!spacetime::apart(even.near(other), other, state.tree->node(0).box)) state.nearby.push_back(body);
  }
  window.last = state.nearby.size();
  return window.first < window.last;
}

/// Are there so many bodies in the window of the last box, and is that so long, that halves of it have fewer?
bool RobotSearch::crowded(std::size_t link, const Window& window) const {
  const double middle = window.middle();
  return window.last - window.first > crowd && box_.longest() > long_window * states_[link].size &&
         window.depth < deepest_window && window.from < middle && middle < window.to;
}

/// Is the link blocked at the end, or in the middle of a window, from long windows on to those that are as long as the
/// link? Most blocked paths are blocked at such an instant, for a long time. Leaves the windows that are to be
/// searched.
bool RobotSearch::blocked(std::size_t link, double from, double to, RobotFinding& best) {
  LinkState& state = states_[link];
  const UniformSegment segment(world_chain, state.chain, *state.tree, from, to);
  const auto blocked_at = [&](double t, const Window& window) {
    if (!crosses(link, segment, t, window)) return false;
    best = found(Outcome::contact, from, t, {static_cast<int>(link), -1}, crossed_);
    return true;
  };
  state.windows.assign(1, {from, to});
  std::size_t kept = 0;
  for (std::size_t k = 0; k < state.windows.size(); ++k) {
    checkpoint();
    Window window = state.windows[k];
    if (!narrowed(link, segment, window)) continue;
    const bool sampled = box_.longest() >= sampled_window * state.size && window.depth < deepest_sample;
    const bool divided = sampled || crowded(link, window);
    if (window.depth == 0 && blocked_at(to, window)) return true;
    if (sampled && blocked_at(window.middle(), window)) return true;
    if (divided) {
      state.windows.push_back(window.half(0));
      state.windows.push_back(window.half(1));
    } else {
      state.windows[kept++] = window;
    }
  }
  state.windows.resize(kept);
  return false;
}

/// Searches the path in windows, in order of time, as long as there are many bodies in them.
void RobotSearch::cover(std::size_t link, double from, double to, RobotFinding& best) {
  LinkState& state = states_[link];
  const UniformSegment segment(world_chain, state.chain, *state.tree, from, to);
  state.windows.assign(1, {from, to});
  while (!state.windows.empty()) {
    checkpoint();
    Window window = state.windows.back();
    state.windows.pop_back();
    if (best.outcome != Outcome::free && window.from > best.hi) return;
    if (!narrowed(link, segment, window)) continue;
    if (crowded(link, window)) {
      state.windows.push_back(window.half(1));
      state.windows.push_back(window.half(0));
    } else {
      search(link, segment, window, best);
    }
  }
}

/// Searches the window for contacts with its bodies.
void RobotSearch::search(std::size_t link, const UniformSegment& segment, const Window& window, RobotFinding& best) {
  const std::vector<int>& nearby = states_[link].nearby;
  near_.assign(nearby.begin() + static_cast<std::ptrdiff_t>(window.first),
               nearby.begin() + static_cast<std::ptrdiff_t>(window.last));
  list_others(link);
  search(segment, *states_[link].tree, {static_cast<int>(link), -1}, window.from, window.to, best);
}

void RobotSearch::search_any(double from, double to, RobotFinding& best) {
  for (std::size_t k = 0; k < links_.size(); ++k) {
    states_[k].windows.clear();
    if (!roams_free(k, from, to) && blocked(k, from, to, best)) return;
  }
  for (std::size_t k = 0; k < links_.size(); ++k) {
    const LinkState& state = states_[k];
    const UniformSegment segment(world_chain, state.chain, *state.tree, from, to);
    for (const Window& window : state.windows) {
      search(k, segment, window, best);
      if (best.outcome != Outcome::free) return;
    }
  }
}

}  // namespace taut::internal
