#include "query/cell_pair.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/budget.hpp"
#include "taut/error.hpp"

namespace taut::internal {
namespace {

using spacetime::Box;
using spacetime::BoxNode;
using spacetime::Hierarchy;

/// More than what rounds in the few operations on models and boxes, as a share of coordinates up to 1.
constexpr double rounding_slack = 0x1p-44;
/// Boxes that swing farther than this share of their size are left to smaller cells.
constexpr double subdivision_threshold_of_cells = 1.5;
/// So many pairs of ranges are evaluated after one that stays open.
constexpr int most_after_open = 256;
/// So many points of a body are tried in search of one that is deep inside the other one.
constexpr std::uint32_t most_probes = 256;
/// Besides the vertices, points inside of them by these shares of the shorter edge there.
constexpr double insets[] = {0x1p-2, 0x1p-6, 0x1p-10};
/// Points nearer to an outline than this are neither inside nor outside.
constexpr double least_depth = 0x1p-36;

double length_of(Vector v) { return std::sqrt(dot(v, v)); }

Vector unit(Vector v) {
  const double length = length_of(v);
  // Not longer than 1, so that distances are not overestimated.
  return length > 0 ? Vector{v.x / length * (1 - 0x1p-45), v.y / length * (1 - 0x1p-45)} : Vector{};
}

/// The least value of n . z over the cell.
double least_along(Vector n, const JointModel& z) {
  double least = dot(n, z.value) - z.error;
  for (const Vector& r : z.rate) least -= std::fabs(dot(n, r));
  return least;
}

/// From a point to the nearest edge below a node; nothing farther than `best` is searched.
class NearestEdge {
 public:
  NearestEdge(const Hierarchy& tree, Vector at) : tree_(tree), at_(at) {}

  template <class Ends>
  double distance(const Ends& ends) {
    visit(0, ends);
    return best_;
  }

 private:
  double bound(const BoxNode& node) const { return length_of(at_ - node.box.centre) - node.box.radius; }
  template <class Ends>
  void visit(std::uint32_t i, const Ends& ends) {
    const BoxNode& node = tree_.node(i);
    if (bound(node) > best_) return;
    if (node.count == 1) {
      const auto [a, b] = ends(node.first);
      const Vector e = b - a, w = at_ - a;
      const double share = std::clamp(dot(w, e) / dot(e, e), 0.0, 1.0);
      best_ = std::min(best_, length_of(w - Vector{share * e.x, share * e.y}));
      return;
    }
    const bool left_first = bound(tree_.node(node.left)) < bound(tree_.node(node.right));
    visit(left_first ? node.left : node.right, ends);
    visit(left_first ? node.right : node.left, ends);
  }

  const Hierarchy& tree_;
  Vector at_;
  double best_ = INFINITY;
};

}  // namespace

/// How the bodies see each other over a cell.
struct CellPair::Seen {
  PoseModel of_q, of_p;  ///< Q from P, and P from Q

