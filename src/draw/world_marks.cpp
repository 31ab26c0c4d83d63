#include "draw/world_marks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "draw/svg_canvas.hpp"
#include "draw/svg_track.hpp"
#include "io/text_file.hpp"

namespace taut::internal::io {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr const char* distance_colour = "#6a1fb5";
constexpr const char* free_colour = "#0f6b4f";
constexpr double rose_radius = 38;

/// Text next to a point, on the side where there is more room.
std::string label_at(const Point& p, const SvgCanvas& canvas, const std::string& text,
                     const char* colour = contact_colour) {
  const bool right = p.x < canvas.width() / 2;
  return fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-weight=\"bold\" fill=\"{}\" stroke=\"#fff\" "
      "stroke-width=\"4\" stroke-linejoin=\"round\" paint-order=\"stroke\">{}</text>\n",
      p.x + (right ? 14 : -14), p.y < title_height + 24 ? p.y + 26 : p.y - 14, right ? "start" : "end", colour,
      escape_xml(text));
}

/// White below, so that a line is seen on every colour.
std::string seamed(const std::string& path, double width, const char* colour = contact_colour) {
  return fmt::format(
      "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\"><path d=\"{0}\" stroke=\"#fff\" "
      "stroke-width=\"{1}\"/><path d=\"{0}\" stroke=\"{2}\" stroke-width=\"{3}\"/></g>\n",
      path, 2 * width, colour, width);
}

std::string contact_mark(const WorldShapes& shapes, const std::vector<BodyPose>& poses, const SvgCanvas& canvas,
                         const Contact& contact) {
  const Point p = canvas.pixel(contact.point);
  const Point tip{p.x + 30 * contact.normal.x, p.y - 30 * contact.normal.y};
  const std::string circle = fmt::format("M{:.2f},{:.2f}a9,9 0 1 0 18,0a9,9 0 1 0 -18,0", p.x - 9, p.y);
  const std::string normal = "M" + pixel_text(p) + "L" + pixel_text(tip) + circle;
  if (contact.edge.parameter) return seamed(normal, 2.5);
  const Polygon& ring = shapes.parts(at(contact.edge.body))[at(contact.edge.part)][at(contact.edge.ring)];
  const BodyPose& pose = poses[at(contact.edge.body)];
  const std::size_t i = at(contact.edge.index);
  const Point a = canvas.pixel(placed(pose, ring[i])), b = canvas.pixel(placed(pose, ring[(i + 1) % ring.size()]));
  return seamed("M" + pixel_text(a) + "L" + pixel_text(b) + normal, 2.5);
}

std::string overlap_mark(const WorldShapes& shapes, const std::vector<BodyPose>& poses, const SvgCanvas& canvas,
                         const std::array<BodyId, 2>& pair) {
  std::string out;
  for (const BodyId body : pair) {
    const auto pixel = [&](const Point& p) { return canvas.pixel(placed(poses[at(body)], p)); };
    for (const std::vector<Polygon>& part : shapes.parts(at(body))) out += seamed(rings_path(part, pixel), 2);
  }
  return out;
}

std::string circle_path(const Point& middle, double radius) {
  return fmt::format("M{:.2f},{:.2f}a{r},{r} 0 1 0 {d},0a{r},{r} 0 1 0 -{d},0", middle.x - radius, middle.y,
                     fmt::arg("r", radius), fmt::arg("d", 2 * radius));
}

/// A line between the points, and a ring around them where they are too close to be distinguished.
std::string distance_mark(const SvgCanvas& canvas, const DrawnDistance& distance) {
  const Point a = canvas.pixel(distance.points[0]), b = canvas.pixel(distance.points[1]);
  std::string path = "M" + pixel_text(a) + "L" + pixel_text(b);
  if (std::hypot(a.x - b.x, a.y - b.y) < 12) path += circle_path({(a.x + b.x) / 2, (a.y + b.y) / 2}, 12);
  std::string out = "<g class=\"distance\">" + seamed(path, 2.2, distance_colour);
  for (const Point& p : {a, b})
    out += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"2.5\" fill=\"{}\"/>", p.x, p.y, distance_colour);
  return out + "</g>\n";
}

/// On a circle around a pixel, an angle counterclockwise as it is seen.
Point on_circle(const Point& middle, double degrees) {
  const double angle = degrees * 3.14159265358979323846 / 180;
  return {middle.x + rose_radius * std::cos(angle), middle.y - rose_radius * std::sin(angle)};
}

std::string sector_of(const Point& middle, double from, double to) {
  const Point a = on_circle(middle, from), b = on_circle(middle, to);
  if (to - from < 0.5)
    return fmt::format("<path class=\"free\" d=\"M{}L{}\" stroke-width=\"3\"/>", pixel_text(middle), pixel_text(a));
  if (to - from > 359.999) return fmt::format("<path class=\"free\" d=\"{}Z\"/>", circle_path(middle, rose_radius));
  return fmt::format("<path class=\"free\" d=\"M{}L{}A{r},{r} 0 {} 0 {}Z\"/>", pixel_text(middle), pixel_text(a),
                     to - from > 180 ? 1 : 0, pixel_text(b), fmt::arg("r", rose_radius));
}

