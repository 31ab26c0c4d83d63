#include "path/shortest.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/budget.hpp"
#include "path/path_search.hpp"
#include "path/portals.hpp"
#include "path/reach.hpp"

namespace taut::internal::path {
namespace {

/// So many pieces of faces are enough.
constexpr std::size_t most_pieces = 10'000;
constexpr std::size_t most_waypoints = 100;
/// So many lengths are tried, each with so many cells.
constexpr int most_reaches = 12;
constexpr std::uint64_t most_cells_of_reach = 20'000;

JointValues between(const JointValues& a, const JointValues& b, double share) {
  JointValues c{};
  for (std::size_t k = 0; k < c.size(); ++k) c[k] = a[k] + share * (b[k] - a[k]);
  return c;
}

class Shortening {
 public:
  Shortening(const PathProblem& problem, const PathOptions& options, const JointSpace& space, const WayChecker& checker,
             CellTree& tree, PathAnswer& answer)
      : problem_(problem),
        options_(options),
        space_(space),
        checker_(checker),
        tree_(tree),
        answer_(answer),
        metric_(problem, space),
        goal_(problem, space) {
    answer.length = PathLength{metric_.length(answer.waypoints), 0, metric_.weights()};
  }

  void run() {
    answer_.length->shortest_at_least = Reach(problem_, metric_, 0).straight();
    offer(answer_.waypoints);
    if (tree_[tree_.root()].state == CellState::colliding) return;  // by the rounding of cells only
    narrow();
    Portals portals(problem_, tree_, metric_, goal_);
    while (improve(portals)) {
      checkpoint();
      if (tree_.size() >= options_.max_cells) throw Interrupted{"limit of cells reached"};
      if (portals.size() >= most_pieces) throw Interrupted{"limit of pieces of faces reached"};
    }
  }

 private:
  /// Ways that are no longer than some length lead through few combinations. If a search finds none among these, all
  /// ways are longer; one that it finds may pass obstacles on other sides than the way that is known.
  void narrow() {
    PathOptions options = options_;
    options.max_cells = std::min(options.max_cells, most_cells_of_reach);
    const PathLength& length = *answer_.length;
    double least_tried = length.way;
    for (int round = 0; round < most_reaches; ++round) {
      least_tried = std::min(least_tried, length.way);
      if (length.way <= (1 + options_.within) * length.shortest_at_least) return;
      const double tried = length.shortest_at_least + (least_tried - length.shortest_at_least) / 2;
      const Reach reach(problem_, metric_, tried);
      const PathAnswer found = searched(options, reach);
      if (found.outcome == PathOutcome::none) {
        answer_.length->shortest_at_least = tried;
        continue;
      }
      least_tried = tried;
      if (found.outcome == PathOutcome::path) offer(found.waypoints);
    }
  }
  PathAnswer searched(const PathOptions& options, const Reach& reach) const {
    PathAnswer found;
    PathSearch search(problem_, options, space_, checker_, &reach);
    try {
      search.run(found);
    } catch (const Interrupted&) {
      checkpoint();
    }
    return found;
  }
  /// False if there is nothing left to do.
  bool improve(Portals& portals) {
    PathLength& length = *answer_.length;
    const double enough = length.way / (1 + options_.within);
    if (length.shortest_at_least >= enough) return false;
    const std::optional<Portals::Chain> chain = portals.shortest(enough);
    const auto raise = [&](double bound) { length.shortest_at_least = std::max(length.shortest_at_least, bound); };
    if (!chain) {
      raise(enough * (1 - 0x1p-40));
      return false;
    }
    // What was dropped earlier is no shorter than a way could be then, which is more.
    raise(std::min(chain->length, length.way));
    const std::vector<JointValues> way = portals.way_through(*chain);
    const bool ends = !problem_.goal_outside || goal_.point_in({way.back(), {}});
    std::vector<CellId> cells = blocked_in(*chain, way);
    if (ends && cells.empty()) offer(way);
    if (!ends && !tree_[chain->cells.back()].is_least) cells.push_back(chain->cells.back());
    const double largest = portals.largest();
    const std::vector<CellId> large = portals.undecided_above(8 * largest);
    cells.insert(cells.end(), large.begin(), large.end());
    bool any = portals.refine(largest / 2);
    for (const CellId cell : cells) {
      if (!tree_[cell].is_leaf() || !tree_.divide(cell)) continue;
      portals.divided(cell);
      any = true;
    }
    if (!any) answer_.reason = "the shortest way leads through cells as small as the tolerance";
    return any;
  }

  /// The largest ones in which the way is not known to be free.
  std::vector<CellId> blocked_in(const Portals::Chain& chain, const std::vector<JointValues>& way) const {
    std::vector<CellId> blocked;
    for (std::size_t i = 0; i < chain.cells.size(); ++i) {
      const CellId cell = chain.cells[i];
      if (tree_[cell].state == CellState::free || checker_.passes(way[i], way[i + 1], false)) continue;
      if (!blocked.empty() && tree_[cell].depth < tree_[blocked.front()].depth) blocked.clear();
      if (blocked.empty() || tree_[cell].depth == tree_[blocked.front()].depth) blocked.push_back(cell);
    }
    // A chain may come to a cell twice.
    std::sort(blocked.begin(), blocked.end());
    blocked.erase(std::unique(blocked.begin(), blocked.end()), blocked.end());
    return blocked;
  }

