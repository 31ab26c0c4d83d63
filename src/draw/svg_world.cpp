// A picture of any number of bodies at one instant.
#include <fmt/format.h>

#include "draw/svg_legend.hpp"
#include "draw/world_marks.hpp"
#include "draw/world_shapes.hpp"
#include "io/text.hpp"
#include "taut/io.hpp"

namespace taut {
using namespace internal;

namespace {

class WorldPicture {
 public:
  WorldPicture(const Scene& scene, double t, const DrawOptions& options)
      : scene_(scene),
        t_(t),
        options_(options),
        shapes_(scene),
        poses_(poses_at(scene, t)),
        legend_(scene, options.width),
        canvas_(all_points(), options.width, io::title_height, options.legend ? legend_.height() : 0) {}

  std::string draw() const {
    const std::string title = options_.title.empty() ? fmt::format("{}, t = {}", io::world_title(scene_),
                                                                   io::instant_text(t_, scene_.start, scene_.end, 10))
                                                     : options_.title;
    std::string out = io::world_head(canvas_, title);
    for (const DrawnRegion& region : options_.regions) out += draw_region(region);
    // Below the bodies: lines lie between those of their pair.
    const std::vector<NearEdge> lines = io::tiling_lines(shapes_, poses_, options_.tilings);
    for (const bool pq : {false, true}) {
      const std::string path = io::tiling_path(shapes_, poses_, lines, pq, canvas_);
      if (!path.empty()) out += io::tiling_element(path, pq);
    }
    for (const io::PaintedSheet& sheet : shapes_.sheets()) out += draw_sheet(sheet);
    for (const std::size_t body : shapes_.painting_order()) out += draw_number(body);
    for (const io::JointPlace& joint : io::joint_places(scene_, shapes_)) out += draw_joint(joint);
    out += io::world_marks(scene_, shapes_, poses_, canvas_, options_);
    if (options_.legend) out += legend_.draw(canvas_.height() - legend_.height());
    return out + "</svg>\n";
  }

 private:
  std::vector<Point> all_points() const {
    std::vector<Point> points;
    for (std::size_t b = 0; b < shapes_.size(); ++b) {
      for (const std::vector<Polygon>& part : shapes_.parts(b)) {
        for (const Point& p : part[0]) points.push_back(io::placed(poses_[b], p));
      }
    }
    for (const Contact& contact : options_.contacts) points.push_back(contact.point);
    for (const DrawnRegion& region : options_.regions) {
      for (const Part& part : region.parts) points.insert(points.end(), part.outline.begin(), part.outline.end());
    }
    return points;
  }

  std::string draw_region(const DrawnRegion& region) const {
    std::string path;
    const auto add = [&](const Polygon& ring) {
      std::vector<Point> pixels;
      for (const Point& p : ring) pixels.push_back(canvas_.pixel(p));
      path += io::outline_path(pixels);
    };
    for (const Part& part : region.parts) {
      add(part.outline);
      for (const Polygon& hole : part.holes) add(hole);
    }
    const io::BodyStyle style = io::body_style(static_cast<std::size_t>(region.body));
    return fmt::format(
        "<path d=\"{}\" fill=\"{}\" fill-opacity=\"0.25\" fill-rule=\"evenodd\" stroke=\"{}\" "
        "stroke-width=\"1\"/>\n",
        path, style.fill, style.line);
  }

  std::string draw_sheet(const io::PaintedSheet& sheet) const {
    const auto pixel = [&](const Point& p) { return canvas_.pixel(io::placed(poses_[sheet.body], p)); };
    return io::sheet_shape(shapes_, sheet, pixel) + "\n";
  }

  std::string draw_number(std::size_t body) const {
    const io::InnerPoint& inner = shapes_.inner(body);
    if (!options_.legend || !io::has_room(inner, canvas_.scale(), body) || shapes_.is_covered(body, poses_)) return "";
    const Point p = canvas_.pixel(io::placed(poses_[body], inner.at));
    return fmt::format("<g transform=\"translate({})\">{}</g>\n", io::pixel_text(p), io::number_mark(body));
  }

  std::string draw_joint(const io::JointPlace& joint) const {
    const BodyPose& pose = poses_[joint.body];
    return fmt::format("<g transform=\"translate({})\">{}</g>\n",
                       io::pixel_text(canvas_.pixel(io::placed(pose, joint.at))), io::joint_mark(joint, pose));
  }

  const Scene& scene_;
  double t_;
  const DrawOptions& options_;
  io::WorldShapes shapes_;
  std::vector<BodyPose> poses_;
  io::WorldLegend legend_;
  io::SvgCanvas canvas_;
};

}  // namespace

DrawOptions marked(const Answer& answer, DrawOptions options) {
  if (answer.contact) options.contacts.push_back(*answer.contact);
  if (answer.outcome == Outcome::overlap_at_start)
    options.overlaps.push_back(answer.pair.value_or(std::array<BodyId, 2>{0, 1}));
  for (const PairAnswer& pair : answer.also) {
    if (pair.contact) options.contacts.push_back(*pair.contact);
    if (pair.outcome == Outcome::overlap_at_start) options.overlaps.push_back(pair.bodies);
  }
  return options;
}

std::string draw_svg(const Scene& scene, double t, const DrawOptions& options) {
  return WorldPicture(scene, t, options).draw();
}

}  // namespace taut
