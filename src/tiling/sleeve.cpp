#include "tiling/sleeve.hpp"

#include <algorithm>
#include <cmath>

#include "motion/motion_segment.hpp"
#include "motion/motion_segments.hpp"
#include "motion/pieces.hpp"
#include "numeric/errors.hpp"
#include "scene/placement.hpp"
#include "tiling/geodesic_faces.hpp"
#include "tiling/root_faces.hpp"

namespace taut::internal {
namespace {

constexpr std::uint32_t no_edge = FreeTriangulation::none;

std::uint32_t half_edges(const Arena& arena) { return static_cast<std::uint32_t>(arena.triangulation.origin.size()); }
bool touches_box(const Arena& arena, Gate g) { return arena.in_box(arena.apex(g)); }
/// The gate behind the triangle of g, with the apex as its new left (right) end.
Gate step(const Arena& arena, Gate g, bool new_left) {
  return arena.twin(new_left ? FreeTriangulation::next(g) : FreeTriangulation::previous(g));
}

/// Around infinity behind gate g, whose apex is a corner of the box, and back to where it started.
OpenSleeve::Tail around_infinity(const Arena& arena, Gate g, bool left) {
  OpenSleeve::Tail tail;
  // The box stays on the left (right): its corners are new left (right) ends.
  for (Gate at = step(arena, g, left);; at = step(arena, at, arena.in_box(arena.apex(at)) == left)) {
    if (!tail.gates.empty() && at == tail.gates.front()) return tail;
    tail.gates.push_back(at);
    tail.exit.push_back(touches_box(arena, at));
    if (tail.gates.size() > half_edges(arena)) throw StructureError("no path around the bodies");
  }
}

/// The gates from the triangle of `start` (a gate) to one with a corner of the box, through the region behind `start`;
/// empty if there is none.
std::vector<Gate> way_to_box(const Arena& arena, Gate start) {
  struct Visit {
    Gate gate;
    std::size_t parent;
  };
  std::vector<Visit> visits{{start, 0}};
  for (std::size_t i = 0; i < visits.size(); ++i) {
    const Gate g = visits[i].gate;
    if (touches_box(arena, g)) {
      std::vector<Gate> path;
      for (std::size_t k = i; k != 0; k = visits[k].parent) path.push_back(visits[k].gate);
      path.push_back(start);
      std::reverse(path.begin(), path.end());
      return path;
    }
    for (const bool left : {true, false}) {
      const Gate next = step(arena, g, left);
      // The region is a pocket: a tree of triangles, unless it holds the other polygon.
      if (next != no_edge && arena.owner(arena.origin(next)) == arena.owner(arena.target(next)))
        visits.push_back({next, i});
    }
  }
  return {};
}

/// All edges from P to Q between the two places where the free space between them opens to infinity.
std::vector<Gate> core_of_bay(const Arena& arena, Gate first) {
  std::vector<Gate> core{first};
  while (!touches_box(arena, core.back()))
    core.push_back(step(arena, core.back(), arena.owner(arena.apex(core.back())) == 0));
  return core;
}

/// The edges from P to Q form a loop, because one polygon lies in a pocket of the other. In through the mouth of the
/// pocket, around the loop, and out.
std::vector<Gate> core_of_pocket(const Arena& arena, Gate any) {
  std::vector<Gate> loop;
  for (Gate g = any; loop.empty() || g != any; g = step(arena, g, arena.owner(arena.apex(g)) == 0)) loop.push_back(g);
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const bool left = arena.owner(arena.apex(loop[k])) == 0;
    const std::uint32_t mouth = side_edge(loop[k], left);
    if (arena.twin(mouth) == no_edge) continue;
    const std::vector<Gate> out = way_to_box(arena, arena.twin(mouth));
    if (out.empty()) continue;
    std::vector<Gate> core = reversed(arena, out);
    for (std::size_t i = 1; i <= loop.size(); ++i) core.push_back(loop[(k + i) % loop.size()]);
    core.insert(core.end(), out.begin(), out.end());
    return core;
  }
  throw StructureError("no path from between the bodies to infinity");
}

}  // namespace

std::vector<Gate> reversed(const Arena& arena, const std::vector<Gate>& gates) {
  std::vector<Gate> out;
  out.reserve(gates.size());
  for (std::size_t i = gates.size(); i-- > 0;) out.push_back(arena.twin(gates[i]));
  return out;
}

std::vector<Gate> loop_gates(const Arena& arena, int owner) {
  std::vector<Gate> loop;
  std::size_t edges = 0;
  Gate start = no_edge;
  for (std::uint32_t h = 0; h < half_edges(arena); ++h) {
    if (arena.owner(arena.origin(h)) != owner || arena.owner(arena.target(h)) == owner) continue;
    ++edges;
    start = h;
  }
  if (start == no_edge) return loop;
  for (Gate g = start; loop.empty() || g != start; g = step(arena, g, arena.owner(arena.apex(g)) == owner))
    loop.push_back(g);
  if (loop.size() != edges) loop.clear();
  return loop;
}