  const PoseModel& pose(bool p) const { return p ? of_p : of_q; }
};

std::vector<std::uint32_t> CellPair::outlines(const DisplacedPolygon& body) {
  if (body.rings.empty()) return {0};
  std::vector<std::uint32_t> first;
  for (const RingSpan& ring : body.rings) {
    if (!ring.hole) first.push_back(ring.first);
  }
  return first;
}

CellState CellPair::evaluate(const PoseModel& of_q, std::optional<InnerPoint>& hint) const {
  const Seen seen{of_q, of_q.inverse()};
  if (hint && stays_inside(seen, *hint)) return CellState::colliding;
  switch (look_at_ranges(seen)) {
    case Ranges::apart:
      return containment(seen);
    case Ranges::crossing:
      return CellState::colliding;
    case Ranges::open:
      break;
  }
  if (find_inner(seen, hint) && stays_inside(seen, *hint)) return CellState::colliding;
  return CellState::undecided;
}

/// Depth first. With the first pair of ranges that stays open the cell is not free; for a while two edges are searched
/// for that cross.
CellPair::Ranges CellPair::look_at_ranges(const Seen& seen) const {
  thread_local std::vector<std::pair<std::uint32_t, std::uint32_t>> todo;
  todo.assign(1, {0, 0});
  int more = most_after_open;
  while (!todo.empty() && more > 0) {
    checkpoint();
    if (more < most_after_open) --more;
    const auto [i, k] = todo.back();
    todo.pop_back();
    const BoxNode &p = trees_.p.node(i), &q = trees_.q.node(k);
    if (separated(seen, p.box, q.box)) continue;
    if (p.count == 1 && q.count == 1) {
      if (cross(seen, p.first, q.first)) return Ranges::crossing;
      more = std::min(more, most_after_open - 1);
      continue;
    }
    if (seen.of_q.place(q.box.centre).swing() > subdivision_threshold_of_cells * (p.box.radius + q.box.radius))
      return Ranges::open;
    if (divides_first(p, q)) {
      todo.emplace_back(p.right, k);
      todo.emplace_back(p.left, k);
    } else {
      todo.emplace_back(i, q.right);
      todo.emplace_back(i, q.left);
    }
  }
  return more == most_after_open ? Ranges::apart : Ranges::open;
}

/// Is there a direction along which Q's box is beyond P's, at all joint values? A box is beyond where its corners are.
bool CellPair::separated(const Seen& seen, const Box& p, const Box& q) const {
  const JointModel centre = seen.of_q.place(q.centre);
  const Vector relative = centre.value - p.centre;
  if (length_of(relative) - centre.swing() - p.radius - q.radius > rounding_slack * (1 + centre.reach())) return true;
  const auto side_of = [&](Vector along, double half) {
    return seen.of_q.rotation * JointModel::constant({half * along.x, half * along.y});
  };
  const JointModel length = side_of(q.along, q.half_length), width = side_of(turned(q.along), q.half_width);
  const auto beyond = [&](Vector n) {
    if (dot(n, relative) < 0) n = -n;
    const double edge = dot(n, p.centre) + std::fabs(dot(n, p.along)) * p.half_length +
                        std::fabs(dot(n, turned(p.along))) * p.half_width;
    double gap = INFINITY;
    for (const JointModel& end : {centre + length, centre - length}) {
      gap = std::min({gap, least_along(n, end + width), least_along(n, end - width)});
    }
    return gap - edge > rounding_slack * (1 + centre.reach());
  };
  const Vector rotation = seen.of_q.rotation.value;
  return beyond(unit(turned(p.along))) || beyond(unit(rotation * turned(q.along))) || beyond(unit(relative)) ||
         beyond(unit(p.along)) || beyond(unit(rotation * q.along));
}

/// Do two edges cross at all joint values: are the ends of each on either side of the other one's line?
bool CellPair::cross(const Seen& seen, std::uint32_t p, std::uint32_t q) const {
  const auto splits = [&](bool edge_of_p, std::uint32_t edge, std::uint32_t other) {
    const Vector a = point(edge_of_p, edge), b = point(edge_of_p, next(edge_of_p, edge));
    const Vector n = turned(b - a);
    const PoseModel& pose = seen.pose(!edge_of_p);
    const auto side = [&](std::uint32_t v) {
      const JointModel relative = pose.place(point(!edge_of_p, v)) - JointModel::constant(a);
      const double room = rounding_slack * (1 + relative.reach()) * length_of(n);
      const JointModel scaled{relative.value, relative.rate, relative.error * length_of(n)};
      return least_along(n, scaled) > room ? 1 : least_along(-n, scaled) > room ? -1 : 0;
    };
    return side(other) * side(next(!edge_of_p, other)) < 0;
  };
  return splits(true, p, q) && splits(false, q, p);
}

namespace {

/// How often a body's boundary, given by its directed edges, goes around a point.
class Winding {
 public:
  explicit Winding(Vector at) : at_(at) {}
  void add(Vector a, Vector b) {
    if ((a.y > at_.y) == (b.y > at_.y)) return;
    const Vector e = b - a, w = at_ - a;
    const double side = e.x * w.y - e.y * w.x;
    if (std::fabs(side) <= 0x1p-48) unknown_ = true;
    if (b.y > a.y && side > 0) ++turns_;
    if (b.y < a.y && side < 0) --turns_;
  }
  bool unknown() const { return unknown_; }
  bool inside() const { return turns_ > 0; }

