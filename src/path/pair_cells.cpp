#include "path/pair_cells.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/budget.hpp"

namespace taut::internal::path {
namespace {

using spacetime::Box;
using spacetime::BoxNode;
using spacetime::Hierarchy;

/// Runs that swing farther than this share of their size are left to smaller cells.
constexpr double subdivision_threshold = 1.5;
/// So many pairs of runs are tested after one that stays open.
constexpr int most_after_open = 200;
/// So many vertices of a body are tried in search of one inside the other body.
constexpr std::uint32_t most_probes = 64;
/// So many for which more than one point is tried.
constexpr std::uint32_t most_deep_probes = 64;
/// A point nearer to an outline than this is neither inside nor outside.
constexpr double least_depth = 0x1p-36;

double length_of(Vector v) { return std::sqrt(dot(v, v)); }

/// Not longer than 1, so that distances are not overestimated.
Vector unit(Vector v) {
  const double length = length_of(v);
  return length > 0 ? Vector{v.x / length * (1 - 0x1p-45), v.y / length * (1 - 0x1p-45)} : Vector{};
}

Vector scaled(double s, Vector v) { return {s * v.x, s * v.y}; }

double cross_product(Vector a, Vector b) { return a.x * b.y - a.y * b.x; }

Vector nearest_on(Vector at, Vector a, Vector b) {
  const Vector e = b - a;
  const double share = std::clamp(dot(at - a, e) / dot(e, e), 0.0, 1.0);
  return a + scaled(share, e);
}

}  // namespace

/// How the bodies see each other over a cell.
struct PairCells::Seen {
  PairView of_q, of_p;  ///< Q from P, and P from Q

