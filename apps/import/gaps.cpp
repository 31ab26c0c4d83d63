#include "import/gaps.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "geometry/segment_strips.hpp"
#include "taut/error.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

/// More come of a distance as large as the drawing, and would fill the memory.
constexpr std::size_t most_pairs = 10000000;
/// What is near a node: enough for all but scribbles.
constexpr std::size_t most_reached = 200;

double distance_of(const Point& p, const Point& q) { return std::hypot(p.x - q.x, p.y - q.y); }

Point between(const Point& a, const Point& b, double along) {
  return {a.x + along * (b.x - a.x), a.y + along * (b.y - a.y)};
}

/// Where on the segment, from 0 to 1, the nearest point is.
double nearest_along(const Point& a, const Point& b, const Point& p) {
  const double x = b.x - a.x, y = b.y - a.y;
  return std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / (x * x + y * y), 0.0, 1.0);
}

/// What is reached along lines from a node where they end and none goes on, and how long the path is.
using PathLengths = std::map<int, double>;
/// Two places are not joined if the path from one to the other is at most so many times as long as the gap: lines lead
/// there anyway, and a chain of short lines would collapse.
constexpr double direct = 3;

class GapCloser {
 public:
  GapCloser(const LineGraph& graph, double join)
      : graph_(graph),
        join_(join),
        incidence_(graph, std::vector<bool>(graph.edges.size(), true)),
        passed_(graph.nodes.size(), false) {
    for (const std::vector<int>& walk : graph.walks)
      for (std::size_t i = 0; i + 1 < walk.size(); ++i) passed_[static_cast<std::size_t>(graph.target(walk[i]))] = true;
  }

  /// Ends that go a little beyond a crossing, which is a node: the one back to which to cut. A short line whose other
  /// end meets another line does not go beyond: it leads from one to the other.
  std::map<int, int> overshoots() {
    std::map<int, int> found = short_ends();
    if (found.empty()) return found;
    find_neighbours();
    for (const auto& [apart, p, q] : pairs_) {
      for (const auto& [end, other] : {std::pair(p, q), std::pair(q, p)})
        if (found.count(end) && !paths_at(end).count(other)) found.erase(end);
    }
    return found;
  }

  std::map<int, Point> moves() {
    find_neighbours();
    gather_ends();
    for (const auto& [node, edges] : near_edges_) lead_to_line(node, edges);
    return std::move(moves_);
  }

 private:
  std::map<int, int> short_ends() const {
    std::map<int, int> found;
    for (int node = 0; node < static_cast<int>(graph_.nodes.size()); ++node) {
      if (incidence_.degree(node) != 1) continue;
      double length = 0;
      for (int h = *incidence_.begin(node);;) {
        length += graph_.length(h);
        const int there = graph_.target(h);
        if (length > join_ || incidence_.degree(there) == 1) break;
        if (incidence_.degree(there) > 2) {
          found[node] = there;
          break;
        }
        const int* out = incidence_.begin(there);
        h = out[0] == (h ^ 1) ? out[1] : out[0];
      }
    }
    return found;
  }

  bool movable(int node) const { return incidence_.degree(node) > 0 && !passed_[static_cast<std::size_t>(node)]; }

  /// What each end may have been meant to meet. Most ends have nothing near them but the lines that end there.
  void find_neighbours() {
    if (std::exchange(neighbours_known_, true)) return;
    std::vector<AxisBox> boxes;
    for (const LineGraph::Edge& e : graph_.edges) boxes.emplace_back(graph_.point(e.from), graph_.point(e.to));
    std::vector<int> ends;
    for (int node = 0; node < static_cast<int>(graph_.nodes.size()); ++node) {
      if (!movable(node)) continue;
      ends.push_back(node);
      boxes.emplace_back(graph_.point(node), graph_.point(node), join_);
    }
    const std::size_t edges = graph_.edges.size();
    SegmentStrips(std::move(boxes)).each_pair([&](std::size_t i, std::size_t j) {
      if (i > j) std::swap(i, j);
      if (j < edges) return;
      const int node = ends[j - edges];
      if (i < edges) {
        const LineGraph::Edge& edge = graph_.edges[i];
        if (edge.from != node && edge.to != node) near_edges_[node].push_back(static_cast<int>(i));
        return;
      }
      const int p = std::min(node, ends[i - edges]), q = std::max(node, ends[i - edges]);
      const double apart = distance_of(graph_.point(p), graph_.point(q));
      if (apart <= join_) pairs_.emplace_back(apart, p, q);
      if (pairs_.size() > most_pairs)
        throw InputError("--join", "too many ends of lines are so near to each other", "give a smaller distance");
    });
  }

