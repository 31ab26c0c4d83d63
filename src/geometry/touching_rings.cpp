#include "geometry/part_rings.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "geometry/predicates.hpp"
#include "geometry/segment_strips.hpp"
#include "geometry/subdivision.hpp"

namespace taut::internal {

namespace {

/// Is p on the segment, but not one of its ends?
bool inside_of_segment(const Point& a, const Point& b, const Point& p) {
  return p != a && p != b && AxisBox(a, b).meets(AxisBox(p, p)) && orientation(a, b, p) == 0;
}

/// Do two segments meet otherwise than at ends, or along a line?
bool meet_badly(const Point& a, const Point& b, const Point& c, const Point& d) {
  const int side_a = orientation(c, d, a), side_b = orientation(c, d, b);
  if (side_a == 0 && side_b == 0) {
    for (const Point& p : {c, d})
      if (inside_of_segment(a, b, p)) return true;
    for (const Point& p : {a, b})
      if (inside_of_segment(c, d, p)) return true;
    return (a == c && b == d) || (a == d && b == c);
  }
  const int side_c = orientation(a, b, c), side_d = orientation(a, b, d);
  return side_a * side_b < 0 && side_c * side_d < 0;
}

/// The rings of a part as a graph, and the cuts.
class RingCutter {
 public:
  explicit RingCutter(const Part& part) {
    rings_.push_back(part.outline);
    rings_.insert(rings_.end(), part.holes.begin(), part.holes.end());
  }

  std::optional<std::vector<Part>> cut() {
    if (!split_where_vertices_lie() || !touch()) return std::nullopt;
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      if ((ring_direction(rings_[r]) > 0) != (r == 0)) std::reverse(rings_[r].begin(), rings_[r].end());
      add_edges(rings_[r]);
    }
    connected_.assign(rings_.size(), 0);
    // Where rings touch, a face is more than a ring: connect one of its holes, until all faces are rings.
    for (;;) {
      const std::optional<std::size_t> hole = hole_to_connect();
      if (!hole) return faces();
      if (*hole == 0 || !connect(*hole, connected_[*hole]++ > 0)) return std::nullopt;
    }
  }