  const PairView& pose(bool p) const { return p ? of_p : of_q; }
};

PairView::PairView(const PoseModel& pose, double reach) : shift_(pose.shift), rotation_(pose.rotation) {
  for (std::size_t k = 0; k < static_cast<std::size_t>(max_joints); ++k) {
    if (l1_norm(shift_.rate[k]) + l1_norm(rotation_.rate[k]) == 0) continue;
    shift_.rate[count_] = shift_.rate[k];
    rotation_.rate[count_] = rotation_.rate[k];
    joint_[count_++] = k;
  }
  slack_ = 0x1p-43 * (1 + shift_.reach() + rotation_.reach() * reach);
}

PairCells::PairCells(const LinkedPair& pair, double clearance)
    : tree_p_(pair.search.tree_p),
      tree_q_(pair.search.tree_q),
      clearance_(clearance),
      reach_p_(reach_of(tree_p_)),
      reach_q_(reach_of(tree_q_)) {
  const PairGeometry& geometry = pair.search.geometry;
  for (std::uint32_t k = 0; k < geometry.size(); ++k) {
    const bool p = k < geometry.np;
    const DisplacedPoint& d = geometry.point(VertexId(k));
    (p ? points_p_ : points_q_).push_back({d.x, d.y});
    (p ? next_p_ : next_q_).push_back(geometry.next(VertexId(k)).value - (p ? 0 : geometry.np));
  }
  for (const RingSpan& ring : rings_of(*geometry.p())) {
    if (!ring.hole) outlines_p_.push_back(ring.first);
  }
  for (const RingSpan& ring : rings_of(*geometry.q())) {
    if (!ring.hole) outlines_q_.push_back(ring.first);
  }
}

/// Depth first. What is neither apart nor crossing stays open. After a while the rest stays open as it is.
bool PairCells::runs_collide(const Seen& seen, Runs& runs, Collision& why, std::vector<Condition>* conditions) const {
  thread_local Runs todo, left;
  todo = runs;
  left.clear();
  int more = most_after_open;
  while (!todo.empty()) {
    checkpoint();
    const auto [i, k] = todo.back();
    todo.pop_back();
    const BoxNode &p = tree_p_.node(i), &q = tree_q_.node(k);
    if (!left.empty() && --more < 0) {
      left.emplace_back(i, k);
      continue;
    }
    if (p.count == 1 && q.count == 1) {
      if (edges_apart(seen.of_q, p.first, q.first)) continue;
      why = {Collision::Kind::crossing, p.first, q.first, false, {}};
      if (cross(seen, p.first, q.first, conditions)) return true;
      if (clearance_ > 0 && near(seen, p.first, q.first, why)) return true;
      left.emplace_back(i, k);
      continue;
    }
    if (apart(seen.of_q, p.box, q.box)) continue;
    const double swing = seen.of_q.swing(seen.of_q.place(q.box.centre));
    if (swing > subdivision_threshold * (p.box.radius + q.box.radius)) {
      left.emplace_back(i, k);
    } else if (divides_first(p, q)) {
      todo.emplace_back(p.right, k);
      todo.emplace_back(p.left, k);
    } else {
      todo.emplace_back(i, q.right);
      todo.emplace_back(i, q.left);
    }
  }
  runs = left;
  return false;
}

CellState PairCells::evaluate(const PoseModel& of_q, OpenFeatures& open, Collision* why,
                              std::vector<Condition>* conditions) const {
  Collision unused;
  Collision& reason = why ? *why : unused;
  const Seen seen{PairView(of_q, reach_q_), PairView(of_q.inverse(), reach_p_)};
  const auto inside = [&] {
    reason = {Collision::Kind::inside, 0, 0, open.inner->of_p, open.inner->at};
    return CellState::colliding;
  };
  if (open.inner && stays_inside(seen, *open.inner)) return inside();
  if (runs_collide(seen, open.runs, reason, conditions)) return CellState::colliding;
  if (!open.runs.empty()) return find_inside(seen, open) ? inside() : CellState::undecided;
  return containment(seen, open) == CellState::colliding ? inside() : CellState::free;
}

/// Is there a direction along which Q's box is beyond P's, for all joint values? A box is beyond where its corners are.
bool PairCells::apart(const PairView& seen, const Box& p, const Box& q) const {
  const PairView::Place centre = seen.place(q.centre);
  const Vector relative = centre.value - p.centre;
  const double need = seen.slack() + clearance_;
  if (length_of(relative) - seen.swing(centre) - p.radius - q.radius > need) return true;
  const PairView::Place length = seen.turn(scaled(q.half_length, q.along)),
                        width = seen.turn(scaled(q.half_width, turned(q.along)));
  const double error = centre.error + length.error + width.error;
  const auto beyond = [&](Vector n) {
    if (dot(n, relative) < 0) n = -n;
    double gap = dot(n, relative) - error - std::fabs(dot(n, p.along)) * p.half_length -
                 std::fabs(dot(n, turned(p.along))) * p.half_width;
    double corner = INFINITY;
    for (const double s : {1.0, -1.0}) {
      for (const double t : {1.0, -1.0}) {
        double least = s * dot(n, length.value) + t * dot(n, width.value);
        for (std::size_t k = 0; k < seen.count(); ++k)
          least -= std::fabs(dot(n, centre.rate[k]) + s * dot(n, length.rate[k]) + t * dot(n, width.rate[k]));
        corner = std::min(corner, least);
      }
    }
    return gap + corner > need;
  };
  const Vector rotation = seen.rotation();
  return beyond(unit(turned(p.along))) || beyond(unit(rotation * turned(q.along))) || beyond(unit(relative)) ||
         beyond(unit(p.along)) || beyond(unit(rotation * q.along));
}

/// Two segments that do not meet are apart along a normal of one of them, or along it. Where a distance is to be kept,
/// the direction between their nearest points counts as well.
bool PairCells::edges_apart(const PairView& seen, std::uint32_t p, std::uint32_t q) const {
  const Vector a = points_p_[p], b = points_p_[next_p_[p]];
  const PairView::Place c = seen.place(points_q_[q]), d = seen.place(points_q_[next_q_[q]]);
  const double need = seen.slack() + clearance_;
  const auto beyond = [&](Vector n) {
    const auto least = [&](double sign) {
      const double ends = std::max(sign * dot(n, a), sign * dot(n, b));
      const double from_c = sign * dot(n, c.value) - seen.spread(n, c) - c.error;
      const double from_d = sign * dot(n, d.value) - seen.spread(n, d) - d.error;
      return std::min(from_c, from_d) - ends;
    };
    return least(1) > need || least(-1) > need;
  };
  const Vector e = b - a, f = d.value - c.value;
  if (beyond(unit(turned(e))) || beyond(unit(turned(f))) || beyond(unit(e)) || beyond(unit(f))) return true;
  const std::array<Vector, 4> ways = {c.value - nearest_on(c.value, a, b), d.value - nearest_on(d.value, a, b),
                                      a - nearest_on(a, c.value, d.value), b - nearest_on(b, c.value, d.value)};
  const auto shorter = [](Vector u, Vector v) { return dot(u, u) < dot(v, v); };
  return beyond(unit(*std::min_element(ways.begin(), ways.end(), shorter)));
}

/// Do two edges cross for all joint values: are the ends of each on either side of the other one's line? Where three
/// ends are on the right sides, the fourth one makes a condition.
bool PairCells::cross(const Seen& seen, std::uint32_t p, std::uint32_t q, std::vector<Condition>* conditions) const {
  struct End {
    double at = 0, off = 0;
    Vector normal;
    PairView::Place place;
    int side() const { return at > off ? 1 : at < -off ? -1 : 0; }
  };
  // Of P's edge, then of Q's.
  std::array<End, 4> ends;
  int uncertain = 0;
  std::size_t fourth = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const bool of_p = i < 2;
    const std::uint32_t own = of_p ? p : q, other = of_p ? q : p;
    const Vector a = points(!of_p)[other], b = points(!of_p)[next(!of_p)[other]];
    const PairView& pose = seen.pose(of_p);
    End& end = ends[i];
    end.normal = unit(turned(b - a));
    end.place = pose.place(points(of_p)[i % 2 ? next(of_p)[own] : own]);
    end.at = dot(end.normal, end.place.value - a);
    end.off = pose.spread(end.normal, end.place) + end.place.error + pose.slack();
    if (end.side() != 0) continue;
    if (++uncertain > 1) return false;
    fourth = i;
  }
  const bool p_split = ends[0].side() * ends[1].side() < 0, q_split = ends[2].side() * ends[3].side() < 0;
  if (uncertain == 0) return p_split && q_split;
  if (!conditions || !(fourth < 2 ? q_split : p_split)) return false;
  // The edges cross where the fourth end is on the other side than its neighbour.
  const End& end = ends[fourth];
  const double sign = ends[fourth ^ 1U].side();
  const PairView& pose = seen.pose(fourth < 2);
  Condition condition{sign * end.at + end.place.error + pose.slack(), {}, 0, p, q, fourth < 2, fourth % 2 == 1};
  for (std::size_t k = 0; k < pose.count(); ++k)
    condition.rate[pose.joint(k)] = sign * dot(end.normal, end.place.rate[k]);
  conditions->push_back(condition);
  return false;
}

