#include "path/slides.hpp"

#include <algorithm>

#include "scene/linkage.hpp"

namespace taut::internal::path {
namespace {

Dyadic dot(const ExactVector& a, const ExactVector& b) { return a.x * b.x + a.y * b.y; }
Dyadic cross(const ExactVector& a, const ExactVector& b) { return a.x * b.y - a.y * b.x; }

ExactVector sum(const ExactVector& a, const ExactVector& b) { return {a.x + b.x, a.y + b.y}; }

ExactVector scaled(double by, const Point& v) {
  const Dyadic s = Dyadic::exact(by);
  return {s * Dyadic::exact(v.x), s * Dyadic::exact(v.y)};
}

/// a / b as a double, exactly if it is one: the quotient of two rounded numbers is corrected by what is left.
double quotient(const Dyadic& a, const Dyadic& b) {
  const double near = nearest_quotient(a, b);
  return near + nearest_quotient(a - b * Dyadic::exact(near), b);
}

}  // namespace

bool Slides::moves() const {
  return std::any_of(joint.begin(), joint.end(), [](const ExactVector& v) { return !v.is_zero(); });
}

std::optional<Slides> slides_of(const Linkage& linkage, int body) {
  const std::vector<Body>& bodies = linkage.scene.bodies;
  Slides slides;
  for (auto i = static_cast<std::size_t>(body);;) {
    const std::vector<JointMotion> motions = i < linkage.motions.size() && linkage.motions[i]
                                                 ? single_motions(*linkage.motions[i])
                                                 : std::vector<JointMotion>();
    for (const JointMotion& motion : motions) {
      const auto* slide = std::get_if<Slide>(&motion.kind);
      if (!slide) return std::nullopt;
      ExactVector& v = slides.joint[static_cast<std::size_t>(motion.joint)];
      v = sum(v, scaled(motion.times, slide->direction));
      slides.offset = sum(slides.offset, scaled(motion.plus, slide->direction));
    }
    const std::string& parent = bodies[i].relative_to;
    if (parent.empty()) return slides;
    const auto is_parent = [&](const Body& b) { return b.name == parent; };
    i = static_cast<std::size_t>(std::find_if(bodies.begin(), bodies.end(), is_parent) - bodies.begin());
  }
}

std::optional<SlideMap> SlideMap::of(const Slides& slides) {
  SlideMap map;
  map.slides_ = slides;
  for (std::size_t k = 0; k < slides.joint.size(); ++k) {
    if (!slides.joint[k].is_zero()) map.joints_.push_back(k);
  }
  if (map.joints_.empty() || map.joints_.size() > 2) return std::nullopt;
  map.determinant_ = map.joints_.size() == 1 ? dot(map.vector(0), map.vector(0)) : cross(map.vector(0), map.vector(1));
  if (map.determinant_.is_zero()) return std::nullopt;
  return map;
}

ExactPoint SlideMap::displaced(const JointValues& values) const {
  ExactVector by;
  for (const std::size_t k : joints_) {
    const Dyadic value = Dyadic::exact(values[k]);
    by = sum(by, {value * slides_.joint[k].x, value * slides_.joint[k].y});
  }
  return ExactPoint::of(by.x, by.y);
}

/// Counterclockwise.
ConvexRing SlideMap::displaced(const JointValues& lo, const JointValues& hi) const {
  JointValues at = lo;
  ConvexRing ring = {displaced(at)};
  const bool turned = joints_.size() == 2 && determinant_.sign() < 0;
  const std::size_t first = turned ? joints_.back() : joints_.front(),
                    second = turned ? joints_.front() : joints_.back();
  at[first] = hi[first];
  ring.push_back(displaced(at));
  if (joints_.size() == 2) {
    at[second] = hi[second];
    ring.push_back(displaced(at));
    at[first] = lo[first];
    ring.push_back(displaced(at));
  }
  return without_repeated(ring);
}

JointValues SlideMap::values_at(const ExactPoint& displacement, JointValues others) const {
  const ExactVector by{displacement.x, displacement.y};
  const Dyadic scale = determinant_ * displacement.w;
  if (joints_.size() == 1) {
    others[joints_[0]] = quotient(dot(by, vector(0)), scale);
  } else {
    others[joints_[0]] = quotient(cross(by, vector(1)), scale);
    others[joints_[1]] = quotient(cross(vector(0), by), scale);
  }
  return others;
}

}  // namespace taut::internal::path