 private:
  Vector at_;
  int turns_ = 0;
  bool unknown_ = false;
};

}  // namespace

/// Outlines that meet no edge of the other body for any joint values are inside or outside for all, if they are for
/// one.
CellState CellPair::containment(const Seen& seen) const {
  for (const bool of_p : {true, false}) {
    for (const std::uint32_t v : outlines_[of_p ? 0 : 1]) {
      const Vector at = seen.pose(of_p).place(point(of_p, v)).value;
      Winding winding(at);
      const std::uint32_t n = of_p ? geometry_.nq : geometry_.np;
      for (std::uint32_t k = 0; k < n; ++k) winding.add(point(!of_p, k), point(!of_p, next(!of_p, k)));
      if (winding.unknown()) return CellState::undecided;
      if (winding.inside()) return CellState::colliding;
    }
  }
  return CellState::free;
}

double CellPair::depth_in(bool p, Vector at) const {
  const Hierarchy& tree = p ? trees_.p : trees_.q;
  if (length_of(at - tree.node(0).box.centre) > tree.node(0).box.radius) return 0;
  Winding winding(at);
  const std::uint32_t n = p ? geometry_.np : geometry_.nq;
  for (std::uint32_t k = 0; k < n; ++k) winding.add(point(p, k), point(p, next(p, k)));
  if (winding.unknown() || !winding.inside()) return 0;
  const auto ends = [&](std::uint32_t k) { return std::pair(point(p, k), point(p, next(p, k))); };
  const double depth = NearestEdge(tree, at).distance(ends);
  return depth > least_depth ? depth : 0;
}

/// Vertices, and points that are certainly inside the body, near them: material is to the left of every edge.
std::vector<Vector> CellPair::probes(bool of_p) const {
  const std::uint32_t n = of_p ? geometry_.np : geometry_.nq;
  constexpr auto of_one = static_cast<std::uint32_t>(1 + std::size(insets));
  const std::uint32_t step = std::max<std::uint32_t>(1, n * of_one / most_probes);
  std::vector<Vector> found;
  for (std::uint32_t v = 0; v < n; v += step) {
    const Vector before = point(of_p, v), at = point(of_p, next(of_p, v)),
                 after = point(of_p, next(of_p, next(of_p, v)));
    found.push_back(at);
    const Vector inwards = turned(unit(at - before)) + turned(unit(after - at));
    const double edge = std::min(length_of(at - before), length_of(after - at));
    for (const double inset : insets) {
      const Vector inner{at.x + inset * edge * inwards.x, at.y + inset * edge * inwards.y};
      if (depth_in(of_p, inner) > 0) found.push_back(inner);
    }
  }
  return found;
}

bool CellPair::stays_inside(const Seen& seen, const InnerPoint& inner) const {
  const JointModel at = seen.pose(inner.of_p).place(probes_[inner.of_p ? 0 : 1][inner.index]);
  return depth_in(!inner.of_p, at.value) - at.swing() > least_depth;
}

/// Of the points of both bodies, the one that is deepest inside the other body at the cell's middle.
bool CellPair::find_inner(const Seen& seen, std::optional<InnerPoint>& hint) const {
  double deepest = 0;
  for (const bool of_p : {true, false}) {
    const std::vector<Vector>& points = probes_[of_p ? 0 : 1];
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      const double depth = depth_in(!of_p, seen.pose(of_p).place(points[i]).value);
      if (!(depth > deepest)) continue;
      deepest = depth;
      hint = InnerPoint{of_p, i};
    }
  }
  return deepest > 0;
}