bool PairCells::near_vertex(const PairView& seen, Vector a, Vector b, Vector vertex) const {
  const PairView::Place z = seen.place(vertex);
  const Vector away = z.value - nearest_on(z.value, a, b);
  // Where the vertex is on the edge, any direction and the one across it do.
  const Vector n = length_of(away) > 0x1p-40 ? unit(away) : Vector{1, 0}, t = turned(n);
  const double along = length_of(away) + seen.spread(n, z) + z.error + seen.slack();
  const double across = seen.spread(t, z) + z.error + seen.slack();
  return std::sqrt(along * along + across * across) * (1 + 0x1p-40) < clearance_;
}

/// Is a vertex of one edge nearer to the other edge than the clearance, for all joint values?
bool PairCells::near(const Seen& seen, std::uint32_t p, std::uint32_t q, Collision& why) const {
  for (const bool vertex_of_p : {true, false}) {
    const std::uint32_t own = vertex_of_p ? p : q, other = vertex_of_p ? q : p;
    const Vector a = points(!vertex_of_p)[other], b = points(!vertex_of_p)[next(!vertex_of_p)[other]];
    for (const std::uint32_t v : {own, next(vertex_of_p)[own]}) {
      if (!near_vertex(seen.pose(vertex_of_p), a, b, points(vertex_of_p)[v])) continue;
      why = {Collision::Kind::near, vertex_of_p ? v : other, vertex_of_p ? other : v, vertex_of_p, {}};
      return true;
    }
  }
  return false;
}

