// Do the bodies overlap in one placement? Boxes first, then exact signs.
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "numeric/budget.hpp"
#include "scene/placement.hpp"
#include "spacetime/box_separation.hpp"
#include "spacetime/first_contact.hpp"

namespace taut::internal::spacetime {
namespace {

bool edges_cross(const Placement& place, VertexId a, VertexId b) {
  const PairGeometry& g = place.geometry();
  const VertexId a2 = g.next(a), b2 = g.next(b);
  return place.orientation(a, a2, b) != place.orientation(a, a2, b2) &&
         place.orientation(b, b2, a) != place.orientation(b, b2, a2);
}

/// The winding number of the other body's rings around a vertex of one body. The vertex is inside if the number is not
/// 0; it may be larger than 1 where parts overlap. A ray in the sweep's "up" direction crosses rings, which have their
/// material to the left, in one direction or the other.
class Winding {
 public:
  /// `first` is the first vertex of the tree's body, and `pose` is the pose of that body.
  Winding(const Placement& place, VertexId v, const Hierarchy& tree, const RoundedPose& pose, std::uint32_t first)
      : place_(place), v_(v), tree_(tree), pose_(pose), first_(first) {}

  bool inside() {
    visit(0);
    return winds_ > 0;
  }

 private:
  void visit(std::uint32_t i) {
    const BoxNode& node = tree_.node(i);
    if (misses(node.box)) return;
    if (node.count == 1) {
      count(VertexId(first_ + node.first));
    } else {
      visit(node.left);
      visit(node.right);
    }
  }
  /// Does the sweep certainly reach the whole box before the vertex, or after it?
  bool misses(const Box& box) const {
    const double x = box.centre.x, y = box.centre.y, c = pose_.c, s = pose_.s;
    const double key = Placement::key_at({pose_.x + (c * x - s * y), pose_.y + (s * x + c * y)});
    return std::fabs(key - place_.key(v_)) > Placement::steepest_key * box.radius + 2 * place_.key_error();
  }
  void count(VertexId a) {
    const VertexId b = place_.geometry().next(a);
    const bool forwards = place_.before(a, v_);
    if (forwards == place_.before(b, v_)) return;
    if (place_.orientation(forwards ? a : b, forwards ? b : a, v_) < 0) winds_ += forwards ? -1 : 1;
  }

  const Placement& place_;
  VertexId v_;
  const Hierarchy& tree_;
  RoundedPose pose_;
  std::uint32_t first_;
  int winds_ = 0;
};

/// A vertex of each part's outline.
std::vector<std::uint32_t> outlines(const DisplacedPolygon& body) {
  if (body.rings.empty()) return {0};
  std::vector<std::uint32_t> first;
  for (const RingSpan& ring : body.rings) {
    if (!ring.hole) first.push_back(ring.first);
  }
  return first;
}

Stretch at_instant(const MotionSegment& segment, double t) {
  if (segment.translation) return Stretch::of_translation(segment, TranslationPolynomial(segment), t, t);
  // The window is the shortest possible: near a singular start, longer ones would be halved down to it.
  FrameWindow window(segment, t, segment.end, std::nextafter(t, std::numeric_limits<double>::infinity()) - t);
  return window.smooth() ? Stretch::of_window(segment, window, t, t) : Stretch::of_range(segment, window);
}

}  // namespace

std::optional<StartOverlap> overlapping(const PairGeometry& g, const MotionSegment& segment, double t) {
  const Hierarchy p = hierarchy_of_p(g), q = hierarchy_of_q(g);
  return overlapping(g, {p, q}, segment, t);
}

namespace {

std::optional<StartOverlap> overlap_in(const Placement& place, const TreePair& trees, const Stretch& instant) {
  const PairGeometry& g = place.geometry();
  const auto& [p, q] = trees;
  if (apart(instant, p.node(0).box, q.node(0).box)) return std::nullopt;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> stack{{0, 0}};
  while (!stack.empty()) {
    checkpoint();
    const auto [i, j] = stack.back();
    stack.pop_back();
    const BoxNode &a = p.node(i), &b = q.node(j);
    if (apart(instant, a.box, b.box)) continue;
    if (a.count == 1 && b.count == 1) {
      const VertexId e(a.first), f(g.np + b.first);
      if (edges_cross(place, e, f)) return StartOverlap{true, e, f, {}};
    } else if (divides_first(a, b)) {
      stack.insert(stack.end(), {{a.left, j}, {a.right, j}});
    } else {
      stack.insert(stack.end(), {{i, b.left}, {i, b.right}});
    }
  }
  // The boundaries do not cross. So either one part contains the outline of another one, or they are disjoint.
  for (const std::uint32_t v : outlines(*g.p())) {
    checkpoint();
    if (Winding(place, VertexId(v), q, place.pose_q(), g.np).inside()) return StartOverlap{false, {}, {}, VertexId(v)};
  }
  for (const std::uint32_t v : outlines(*g.q())) {
    checkpoint();
    const VertexId of_q(g.np + v);
    if (Winding(place, of_q, p, place.pose_p(), 0).inside()) return StartOverlap{false, {}, {}, of_q};
  }
  return std::nullopt;
}

}  // namespace

std::optional<StartOverlap> overlapping(const PairGeometry& g, const TreePair& trees, const MotionSegment& segment,
                                        double t, StageCounts* stages) {
  const Placement place(g, segment, t, Positions::on_demand);
  const auto found = overlap_in(place, trees, at_instant(segment, t));
  if (stages) *stages += place.stages();
  return found;
}

std::optional<StartOverlap> overlapping(const PairGeometry& g, const TreePair& trees, const MotionSegment& segment,
                                        double t, const Stretch& instant) {
  return overlap_in(Placement(g, segment, t, Positions::on_demand), trees, instant);
}

}  // namespace taut::internal::spacetime
