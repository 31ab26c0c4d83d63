// The question: how do bodies come apart?
#include "taut/separate.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "path/take_apart.hpp"
#include "query/separate_straight.hpp"
#include "taut/error.hpp"
#include "taut/motions.hpp"

namespace taut {
using namespace internal;
using namespace internal::path;
namespace {

void validate_turns(const Scene& scene, const SeparateOptions& options) {
  if (!(options.tolerance >= 1e-9 && options.tolerance <= 1))
    throw InputError("tolerance", "it is not between 1e-9 and 1", "it is a share of what places and angles range over");
  for (const Body& body : scene.bodies) {
    if (!body.curves.empty())
      throw InputError(body.name, "it has curves, and ways with turns are found for polygons",
                       "taut flatten --outer makes a polygon around it: bodies that come apart then do so");
  }
}

/// Where bodies wait that have left: beyond all that those that leave later pass over.
class Parking {
 public:
  Parking(const Scene& standing, const Separation& answer) : scene_(standing), ways_(answer.ways) {
    std::vector<BodyId> left(standing.bodies.size());
    std::iota(left.begin(), left.end(), 0);
    AxisBox used = extent_of(standing, left);
    for (const RemovalWay& way : ways_) std::erase(left, way.body);
    places_.resize(ways_.size());
    for (std::size_t n = ways_.size(); n-- > 0;) {
      for (const WayPoint& at : ways_[n].points) used.include(around(ways_[n], at));
      // The last one that leaves is in nobody's way.
      if (n + 1 < ways_.size()) {
        places_[n] = beyond(used, ways_[n], extent_of(scene_, blockers_of(scene_, ways_[n].body, left)));
        used.include(around(ways_[n], *places_[n]));
      }
      left.push_back(ways_[n].body);
    }
  }

  const std::optional<WayPoint>& place(std::size_t n) const { return places_[n]; }

 private:
  double radius_of(const RemovalWay& way) const {
    return diagonal(extent_of(scene_.bodies[static_cast<std::size_t>(way.body)])) / 2;
  }
  /// Around the body there, however it is turned.
  AxisBox around(const RemovalWay& way, const WayPoint& at) const {
    const Point middle{way.pivot.x + at.x, way.pivot.y + at.y};
    return {middle, middle, radius_of(way)};
  }

  /// On along an axis from the end of the way, away from what blocks the body.
  WayPoint beyond(const AxisBox& used, const RemovalWay& way, const AxisBox& rest) const {
    WayPoint place = way.points.back();
    const AxisBox own = box_at_end(way);
    const Point middle{way.pivot.x + place.x, way.pivot.y + place.y};
    const double room = 1.125 * radius_of(way);
    const std::array<double, 4> gaps{own.lo_x - rest.hi_x, rest.lo_x - own.hi_x, own.lo_y - rest.hi_y,
                                     rest.lo_y - own.hi_y};
    switch (std::max_element(gaps.begin(), gaps.end()) - gaps.begin()) {
      case 0:
        place.x += std::max(0.0, used.hi_x + room - middle.x);
        break;
      case 1:
        place.x -= std::max(0.0, middle.x - (used.lo_x - room));
        break;
      case 2:
        place.y += std::max(0.0, used.hi_y + room - middle.y);
        break;
      default:
        place.y -= std::max(0.0, middle.y - (used.lo_y - room));
    }
    return place;
  }

  /// Rounded.
  AxisBox box_at_end(const RemovalWay& way) const {
    const WayPoint& last = way.points.back();
    const double angle = last.deg * (std::acos(-1.0) / 180), c = std::cos(angle), s = std::sin(angle);
    AxisBox box;
    for (const Part& part : scene_.bodies[static_cast<std::size_t>(way.body)].parts) {
      for (const Point& p : part.outline) {
        const double x = p.x - way.pivot.x, y = p.y - way.pivot.y;
        box.include(way.pivot.x + last.x + c * x - s * y, way.pivot.y + last.y + s * x + c * y);
      }
    }
    return box;
  }

  const Scene& scene_;
  const std::vector<RemovalWay>& ways_;
  std::vector<std::optional<WayPoint>> places_;
};

}  // namespace

Separation separate(const Scene& scene, const SeparateOptions& options) {
  if (!options.turns) return separate_straight(scene, options);
  validate_turns(scene, options);
  const Budget scope(options.limits);
  Separation answer = separate_straight(scene, options);
  const bool asked = answer.outcome == SeparationOutcome::free || answer.outcome == SeparationOutcome::locked;
  if (asked) take_apart(standing_scene(scene), options, scope, answer);
  return answer;
}

Scene removal_scene(const Scene& scene, const Separation& answer) {
  Scene standing = standing_scene(scene).scene;
  const Parking parking(standing, answer);
  std::vector<Motion> motions(standing.bodies.size());
  double t = 0;
  for (std::size_t n = 0; n < answer.ways.size(); ++n) {
    const RemovalWay& way = answer.ways[n];
    std::vector<WayPoint> points = way.points;
    if (parking.place(n)) points.push_back(*parking.place(n));
    std::vector<Keyframe> frames;
    for (const WayPoint& at : points) frames.push_back({t + static_cast<double>(frames.size()), at.x, at.y, at.deg});
    t = frames.back().t;
    motions[static_cast<std::size_t>(way.body)] = from_keyframes(frames, way.pivot);
  }
  for (std::size_t k = 0; k < motions.size(); ++k) standing.bodies[k].motion = std::move(motions[k]);
  standing.end = t;
  standing.at_rest = AtRest::skip;
  return standing;
}

}  // namespace taut