/// Is the point inside the body? It must not be as near to an edge as doubles round.
bool PairCells::goes_around(bool p, Vector at) const {
  const std::vector<Vector>& ring = points(p);
  const std::vector<std::uint32_t>& after = next(p);
  int turns = 0;
  for (std::uint32_t k = 0; k < ring.size(); ++k) {
    const Vector a = ring[k], b = ring[after[k]];
    if ((a.y > at.y) == (b.y > at.y)) continue;
    const double side = cross_product(b - a, at - a);
    if (b.y > a.y && side > 0) ++turns;
    if (b.y < a.y && side < 0) --turns;
  }
  return turns > 0;
}

/// Does an edge of the body come as near to the point as this? `spread(n)`: how far, and less far than that, the point
/// may be moved along n.
template <class Spread>
bool PairCells::is_near_edge(bool p, Vector at, double distance, const Spread& spread) const {
  const Hierarchy& tree = p ? tree_p_ : tree_q_;
  thread_local std::vector<std::uint32_t> todo;
  todo.assign(1, 0);
  while (!todo.empty()) {
    const BoxNode& node = tree.node(todo.back());
    todo.pop_back();
    const Vector away = at - node.box.centre;
    const double reach = node.box.radius + distance;
    if (dot(away, away) > reach * reach * (1 + 0x1p-40)) continue;
    if (node.count > 1) {
      todo.push_back(node.left);
      todo.push_back(node.right);
      continue;
    }
    const Vector a = points(p)[node.first], b = points(p)[next(p)[node.first]], gap = at - nearest_on(at, a, b);
    if (dot(gap, gap) > distance * distance) continue;
    // The edge is beyond a direction where both of its ends are.
    const auto beyond = [&](Vector n) { return std::min(dot(n, at - a), dot(n, at - b)) > spread(n); };
    const Vector across = unit(turned(b - a));
    if (!beyond(dot(across, gap) > 0 ? across : -across) && !beyond(unit(gap))) return true;
  }
  return false;
}

/// Is the point inside the body, and farther from its edges than this?
template <class Spread>
bool PairCells::is_deep(bool in_p, Vector at, double distance, const Spread& spread) const {
  const BoxNode& all = (in_p ? tree_p_ : tree_q_).node(0);
  const Vector away = at - all.box.centre;
  if (dot(away, away) > all.box.radius * all.box.radius) return false;
  // Of few edges, most points are found to be outside sooner than near.
  constexpr std::size_t few = 64;
  if (points(in_p).size() <= few && !goes_around(in_p, at)) return false;
  return !is_near_edge(in_p, at, distance, spread) && (points(in_p).size() <= few || goes_around(in_p, at));
}

bool PairCells::stays_inside(const Seen& seen, const OpenFeatures::Inner& inner) const {
  const PairView& pose = seen.pose(inner.of_p);
  const PairView::Place at = pose.place(inner.at);
  const double margin = at.error + pose.slack() + least_depth;
  return is_deep(!inner.of_p, at.value, pose.swing(at) + pose.slack() + least_depth,
                 [&](Vector n) { return (pose.spread(n, at) + margin) * (1 + 0x1p-40); });
}

