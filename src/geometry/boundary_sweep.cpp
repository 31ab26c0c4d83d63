#include "geometry/boundary_sweep.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include "geometry/predicates.hpp"
#include "numeric/budget.hpp"
#include "taut/error.hpp"

namespace taut::internal {

namespace {

/// An edge in the status, seen from left to right in the lexicographic order (a vertical one from bottom to top).
struct StatusEdge {
  Point left, right;
  int index = 0;
};

/// The status orders, from bottom to top, the edges that the sweep line cuts; with the lexicographic order the sweep
/// line is tilted infinitesimally, so a vertical edge is cut like any other.
struct Below {
  using is_transparent = void;
  /// True if the edge passes strictly below the point.
  bool operator()(const StatusEdge& e, const Point& p) const { return orientation(e.left, e.right, p) > 0; }
  bool operator()(const Point& p, const StatusEdge& e) const { return orientation(e.left, e.right, p) < 0; }
  bool operator()(const StatusEdge& a, const StatusEdge& b) const {
    if (a.left == b.left) return orientation(a.left, a.right, b.right) > 0;
    if (lexicographically_less(a.left, b.left)) return (*this)(a, b.left);
    return (*this)(a.left, b);
  }
};

class Sweep {
 public:
  Sweep(const Polygon& polygon, const std::vector<int>& order)
      : polygon_(polygon), order_(order), n_(static_cast<int>(polygon.size())), place_(polygon.size()) {}

  std::optional<SelfMeeting> run() {
    for (const int v : order_) {
      checkpoint();
      const int before = v == 0 ? n_ - 1 : v - 1;
      const bool ends = lexicographically_less(vertex(before), vertex(v));      // edge `before` lies to the left
      const bool next_ends = lexicographically_less(vertex(v + 1), vertex(v));  // edge v lies to the left
      if (ends && next_ends) {
        close(before, v);
      } else if (ends) {
        replace(before, v);
      } else if (next_ends) {
        replace(v, before);
      } else {
        open(v, before, v);
      }
      if (found_.kind != Meeting::none) return found_;
    }
    return std::nullopt;
  }

 private:
  // The edge is mutable: where one edge ends and the next begins, it takes over the place. Nothing passes through the
  // vertex (neighbours in the status are known not to meet), so the order stays what it was.
  struct Entry {
    mutable StatusEdge edge;
  };
  struct EntryBelow {
    using is_transparent = void;
    bool operator()(const Entry& a, const Entry& b) const { return Below()(a.edge, b.edge); }
    bool operator()(const Entry& a, const Point& p) const { return Below()(a.edge, p); }
    bool operator()(const Point& p, const Entry& a) const { return Below()(p, a.edge); }
  };
  using Status = std::set<Entry, EntryBelow>;
  using Place = Status::iterator;

  const Point& vertex(int i) const { return polygon_[i == n_ ? 0 : i]; }

  StatusEdge directed(int e) const {
    const Point &a = vertex(e), &b = vertex(e + 1);
    return lexicographically_less(a, b) ? StatusEdge{a, b, e} : StatusEdge{b, a, e};
  }

  /// Neighbours in the status must not meet, unless in a common vertex.
  void check(Place lower, Place upper) {
    if (found_.kind != Meeting::none) return;
    const int i = std::min(lower->edge.index, upper->edge.index), j = std::max(lower->edge.index, upper->edge.index);
    if (j - i == 1 || j - i == n_ - 1) return;  // neighbours along the boundary; fold-backs were found before
    found_ = classify_edges(polygon_, i, j);
  }
  void check_below(Place p) {
    if (p != status_.begin()) check(std::prev(p), p);
  }
  void check_above(Place p) {
    if (std::next(p) != status_.end()) check(p, std::next(p));
  }

  void replace(int ending, int beginning) {
    const Place p = place_[ending];
    p->edge = directed(beginning);
    place_[beginning] = p;
    check_below(p);
    check_above(p);
  }

  void open(int v, int e, int f) {
    const Place above = status_.lower_bound(vertex(v));
    if (above != status_.end() && orientation(above->edge.left, above->edge.right, vertex(v)) == 0) {
      const int on = above->edge.index;  // v lies on this edge
      found_ = classify_edges(polygon_, std::min(on, e), std::max(on, e));
      return;
    }
    StatusEdge low = directed(e), high = directed(f);
    if (Below()(high, low)) std::swap(low, high);
    const Place p = status_.insert(above, Entry{low});
    const Place q = status_.insert(above, Entry{high});
    place_[low.index] = p;
    place_[high.index] = q;
    check_below(p);
    check_above(q);
  }