  PathLengths paths_from(int node) const {
    PathLengths paths{{node, 0}};
    std::vector<int> reached{node};
    for (std::size_t i = 0; i < reached.size() && i < most_reached; ++i) {
      const double path = paths.at(reached[i]);
      for (const int* out = incidence_.begin(reached[i]); out != incidence_.end(reached[i]); ++out) {
        const double length = path + graph_.length(*out);
        const auto [known, fresh] = paths.try_emplace(graph_.target(*out), length);
        if (!fresh) known->second = std::min(known->second, length);
        if (fresh && length <= direct * join_) reached.push_back(graph_.target(*out));
      }
    }
    return paths;
  }

  const PathLengths& paths_at(int node) {
    const auto known = paths_.find(node);
    return known != paths_.end() ? known->second : paths_.emplace(node, paths_from(node)).first->second;
  }

  static bool leads_to(const PathLengths& paths, int node, double distance, double more = 0) {
    const auto path = paths.find(node);
    return path != paths.end() && path->second + more <= direct * distance;
  }

  /// Sets of ends that are all near to each other, the nearest ones first: all go to one of them.
  void gather_ends() {
    std::sort(pairs_.begin(), pairs_.end());
    std::map<int, std::size_t> set_of;
    std::vector<std::vector<int>> sets;
    const auto set_at = [&](int node) {
      const auto [known, fresh] = set_of.try_emplace(node, sets.size());
      if (fresh) sets.push_back({node});
      return known->second;
    };
    for (const auto& [apart, p, q] : pairs_) {
      const std::size_t a = set_at(p), b = set_at(q);
      if (a == b || !may_be_one(sets[a], sets[b])) continue;
      for (const int node : sets[b]) set_of[node] = a;
      sets[a].insert(sets[a].end(), sets[b].begin(), sets[b].end());
      sets[b].clear();
    }
    for (std::vector<int>& set : sets) {
      if (set.size() < 2) continue;
      std::sort(set.begin(), set.end());
      // Where most lines end already; of equal ones, the one in the middle.
      const auto rank = [&](int node) { return std::tuple(-incidence_.degree(node), farthest(node, set), node); };
      const int middle = *std::min_element(set.begin(), set.end(), [&](int a, int b) { return rank(a) < rank(b); });
      taken_.insert(set.begin(), set.end());
      for (const int node : set)
        if (node != middle) moves_[node] = graph_.point(middle);
    }
  }

  bool may_be_one(const std::vector<int>& some, const std::vector<int>& others) {
    for (const int p : some) {
      for (const int q : others) {
        const double distance = distance_of(graph_.point(p), graph_.point(q));
        if (distance > join_ || leads_to(paths_at(p), q, distance)) return false;
      }
    }
    return true;
  }

  double farthest(int node, const std::vector<int>& set) const {
    double most = 0;
    for (const int other : set) most = std::max(most, distance_of(graph_.point(node), graph_.point(other)));
    return most;
  }

  /// Where a node will be.
  const Point& moved(int node) const {
    const auto move = moves_.find(node);
    return move == moves_.end() ? graph_.point(node) : move->second;
  }

