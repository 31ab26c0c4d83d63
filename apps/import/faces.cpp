#include "import/faces.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "geometry/part_rings.hpp"
#include "geometry/predicates.hpp"
#include "import/crossing_contours.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

std::size_t slot(int i) { return static_cast<std::size_t>(i); }

std::vector<int> indices_of(const std::vector<bool>& alive) {
  std::vector<int> all;
  for (std::size_t e = 0; e < alive.size(); ++e)
    if (alive[e]) all.push_back(static_cast<int>(e));
  return all;
}

std::vector<SubdivisionEdge> ends_of(const LineGraph& graph, const std::vector<int>& edges) {
  std::vector<SubdivisionEdge> ends;
  for (const int e : edges) ends.push_back({graph.edges[slot(e)].from, graph.edges[slot(e)].to});
  return ends;
}

/// Goes from face to face, from the unbounded one.
class LineKeys {
 public:
  LineKeys(const LineGraph& graph, const std::vector<bool>& alive, const Contours& all, const FaceMap& faces,
           Crossing crossing)
      : contour_(all.edges),
        faces_(faces),
        crossing_(crossing),
        block_(blocks_of(graph, alive)),
        label_(slot(faces.map.faces()), unknown) {
    std::vector<bool> contours(alive.size());
    for (std::size_t e = 0; e < alive.size(); ++e) contours[e] = alive[e] && contour_[e];
    contour_block_ = contours == alive ? block_ : blocks_of(graph, contours);
    // Often all lines are contours.
    const auto other = contours == alive ? std::nullopt : std::optional<FaceMap>(std::in_place, graph, contours);
    const FaceMap& cells = other ? *other : faces;
    find_cells(cells);
    crossing_contours_ = CrossingContours(graph, all, contour_block_, cells);
    const std::size_t blocks = graph.edges.size();
    for (auto* labels : {&block_label_, &contour_label_}) labels->assign(blocks, unknown);
    outer_cell_.assign(blocks, unknown);
    attached_.assign(blocks, false);
    for (std::size_t e = 0; e < alive.size(); ++e)
      if (contours[e] && block_[e] >= 0) attached_[slot(block_[e])] = true;
  }