namespace {

constexpr std::size_t most_marked = std::size_t{1} << 26;
constexpr double farthest_cell = 0x1p30;

int cell_of(double x) {
  if (!(std::fabs(x) < farthest_cell))
    throw InputError("cells", "the body goes beyond 2^30 cells from the grid's origin",
                     "choose larger cells, or an origin nearer to the body");
  return static_cast<int>(std::floor(x));
}

double squared_to_segment(const Point& p, const Point& a, const Point& b) {
  const double ux = b.x - a.x, uy = b.y - a.y, vx = p.x - a.x, vy = p.y - a.y;
  const double square = ux * ux + uy * uy;
  const double share = square > 0 ? std::clamp((vx * ux + vy * uy) / square, 0.0, 1.0) : 0;
  const double dx = vx - share * ux, dy = vy - share * uy;
  return dx * dx + dy * dy;
}

double squared_to_cell(const Point& p, double x, double y) {
  const double dx = std::max({x - p.x, 0.0, p.x - (x + 1)}), dy = std::max({y - p.y, 0.0, p.y - (y + 1)});
  return dx * dx + dy * dy;
}

/// Is the cell with its lower left corner at (x, y) at most that far from the segment?
bool near_segment(double x, double y, const Point& a, const Point& b, double margin) {
  const double square = margin * margin;
  if (squared_to_cell(a, x, y) <= square || squared_to_cell(b, x, y) <= square) return true;
  const Point corners[4] = {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}};
  int left = 0;
  for (const Point& c : corners) {
    if (squared_to_segment(c, a, b) <= square) return true;
    if ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0) ++left;
  }
  // No end is near and no corner is: it is only near if it goes through, with corners on both sides of it.
  return left > 0 && left < 4 && std::max(a.x, b.x) >= x && std::min(a.x, b.x) <= x + 1 && std::max(a.y, b.y) >= y &&
         std::min(a.y, b.y) <= y + 1;
}

}  // namespace

void CellRaster::mark(int i, int j) {
  marked_.insert(static_cast<std::uint64_t>(static_cast<std::uint32_t>(j)) << 32 | static_cast<std::uint32_t>(i));
  if (marked_.size() > most_marked)
    throw InputError("cells", "there are more than 2^26 cells", "choose larger ones, or a shorter motion");
}

/// Row by row, the cells that the segment, made wider, may come to; each is tested.
void CellRaster::add_edge(const Point& a, const Point& b, double margin) {
  const Point &low = a.y <= b.y ? a : b, &high = a.y <= b.y ? b : a;
  const double rise = high.y - low.y;
  for (int j = cell_of(low.y - margin); j <= cell_of(high.y + margin); ++j) {
    const double from = std::clamp(j - margin, low.y, high.y), to = std::clamp(j + 1 + margin, low.y, high.y);
    // On a segment that hardly rises, all of it is in the row.
    const bool flat = !(rise > 0x1p-20);
    const double x0 = flat ? low.x : low.x + (from - low.y) / rise * (high.x - low.x);
    const double x1 = flat ? high.x : low.x + (to - low.y) / rise * (high.x - low.x);
    const int last = cell_of(std::max(x0, x1) + 2 * margin);
    for (int i = cell_of(std::min(x0, x1) - 2 * margin); i <= last; ++i) {
      if (near_segment(i, j, a, b, margin)) mark(i, j);
    }
  }
}

/// Cells whose middles are inside. Those with a middle on the boundary are near it, and marked already.
void CellRaster::add_inside(const std::vector<Polygon>& rings) {
  double lo = INFINITY, hi = -INFINITY;
  for (const Point& p : rings[0]) {
    lo = std::min(lo, p.y);
    hi = std::max(hi, p.y);
  }
  std::vector<double> crossings;
  for (int j = cell_of(lo); j <= cell_of(hi); ++j) {
    const double y = j + 0.5;
    crossings.clear();
    for (const Polygon& ring : rings) {
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const Point &a = ring[k], &b = ring[(k + 1) % ring.size()];
        if ((a.y > y) != (b.y > y)) crossings.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
      }
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
      const int last = cell_of(crossings[k + 1] - 0.5);
      for (int i = cell_of(std::ceil(crossings[k] - 0.5)); i <= last; ++i) mark(i, j);
    }
  }
}

void CellRaster::add(const std::vector<std::vector<Polygon>>& parts, double margin, double slack) {
  for (const std::vector<Polygon>& rings : parts) {
    for (const Polygon& ring : rings) {
      for (std::size_t k = 0; k < ring.size(); ++k) add_edge(ring[k], ring[(k + 1) % ring.size()], margin + slack);
    }
    add_inside(rings);
  }
}

std::vector<std::array<int, 2>> CellRaster::sorted() const {
  std::vector<std::array<int, 2>> cells;
  cells.reserve(marked_.size());
  for (const std::uint64_t key : marked_)
    cells.push_back({static_cast<int>(static_cast<std::uint32_t>(key)), static_cast<int>(key >> 32)});
  std::sort(cells.begin(), cells.end(),
            [](const auto& a, const auto& b) { return a[1] != b[1] ? a[1] < b[1] : a[0] < b[0]; });
  return cells;
}

}  // namespace taut::internal
