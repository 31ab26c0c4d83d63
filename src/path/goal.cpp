#include "path/goal.hpp"

#include <algorithm>
#include <cmath>

#include "path/boxes_overlap.hpp"
#include "path/take_apart.hpp"

namespace taut::internal::path {

/// The values of the joint that are the goal and in the box, perhaps some periods on; nothing if there are none.
std::optional<std::array<double, 2>> Goal::values_in(const JointCell& box, std::size_t joint) const {
  const double lo = box.middle[joint] - box.half[joint], hi = box.middle[joint] + box.half[joint];
  const auto& goal = problem_.goal[joint];
  if (!goal) return std::array<double, 2>{lo, hi};
  const Joint& range = problem_.linkage.joints[joint];
  const double period = problem_.periodic[joint] ? range.hi - range.lo : 0;
  for (const double turn : {0.0, period, -period}) {
    const double from = std::max(lo, (*goal)[0] + turn), to = std::min(hi, (*goal)[1] + turn);
    if (from <= to) return std::array<double, 2>{from, to};
  }
  return std::nullopt;
}

bool Goal::may_meet(const JointCell& box) const {
  if (problem_.goal_outside) return outside(box) >= 0;
  for (std::size_t k = 0; k < space_.dimension(); ++k) {
    if (!values_in(box, k)) return false;
  }
  return true;
}

std::optional<JointValues> Goal::point_in(const JointCell& box) const {
  if (problem_.goal_outside) {
    if (outside({box.middle, {}}) > 0) return box.middle;
    return std::nullopt;
  }
  JointValues point{};
  for (std::size_t k = 0; k < space_.dimension(); ++k) {
    const auto values = values_in(box, k);
    if (!values) return std::nullopt;
    const Joint& joint = problem_.linkage.joints[k];
    point[k] = std::clamp(box.middle[k], (*values)[0], (*values)[1]);
    if (!problem_.periodic[k]) point[k] = std::clamp(point[k], joint.lo, joint.hi);
  }
  return point;
}

std::optional<JointValues> Goal::only() const {
  if (problem_.goal_outside) return std::nullopt;
  JointValues only{};
  for (std::size_t k = 0; k < space_.dimension(); ++k) {
    const auto& goal = problem_.goal[k];
    if (!goal || (*goal)[0] != (*goal)[1]) return std::nullopt;
    only[k] = (*goal)[0];
  }
  return only;
}

Goal::BodyExtents Goal::extents(int body, const JointCell& box) const {
  const PoseModel pose = space_.pairs().pose(body, box);
  constexpr double far = INFINITY;
  BodyExtents found{{far, -far, far, -far}, {far, -far, far, -far}};
  // The box of a body is as far to each side as its farthest vertex: of all values, the least and the largest.
  for (const int section : space_.pairs().world().sections(body)) {
    const RingSet& rings = *space_.pairs().world().bodies()[static_cast<std::size_t>(section)].rings;
    for (std::size_t ring = 0; ring < rings.rings().size(); ++ring) {
      for (const Point& p : rings.points(ring)) {
        const JointModel z = pose.place({p.x, p.y});
        const double error = z.error + 0x1p-45 * (1 + z.reach());
        double dx = error, dy = error;
        for (const Vector& r : z.rate) {
          dx += std::fabs(r.x);
          dy += std::fabs(r.y);
        }
        Extent &a = found.least, &b = found.most;
        a = {std::min(a.lo_x, z.value.x + dx), std::max(a.hi_x, z.value.x - dx), std::min(a.lo_y, z.value.y + dy),
             std::max(a.hi_y, z.value.y - dy)};
        b = {std::min(b.lo_x, z.value.x - dx), std::max(b.hi_x, z.value.x + dx), std::min(b.lo_y, z.value.y - dy),
             std::max(b.hi_y, z.value.y + dy)};
      }
    }
  }
  return found;
}

int Goal::outside(const JointCell& box) const {
  const int n = static_cast<int>(problem_.linkage.scene.bodies.size());
  std::vector<BodyExtents> moving, resting;
  for (int body = 0; body < n; ++body) (space_.pairs().moves(body) ? moving : resting).push_back(extents(body, box));
  const auto apart = [](const Extent& a, const Extent& b) {
    return a.lo_x >= b.hi_x || b.lo_x >= a.hi_x || a.lo_y >= b.hi_y || b.lo_y >= a.hi_y;
  };
  bool all = true;
  for (const BodyExtents& a : moving) {
    for (const BodyExtents& b : resting) {
      all = all && apart(a.most, b.most);
      // What each certainly covers has an interior in common: for all values they overlap.
      const auto overlap = [](double lo_a, double hi_a, double lo_b, double hi_b) {
        return std::max(lo_a, lo_b) < std::min(hi_a, hi_b);
      };
      if (overlap(a.least.lo_x, a.least.hi_x, b.least.lo_x, b.least.hi_x) &&
          overlap(a.least.lo_y, a.least.hi_y, b.least.lo_y, b.least.hi_y))
        return -1;
    }
  }
  return all ? 1 : 0;
}

namespace {

/// Open, of coordinates or of values of a joint: from lo / weight to hi / weight; weight > 0.
struct ExactInterval {
  Dyadic lo, hi, weight;
};

/// A body, its box where no joint moves it, and how joints do.
struct SlidingBox {
  BodyId body;
  AxisBox box;
  Slides slides;
};

/// Along one axis: by how much the one may be moved so that the two overlap.
ExactInterval overlap_along(double own_lo, double own_hi, double other_lo, double other_hi, const Dyadic& offset) {
  return {Dyadic::exact(other_lo) - Dyadic::exact(own_hi) + offset,
          Dyadic::exact(other_hi) - Dyadic::exact(own_lo) + offset, Dyadic(1, 0)};
}

std::array<ExactInterval, 2> overlap_of(const SlidingBox& own, const SlidingBox& other) {
  const AxisBox &a = own.box, &b = other.box;
  return {overlap_along(a.lo_x, a.hi_x, b.lo_x, b.hi_x, other.slides.offset.x - own.slides.offset.x),
          overlap_along(a.lo_y, a.hi_y, b.lo_y, b.hi_y, other.slides.offset.y - own.slides.offset.y)};
}

ConvexRing rectangle_of(const std::array<ExactInterval, 2>& sides) {
  const auto& [x, y] = sides;
  return {ExactPoint::of(x.lo, y.lo), ExactPoint::of(x.hi, y.lo), ExactPoint::of(x.hi, y.hi),
          ExactPoint::of(x.lo, y.hi)};
}

/// Makes `values` those at which values times the rate is in the interval as well; false if there are none.
bool intersect(std::optional<ExactInterval>& values, const ExactInterval& interval, const Dyadic& rate) {
  if (rate.is_zero()) return interval.lo.sign() < 0 && interval.hi.sign() > 0;
  ExactInterval own{interval.lo, interval.hi, rate};
  if (rate.sign() < 0) own = {-interval.hi, -interval.lo, -rate};
  if (!values) {
    values = own;
    return true;
  }
  // With a common weight.
  const ExactInterval a{values->lo * own.weight, values->hi * own.weight, values->weight * own.weight};
  const ExactInterval b{own.lo * values->weight, own.hi * values->weight, a.weight};
  values = {(a.lo - b.lo).sign() > 0 ? a.lo : b.lo, (a.hi - b.hi).sign() < 0 ? a.hi : b.hi, a.weight};
  return (values->hi - values->lo).sign() > 0;
}

/// A body that follows one joint overlaps for values of that joint between two, whatever the other joint does: a strip
/// across the range. Nothing if it never overlaps.
std::optional<ConvexRing> strip_of(const std::array<ExactInterval, 2>& sides, std::size_t joint, const Slides& own,
                                   const Linkage& linkage, const SlideMap& map) {
  std::optional<ExactInterval> values;
  if (!intersect(values, sides[0], own.joint[joint].x) || !intersect(values, sides[1], own.joint[joint].y))
    return std::nullopt;
  const std::size_t other = map.joints()[0] == joint ? map.joints()[1] : map.joints()[0];
  const Joint& range = linkage.joints[other];
  const Dyadic lo = Dyadic::exact(range.lo - std::max(1.0, std::fabs(range.lo))),
               hi = Dyadic::exact(range.hi + std::max(1.0, std::fabs(range.hi)));
  const ExactVector &u = map.slides().joint[joint], &v = map.slides().joint[other];
  const auto corner = [&](const Dyadic& of_joint, const Dyadic& of_other) {
    const Dyadic weighted = of_other * values->weight;
    return ExactPoint::of(of_joint * u.x + weighted * v.x, of_joint * u.y + weighted * v.y, values->weight);
  };
  ConvexRing ring = {corner(values->lo, lo), corner(values->hi, lo), corner(values->hi, hi), corner(values->lo, hi)};
  if (turn_sign(ring[0], ring[1], ring[2]) < 0) std::reverse(ring.begin(), ring.end());
  return ring;
}

/// The only joint that moves the body, if it is one of two of the map.
std::optional<std::size_t> only_joint(const Slides& slides, const SlideMap& map) {
  std::optional<std::size_t> only;
  for (std::size_t k = 0; k < slides.joint.size(); ++k) {
    if (slides.joint[k].is_zero()) continue;
    if (only || std::find(map.joints().begin(), map.joints().end(), k) == map.joints().end()) return std::nullopt;
    only = k;
  }
  return map.joints().size() == 2 ? only : std::nullopt;
}

}  // namespace

std::optional<std::vector<BoxesOverlap>> boxes_overlap(const Linkage& linkage, const SlideMap& map,
                                                       const LinkedPairs& pairs) {
  std::vector<SlidingBox> moving, resting;
  for (std::size_t i = 0; i < linkage.scene.bodies.size(); ++i) {
    const auto body = static_cast<int>(i);
    std::optional<Slides> slides = slides_of(linkage, body);
    // A joint that moves nothing makes a body one that moves by name only.
    if (!slides || slides->moves() != pairs.moves(body)) return std::nullopt;
    auto& kind = slides->moves() ? moving : resting;
    kind.push_back({body, extent_of(linkage.scene.bodies[i]), std::move(*slides)});
  }
  std::vector<BoxesOverlap> all;
  for (const SlidingBox& own : moving) {
    const bool whole = own.slides.moves_like(map.slides());
    const std::optional<std::size_t> joint = only_joint(own.slides, map);
    if (!whole && !joint) return std::nullopt;
    for (const SlidingBox& other : resting) {
      const std::array<ExactInterval, 2> sides = overlap_of(own, other);
      if (whole) {
        all.push_back({rectangle_of(sides), {own.body, other.body}});
      } else if (auto strip = strip_of(sides, *joint, own.slides, linkage, map)) {
        all.push_back({std::move(*strip), {own.body, other.body}, false});
      }
    }
  }
  return all;
}

}  // namespace taut::internal::path