  FaceKeys keys() {
    const std::vector<std::vector<int>> boundaries = boundaries_of(faces_.map);
    std::vector<int> queue{0};
    label_[0] = 0;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      for (const int h : boundaries[slot(queue[i])]) {
        const int there = faces_.map.face(h ^ 1);
        if (label_[slot(there)] != unknown) continue;
        label_[slot(there)] = across(h);
        if (label_[slot(there)] != unknown) queue.push_back(there);
      }
    }
    FaceKeys keys;
    for (std::size_t f = 0; f < label_.size(); ++f) keys.push_back(label_[f] == 1 ? static_cast<int>(f) + 1 : 0);
    if (crossing_ == Crossing::unite) unite(keys);
    return keys;
  }

  /// Of contours around material, and of those that are holes.
  std::vector<ContourCrossing> crossings() const {
    std::vector<ContourCrossing> all;
    for (auto [block, crossing] : crossing_contours_.crossings()) {
      crossing.hole = contour_label_[slot(block)] != 1;
      all.push_back(crossing);
    }
    return all;
  }

 private:
  static constexpr int unknown = -1;

  /// The faces of the contours alone: each holds those that other lines divide it into.
  void find_cells(const FaceMap& contours) {
    std::vector<int> contour_half_edge(contour_.size(), unknown);
    for (std::size_t k = 0; k < contours.edges.size(); ++k)
      contour_half_edge[slot(contours.edges[k])] = static_cast<int>(2 * k);
    cell_.assign(slot(faces_.map.faces()), unknown);
    cell_[0] = 0;
    std::vector<int> queue{0};
    for (int h = 0; h < faces_.map.half_edges(); ++h) {
      const int known = contour_half_edge[slot(faces_.edge(h))], face = faces_.map.face(h);
      if (known < 0 || cell_[slot(face)] != unknown) continue;
      cell_[slot(face)] = contours.map.face(known + h % 2);
      queue.push_back(face);
    }
    const std::vector<std::vector<int>> boundaries = boundaries_of(faces_.map);
    for (std::size_t i = 0; i < queue.size(); ++i) {
      for (const int h : boundaries[slot(queue[i])]) {
        const int there = faces_.map.face(h ^ 1);
        if (contour_half_edge[slot(faces_.edge(h))] >= 0 || cell_[slot(there)] != unknown) continue;
        cell_[slot(there)] = cell_[slot(queue[i])];
        queue.push_back(there);
      }
    }
  }

  /// The label of what is on the other side of a half-edge, or unknown if another path there will decide.
  int across(int h) {
    const int here = faces_.map.face(h), there = faces_.map.face(h ^ 1), e = faces_.edge(h);
    const auto opposite = [&](int& label) { return label == unknown ? label = 1 - label_[slot(here)] : label; };
    if (!contour_[slot(e)]) {
      const int block = block_[slot(e)];
      if (!attached_[slot(block)]) return opposite(block_label_[slot(block)]);
      return cell_[slot(here)] == 0 ? 1 : label_[slot(here)];
    }
    const int block = contour_block_[slot(e)];
    int& outer = outer_cell_[slot(block)];
    if (outer == unknown) outer = cell_[slot(here)];
    // Out of the block again, to a place that other lines have cut off.
    if (cell_[slot(there)] == outer) return unknown;
    const int within = opposite(contour_label_[slot(block)]), cell = cell_[slot(there)];
    const bool taken_out = within == 1 && crossing_ == Crossing::subtract && crossing_contours_.in_smaller(block, cell);
    return taken_out || crossing_contours_.between(block, cell) ? 1 - within : within;
  }

  /// Faces on both sides of a contour, in contours that cross each other, are one piece.
  void unite(FaceKeys& keys) const {
    std::map<std::pair<int, int>, int> first;  // of blocks and sets of contours: the key of a face
    for (int h = 0; h < faces_.map.half_edges(); ++h) {
      const int face = faces_.map.face(h), block = contour_block_[slot(faces_.edge(h))];
      if (block < 0 || label_[slot(face)] != 1) continue;
      const int set = crossing_contours_.united(block, cell_[slot(face)]);
      if (set >= 0) keys[slot(face)] = first.try_emplace({block, set}, keys[slot(face)]).first->second;
    }
  }

  const std::vector<bool>& contour_;
  const FaceMap& faces_;
  const Crossing crossing_;
  CrossingContours crossing_contours_;
  std::vector<int> block_, contour_block_;  ///< of all edges, and of contours alone
  std::vector<int> label_, cell_;           ///< of faces
  std::vector<int> block_label_, contour_label_, outer_cell_;
  std::vector<bool> attached_;  ///< is there a contour in the block?
};

/// Walks along the boundaries of regions.
class RegionTracer {
 public:
  RegionTracer(const FaceMap& faces, const FaceKeys& keys)
      : faces_(faces), keys_(keys), region_(slot(faces.map.faces())) {
    std::iota(region_.begin(), region_.end(), 0);
    for (int h = 0; h < map().half_edges(); h += 2) {
      if (key(h) != 0 && key(h) == key(h ^ 1)) region_[slot(root(map().face(h)))] = root(map().face(h ^ 1));
    }
  }

  std::vector<Region> trace() {
    std::map<int, Region> regions;
    std::vector<bool> seen(slot(map().half_edges()), false);
    for (int start = 0; start < map().half_edges(); ++start) {
      if (seen[slot(start)] || !boundary(start)) continue;
      std::vector<int> walk;
      for (int h = start; !seen[slot(h)]; h = following(h)) {
        seen[slot(h)] = true;
        walk.push_back(h);
      }
      add_rings(walk, regions[root(map().face(start))]);
    }
    std::vector<Region> all;
    for (auto& [root, region] : regions) all.push_back(std::move(region));
    std::sort(all.begin(), all.end(), [](const Region& a, const Region& b) {
      return std::lexicographical_compare(a.part.outline.begin(), a.part.outline.end(), b.part.outline.begin(),
                                          b.part.outline.end(), lexicographically_less);
    });
    return all;
  }

 private:
  const Subdivision& map() const { return faces_.map; }
  int key(int h) const { return keys_[slot(map().face(h))]; }
  /// Is material on the left, and something else on the right?
  bool boundary(int h) const { return key(h) != 0 && key(h) != key(h ^ 1); }

  int root(int face) {
    while (region_[slot(face)] != face) face = region_[slot(face)] = region_[slot(region_[slot(face)])];
    return face;
  }

  /// The next half-edge along the boundary of what is on the left; edges with the same on both sides are passed.
  int following(int h) const {
    int g = map().next(h);
    while (!boundary(g)) g = map().next(g ^ 1);
    return g;
  }

