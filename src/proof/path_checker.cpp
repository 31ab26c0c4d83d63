#include "proof/path_checker.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/predicates.hpp"
#include "scene/ring_set.hpp"
#include "taut/error.hpp"

namespace taut::internal::proof {
namespace {

/// Scaled by this, what is bounded from below by a few operations on coordinates stays below.
constexpr double path_rounding = 0x1p-44;

/// How far s is to the left of the line from a to b, times its length.
CellFunction left_of(const Point& a, const Point& b, const CellPoint& s) {
  const CellFunction ex = CellFunction::constant(b.x) - CellFunction::constant(a.x),
                     ey = CellFunction::constant(b.y) - CellFunction::constant(a.y);
  return ex * (s.y - CellFunction::constant(a.y)) - ey * (s.x - CellFunction::constant(a.x));
}

Point nearest_on_edge(const Point& p, const Point& a, const Point& b) {
  const double ex = b.x - a.x, ey = b.y - a.y, length = ex * ex + ey * ey;
  const double share = length > 0 ? std::clamp(((p.x - a.x) * ex + (p.y - a.y) * ey) / length, 0.0, 1.0) : 0;
  return {a.x + share * ex, a.y + share * ey};
}

}  // namespace

PathChecker::PathChecker(const PathProblem& problem, double clearance)
    : problem_(problem), clearance_(clearance), bodies_(problem) {}

std::optional<PathChecker::EdgeOfPart> PathChecker::edge(const PathFeature& feature) const {
  if (feature.body >= bodies_.size()) return std::nullopt;
  std::size_t left = feature.vertex;
  for (const PartShape& part : bodies_[feature.body].parts) {
    for (const Polygon& ring : part.rings) {
      const std::size_t n = ring.size();
      if (left < n) return EdgeOfPart{{ring[left], ring[(left + 1) % n]}, part.z};
      left -= n;
    }
  }
  return std::nullopt;
}

CellPose PathChecker::pose(const CellValues& values, const std::vector<int>& chain) const {
  CellPose whole;
  for (const int body : chain) {
    if (bodies_.moves(body)) whole = values.pose(*problem_.linkage.motions[static_cast<std::size_t>(body)]).of(whole);
  }
  return whole;
}

CellPose PathChecker::seen(const CellValues& values, std::uint32_t from, std::uint32_t body) const {
  std::vector<int> own = bodies_[body].chain, other = bodies_[from].chain;
  while (!own.empty() && !other.empty() && own.back() == other.back()) {
    own.pop_back();
    other.pop_back();
  }
  return pose(values, other).inverse().of(pose(values, own));
}

std::optional<std::array<CellFunction, 4>> PathChecker::sides(const CellValues& values,
                                                              const PathCrossing& crossing) const {
  const auto of_first = edge(crossing.first), of_second = edge(crossing.second);
  const std::uint32_t a = crossing.first.body, b = crossing.second.body;
  if (!of_first || !of_second || !of_first->z.meet(of_second->z) || !bodies_.is_tested(a, b)) return std::nullopt;
  const Segment &first = of_first->ends, &second = of_second->ends;
  const CellPose to_second = seen(values, b, a), to_first = seen(values, a, b);
  return std::array<CellFunction, 4>{left_of(second[0], second[1], to_second.place(first[0])),
                                     left_of(second[0], second[1], to_second.place(first[1])),
                                     left_of(first[0], first[1], to_first.place(second[0])),
                                     left_of(first[0], first[1], to_first.place(second[1]))};
}

namespace {

int sign_of(const CellValues& values, const CellFunction& f) {
  return values.least(f) > 0 ? 1 : values.largest(f) < 0 ? -1 : 0;
}

}  // namespace

/// The ends of each edge are on either side of the other one's line.
bool PathChecker::crosses(const CellValues& values, const PathCrossing& crossing) const {
  const auto ends = sides(values, crossing);
  if (!ends) return false;
  std::array<int, 4> sign{};
  for (std::size_t i = 0; i < 4; ++i) sign[i] = sign_of(values, (*ends)[i]);
  return sign[0] * sign[1] < 0 && sign[2] * sign[3] < 0;
}

/// Of each crossing, three ends are on the right sides for all values. So where the fourth one is on the other side
/// than its neighbour, the edges cross. At a value where nothing collides, none of the fourth ends is: a sum of these
/// functions, times positive weights, is not negative there. But it is for all values in the cell.
bool PathChecker::exclude_each_other(const CellValues& values, const std::vector<PathCrossing>& crossings) const {
  CellFunction sum = CellFunction::constant(0);
  for (const PathCrossing& crossing : crossings) {
    if (!(crossing.weight >= 0) || !std::isfinite(crossing.weight) || crossing.end > 3) return false;
    const auto ends = sides(values, crossing);
    if (!ends) return false;
    const std::size_t fourth = crossing.end, neighbour = fourth ^ 1U, other = fourth < 2 ? 2 : 0;
    const int side = sign_of(values, (*ends)[neighbour]);
    if (side == 0 || sign_of(values, (*ends)[other]) * sign_of(values, (*ends)[other + 1]) >= 0) return false;
    sum = sum + CellFunction::constant(side * crossing.weight) * (*ends)[fourth];
  }
  return !crossings.empty() && values.largest(sum) < 0;
}

/// Is the point in the part? `strictly`: not on its boundary.
bool PathChecker::holds_point(const PartShape& part, const Point& p, bool strictly) {
  for (std::size_t i = 0; i < part.rings.size(); ++i) {
    // The first ring is the outline, the others are holes.
    const int side = i == 0 ? side_of_ring(part.rings[i], p) : -side_of_ring(part.rings[i], p);
    if (side < 0 || (strictly && side == 0)) return false;
  }
  return true;
}

/// Is the point for all values, and the middle, farther along n than both ends of the edge? Then none of these places,
/// nor what is between two of them, is on the edge.
bool PathChecker::is_beyond(const CellValues& values, const CellPoint& at, const Point& middle, const Segment& edge,
                            const Point& n) {
  const CellPoint still{CellFunction::constant(middle.x), CellFunction::constant(middle.y)};
  const auto along = [&](const CellPoint& p, const Point& end) {
    return CellFunction::constant(n.x) * (p.x - CellFunction::constant(end.x)) +
           CellFunction::constant(n.y) * (p.y - CellFunction::constant(end.y));
  };
  return std::all_of(edge.begin(), edge.end(), [&](const Point& end) {
    return values.least(along(at, end)) > 0 && values.least(along(still, end)) > 0;
  });
}

/// The point is in a part of its body, and stays inside a part of the other one that has a layer in common with it.
bool PathChecker::stays_inside(const CellValues& values, const PathClaim& claim) const {
  if (!bodies_.is_tested(claim.body, claim.other) || !in_range(claim.point.x) || !in_range(claim.point.y)) return false;
  const CellPoint at = seen(values, claim.other, claim.body).place(claim.point);
  const auto meets_own = [&](const PartShape& part) {
    return std::any_of(bodies_[claim.body].parts.begin(), bodies_[claim.body].parts.end(), [&](const PartShape& own) {
      return own.z.meet(part.z) && holds_point(own, claim.point, false);
    });
  };
  return std::any_of(bodies_[claim.other].parts.begin(), bodies_[claim.other].parts.end(),
                     [&](const PartShape& part) { return meets_own(part) && stays_inside(values, at, part); });
}

/// The point stays on one side of each edge of the part: in a disc that the edge does not meet, or beyond the edge in
/// some direction. The disc's middle is inside.
bool PathChecker::stays_inside(const CellValues& values, const CellPoint& at, const PartShape& part) {
  const Point middle{tidy(at.x.middle.mid), tidy(at.y.middle.mid)};
  const double dx = std::max(values.largest(at.x) - middle.x, middle.x - values.least(at.x)),
               dy = std::max(values.largest(at.y) - middle.y, middle.y - values.least(at.y));
  const double radius = std::sqrt(dx * dx + dy * dy) * (1 + path_rounding);
  if (!std::isfinite(radius) || !in_range(middle.x) || !in_range(middle.y)) return false;
  for (const Polygon& ring : part.rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point &a = ring[k], &b = ring[(k + 1) % ring.size()];
      const Point foot = nearest_on_edge(middle, a, b), away{middle.x - foot.x, middle.y - foot.y};
      const double size =
          std::fabs(middle.x) + std::fabs(middle.y) + std::fabs(a.x) + std::fabs(a.y) + std::fabs(b.x) + std::fabs(b.y);
      if (std::hypot(away.x, away.y) > radius + path_rounding * size) continue;
      const Point across{a.y - b.y, b.x - a.x};
      const Point towards = across.x * away.x + across.y * away.y > 0 ? across : Point{-across.x, -across.y};
      if (!is_beyond(values, at, middle, {a, b}, towards) && !is_beyond(values, at, middle, {a, b}, away)) return false;
    }
  }
  return holds_point(part, middle, true);
}