 private:
  /// Vertices that lie on edges of other rings become vertices of both. False if rings meet in any other way.
  bool split_where_vertices_lie() {
    struct EdgePlace {
      std::size_t ring, index;
    };
    std::vector<EdgePlace> edges;
    std::vector<AxisBox> boxes;
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      if (rings_[r].size() < 3) return false;
      for (std::size_t i = 0; i < rings_[r].size(); ++i) {
        edges.push_back({r, i});
        boxes.emplace_back(rings_[r][i], end_of_edge(r, i));
      }
    }
    bool well = true;
    std::map<std::pair<std::size_t, std::size_t>, std::vector<Point>> inserted;
    const auto insert = [&](const EdgePlace& e, const Point& p) { inserted[{e.ring, e.index}].push_back(p); };
    SegmentStrips(std::move(boxes)).each_pair([&](std::size_t i, std::size_t j) {
      const EdgePlace &e = edges[i], &f = edges[j];
      const Point &a = rings_[e.ring][e.index], b = end_of_edge(e.ring, e.index);
      const Point &c = rings_[f.ring][f.index], d = end_of_edge(f.ring, f.index);
      well = well && !meet_badly(a, b, c, d);
      const bool on[] = {inside_of_segment(a, b, c), inside_of_segment(c, d, a), inside_of_segment(a, b, d),
                         inside_of_segment(c, d, b)};
      if (e.ring == f.ring) well = well && !on[0] && !on[1] && !on[2] && !on[3];
      // Each vertex is the start of one edge.
      if (on[0]) insert(e, c);
      if (on[1]) insert(f, a);
    });
    if (!well) return false;
    for (auto it = inserted.rbegin(); it != inserted.rend(); ++it) {
      Polygon& ring = rings_[it->first.first];
      const Point from = ring[it->first.second], to = end_of_edge(it->first.first, it->first.second);
      const bool forwards = lexicographically_less(from, to);
      std::vector<Point>& points = it->second;
      std::sort(points.begin(), points.end(), [forwards](const Point& p, const Point& q) {
        return forwards ? lexicographically_less(p, q) : lexicographically_less(q, p);
      });
      points.erase(std::unique(points.begin(), points.end()), points.end());
      ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(it->first.second + 1), points.begin(), points.end());
    }
    return true;
  }

  Point end_of_edge(std::size_t ring, std::size_t i) const { return rings_[ring][(i + 1) % rings_[ring].size()]; }

  /// Numbers the nodes. Is any of them on two rings? None may be on one ring twice.
  bool touch() {
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      for (const Point& p : rings_[r]) {
        const auto [known, fresh] = ids_.try_emplace({p.x, p.y}, static_cast<int>(nodes_.size()));
        if (fresh) {
          nodes_.push_back(p);
          rings_at_.push_back({});
        }
        std::vector<std::size_t>& here = rings_at_[static_cast<std::size_t>(known->second)];
        if (!here.empty() && here.back() == r) return false;
        here.push_back(r);
      }
    }
    involved_.assign(rings_.size(), false);
    for (const std::vector<std::size_t>& here : rings_at_)
      if (here.size() > 1)
        for (const std::size_t r : here) involved_[r] = true;
    const bool any = std::find(involved_.begin(), involved_.end(), true) != involved_.end();
    involved_[0] = true;
    return any;
  }

  int id(const Point& p) const { return ids_.at({p.x, p.y}); }

  void add_edges(const Polygon& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      edges_.push_back({id(ring[i]), id(ring[(i + 1) % ring.size()])});
      ring_of_.push_back(static_cast<std::size_t>(&ring - rings_.data()));
    }
  }

  /// The edges of rings that touch others or are connected to them, and the cuts.
  Subdivision involved_map() {
    std::vector<SubdivisionEdge> some;
    involved_edges_.clear();
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (e < ring_of_.size() && !involved_[ring_of_[e]]) continue;
      some.push_back(edges_[e]);
      involved_edges_.push_back(e);
    }
    return Subdivision(nodes_, std::move(some));
  }

  /// Material is to the left of rings, and on both sides of cuts.
  bool material(int h) const {
    return h % 2 == 0 || involved_edges_[static_cast<std::size_t>(h / 2)] >= ring_of_.size();
  }

  /// A hole on a face whose boundary is not one ring; 0 if there is such a face, and none of its holes is left.
  std::optional<std::size_t> hole_to_connect() {
    const Subdivision map = involved_map();
    std::map<int, std::vector<int>> bounds;  // half-edges of each face of material
    for (int h = 0; h < map.half_edges(); ++h)
      if (material(h)) bounds[map.face(h)].push_back(h);
    for (const auto& [face, all] : bounds) {
      // One walk, and no node twice.
      std::set<int> seen;
      std::size_t length = 0;
      int h = all.front();
      do {
        seen.insert(map.origin(h));
        ++length;
        h = map.next(h);
      } while (h != all.front());
      if (length == all.size() && seen.size() == length) continue;
      for (const int g : all) {
        const std::size_t e = involved_edges_[static_cast<std::size_t>(g / 2)];
        if (e < ring_of_.size() && ring_of_[e] != 0 && connected_[ring_of_[e]] < 2) return ring_of_[e];
      }
      return 0;
    }
    return std::nullopt;
  }

  static bool before(const Point& p, const Point& q, bool right) {
    return right ? lexicographically_less(q, p) : lexicographically_less(p, q);
  }

  Point extreme(std::size_t ring, bool right) const {
    return *std::min_element(rings_[ring].begin(), rings_[ring].end(),
                             [right](const Point& p, const Point& q) { return before(p, q, right); });
  }

  /// A hole that is connected to what lies to its left by its leftmost vertex, and to what lies to its right by its
  /// rightmost one, is on a cycle through the outline. If all are, no vertex is twice on the boundary of a face; mostly
  /// fewer connections do.
  bool connect(std::size_t hole, bool right) {
    const Point q = extreme(hole, right);
    for (const std::size_t r : rings_at_[static_cast<std::size_t>(id(q))])
      if (r != hole && (r == 0 || extreme(r, right) != q)) return true;
    std::vector<std::pair<double, int>> candidates;
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (before(nodes_[i], q, right))
        candidates.push_back({std::hypot(nodes_[i].x - q.x, nodes_[i].y - q.y), static_cast<int>(i)});
    std::sort(candidates.begin(), candidates.end());
    for (const auto& [distance, r] : candidates) {
      if (!visible(q, nodes_[static_cast<std::size_t>(r)])) continue;
      edges_.push_back({id(q), r});
      for (const std::size_t ring : rings_at_[static_cast<std::size_t>(r)]) involved_[ring] = true;
      return true;
    }
    return false;
  }

  bool visible(const Point& q, const Point& r) const {
    const AxisBox box(q, r);
    return std::none_of(edges_.begin(), edges_.end(), [&](const SubdivisionEdge& e) {
      const Point &a = nodes_[static_cast<std::size_t>(e.from)], &b = nodes_[static_cast<std::size_t>(e.to)];
      if (!AxisBox(a, b).meets(box)) return false;
      return meet_badly(a, b, q, r) || inside_of_segment(q, r, a) || inside_of_segment(q, r, b);
    });
  }

  std::optional<std::vector<Part>> faces() {
    const Subdivision map = involved_map();
    std::vector<Part> parts;
    std::vector<bool> seen(static_cast<std::size_t>(map.half_edges()), false);
    for (int start = 0; start < map.half_edges(); ++start) {
      if (!material(start) || seen[static_cast<std::size_t>(start)]) continue;
      Part part;
      for (int h = start; !seen[static_cast<std::size_t>(h)]; h = map.next(h)) {
        // Holes that lie outside of the outline, or in each other.
        if (map.face(h) == 0 || !material(h)) return std::nullopt;
        seen[static_cast<std::size_t>(h)] = true;
        part.outline.push_back(map.point(map.origin(h)));
      }
      parts.push_back(std::move(part));
    }
    for (std::size_t r = 1; r < rings_.size(); ++r) {
      if (involved_[r]) continue;
      const auto around = std::find_if(parts.begin(), parts.end(), [&](const Part& part) {
        return side_of_ring(part.outline, rings_[r].front()) > 0;
      });
      if (around == parts.end()) return std::nullopt;
      around->holes.push_back(std::move(rings_[r]));
    }
    return parts;
  }

  std::vector<Polygon> rings_;
  std::vector<Point> nodes_;
  std::vector<std::vector<std::size_t>> rings_at_;  ///< of each node
  std::map<std::pair<double, double>, int> ids_;
  std::vector<SubdivisionEdge> edges_;
  std::vector<std::size_t> ring_of_;         ///< of edges that are not cuts
  std::vector<bool> involved_;               ///< of rings: does it touch another one, or is it connected to one?
  std::vector<int> connected_;               ///< of holes: how often
  std::vector<std::size_t> involved_edges_;  ///< of the map's edges
};

}  // namespace

int ring_direction(const Polygon& ring) {
  if (ring.size() < 3) return 0;
  const std::size_t n = ring.size();
  const std::size_t least =
      static_cast<std::size_t>(std::min_element(ring.begin(), ring.end(), lexicographically_less) - ring.begin());
  return orientation(ring[(least + n - 1) % n], ring[least], ring[(least + 1) % n]);
}

std::vector<Part> cut_where_rings_touch(Part part) {
  if (!part.holes.empty()) {
    if (auto parts = RingCutter(part).cut()) return std::move(*parts);
  }
  return {std::move(part)};
}

}  // namespace taut::internal