OpenSleeve open_sleeve(const Arena& arena) {
  OpenSleeve sleeve;
  Gate first = no_edge, any = no_edge;
  for (std::uint32_t h = 0; h < half_edges(arena) && first == no_edge; ++h) {
    if (arena.owner(arena.origin(h)) != 0 || arena.owner(arena.target(h)) != 1) continue;
    any = h;
    if (touches_box(arena, arena.twin(h))) first = h;
  }
  if (any == no_edge) throw StructureError("no edge between the bodies");
  sleeve.core = first != no_edge ? core_of_bay(arena, first) : core_of_pocket(arena, any);
  for (const bool left : {true, false}) {
    sleeve.tails.push_back(around_infinity(arena, sleeve.core.back(), left));
    const OpenSleeve::Tail back = around_infinity(arena, arena.twin(sleeve.core.front()), left);
    for (std::size_t k = 0; k < back.gates.size(); ++k) {
      if (!back.exit[k]) continue;
      std::vector<Gate> head{side_edge(back.gates[k], left)};
      const std::vector<Gate> in(back.gates.begin(), back.gates.begin() + static_cast<std::ptrdiff_t>(k) + 1);
      const std::vector<Gate> turned = reversed(arena, in);
      head.insert(head.end(), turned.begin(), turned.end());
      sleeve.heads.push_back(head);
    }
  }
  return sleeve;
}

Hourglass::Hourglass(std::vector<Point> left, std::vector<Point> right) {
  for (const Point& p : left) push_left(p, 0);
  for (const Point& p : right) push_right(p, 0);
  find_extremes();
}

/// String points up to `keep` stay.
void Hourglass::push_left(const Point& p, std::size_t keep) {
  if (!left_.empty() && left_.back() == p) return;
  while (left_string_.size() > keep + 1 && left_string_.size() > 1 &&
         orientation(left_point(left_string_.size() - 2), left_point(left_string_.size() - 1), p) < 0) {
    left_string_.pop_back();
  }
  left_string_.push_back(left_.size());
  left_.push_back(p);
}

void Hourglass::push_right(const Point& p, std::size_t keep) {
  if (!right_.empty() && right_.back() == p) return;
  while (right_string_.size() > keep + 1 && right_string_.size() > 1 &&
         orientation(right_point(right_string_.size() - 2), right_point(right_string_.size() - 1), p) > 0) {
    right_string_.pop_back();
  }
  right_string_.push_back(right_.size());
  right_.push_back(p);
}

/// Moves the ends of either line along the strings, in turn, as long as a neighbour is on the wrong side.
void Hourglass::find_extremes() {
  const std::size_t nl = left_string_.size(), nr = right_string_.size();
  std::size_t a = 0, b = 0, c = 0, d = 0;
  // Each move turns the line one way only, so a line comes back only where points coincide.
  std::size_t moves = 4 * (nl + nr) + 16;
  const auto on_wrong_side = [&](const Point& from, const Point& to, const Point& p, int wrong) {
    return orientation(from, to, p) == wrong && moves > 0;
  };
  for (bool moved = true; moved;) {
    moved = false;
    const auto right_wrong = [&](std::size_t i) {
      return on_wrong_side(left_point(a), right_point(b), right_point(i), 1);
    };
    while (b + 1 < nr && right_wrong(b + 1)) ++b, --moves, moved = true;
    while (b > 0 && right_wrong(b - 1)) --b, --moves, moved = true;
    const auto left_wrong = [&](std::size_t i) {
      return on_wrong_side(left_point(a), right_point(b), left_point(i), -1);
    };
    while (a + 1 < nl && left_wrong(a + 1)) ++a, --moves, moved = true;
    while (a > 0 && left_wrong(a - 1)) --a, --moves, moved = true;
  }
  moves = 4 * (nl + nr) + 16;
  for (bool moved = true; moved;) {
    moved = false;
    const auto left_wrong = [&](std::size_t i) {
      return on_wrong_side(right_point(c), left_point(d), left_point(i), -1);
    };
    while (d + 1 < nl && left_wrong(d + 1)) ++d, --moves, moved = true;
    while (d > 0 && left_wrong(d - 1)) --d, --moves, moved = true;
    const auto right_wrong = [&](std::size_t i) {
      return on_wrong_side(right_point(c), left_point(d), right_point(i), 1);
    };
    while (c + 1 < nr && right_wrong(c + 1)) ++c, --moves, moved = true;
    while (c > 0 && right_wrong(c - 1)) --c, --moves, moved = true;
  }
  clockwise_left_ = a;
  clockwise_right_ = b;
  counter_right_ = c;
  counter_left_ = d;
}