  /// To the nearest node, or else to the nearest place on a line: where these will be, for their ends may move, too.
  void lead_to_line(int node, const std::vector<int>& edges) {
    if (taken_.count(node)) return;
    const PathLengths& paths = paths_at(node);
    const Point& p = graph_.point(node);
    using Candidate = std::tuple<bool, double, int, double>;  // on a line, how far away, node or edge, where along it
    std::optional<Candidate> best;
    const auto offer = [&](const Candidate& candidate) {
      if (std::get<1>(candidate) <= join_ && (!best || candidate < *best)) best = candidate;
    };
    for (const int e : edges) {
      const LineGraph::Edge& edge = graph_.edges[static_cast<std::size_t>(e)];
      const Point &a = graph_.point(edge.from), &b = graph_.point(edge.to);
      for (const int other : {edge.from, edge.to}) {
        const double distance = distance_of(p, graph_.point(other));
        if (!leads_to(paths, other, distance)) offer({false, distance, other, 0});
      }
      const double along = nearest_along(a, b, p), distance = distance_of(p, between(a, b, along));
      const double length = graph_.length(2 * e);
      if (!leads_to(paths, edge.from, distance, along * length) &&
          !leads_to(paths, edge.to, distance, (1 - along) * length))
        offer({true, distance, e, along});
    }
    if (!best) return;
    const auto [on_line, distance, target, along] = *best;
    taken_.insert(node);
    if (!on_line) taken_.insert(target);
    const LineGraph::Edge edge = on_line ? graph_.edges[static_cast<std::size_t>(target)] : LineGraph::Edge{};
    moves_[node] = on_line ? between(moved(edge.from), moved(edge.to), along) : moved(target);
  }

  const LineGraph& graph_;
  double join_;
  Incidence incidence_;
  std::vector<bool> passed_;  ///< of each node: does a line go on through it, so that it cannot be moved?
  bool neighbours_known_ = false;
  std::vector<std::tuple<double, int, int>> pairs_;  ///< ends near each other
  std::map<int, std::vector<int>> near_edges_;       ///< of ends
  std::map<int, PathLengths> paths_;                 ///< from ends
  std::set<int> taken_;
  std::map<int, Point> moves_;
};

/// Strands that go a little too far end where they should. False if there are none.
bool trim(std::vector<Strand>& strands, const LineGraph& graph, const std::map<int, int>& overshoots) {
  bool any = false;
  for (std::size_t s = 0; s < strands.size() && !overshoots.empty(); ++s) {
    std::vector<int> nodes;
    for (const int h : graph.walks[s]) nodes.push_back(graph.origin(h));
    if (strands[s].closed || nodes.empty()) continue;
    nodes.push_back(graph.target(graph.walks[s].back()));
    const std::size_t before = nodes.size();
    for (int side = 0; side < 2; ++side) {
      const auto to = overshoots.find(nodes.back());
      const auto place = to == overshoots.end() ? nodes.rend() : std::find(nodes.rbegin(), nodes.rend(), to->second);
      if (place != nodes.rend()) nodes.erase(place.base(), nodes.end());
      std::reverse(nodes.begin(), nodes.end());
    }
    if (nodes.size() == before) continue;
    any = true;
    strands[s].points.clear();
    for (const int node : nodes) strands[s].points.push_back(graph.point(node));
  }
  return any;
}

}  // namespace

bool close_gaps(std::vector<Strand>& strands, const LineGraph& graph, double join, std::vector<Gap>& gaps) {
  if (!(join > 0)) return false;
  GapCloser closer(graph, join);
  if (trim(strands, graph, closer.overshoots())) return true;
  const std::map<int, Point> moves = closer.moves();
  std::map<int, std::size_t> moved;  // nodes, and a chain that ends there
  for (std::size_t s = 0; s < strands.size() && !moves.empty(); ++s) {
    Strand& strand = strands[s];
    const std::vector<int>& walk = graph.walks[s];
    if (strand.closed || walk.empty()) continue;
    const auto move = [&](int node, Point& end) {
      const auto to = moves.find(node);
      if (to == moves.end()) return;
      end = to->second;
      moved.emplace(node, strand.source);
    };
    move(graph.origin(walk.front()), strand.points.front());
    move(graph.target(walk.back()), strand.points.back());
  }
  for (const auto& [node, source] : moved)
    gaps.push_back({graph.point(node), moves.at(node), distance_of(graph.point(node), moves.at(node)), source});
  return !moved.empty();
}

}  // namespace taut::drawing