/// The vertex stays within the clearance of a fixed point of the edge: along the way there, and across.
bool PathChecker::stays_near(const CellValues& values, const PathClaim& claim) const {
  const auto moving = edge(claim.vertex), rest = edge(claim.edge);
  if (!moving || !rest || !moving->z.meet(rest->z) || !bodies_.is_tested(claim.vertex.body, claim.edge.body))
    return false;
  const CellPoint at = seen(values, claim.edge.body, claim.vertex.body).place(moving->ends[0]);
  const Point middle{at.x.middle.mid, at.y.middle.mid}, foot = nearest_on_edge(middle, rest->ends[0], rest->ends[1]);
  const double far = std::hypot(middle.x - foot.x, middle.y - foot.y);
  const Point n = far > 0 ? Point{(middle.x - foot.x) / far, (middle.y - foot.y) / far} : Point{1, 0};
  const auto most = [&](double nx, double ny) {
    const CellFunction f = CellFunction::constant(nx) * (at.x - CellFunction::constant(foot.x)) +
                           CellFunction::constant(ny) * (at.y - CellFunction::constant(foot.y));
    return std::max(std::fabs(values.least(f)), std::fabs(values.largest(f)));
  };
  const double along = most(n.x, n.y), across = most(-n.y, n.x);
  const double size = std::fabs(middle.x) + std::fabs(middle.y) + std::fabs(foot.x) + std::fabs(foot.y);
  return std::hypot(along, across) * (1 + path_rounding) + path_rounding * size < clearance_;
}

