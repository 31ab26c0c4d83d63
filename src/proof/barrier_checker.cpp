#include "proof/barrier_checker.hpp"

#include <algorithm>
#include <string>

#include "numeric/budget.hpp"

namespace taut::internal::proof {
namespace {

ProofError at_edge(std::size_t edge, const char* what) {
  return ProofError("edge " + std::to_string(edge) + " of the polygon: " + what);
}

std::vector<ExactPlace> corners(const Barrier& barrier) {
  std::vector<ExactPlace> all;
  for (const BarrierEdge& edge : barrier.edges) all.push_back(edge.from);
  return all;
}

}  // namespace

/// Displacements by the joints that move the bodies of the log's collisions: one, or two that are not parallel.
struct BarrierChecker::Frame {
  RelativeSlide slide;
  std::vector<std::size_t> joints;

  const ExactPlace& vector(std::size_t k) const { return slide.joint[joints[k]]; }
  ExactPlace displaced(const JointValues& values) const {
    ExactPlace sum;
    for (const std::size_t k : joints) sum = sum + Dyadic::exact(values[k]) * slide.joint[k];
    return sum;
  }
  /// How far a displacement is beyond a side of the ranges, times something positive. Of a joint, that side is a bound
  /// of its value; if only one moves, the other two sides are those of the line along which it does.
  Dyadic beyond(std::uint8_t side, const ExactPlace& at, const std::vector<Joint>& ranges) const {
    const std::size_t k = side / 2;
    Dyadic value, scale;
    if (joints.size() == 1) {
      value = k == 0 ? dot(at, vector(0)) : cross(vector(0), at);
      scale = dot(vector(0), vector(0));
    } else {
      value = k == 0 ? cross(at, vector(1)) : cross(vector(0), at);
      scale = cross(vector(0), vector(1));
    }
    Dyadic bound;
    if (k < joints.size()) bound = Dyadic::exact(side % 2 == 1 ? ranges[joints[k]].hi : ranges[joints[k]].lo);
    const Dyadic excess = value - scale * bound;
    return (scale.sign() > 0) == (side % 2 == 1) ? excess : -excess;
  }
};

/// Nothing if the body, or one of its parents, turns.
std::optional<RelativeSlide> BarrierChecker::slide_of(std::uint32_t body) const {
  RelativeSlide slide;
  const auto add = [&](int joint, double times, double plus, const Point& direction) {
    const ExactPlace d = ExactPlace::of(direction);
    ExactPlace& v = slide.joint[static_cast<std::size_t>(joint)];
    v = v + Dyadic::exact(times) * d;
    slide.offset = slide.offset + Dyadic::exact(plus) * d;
  };
  for (const int one : bodies_[body].chain) {
    if (!bodies_.moves(one)) continue;
    const JointMotion& motion = *problem_.linkage.motions[static_cast<std::size_t>(one)];
    if (const auto* along = std::get_if<Slide>(&motion.kind)) {
      add(motion.joint, motion.times, motion.plus, along->direction);
    } else if (const auto* free = std::get_if<FreeMotion>(&motion.kind); free && !free->deg) {
      if (free->x) add(*free->x, 1, 0, {1, 0});
      if (free->y) add(*free->y, 1, 0, {0, 1});
    } else {
      return std::nullopt;
    }
  }
  return slide;
}

RelativeSlide BarrierChecker::relative_slide(std::uint32_t body, std::uint32_t other) const {
  if (body >= bodies_.size() || other >= bodies_.size()) throw ProofError("the log names a body that is not there");
  const auto from = slide_of(body), of = slide_of(other);
  if (!from || !of) throw ProofError("a body that the polygon is about does not only translate");
  RelativeSlide relative{of->offset - from->offset, {}};
  for (std::size_t k = 0; k < relative.joint.size(); ++k) relative.joint[k] = of->joint[k] - from->joint[k];
  return relative;
}

/// That of the first collision: all others have to be alike.
BarrierChecker::Frame BarrierChecker::frame_of(const Barrier& barrier) const {
  const auto collides = [](const BarrierEdge& e) { return e.kind == BarrierEdge::Kind::collision; };
  const auto first = std::find_if(barrier.edges.begin(), barrier.edges.end(), collides);
  if (first == barrier.edges.end()) throw ProofError("nothing collides along the polygon");
  Frame frame{relative_slide(first->body, first->other), {}};
  for (std::size_t k = 0; k < frame.slide.joint.size(); ++k) {
    if (!frame.slide.joint[k].is_zero()) frame.joints.push_back(k);
  }
  const bool known =
      frame.joints.size() == 1 || (frame.joints.size() == 2 && !cross(frame.vector(0), frame.vector(1)).is_zero());
  if (!known) throw ProofError("what the polygon is about is not moved by one joint, or by two across each other");
  return frame;
}

/// A point that moves evenly is in both bodies: in the closed shape of the one, and within the other one, or, if
/// touching is enough, in its closed shape.
void BarrierChecker::require_collision(const Frame& frame, const Barrier& barrier, std::size_t edge) const {
  const BarrierEdge& claim = barrier.edges[edge];
  const RelativeSlide relative = relative_slide(claim.body, claim.other);
  if (relative.joint != frame.slide.joint) throw at_edge(edge, "its bodies are moved in another way");
  if (!bodies_.is_tested(claim.body, claim.other)) throw at_edge(edge, "its bodies are not tested");
  const ExactPlace &from = claim.from, &to = barrier.edges[(edge + 1) % barrier.edges.size()].from;
  const ExactPlace begin = claim.common[0] - relative.offset - from, end = claim.common[1] - relative.offset - to;
  for (const PartShape& own : bodies_[claim.body].parts) {
    for (const PartShape& other : bodies_[claim.other].parts) {
      if (!own.z.meet(other.z)) continue;
      const auto in = [&](bool own_strictly, bool other_strictly) {
        return holds_segment(own.rings, claim.common[0], claim.common[1], own_strictly) &&
               holds_segment(other.rings, begin, end, other_strictly);
      };
      if (barrier.touching ? in(false, false) : in(true, false) || in(false, true)) return;
    }
  }
  throw at_edge(edge, "its bodies are not shown to collide");
}

/// Both ends are beyond a side of the ranges, or one is on it, where two bodies collide by an edge before or after.
void BarrierChecker::require_outside(const Frame& frame, const Barrier& barrier, std::size_t edge) const {
  const std::size_t n = barrier.edges.size(), next = (edge + 1) % n;
  const BarrierEdge& claim = barrier.edges[edge];
  if (claim.side > 3) throw at_edge(edge, "there is no such side");
  int on = 0;
  for (const std::size_t end : {edge, next}) {
    const int sign = frame.beyond(claim.side, barrier.edges[end].from, problem_.linkage.joints).sign();
    if (sign < 0) throw at_edge(edge, "it is not outside of the joint's range");
    if (sign > 0) continue;
    ++on;
    const BarrierEdge& meeting = barrier.edges[end == edge ? (edge + n - 1) % n : next];
    if (meeting.kind != BarrierEdge::Kind::collision) throw at_edge(edge, "its end is in the joint's range");
  }
  if (on > 1) throw at_edge(edge, "it is along the end of the joint's range");
}

bool BarrierChecker::starts_in_goal(const Frame& frame) const {
  return std::all_of(frame.joints.begin(), frame.joints.end(), [&](std::size_t k) {
    const auto& goal = problem_.goal[k];
    return !goal || ((*goal)[0] <= problem_.start[k] && problem_.start[k] <= (*goal)[1]);
  });
}

/// Corners in order; of one joint the two ends.
std::vector<ExactPlace> BarrierChecker::goal_region(const Frame& frame) const {
  JointValues lo{}, hi{};
  for (const std::size_t k : frame.joints) {
    const Joint& joint = problem_.linkage.joints[k];
    lo[k] = problem_.goal[k] ? std::max((*problem_.goal[k])[0], joint.lo) : joint.lo;
    hi[k] = problem_.goal[k] ? std::min((*problem_.goal[k])[1], joint.hi) : joint.hi;
  }
  JointValues at = lo;
  std::vector<ExactPlace> region = {frame.displaced(at)};
  for (const std::size_t k : frame.joints) {
    at[k] = hi[k];
    region.push_back(frame.displaced(at));
  }
  if (frame.joints.size() == 2) {
    at[frame.joints[0]] = lo[frame.joints[0]];
    region.push_back(frame.displaced(at));
  }
  return region;
}

/// The corners are where the boxes of two bodies overlap, or touch: what is inside of the polygon is where they
/// overlap.
void BarrierChecker::require_boxes_overlap(const Frame& frame, const Barrier& barrier) const {
  const auto [moving, resting] = barrier.boxes;
  const RelativeSlide relative = relative_slide(resting, moving);
  if (relative.joint != frame.slide.joint) throw ProofError("the bodies whose boxes overlap are moved in another way");
  if (!bodies_.is_moved(bodies_[moving]) || bodies_.is_moved(bodies_[resting]))
    throw ProofError("of the bodies whose boxes overlap, not the first one only is moved");
  const auto box = [&](std::uint32_t body) {
    AxisBox around;
    for (const PartShape& part : bodies_[body].parts) around.include(box_around(part.rings[0]));
    return around;
  };
  const AxisBox a = box(moving), b = box(resting);
  for (const ExactPlace& corner : corners(barrier)) {
    const ExactPlace at = relative.offset + corner;
    const auto apart = [](double own_lo, double own_hi, const Dyadic& by, double lo, double hi) {
      return (Dyadic::exact(own_lo) + by - Dyadic::exact(hi)).sign() > 0 ||
             (Dyadic::exact(lo) - by - Dyadic::exact(own_hi)).sign() > 0;
    };
    if (apart(a.lo_x, a.hi_x, at.x, b.lo_x, b.hi_x) || apart(a.lo_y, a.hi_y, at.y, b.lo_y, b.hi_y))
      throw ProofError("the polygon leads to where the boxes of the two bodies are apart");
  }
}

void BarrierChecker::require(const Barrier& barrier) const {
  const Frame frame = frame_of(barrier);
  for (std::size_t i = 0; i < barrier.edges.size(); ++i) {
    checkpoint();
    barrier.edges[i].kind == BarrierEdge::Kind::collision ? require_collision(frame, barrier, i)
                                                          : require_outside(frame, barrier, i);
  }
  const std::vector<ExactPlace> polygon = corners(barrier);
  const ExactPlace start = frame.displaced(problem_.start);
  if (is_on_edge(polygon, start)) throw ProofError("the start is on the polygon");
  const bool odd = is_odd(polygon, start);
  if (problem_.goal_outside) {
    require_boxes_overlap(frame, barrier);
    if (!odd) throw ProofError("the start is not inside of the polygon");
    return;
  }
  // A way from elsewhere comes to the goal where its boundary is.
  if (starts_in_goal(frame)) throw ProofError("the start is in the goal");
  const std::vector<ExactPlace> goal = goal_region(frame);
  for (std::size_t k = 0; k < goal.size(); ++k) {
    if (!is_on_or_beside(polygon, goal[k], goal[(k + 1) % goal.size()], !odd))
      throw ProofError("the start and some of the goal are on one side of the polygon");
  }
}

}  // namespace taut::internal::proof