  /// Takes the way, made tauter, if it is shorter, and proved.
  void offer(std::vector<JointValues> way) {
    tighten(way);
    way.erase(std::unique(way.begin(), way.end()), way.end());
    if (way.size() == 1) way.push_back(way.front());
    const double length = metric_.length(way);
    if (!(length < answer_.length->way) || !checker_.proves(way)) return;
    answer_.waypoints = std::move(way);
    answer_.length->way = length;
  }

  void tighten(std::vector<JointValues>& way) const {
    for (int round = 0; round < 60; ++round) {
      checkpoint();
      const double before = metric_.length(way);
      pull_end(way);
      pull(way);
      if (metric_.length(way) > before * 0.999) {
        if (way.size() >= most_waypoints) return;
        cut_corners(way);
        if (metric_.length(way) > before * 0.9999) return;
      }
    }
  }

  /// Moves each waypoint as far as it goes towards the straight segment between its neighbours, and drops it there.
  void pull(std::vector<JointValues>& way) const {
    for (std::size_t i = 1; i + 1 < way.size();) {
      const JointValues &a = way[i - 1], &b = way[i + 1];
      if (checker_.passes(a, b, false)) {
        way.erase(way.begin() + static_cast<std::ptrdiff_t>(i));
        continue;
      }
      const JointValues foot = nearest_on(a, b, way[i]);
      for (double share = 0.5; share > 1e-4; share /= 2) {
        const JointValues to = between(way[i], foot, share);
        if (!checker_.passes(a, to, false) || !checker_.passes(to, b, false)) continue;
        way[i] = to;
        break;
      }
      ++i;
    }
  }

  /// In place of a waypoint, two on the segments next to it.
  void cut_corners(std::vector<JointValues>& way) const {
    std::vector<JointValues> cut = {way.front()};
    for (std::size_t i = 1; i + 1 < way.size(); ++i) {
      double share = 0.5;
      while (share > 1e-3 &&
             !checker_.passes(between(way[i], way[i - 1], share), between(way[i], way[i + 1], share), false))
        share /= 2;
      if (share > 1e-3) {
        cut.push_back(between(way[i], way[i - 1], share));
        cut.push_back(between(way[i], way[i + 1], share));
      } else {
        cut.push_back(way[i]);
      }
    }
    cut.push_back(way.back());
    way = std::move(cut);
  }

  /// The end moves within the goal towards the waypoint before it.
  void pull_end(std::vector<JointValues>& way) const {
    JointValues end = way.back();
    const JointValues& last = way[way.size() - 2];
    for (double share = 1; share > 1e-4; share /= 2) {
      const JointValues to =
          problem_.goal_outside ? between(end, last, share) : between(end, goal_near(end, last), share);
      if (problem_.goal_outside && !goal_.point_in({to, {}})) continue;
      if (!checker_.passes(last, to, false)) continue;
      way.back() = to;
      return;
    }
  }

  /// Of the goal around `end`, periods on perhaps, what is nearest to `from`.
  JointValues goal_near(const JointValues& end, const JointValues& from) const {
    JointValues near = end;
    for (std::size_t k = 0; k < problem_.linkage.joints.size(); ++k) {
      const Joint& joint = problem_.linkage.joints[k];
      const auto& range = problem_.goal[k];
      if (!range) {
        near[k] = from[k];
        continue;
      }
      const double period = problem_.periodic[k] ? joint.hi - joint.lo : 0;
      const double shift = period > 0 ? std::round((end[k] - ((*range)[0] + (*range)[1]) / 2) / period) * period : 0;
      const double lo = (*range)[0] + shift, hi = (*range)[1] + shift;
      if (end[k] < lo || end[k] > hi) continue;
      near[k] = std::clamp(from[k], lo, hi);
      if (period == 0) near[k] = std::clamp(near[k], joint.lo, joint.hi);
    }
    return near;
  }

  JointValues nearest_on(const JointValues& a, const JointValues& b, const JointValues& p) const {
    double along = 0, whole = 0;
    for (std::size_t k = 0; k < problem_.linkage.joints.size(); ++k) {
      const double w = metric_.weights()[k] * metric_.weights()[k];
      along += w * (p[k] - a[k]) * (b[k] - a[k]);
      whole += w * (b[k] - a[k]) * (b[k] - a[k]);
    }
    return between(a, b, whole > 0 ? std::clamp(along / whole, 0.0, 1.0) : 0.5);
  }

  const PathProblem& problem_;
  const PathOptions& options_;
  const JointSpace& space_;
  const WayChecker& checker_;
  CellTree& tree_;
  PathAnswer& answer_;
  JointMetric metric_;
  Goal goal_;
};

}  // namespace

void shorten(const PathProblem& problem, const PathOptions& options, const JointSpace& space, const WayChecker& checker,
             CellTree& tree, PathAnswer& answer) {
  Shortening(problem, options, space, checker, tree, answer).run();
}

}  // namespace taut::internal::path