/// Outlines that meet no edge of the other body for any joint values are inside or outside for all, if they are for
/// one.
CellState PairCells::containment(const Seen& seen, OpenFeatures& open) const {
  for (const bool of_p : {true, false}) {
    for (const std::uint32_t v : of_p ? outlines_p_ : outlines_q_) {
      const Vector at = seen.pose(of_p).place(points(of_p)[v]).value;
      if (!goes_around(!of_p, at)) continue;
      open.inner = {of_p, points(of_p)[v]};
      return CellState::colliding;
    }
  }
  return CellState::free;
}

/// Of some vertices of both bodies, one that is inside the other body for all joint values.
bool PairCells::find_inside(const Seen& seen, OpenFeatures& open) const {
  for (const bool of_p : {true, false}) {
    const auto n = static_cast<std::uint32_t>(points(of_p).size());
    const std::uint32_t step = std::max<std::uint32_t>(1, n / most_probes);
    for (std::uint32_t v = 0; v < n; v += step) {
      const OpenFeatures::Inner inner{of_p, points(of_p)[v]};
      if (!stays_inside(seen, inner)) continue;
      open.inner = inner;
      return true;
    }
  }
  return false;
}

bool PairCells::find_deep(const PoseModel& of_q, OpenFeatures& open) const {
  const Seen seen{PairView(of_q, reach_q_), PairView(of_q.inverse(), reach_p_)};
  for (const bool of_p : {true, false}) {
    const std::vector<Vector>& ring = points(of_p);
    const PairView& pose = seen.pose(of_p);
    const auto n = static_cast<std::uint32_t>(ring.size());
    const std::uint32_t step = std::max<std::uint32_t>(1, n / most_deep_probes);
    for (std::uint32_t k = 0; k < n; k += step) {
      checkpoint();
      const std::uint32_t v = next(of_p)[k];
      const Vector before = ring[k], at = ring[v], after = ring[next(of_p)[v]];
      const Vector inwards = turned(unit(at - before)) + turned(unit(after - at));
      const double swing = pose.swing(pose.place(at)) + pose.slack() + least_depth;
      for (const double share : {3.0, 12.0, 48.0}) {
        const Vector inner = at + scaled(share * swing, inwards);
        if (!stays_inside(seen, {of_p, inner}) ||
            !is_deep(of_p, inner, least_depth, [](Vector) { return least_depth; }))
          continue;
        open.inner = {of_p, inner};
        return true;
      }
    }
  }
  return false;
}

std::array<double, max_joints> PairCells::effect(const PoseModel& of_q, const PoseModel& rest,
                                                 const std::array<PoseModel, max_joints>& held,
                                                 const OpenFeatures& open) const {
  constexpr std::size_t most_runs = 16;
  constexpr double more_than_rounding = 0x1p-40;
  const std::size_t step = std::max<std::size_t>(1, open.runs.size() / most_runs);
  std::array<double, max_joints> most{};
  for (std::size_t i = 0; i < open.runs.size(); i += step) {
    const Box& q = tree_q_.node(open.runs[i].second).box;
    const JointModel centre = of_q.place(q.centre);
    // To first order that may be 0 at the middle and matter nevertheless: then it is what the model leaves out.
    const auto left_out = [&](const PoseModel& pose) {
      return pose.place(q.centre).error + pose.rotation.error * q.radius;
    };
    const double all = left_out(of_q);
    const bool rounding = all <= more_than_rounding * (centre.reach() + of_q.rotation.reach() * q.radius);
    for (std::size_t k = 0; k < most.size(); ++k) {
      const double first = length_of(centre.rate[k]) + length_of(of_q.rotation.rate[k]) * q.radius;
      const double more = rounding ? 0 : left_out(rest) + std::max(0.0, all - left_out(held[k]));
      most[k] = std::max(most[k], first + more);
    }
  }
  return most;
}

}  // namespace taut::internal::path
