#include "import/line_graph.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "geometry/predicates.hpp"
#include "geometry/segment_strips.hpp"
#include "taut/error.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

constexpr int most_rounds = 64;

/// Points that are so near to each other are one.
class NodeSet {
 public:
  explicit NodeSet(double distance) : distance_(distance), cell_(64 * distance) {}

  void reserve(std::size_t n) {
    heads_.reserve(n);
    links_.reserve(n);
    points.reserve(n);
  }

  int find_or_add(const Point& p) {
    const double column = std::floor(p.x / cell_), row = std::floor(p.y / cell_);
    // Neighbouring cells matter near the sides of a cell only.
    for (double i = std::floor((p.x - distance_) / cell_); i <= std::floor((p.x + distance_) / cell_); ++i) {
      for (double j = std::floor((p.y - distance_) / cell_); j <= std::floor((p.y + distance_) / cell_); ++j) {
        const auto cell = heads_.find(key(i, j));
        for (int k = cell == heads_.end() ? -1 : cell->second; k >= 0; k = links_[static_cast<std::size_t>(k)]) {
          const Point& q = points[static_cast<std::size_t>(k)];
          if (std::fabs(p.x - q.x) <= distance_ && std::fabs(p.y - q.y) <= distance_) return k;
        }
      }
    }
    const int id = static_cast<int>(points.size());
    points.push_back(p);
    const auto [head, fresh] = heads_.try_emplace(key(column, row), id);
    links_.push_back(fresh ? -1 : std::exchange(head->second, id));
    return id;
  }

  std::vector<Point> points;

 private:
  static std::uint64_t key(double column, double row) {
    const auto bits = [](double x) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(x)); };
    return bits(column) * 0x9E3779B97F4A7C15u ^ (bits(row) * 0xC2B2AE3D27D4EB4Fu >> 7);
  }

  double distance_, cell_;
  std::unordered_map<std::uint64_t, int> heads_;
  std::vector<int> links_;
};

struct PlaceOnSegment {
  double along = 0, distance = 0;
};

/// The nearest point of the segment: at a + along (b - a).
PlaceOnSegment place_on(const Point& a, const Point& b, const Point& p) {
  const double x = b.x - a.x, y = b.y - a.y, length = x * x + y * y;
  const double along = length > 0 ? std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / length, 0.0, 1.0) : 0;
  return {along, std::hypot(p.x - a.x - along * x, p.y - a.y - along * y)};
}

/// Where two segments cross, which they do; rounded.
Point crossing_point(const Point& a, const Point& b, const Point& c, const Point& d) {
  const double x = b.x - a.x, y = b.y - a.y, u = d.x - c.x, v = d.y - c.y;
  const double t = ((c.x - a.x) * v - (c.y - a.y) * u) / (x * v - y * u);
  const double along = std::isfinite(t) ? std::clamp(t, 0.0, 1.0) : 0.5;
  return {a.x + along * x, a.y + along * y};
}

class Splitter {
 public:
  Splitter(const std::vector<Strand>& strands, double distance, std::size_t most, const std::string& file)
      : distance_(distance), most_(most), file_(file), nodes_(distance) {
    // In the order of the plane, so that which point stands for its neighbours does not depend on the strands.
    struct Place {
      Point at;
      std::size_t strand, index;
    };
    std::vector<Place> places;
    std::vector<std::vector<int>> ids;
    for (std::size_t s = 0; s < strands.size(); ++s) {
      ids.emplace_back(strands[s].points.size());
      for (std::size_t i = 0; i < strands[s].points.size(); ++i) places.push_back({strands[s].points[i], s, i});
    }
    std::sort(places.begin(), places.end(),
              [](const Place& p, const Place& q) { return lexicographically_less(p.at, q.at); });
    nodes_.reserve(places.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
      const Place& place = places[k];
      const Place* before = k > 0 && places[k - 1].at == place.at ? &places[k - 1] : nullptr;
      ids[place.strand][place.index] = before ? ids[before->strand][before->index] : nodes_.find_or_add(place.at);
    }
    for (std::size_t s = 0; s < strands.size(); ++s) {
      std::vector<int> walk;
      for (const int id : ids[s]) append(walk, id);
      if (strands[s].closed && walk.size() > 1) append(walk, walk.front());
      walks_.push_back(std::move(walk));
    }
  }

  void split() {
    // A line that was split has moved a little, and a new node may be on another line: the next round finds out. Lines
    // are much longer than the distance at which a node is on them, so that they do not fold, and few rounds suffice.
    for (int round = 0; find_cuts(); ++round) {
      if (round == most_rounds)
        throw InputError(file_, "lines lie too close to each other to be distinguished", "check the drawing's units");
      for (std::vector<int>& walk : walks_) cut(walk);
    }
  }