/// A white ground, so that it is seen on every colour.
std::string rose_mark(const WorldShapes& shapes, const std::vector<BodyPose>& poses, const SvgCanvas& canvas,
                      const DrawnRose& rose) {
  const Point middle = canvas.pixel(placed(poses[at(rose.body)], shapes.inner(at(rose.body)).at));
  std::string out = fmt::format(
      "<g class=\"rose\" fill=\"{0}\" fill-opacity=\"0.75\" stroke=\"{0}\"><circle cx=\"{1:.2f}\" cy=\"{2:.2f}\" "
      "r=\"{3}\" fill=\"#fff\" fill-opacity=\"1\" stroke=\"#5f6b76\"/>",
      free_colour, middle.x, middle.y, rose_radius);
  for (const auto& [from, to] : rose.arcs) out += sector_of(middle, from, to);
  // It lies where the number was.
  const Point number{middle.x, middle.y - rose_radius - 9};
  return out +
         fmt::format("</g>\n<g transform=\"translate({})\">{}</g>\n", pixel_text(number), number_mark(at(rose.body)));
}

/// Where the pair's name stands: in the smaller one's place.
Point middle_of(const WorldShapes& shapes, const std::vector<BodyPose>& poses, const std::array<BodyId, 2>& pair) {
  const std::vector<std::size_t>& order = shapes.painting_order();
  const auto rank = [&](BodyId b) { return std::find(order.begin(), order.end(), at(b)) - order.begin(); };
  const BodyId small = rank(pair[0]) > rank(pair[1]) ? pair[0] : pair[1];
  return placed(poses[at(small)], shapes.inner(at(small)).at);
}

}  // namespace

std::string world_head(const SvgCanvas& canvas, const std::string& title, bool moving) {
  const std::string font = "font-family=\"sans-serif\" font-size=\"13\"";
  return svg_tag(canvas.width(), canvas.height(), moving ? font + " " + pauses_on_click : font) +
         fmt::format(
             "{0}<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n"
             "<title>{1}</title>\n<text x=\"24\" y=\"22\" font-size=\"15\" fill=\"#222\">{1}</text>\n",
             moving ? moving_style : "", escape_xml(title));
}

std::string body_shape(const std::vector<std::string>& parts, std::size_t body, double line_width) {
  const BodyStyle style = body_style(body);
  std::string out = fmt::format(
      "<g fill=\"{}\" fill-rule=\"evenodd\" stroke=\"{}\" stroke-width=\"{:.3g}\" stroke-linejoin=\"round\" "
      "opacity=\"0.93\">",
      style.fill, style.line, parts.size() > 1 ? 1.6 * line_width : line_width);
  for (const std::string& part : parts) out += "<path d=\"" + part + "\"/>";
  if (parts.size() > 1) {
    for (const std::string& part : parts) out += "<path d=\"" + part + "\" stroke=\"none\"/>";
  }
  return out + "</g>";
}

std::string world_marks(const Scene& scene, const WorldShapes& shapes, const std::vector<BodyPose>& poses,
                        const SvgCanvas& canvas, const DrawOptions& options) {
  std::string out;
  for (const auto& pair : options.overlaps) out += overlap_mark(shapes, poses, canvas, pair);
  for (const Contact& contact : options.contacts) out += contact_mark(shapes, poses, canvas, contact);
  for (const DrawnRose& rose : options.roses) out += rose_mark(shapes, poses, canvas, rose);
  for (const DrawnDistance& distance : options.distances) out += distance_mark(canvas, distance);
  // Words last, so that no line crosses them.
  for (const DrawnDistance& distance : options.distances)
    out += label_at(canvas.pixel(distance.points[0]), canvas, distance.text, distance_colour);
  for (const auto& pair : options.overlaps)
    out += label_at(canvas.pixel(middle_of(shapes, poses, pair)), canvas,
                    "overlap: " + pair_text(scene, pair[0], pair[1]));
  for (const Contact& contact : options.contacts)
    out += label_at(canvas.pixel(contact.point), canvas,
                    "contact: " + pair_text(scene, contact.vertex.body, contact.edge.body));
  return out;
}

std::string world_title(const Scene& scene) {
  if (scene.bodies.size() > 3) return fmt::format("{} bodies", scene.bodies.size());
  std::string s;
  for (const Body& body : scene.bodies) s += (s.empty() ? "" : ", ") + body.name;
  return excerpt(s, 80);
}

double world_outline_width(const WorldShapes& shapes) {
  return std::round(14 * std::clamp(60.0 / std::sqrt(static_cast<double>(shapes.vertices()) + 1), 0.4, 1.0)) / 10;
}

bool has_room(const InnerPoint& inner, double scale, std::size_t body) {
  return inner.room * scale >= (body < 9 ? 7 : body < 99 ? 9 : 12);
}

std::string number_mark(std::size_t body) {
  const BodyStyle style = body_style(body);
  return fmt::format("<text y=\"4\" text-anchor=\"middle\" font-size=\"11\" fill=\"{}\">{}</text>", style.ink,
                     body + 1);
}

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
