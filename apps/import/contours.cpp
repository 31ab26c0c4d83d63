#include "import/contours.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace taut::drawing {

namespace {

class ContourFinder {
 public:
  ContourFinder(const LineGraph& graph, const std::vector<bool>& alive)
      : graph_(graph), found_{std::vector<bool>(graph.edges.size(), false), {}} {
    // Lines drawn a little beyond a corner go as far as it.
    const auto lives = [&alive](int h) { return alive[static_cast<std::size_t>(h / 2)]; };
    for (const std::vector<int>& walk : graph.walks) {
      const auto first = std::find_if(walk.begin(), walk.end(), lives);
      const auto last = std::find_if(walk.rbegin(), walk.rend(), lives).base();
      const bool whole = first < last && std::all_of(first, last, lives);
      walks_.push_back(whole ? std::vector<int>(first, last) : std::vector<int>());
    }
  }

  Contours find() {
    drop_copies();
    gather_ends();
    std::vector<bool> used(walks_.size(), false);
    for (const auto& [node, here] : ends_) {
      for (const std::size_t start : here)
        if (!used[start / 2]) follow(start, used);
    }
    return std::move(found_);
  }

 private:
  /// Edges along which it goes to and fro are no part of it: copies of one line that meet at both ends enclose nothing.
  void add(std::vector<int> ring) {
    std::map<int, int> passes;
    for (const int h : ring) passes[h / 2] += h % 2 == 0 ? 1 : -1;
    bool any = false;
    for (const auto& [edge, times] : passes) {
      if (times == 0) continue;
      found_.edges[static_cast<std::size_t>(edge)] = true;
      any = true;
    }
    if (any) found_.rings.push_back(std::move(ring));
  }

  /// A strand that runs only along edges of others is a copy, and does not count; of some that cover each other, the
  /// longest ones do.
  void drop_copies() {
    std::vector<int> times(graph_.edges.size(), 0);
    std::vector<std::tuple<double, std::vector<int>, std::size_t>> copies;  // length, edges, strand
    const auto each_edge = [this](std::size_t s, const auto& visit) {
      std::set<int> edges;
      for (const int h : walks_[s]) edges.insert(h / 2);
      return std::all_of(edges.begin(), edges.end(), visit);
    };
    const auto is_repeated = [this](int h) { return graph_.edge(h).times > 1; };
    for (std::size_t s = 0; s < walks_.size(); ++s)
      if (std::any_of(walks_[s].begin(), walks_[s].end(), is_repeated))
        each_edge(s, [&](int e) { return ++times[static_cast<std::size_t>(e)] > 0; });
    const auto is_shared = [&times](int e) { return times[static_cast<std::size_t>(e)] > 1; };
    for (std::size_t s = 0; s < walks_.size(); ++s) {
      if (walks_[s].empty() || !is_shared(walks_[s].front() / 2) || !each_edge(s, is_shared)) continue;
      double length = 0;
      std::vector<int> edges;
      for (const int h : walks_[s]) {
        length += graph_.length(h);
        edges.push_back(h / 2);
      }
      std::sort(edges.begin(), edges.end());
      copies.emplace_back(length, std::move(edges), s);
    }
    std::sort(copies.begin(), copies.end());
    for (const auto& [length, edges, s] : copies) {
      if (!each_edge(s, is_shared)) continue;
      each_edge(s, [&](int e) { return --times[static_cast<std::size_t>(e)] > 0; });
      walks_[s].clear();
    }
  }

  /// Of open strands: 2s is the start of strand s, 2s + 1 its end.
  void gather_ends() {
    for (std::size_t s = 0; s < walks_.size(); ++s) {
      const std::vector<int>& walk = walks_[s];
      if (walk.empty()) continue;
      if (node_at(2 * s) == node_at(2 * s + 1)) {
        add(walk);
        continue;
      }
      for (const std::size_t end : {2 * s, 2 * s + 1}) ends_[node_at(end)].push_back(end);
    }
  }

  int node_at(std::size_t end) const {
    const std::vector<int>& walk = walks_[end / 2];
    return end % 2 == 0 ? graph_.origin(walk.front()) : graph_.target(walk.back());
  }

  /// From strand to strand, as long as two ends meet.
  void follow(std::size_t start, std::vector<bool>& used) {
    std::vector<std::size_t> ring;  // the ends at which it enters strands
    std::size_t end = start;
    do {
      ring.push_back(end);
      const std::size_t exit = end ^ 1;
      const std::vector<std::size_t>& meeting = ends_[node_at(exit)];
      if (meeting.size() != 2) break;
      end = meeting[0] == exit ? meeting[1] : meeting[0];
      if (end != start) continue;
      add(halves_along(ring));
    } while (end != start && ring.size() <= walks_.size());
    for (const std::size_t e : ring) used[e / 2] = true;
  }

  std::vector<int> halves_along(const std::vector<std::size_t>& ring) const {
    std::vector<int> halves;
    for (const std::size_t end : ring) {
      const std::vector<int>& walk = walks_[end / 2];
      if (end % 2 == 0)
        halves.insert(halves.end(), walk.begin(), walk.end());
      else
        for (std::size_t k = walk.size(); k-- > 0;) halves.push_back(walk[k] ^ 1);
    }
    return halves;
  }

  const LineGraph& graph_;
  Contours found_;
  std::vector<std::vector<int>> walks_;           ///< the living part of each strand
  std::map<int, std::vector<std::size_t>> ends_;  ///< of strands, at each node
};

}  // namespace

Contours contours_of(const LineGraph& graph, const std::vector<bool>& alive) {
  return ContourFinder(graph, alive).find();
}

std::vector<std::pair<int, std::size_t>> self_meetings(const LineGraph& graph, const Contours& contours) {
  std::vector<std::pair<int, std::size_t>> meetings;
  std::vector<int> edges, nodes;
  for (std::size_t r = 0; r < contours.rings.size(); ++r) {
    edges.clear();
    for (const int h : contours.rings[r]) edges.push_back(h / 2);
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    nodes.clear();
    for (const int e : edges) nodes.insert(nodes.end(), {graph.origin(2 * e), graph.target(2 * e)});
    std::sort(nodes.begin(), nodes.end());
    for (std::size_t i = 2; i < nodes.size(); ++i) {
      if (nodes[i] != nodes[i - 2]) continue;
      meetings.emplace_back(nodes[i], r);
      break;
    }
  }
  return meetings;
}

}  // namespace taut::drawing
