#include "import/crossing_contours.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

namespace taut::drawing {

namespace {

std::size_t place(int i) { return static_cast<std::size_t>(i); }

/// Of contours around one cell: more are rare, and say nothing new.
constexpr std::size_t most_compared = 32;

}  // namespace

CrossingContours::CrossingContours(const LineGraph& graph, const Contours& contours, const std::vector<int>& block,
                                   const FaceMap& cells)
    : graph_(&graph), contours_(&contours) {
  // A block whose nodes all have two edges is one contour: between contours is nothing.
  const Incidence incidence(graph, contours.edges);
  for (int node = 0; node < static_cast<int>(graph.nodes.size()); ++node)
    if (incidence.degree(node) > 2)
      for (const int* h = incidence.begin(node); h != incidence.end(node); ++h) tangled_.insert(block[place(*h / 2)]);
  if (tangled_.empty()) return;
  std::vector<Rings> winding(graph.edges.size());  // of rings along each edge
  blocks_.resize(contours.rings.size());
  for (std::size_t r = 0; r < contours.rings.size(); ++r) {
    for (const int h : contours.rings[r]) {
      if (!tangled_.count(block[place(h / 2)])) continue;
      winding[place(h / 2)][static_cast<int>(r)] += h % 2 == 0 ? 1 : -1;
      blocks_[r].insert(block[place(h / 2)]);
    }
  }
  go_around(cells, winding);
  compare_rings(cells);
}

/// How often each ring goes around each cell, from the unbounded one.
void CrossingContours::go_around(const FaceMap& cells, const std::vector<Rings>& winding) {
  const Subdivision& map = cells.map;
  const std::vector<std::vector<int>> boundaries = boundaries_of(map);
  std::vector<bool> seen(place(map.faces()), false);
  std::vector<int> queue{0};
  seen[0] = true;
  rings_.resize(place(map.faces()));
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (const int h : boundaries[place(queue[i])]) {
      const int there = map.face(h ^ 1);
      if (seen[place(there)]) continue;
      seen[place(there)] = true;
      queue.push_back(there);
      Rings& rings = rings_[place(there)] = rings_[place(queue[i])];
      // What lies to the left of a line has one turn more.
      for (const auto& [ring, turns] : winding[place(cells.edge(h))]) rings[ring] += h % 2 == 0 ? -turns : turns;
      std::erase_if(rings, [](const auto& entry) { return entry.second == 0; });
    }
  }
}

/// Rings around one cell have a part in common, if they are of one block.
void CrossingContours::compare_rings(const FaceMap& cells) {
  const std::vector<double> areas = areas_of_faces(cells);
  areas_.assign(blocks_.size(), 0);
  cells_in_.assign(blocks_.size(), 0);
  smaller_.assign(blocks_.size(), false);
  united_.resize(blocks_.size());
  std::iota(united_.begin(), united_.end(), 0);
  for (std::size_t cell = 1; cell < rings_.size(); ++cell) {
    for (const auto& [ring, turns] : rings_[cell]) {
      areas_[place(ring)] += areas[cell];
      ++cells_in_[place(ring)];
    }
  }
  for (std::size_t cell = 1; cell < rings_.size(); ++cell) {
    if (rings_[cell].size() < 2) continue;
    for (const int block : tangled_) {
      const std::vector<int> rings = rings_at(block, static_cast<int>(cell));
      for (std::size_t i = 1; i < rings.size(); ++i) {
        smaller_[place(rings[i])] = true;
        united_[place(root(rings[i]))] = root(rings[0]);
        if (i >= most_compared) continue;
        for (std::size_t j = 0; j < i; ++j) {
          Common& common = common_[{rings[i], rings[j]}];
          ++common.cells;
          common.block = block;
          common.area += areas[cell];
        }
      }
    }
  }
}

/// The largest one first.
std::vector<int> CrossingContours::rings_at(int block, int cell) const {
  std::vector<int> rings;
  for (const auto& [ring, turns] : rings_[place(cell)])
    if (blocks_[place(ring)].count(block) != 0) rings.push_back(ring);
  std::sort(rings.begin(), rings.end(),
            [this](int a, int b) { return std::pair(-areas_[place(a)], a) < std::pair(-areas_[place(b)], b); });
  return rings;
}

int CrossingContours::root(int ring) const {
  while (united_[place(ring)] != ring) ring = united_[place(ring)];
  return ring;
}

bool CrossingContours::between(int block, int cell) const {
  return tangled_.count(block) != 0 && rings_at(block, cell).empty();
}

bool CrossingContours::in_smaller(int block, int cell) const {
  if (!tangled_.count(block)) return false;
  const std::vector<int> rings = rings_at(block, cell);
  return std::any_of(rings.begin(), rings.end(), [this](int ring) { return smaller_[place(ring)]; });
}

int CrossingContours::united(int block, int cell) const {
  if (!tangled_.count(block)) return -1;
  const std::vector<int> rings = rings_at(block, cell);
  return rings.empty() ? -1 : root(rings.front());
}

std::vector<std::pair<int, ContourCrossing>> CrossingContours::crossings() const {
  std::vector<std::pair<int, ContourCrossing>> all;
  for (const auto& [rings, common] : common_) {
    const auto [small, large] = rings;
    if (common.cells == cells_in_[place(small)] || common.cells == cells_in_[place(large)]) continue;
    std::set<int> nodes;
    const auto& of_large = contours_->rings[place(large)];
    for (const int h : of_large) nodes.insert(graph_->origin(h));
    std::optional<int> meeting;
    for (const int h : contours_->rings[place(small)])
      if (nodes.count(graph_->origin(h)) && (!meeting || graph_->origin(h) < *meeting)) meeting = graph_->origin(h);
    if (!meeting) continue;
    all.push_back({common.block,
                   {graph_->edge(contours_->rings[place(small)].front()).source, graph_->edge(of_large.front()).source,
                    areas_[place(small)], areas_[place(large)], common.area, graph_->point(*meeting), false}});
  }
  return all;
}

}  // namespace taut::drawing