bool PathChecker::holds(const PathClaim& claim, const PathCell& cell) const {
  const CellValues values(problem_, cell);
  switch (claim.kind) {
    case PathNode::halved:
      return claim.joint < problem_.linkage.joints.size();
    case PathNode::open:
      return true;
    case PathNode::crossing:
      return claim.crossings.size() == 1 && crosses(values, claim.crossings[0]);
    case PathNode::inside:
      return stays_inside(values, claim);
    case PathNode::near:
      return clearance_ > 0 && stays_near(values, claim);
    case PathNode::conditions:
      return exclude_each_other(values, claim.crossings);
  }
  return false;
}

bool PathChecker::may_be_start(const PathCell& cell) const {
  const CellValues values(problem_, cell);
  for (std::size_t k = 0; k < problem_.linkage.joints.size(); ++k) {
    const Joint& joint = problem_.linkage.joints[k];
    const double period = problem_.periodic[k] ? joint.hi - joint.lo : 0, at = problem_.start[k];
    const auto within = [&](double v) { return v >= values.lo(k) && v <= values.hi(k); };
    if (!within(at) && !within(at + period) && !within(at - period)) return false;
  }
  return true;
}

bool PathChecker::may_be_goal(const PathCell& cell) const {
  const CellValues values(problem_, cell);
  if (problem_.goal_outside) return may_be_outside(values);
  for (std::size_t k = 0; k < problem_.linkage.joints.size(); ++k) {
    if (!problem_.goal[k]) continue;
    const Joint& joint = problem_.linkage.joints[k];
    const double period = problem_.periodic[k] ? joint.hi - joint.lo : 0;
    const auto meets = [&](double turn) {
      return (*problem_.goal[k])[0] + turn <= values.hi(k) && (*problem_.goal[k])[1] + turn >= values.lo(k);
    };
    if (!meets(0) && !meets(period) && !meets(-period)) return false;
  }
  return true;
}

/// Not where, for all values, the box of a body that moves and that of one that does not certainly overlap.
bool PathChecker::may_be_outside(const CellValues& values) const {
  struct CoveredExtent {
    double lo_x = INFINITY, hi_x = -INFINITY, lo_y = INFINITY, hi_y = -INFINITY;
  };
  std::vector<CoveredExtent> moving, resting;
  for (const BodyShape& body : bodies_) {
    const CellPose at = pose(values, body.chain);
    CoveredExtent covered;
    for (const PartShape& part : body.parts) {
      for (const Point& p : part.rings[0]) {
        const CellPoint z = at.place(p);
        covered.lo_x = std::min(covered.lo_x, values.largest(z.x));
        covered.hi_x = std::max(covered.hi_x, values.least(z.x));
        covered.lo_y = std::min(covered.lo_y, values.largest(z.y));
        covered.hi_y = std::max(covered.hi_y, values.least(z.y));
      }
    }
    (bodies_.is_moved(body) ? moving : resting).push_back(covered);
  }
  for (const CoveredExtent& a : moving) {
    for (const CoveredExtent& b : resting) {
      if (std::max(a.lo_x, b.lo_x) < std::min(a.hi_x, b.hi_x) && std::max(a.lo_y, b.lo_y) < std::min(a.hi_y, b.hi_y))
        return false;
    }
  }
  return true;
}

}  // namespace taut::internal::proof
