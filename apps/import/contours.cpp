#include "import/contours.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace taut::drawing {

namespace {

class ContourFinder {
 public:
  ContourFinder(const LineGraph& graph, const std::vector<bool>& alive)
      : graph_(graph), contour_(graph.edges.size(), false) {
    // Lines drawn a little beyond a corner go as far as it.
    const auto lives = [&alive](int h) { return alive[static_cast<std::size_t>(h / 2)]; };
    for (const std::vector<int>& walk : graph.walks) {
      const auto first = std::find_if(walk.begin(), walk.end(), lives);
      const auto last = std::find_if(walk.rbegin(), walk.rend(), lives).base();
      const bool whole = first < last && std::all_of(first, last, lives);
      walks_.push_back(whole ? std::vector<int>(first, last) : std::vector<int>());
    }
  }

  std::vector<bool> find() {
    gather_ends();
    std::vector<bool> used(walks_.size(), false);
    for (const auto& [node, here] : ends_) {
      for (const std::size_t start : here)
        if (!used[start / 2]) follow(start, used);
    }
    return std::move(contour_);
  }

 private:
  void mark(const std::vector<int>& walk) {
    for (const int h : walk) contour_[static_cast<std::size_t>(h / 2)] = true;
  }

  /// Of open strands: 2s is the start of strand s, 2s + 1 its end. Of those that run along the same edges, one counts.
  void gather_ends() {
    std::set<std::vector<int>> known;
    for (std::size_t s = 0; s < walks_.size(); ++s) {
      const std::vector<int>& walk = walks_[s];
      if (walk.empty()) continue;
      if (node_at(2 * s) == node_at(2 * s + 1)) {
        mark(walk);
        continue;
      }
      if (graph_.edge(walk.front()).times > 1) {
        std::vector<int> edges;
        for (const int h : walk) edges.push_back(h / 2);
        std::sort(edges.begin(), edges.end());
        if (!known.insert(edges).second) continue;
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
    std::vector<std::size_t> ring;
    std::size_t end = start;
    do {
      ring.push_back(end / 2);
      const std::size_t exit = end ^ 1;
      const std::vector<std::size_t>& meeting = ends_[node_at(exit)];
      if (meeting.size() != 2) break;
      end = meeting[0] == exit ? meeting[1] : meeting[0];
      if (end != start) continue;
      for (const std::size_t s : ring) mark(walks_[s]);
    } while (end != start && ring.size() <= walks_.size());
    for (const std::size_t s : ring) used[s] = true;
  }

  const LineGraph& graph_;
  std::vector<bool> contour_;
  std::vector<std::vector<int>> walks_;           ///< the living part of each strand
  std::map<int, std::vector<std::size_t>> ends_;  ///< of strands, at each node
};

}  // namespace

std::vector<bool> contour_edges(const LineGraph& graph, const std::vector<bool>& alive) {
  return ContourFinder(graph, alive).find();
}

}  // namespace taut::drawing