  LineGraph graph(const std::vector<Strand>& strands) const {
    LineGraph g;
    std::vector<int> order(nodes_.points.size()), rank(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
    const auto& points = nodes_.points;
    std::sort(order.begin(), order.end(), [&](int i, int j) {
      return lexicographically_less(points[static_cast<std::size_t>(i)], points[static_cast<std::size_t>(j)]);
    });
    for (std::size_t i = 0; i < order.size(); ++i) {
      rank[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
      g.nodes.push_back(points[static_cast<std::size_t>(order[i])]);
    }
    struct Step {
      int from, to;
      std::size_t strand, position;
      bool backwards;
    };
    std::vector<Step> steps;
    g.walks.resize(walks_.size());
    for (std::size_t s = 0; s < walks_.size(); ++s) {
      for (std::size_t i = 0; i + 1 < walks_[s].size(); ++i) {
        const int a = rank[static_cast<std::size_t>(walks_[s][i])],
                  b = rank[static_cast<std::size_t>(walks_[s][i + 1])];
        steps.push_back({std::min(a, b), std::max(a, b), s, i, a > b});
      }
      g.walks[s].resize(walks_[s].empty() ? 0 : walks_[s].size() - 1);
    }
    std::sort(steps.begin(), steps.end(), [](const Step& s, const Step& t) {
      return std::pair(s.from, s.to) < std::pair(t.from, t.to) ||
             (s.from == t.from && s.to == t.to && std::pair(s.strand, s.position) < std::pair(t.strand, t.position));
    });
    for (const Step& step : steps) {
      if (g.edges.empty() || g.edges.back().from != step.from || g.edges.back().to != step.to)
        g.edges.push_back({step.from, step.to, 0, 0, strands[step.strand].source});
      LineGraph::Edge& edge = g.edges.back();
      edge.winding += step.backwards ? -1 : 1;
      ++edge.times;
      edge.source = std::min(edge.source, strands[step.strand].source);
      g.walks[step.strand][step.position] = static_cast<int>(2 * (g.edges.size() - 1)) + (step.backwards ? 1 : 0);
    }
    return g;
  }

 private:
  using Segment = std::pair<int, int>;

  static void append(std::vector<int>& walk, int node) {
    if (walk.empty() || walk.back() != node) walk.push_back(node);
  }
  const Point& at(int node) const { return nodes_.points[static_cast<std::size_t>(node)]; }

  bool find_cuts() {
    segments_.clear();
    for (const std::vector<int>& walk : walks_)
      for (std::size_t i = 0; i + 1 < walk.size(); ++i)
        segments_.push_back({std::min(walk[i], walk[i + 1]), std::max(walk[i], walk[i + 1])});
    std::sort(segments_.begin(), segments_.end());
    segments_.erase(std::unique(segments_.begin(), segments_.end()), segments_.end());
    cuts_.assign(segments_.size(), {});
    std::vector<AxisBox> boxes;
    for (const Segment& s : segments_) boxes.emplace_back(at(s.first), at(s.second), distance_);
    bool any = false;
    SegmentStrips(std::move(boxes)).each_pair([&](std::size_t i, std::size_t j) { any = compare(i, j) || any; });
    return any;
  }

  bool compare(std::size_t i, std::size_t j) {
    const auto [a, b] = segments_[i];
    const auto [c, d] = segments_[j];
    bool any = false;
    for (const int node : {c, d}) any = split_at_node(i, node) || any;
    for (const int node : {a, b}) any = split_at_node(j, node) || any;
    if (any) return true;
    if (a == c || a == d || b == c || b == d) return false;
    if (orientation(at(a), at(b), at(c)) * orientation(at(a), at(b), at(d)) >= 0) return false;
    if (orientation(at(c), at(d), at(a)) * orientation(at(c), at(d), at(b)) >= 0) return false;
    const int node = nodes_.find_or_add(crossing_point(at(a), at(b), at(c), at(d)));
    const bool first = add_cut(i, node), second = add_cut(j, node);
    return first || second;
  }

  bool split_at_node(std::size_t segment, int node) {
    const auto [a, b] = segments_[segment];
    if (node == a || node == b) return false;
    const PlaceOnSegment place = place_on(at(a), at(b), at(node));
    return place.along > 0 && place.along < 1 && place.distance <= distance_ / 4 && add_cut(segment, node);
  }

  bool add_cut(std::size_t segment, int node) {
    const auto [a, b] = segments_[segment];
    if (node == a || node == b) return false;
    if (++made_ > most_)
      throw InputError(file_, "lines cross each other more than " + std::to_string(most_) + " times",
                       "read fewer layers with --layer, or leave the hatching out");
    cuts_[segment].push_back(node);
    return true;
  }

  void cut(std::vector<int>& walk) {
    std::vector<int> out;
    for (std::size_t i = 0; i < walk.size(); ++i) {
      append(out, walk[i]);
      if (i + 1 == walk.size()) break;
      const Segment segment{std::min(walk[i], walk[i + 1]), std::max(walk[i], walk[i + 1])};
      const auto k =
          static_cast<std::size_t>(std::lower_bound(segments_.begin(), segments_.end(), segment) - segments_.begin());
      std::vector<std::pair<double, int>> between;
      for (const int node : cuts_[k]) between.push_back({place_on(at(walk[i]), at(walk[i + 1]), at(node)).along, node});
      std::sort(between.begin(), between.end());
      for (const auto& [along, node] : between) append(out, node);
    }
    walk = std::move(out);
  }

  double distance_;
  std::size_t most_, made_ = 0;
  const std::string& file_;
  NodeSet nodes_;
  std::vector<std::vector<int>> walks_;  ///< nodes along each strand
  std::vector<Segment> segments_;
  std::vector<std::vector<int>> cuts_;  ///< nodes within each segment
};

}  // namespace

double LineGraph::length(int h) const {
  const Point &a = point(origin(h)), &b = point(target(h));
  return std::hypot(b.x - a.x, b.y - a.y);
}

Incidence::Incidence(const LineGraph& graph, const std::vector<bool>& alive)
    : first_(graph.nodes.size() + 1, 0), out_() {
  for (int h = 0; h < static_cast<int>(2 * graph.edges.size()); ++h)
    if (alive[static_cast<std::size_t>(h / 2)]) ++first_[static_cast<std::size_t>(graph.origin(h) + 1)];
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  out_.resize(static_cast<std::size_t>(first_.back()));
  std::vector<int> filled(first_.begin(), first_.end() - 1);
  for (int h = 0; h < static_cast<int>(2 * graph.edges.size()); ++h)
    if (alive[static_cast<std::size_t>(h / 2)])
      out_[static_cast<std::size_t>(filled[static_cast<std::size_t>(graph.origin(h))]++)] = h;
}

double node_distance(const std::vector<Strand>& strands) {
  AxisBox around;
  bool first = true;
  for (const Strand& strand : strands) {
    for (const Point& p : strand.points) {
      if (first) around = AxisBox(p, p);
      first = false;
      around.include(AxisBox(p, p));
    }
  }
  // Far from the origin, coordinates are coarser.
  const double far = std::max({-around.lo_x, -around.lo_y, around.hi_x, around.hi_y});
  return std::max({around.longest() * 0x1p-40, far * 0x1p-48, 0x1p-390});
}

LineGraph split_at_crossings(const std::vector<Strand>& strands, std::size_t most, const std::string& file) {
  Splitter splitter(strands, node_distance(strands), most, file);
  splitter.split();
  return splitter.graph(strands);
}

/// Tarjan's search in depth, with a stack of its own.
std::vector<int> blocks_of(const LineGraph& graph, const std::vector<bool>& alive) {
  const Incidence incidence(graph, alive);
  std::vector<int> block(graph.edges.size(), -1), depth(graph.nodes.size(), -1), low(graph.nodes.size(), 0);
  struct Visit {
    int node, by;  ///< the half-edge that led here, or -1
    const int* next;
  };
  std::vector<Visit> path;
  std::vector<int> open;  ///< edges whose block is not complete
  int blocks = 0, clock = 0;
  const auto enter = [&](int node, int by) {
    depth[static_cast<std::size_t>(node)] = low[static_cast<std::size_t>(node)] = clock++;
    path.push_back({node, by, incidence.begin(node)});
  };
  for (int root = 0; root < static_cast<int>(graph.nodes.size()); ++root) {
    if (depth[static_cast<std::size_t>(root)] < 0) enter(root, -1);
    while (!path.empty()) {
      Visit& visit = path.back();
      const auto here = static_cast<std::size_t>(visit.node);
      if (visit.next != incidence.end(visit.node)) {
        const int h = *visit.next++;
        const auto there = static_cast<std::size_t>(graph.target(h));
        if (visit.by >= 0 && (h ^ 1) == visit.by) continue;
        if (depth[there] < 0) {
          open.push_back(h / 2);
          enter(graph.target(h), h);
        } else if (depth[there] < depth[here]) {
          open.push_back(h / 2);
          low[here] = std::min(low[here], depth[there]);
        }
        continue;
      }
      const int by = visit.by;
      path.pop_back();
      if (by < 0) continue;
      const auto above = static_cast<std::size_t>(graph.origin(by));
      low[above] = std::min(low[above], low[here]);
      if (low[here] < depth[above]) continue;
      for (int e = -1; e != by / 2; open.pop_back()) {
        e = open.back();
        block[static_cast<std::size_t>(e)] = blocks;
      }
      ++blocks;
    }
  }
  return block;
}

}  // namespace taut::drawing