Hourglass::Blocked Hourglass::add_left(const Point& p) {
  if (clockwise().side(p) < 0) return Blocked::by_left;
  const bool tighter = counterclockwise().side(p) < 0;
  push_left(p, tighter ? clockwise_left_ : std::max(clockwise_left_, counter_left_));
  if (!tighter) return Blocked::no;
  counter_left_ = left_string_.size() - 1;
  while (counter_right_ + 1 < right_string_.size() && counterclockwise().side(right_point(counter_right_ + 1)) > 0) {
    ++counter_right_;
  }
  return Blocked::no;
}

Hourglass::Blocked Hourglass::add_right(const Point& p) {
  if (counterclockwise().side(p) > 0) return Blocked::by_right;
  const bool tighter = clockwise().side(p) > 0;
  push_right(p, tighter ? counter_right_ : std::max(counter_right_, clockwise_right_));
  if (!tighter) return Blocked::no;
  clockwise_right_ = right_string_.size() - 1;
  while (clockwise_left_ + 1 < left_string_.size() && clockwise().side(left_point(clockwise_left_ + 1)) < 0) {
    ++clockwise_left_;
  }
  return Blocked::no;
}

bool Hourglass::open() const {
  const DirectedLine line = clockwise();
  for (std::size_t i = 0; i < left_string_.size(); ++i) {
    if (line.side(left_point(i)) < 0) return false;
  }
  for (std::size_t i = 0; i < right_string_.size(); ++i) {
    if (line.side(right_point(i)) > 0) return false;
  }
  return true;
}

bool Hourglass::finish(const std::vector<Point>& left, const std::vector<Point>& right) {
  Hourglass next = *this;
  for (const Point& p : left) next.push_left(p, 0);
  for (const Point& p : right) next.push_right(p, 0);
  next.find_extremes();
  if (!next.open()) return false;
  *this = std::move(next);
  return true;
}

DirectedLine Hourglass::middle() const {
  const DirectedLine a = clockwise(), b = counterclockwise();
  const double ax = a.to.x - a.from.x, ay = a.to.y - a.from.y, bx = b.to.x - b.from.x, by = b.to.y - b.from.y;
  const double la = std::sqrt(ax * ax + ay * ay), lb = std::sqrt(bx * bx + by * by), cross = ax * by - ay * bx;
  // Nearly one line, or opposite ones (a base that sees its gate from very near): either will do.
  if (!(std::fabs(cross) > 1e-9 * la * lb)) return a;
  const double share = ((b.from.x - a.from.x) * by - (b.from.y - a.from.y) * bx) / cross;
  const Point meet{a.from.x + share * ax, a.from.y + share * ay};
  const double dx = ax / la + bx / lb, dy = ay / la + by / lb;
  return {{meet.x - dx, meet.y - dy}, {meet.x + dx, meet.y + dy}};
}

namespace {

std::vector<VertexId> relative_hull(const Placement& placement, const FreeTriangulation& triangulation,
                                    const ChainTree& tree, std::uint32_t first_vertex) {
  std::vector<VertexId> hull = geodesics_of_level(placement, triangulation, tree, first_vertex, 0).front();
  hull.pop_back();
  return hull;
}

}  // namespace

std::optional<Arena> make_arena(const Polygon& a, const Polygon& b) {
  Scene scene;
  scene.bodies = {{"a", a, {}}, {"b", b, {}}};
  std::optional<Arena> arena(std::in_place);
  arena->bodies = pair_of(scene);
  std::optional<PairGeometry> geometry = displaced_pair_if_possible(arena->bodies, Offset::inward);
  if (!geometry) return std::nullopt;
  arena->geometry = std::move(*geometry);
  const MotionSegments segments = segments_of(arena->bodies, 0, 0);
  const Placement placement(arena->geometry, segments.front(), 0);
  if (triangulate_free_space(placement, arena->triangulation, true)) return std::nullopt;
  const PairGeometry& g = arena->geometry;
  for (const SharedPolygon& polygon : {g.p(), g.q()}) {
    for (const DisplacedPoint& v : polygon->points) arena->points.push_back({v.x, v.y});
  }
  for (unsigned i = 0; i < 4; ++i) arena->points.push_back(placement.approximate(placement.box_corner(i)));
  const ChainTree tree_p(g.np, node::p_tree), tree_q(g.nq, node::q_tree);
  arena->hulls[0] = relative_hull(placement, arena->triangulation, tree_p, 0);
  arena->hulls[1] = relative_hull(placement, arena->triangulation, tree_q, g.np);
  return arena;
}

}  // namespace taut::internal
