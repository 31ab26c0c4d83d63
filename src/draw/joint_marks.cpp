#include "draw/joint_marks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "draw/svg_canvas.hpp"

namespace taut::internal::io {

namespace {

constexpr const char* joint_colour = "#1b1b1b";
constexpr double ring_radius = 3.2, rail_half = 11, rail_gap = 7.5;

std::size_t body_named(const Scene& scene, const std::string& name) {
  const auto named = [&](const Body& body) { return body.name == name; };
  return static_cast<std::size_t>(std::find_if(scene.bodies.begin(), scene.bodies.end(), named) - scene.bodies.begin());
}

/// On either side, so that the number of the body can stand between them.
std::string rails(const Point& along) {
  std::string path;
  for (const double side : {-rail_gap, rail_gap}) {
    const Point middle{-side * along.y, side * along.x};
    path += "M" + pixel_text({middle.x - rail_half * along.x, middle.y - rail_half * along.y}) + "L" +
            pixel_text({middle.x + rail_half * along.x, middle.y + rail_half * along.y});
  }
  return path;
}

}  // namespace

std::vector<JointPlace> joint_places(const Scene& scene, const WorldShapes& shapes) {
  std::vector<JointPlace> places;
  if (!scene.mechanism) return places;
  for (const MechanismJoint& joint : scene.mechanism->joints) {
    if (!places.empty() && places.back().name == joint.name) continue;
    const bool slides = joint.kind == MechanismJoint::Kind::slide;
    JointPlace place{joint.name, body_named(scene, slides ? joint.second : joint.first), joint.at, slides};
    if (slides) {
      const double length = std::hypot(joint.direction.x, joint.direction.y);
      place.at = shapes.inner(place.body).at;
      place.direction = {joint.direction.x / length, joint.direction.y / length};
    }
    places.push_back(place);
  }
  return places;
}

std::string joint_mark(const JointPlace& joint, const BodyPose& pose) {
  if (!joint.slides)
    return fmt::format("<circle class=\"joint\" r=\"{}\" fill=\"#fff\" stroke=\"{}\" stroke-width=\"1.6\"/>",
                       ring_radius, joint_colour);
  const Point &d = joint.direction, &axis = pose.axis;
  // In pixels y points down.
  const std::string path = rails({axis.x * d.x - axis.y * d.y, -(axis.y * d.x + axis.x * d.y)});
  return fmt::format(
      "<g class=\"joint\" fill=\"none\" stroke-linecap=\"round\"><path d=\"{0}\" stroke=\"#fff\" stroke-width=\"4\"/>"
      "<path d=\"{0}\" stroke=\"{1}\" stroke-width=\"1.6\"/></g>",
      path, joint_colour);
}

}  // namespace taut::internal::io
