#include "path/boxes_overlap.hpp"

#include <algorithm>
#include <cmath>

#include "path/take_apart.hpp"

namespace taut::internal::path {
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