  void close(int e, int f) {
    Place low = place_[e], high = place_[f];
    if (std::next(low) != high) std::swap(low, high);
    // Whatever lay between them would pass through their common vertex and have been found.
    if (std::next(low) != high) throw StructureError("plane sweep out of order");
    const bool between = low != status_.begin() && std::next(high) != status_.end();
    status_.erase(low);
    const Place after = status_.erase(high);
    if (between) check(std::prev(after), after);
  }

  const Polygon& polygon_;
  const std::vector<int>& order_;
  const int n_;
  Status status_;
  std::vector<Place> place_;  // of each edge in the status
  SelfMeeting found_;
};

/// The point where two crossing edges meet, to a few ulps of their extent.
Point crossing_point(const Point& a, const Point& b, const Point& c, const Point& d) {
  const double rx = b.x - a.x, ry = b.y - a.y, sx = d.x - c.x, sy = d.y - c.y;
  const double denominator = rx * sy - ry * sx;
  double t = ((c.x - a.x) * sy - (c.y - a.y) * sx) / denominator;
  if (!(t >= 0)) t = 0;  // nearly parallel edges: stay on the edge at least
  if (t > 1) t = 1;
  return {a.x + t * rx, a.y + t * ry};
}

std::optional<SelfMeeting> find_fold_back(const Polygon& polygon) {
  const int n = static_cast<int>(polygon.size());
  for (int v = 0; v < n; ++v) {
    const int before = v == 0 ? n - 1 : v - 1;
    const Point &a = polygon[before], &b = polygon[v], &c = polygon[v + 1 == n ? 0 : v + 1];
    if (orientation(a, b, c) != 0 || lexicographically_less(a, b) != lexicographically_less(c, b)) continue;
    const bool c_nearer = lexicographically_less(b, c) == lexicographically_less(c, a);
    return SelfMeeting{Meeting::fold_back, std::min(before, v), std::max(before, v), v, b, c_nearer ? c : a};
  }
  return std::nullopt;
}

/// Where a vertex lies on an edge, the other edge at that vertex may share a whole stretch with it: the better report.
SelfMeeting overlap_rather_than_touch(const Polygon& polygon, const SelfMeeting& touch) {
  const int n = static_cast<int>(polygon.size());
  const int v = touch.vertex, before = v == 0 ? n - 1 : v - 1;
  const int edge = touch.first == v || touch.first == before ? touch.second : touch.first;
  for (const int e : {before, v}) {
    const int i = std::min(e, edge), j = std::max(e, edge);
    if (j - i <= 1 || j - i == n - 1) continue;
    const SelfMeeting m = classify_edges(polygon, i, j);
    if (m.kind == Meeting::overlap) return m;
  }
  return touch;
}

}  // namespace

SelfMeeting classify_edges(const Polygon& polygon, int i, int j) {
  const int n = static_cast<int>(polygon.size());
  const int ends[4] = {i, (i + 1) % n, j, (j + 1) % n};
  const Point &a = polygon[ends[0]], &b = polygon[ends[1]], &c = polygon[ends[2]], &d = polygon[ends[3]];
  SelfMeeting m;
  m.first = i;
  m.second = j;
  const int side[4] = {orientation(c, d, a), orientation(c, d, b), orientation(a, b, c), orientation(a, b, d)};
  if (side[0] * side[1] > 0 || side[2] * side[3] > 0) return m;
  if (side[0] * side[1] < 0 && side[2] * side[3] < 0) {
    m.kind = Meeting::crossing;
    m.from = m.to = crossing_point(a, b, c, d);
    return m;
  }
  if (side[0] == 0 && side[1] == 0) {  // collinear
    const auto low = [](const Point& p, const Point& q) { return lexicographically_less(p, q) ? p : q; };
    const auto high = [](const Point& p, const Point& q) { return lexicographically_less(p, q) ? q : p; };
    const Point from = high(low(a, b), low(c, d)), to = low(high(a, b), high(c, d));
    if (!lexicographically_less(from, to)) return m;
    m.kind = Meeting::overlap;
    m.from = from;
    m.to = to;
    return m;
  }
  for (int k = 0; k < 4; ++k) {
    if (side[k] != 0) continue;  // end k lies on the line of the other edge, whose ends lie on both sides of it?
    if (side[k < 2 ? 2 : 0] * side[k < 2 ? 3 : 1] >= 0) continue;
    m.kind = Meeting::touch;
    m.vertex = ends[k];
    m.from = m.to = polygon[ends[k]];
  }
  return m;
}

std::optional<SelfMeeting> find_self_meeting(const Polygon& polygon, const std::vector<int>& order) {
  if (const std::optional<SelfMeeting> spike = find_fold_back(polygon)) return spike;
  const std::optional<SelfMeeting> meeting = Sweep(polygon, order).run();
  if (meeting && meeting->kind == Meeting::touch) return overlap_rather_than_touch(polygon, *meeting);
  return meeting;
}

}  // namespace taut::internal