  /// Where a walk comes to a node again, it has gone around a ring.
  void add_rings(const std::vector<int>& walk, Region& region) {
    std::vector<int> open;
    std::map<int, std::size_t> position;
    for (const int h : walk) {
      position[map().origin(h)] = open.size();
      open.push_back(h);
      const auto back = position.find(map().target(h));
      if (back == position.end()) continue;
      const std::size_t begin = back->second;
      add_ring({open.begin() + static_cast<std::ptrdiff_t>(begin), open.end()}, region);
      for (std::size_t k = begin; k < open.size(); ++k) position.erase(map().origin(open[k]));
      open.resize(begin);
    }
  }

  void add_ring(std::vector<int> ring, Region& region) {
    std::rotate(ring.begin(),
                std::min_element(ring.begin(), ring.end(),
                                 [this](int g, int h) {
                                   return lexicographically_less(map().point(map().origin(g)),
                                                                 map().point(map().origin(h)));
                                 }),
                ring.end());
    Polygon polygon;
    for (const int h : ring) polygon.push_back(map().point(map().origin(h)));
    if (ring_direction(polygon) < 0) {
      region.holes.push_back(faces_.edge(ring.front()));
      return region.part.holes.push_back(std::move(polygon));
    }
    region.part.outline = std::move(polygon);
    for (const int h : ring) region.outline.push_back(faces_.edge(h));
  }

  const FaceMap& faces_;
  const FaceKeys& keys_;
  std::vector<int> region_;
};

}  // namespace

FaceMap::FaceMap(const LineGraph& graph, const std::vector<bool>& alive)
    : edges(indices_of(alive)), map(graph.nodes, ends_of(graph, edges)) {}

LineFaces faces_of_lines(const LineGraph& graph, const std::vector<bool>& alive, const Contours& contours,
                         const FaceMap& faces, Crossing crossing) {
  LineKeys keys(graph, alive, contours, faces, crossing);
  FaceKeys all = keys.keys();
  return {std::move(all), keys.crossings()};
}

std::vector<std::vector<int>> boundaries_of(const Subdivision& map) {
  std::vector<std::vector<int>> all(slot(map.faces()));
  for (int h = 0; h < map.half_edges(); ++h) all[slot(map.face(h))].push_back(h);
  return all;
}

std::vector<Turns> turns_around(const LineGraph& graph, const FaceMap& faces) {
  const Subdivision& map = faces.map;
  const std::vector<std::vector<int>> boundaries = boundaries_of(map);
  std::vector<Turns> turns(slot(map.faces()));
  std::vector<int> queue{0};
  std::vector<bool> seen(slot(map.faces()), false);
  seen[0] = true;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (const int h : boundaries[slot(queue[i])]) {
      const int there = map.face(h ^ 1);
      if (seen[slot(there)]) continue;
      seen[slot(there)] = true;
      const LineGraph::Edge& edge = graph.edges[slot(faces.edge(h))];
      const Turns& here = turns[slot(queue[i])];
      // What lies to the left of a line has one turn more.
      turns[slot(there)] = {here.winding + (h % 2 == 0 ? -edge.winding : edge.winding), here.times + edge.times};
      queue.push_back(there);
    }
  }
  return turns;
}

std::vector<Region> regions_of(const FaceMap& faces, const FaceKeys& keys) { return RegionTracer(faces, keys).trace(); }

std::vector<double> areas_of_faces(const FaceMap& faces) {
  const Subdivision& map = faces.map;
  std::vector<double> areas(slot(map.faces()), 0);
  for (int h = 0; h < map.half_edges(); ++h) {
    const Point &origin = map.point(map.origin(0)), &a = map.point(map.origin(h)), &b = map.point(map.target(h));
    areas[slot(map.face(h))] += ((a.x - origin.x) * (b.y - origin.y) - (a.y - origin.y) * (b.x - origin.x)) / 2;
  }
  return areas;
}

double doubled_area(const Polygon& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    sum += (a.x - ring[0].x) * (b.y - ring[0].y) - (a.y - ring[0].y) * (b.x - ring[0].x);
  }
  return sum;
}

double area_of(const Part& part) {
  double twice = std::fabs(doubled_area(part.outline));
  for (const Polygon& hole : part.holes) twice -= std::fabs(doubled_area(hole));
  return twice / 2;
}

}  // namespace taut::drawing
