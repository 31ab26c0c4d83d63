#include "import/closed_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/predicates.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

/// Of each node, the least node that edges connect it with.
std::vector<int> connected_nodes(const LineGraph& graph, const std::vector<bool>& edges) {
  std::vector<int> root(graph.nodes.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&root](int node) {
    while (root[static_cast<std::size_t>(node)] != node) {
      int& up = root[static_cast<std::size_t>(node)];
      up = root[static_cast<std::size_t>(up)];
      node = up;
    }
    return node;
  };
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (!edges[e]) continue;
    const int a = find(graph.edges[e].from), b = find(graph.edges[e].to);
    root[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  }
  for (int node = 0; node < static_cast<int>(root.size()); ++node) root[static_cast<std::size_t>(node)] = find(node);
  return root;
}

std::vector<AxisBox> edge_boxes(const LineGraph& graph, const FaceMap& faces) {
  std::vector<AxisBox> boxes;
  for (const int e : faces.edges) {
    const LineGraph::Edge& edge = graph.edges[static_cast<std::size_t>(e)];
    boxes.emplace_back(graph.point(edge.from), graph.point(edge.to));
  }
  return boxes;
}

/// Is p on the left of all sides of the hull, or, if `least` is 0, on them?
bool lies_left(const Polygon& hull, const Point& p, int least) {
  for (std::size_t i = 0; i < hull.size(); ++i)
    if (orientation(hull[i], hull[(i + 1) % hull.size()], p) < least) return false;
  return true;
}

/// Does the segment cross a side of the hull?
bool crosses(const Polygon& hull, const Point& p, const Point& q) {
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Point &a = hull[i], &b = hull[(i + 1) % hull.size()];
    if (orientation(a, b, p) * orientation(a, b, q) < 0 && orientation(p, q, a) * orientation(p, q, b) < 0) return true;
  }
  return false;
}

}  // namespace

ClosedPieces::ClosedPieces(const LineGraph& graph, const std::vector<bool>& closed)
    : graph_(graph), closed_(closed), boxes_({}), edges_({}) {
  const std::vector<int> root = connected_nodes(graph, closed);
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> number(root.size(), none);
  for (std::size_t e = 0; e < closed.size(); ++e) {
    if (!closed[e]) continue;
    const LineGraph::Edge& edge = graph.edges[e];
    std::size_t& piece = number[static_cast<std::size_t>(root[static_cast<std::size_t>(edge.from)])];
    if (piece == none) {
      piece = pieces_.size();
      pieces_.push_back({{}, edge.source});
    }
    pieces_[piece].source = std::min(pieces_[piece].source, edge.source);
    for (const int node : {edge.from, edge.to}) pieces_[piece].nodes.push_back(node);
  }
  std::vector<AxisBox> boxes;
  for (const Piece& piece : pieces_) {
    const Point first = graph.point(piece.nodes.front());
    boxes.emplace_back(first, first);
    for (const int node : piece.nodes) boxes.back().include(AxisBox(graph.point(node), graph.point(node)));
  }
  boxes_ = SegmentStrips(std::move(boxes));
}

std::optional<ClosedPieces::Held> ClosedPieces::in_hull(const std::vector<Point>& points, bool partly) const {
  Polygon hull;
  for (const int k : convex_hull(points)) hull.push_back(points[static_cast<std::size_t>(k)]);
  if (hull.size() < 3) return std::nullopt;
  AxisBox around(hull[0], hull[0]);
  for (const Point& p : hull) around.include(AxisBox(p, p));
  const auto in = [&](int node, int least) {
    const Point& p = graph_.point(node);
    return around.holds(AxisBox(p, p)) && lies_left(hull, p, least);
  };
  const auto part_of = [&](const std::vector<int>& nodes) {
    for (const int node : nodes)
      if (std::find(points.begin(), points.end(), graph_.point(node)) != points.end()) return false;
    for (std::size_t i = 0; i < nodes.size(); i += 2)
      if (in(nodes[i], 1) || in(nodes[i + 1], 1) || crosses(hull, graph_.point(nodes[i]), graph_.point(nodes[i + 1])))
        return true;
    return false;
  };
  std::optional<Held> found;
  boxes_.each_near(around, [&](std::size_t k) {
    const Piece& piece = pieces_[k];
    const auto better = [&](bool whole) {
      return !found || (whole && !found->whole) || (whole == found->whole && piece.source < found->source);
    };
    if (better(true) && std::all_of(piece.nodes.begin(), piece.nodes.end(), [&](int node) { return in(node, 0); }))
      found = {piece.source, true};
    else if (partly && better(false) && part_of(piece.nodes))
      found = {piece.source, false};
  });
  return found;
}

bool ClosedPieces::surround(const std::vector<Point>& line) {
  if (!faces_) {
    faces_.emplace(graph_, closed_);
    edges_ = SegmentStrips(edge_boxes(graph_, *faces_));
  }
  const Subdivision& map = faces_->map;
  std::size_t longest = 0;
  const auto length = [&line](std::size_t i) {
    return std::hypot(line[i + 1].x - line[i].x, line[i + 1].y - line[i].y);
  };
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    if (length(i) > length(longest)) longest = i;
  const Point p{(line[longest].x + line[longest + 1].x) / 2, (line[longest].y + line[longest + 1].y) / 2};
  double nearest = -INFINITY;
  int face = 0;
  edges_.each_to_the_left(p, [&](std::size_t k) {
    const int h = static_cast<int>(2 * k);
    const Point &a = map.point(map.origin(h)), &b = map.point(map.target(h));
    if ((a.y > p.y) == (b.y > p.y)) return nearest;
    const double x = a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x);
    if (x > p.x || x <= nearest) return nearest;
    nearest = x;
    // The point is right of the edge: left of it if the edge goes down.
    face = map.face(a.y > b.y ? h : h ^ 1);
    return nearest;
  });
  return face != 0;
}

}  // namespace taut::drawing
