// What is marked in the picture of a world: contacts and overlaps, with the pair named.
#pragma once

#include <string>
#include <vector>

#include "draw/svg_canvas.hpp"
#include "draw/world_shapes.hpp"
#include "taut/io.hpp"

namespace taut::internal::io {

/// The opening tag and the title. A picture that moves pauses when it is clicked, and rests for those who prefer that.
std::string world_head(const SvgCanvas& canvas, const std::string& title, bool moving = false);
/// Lines get thinner as the picture gets crowded.
double world_outline_width(const WorldShapes& shapes);

/// The rings of a part as the data of one path, for the rule evenodd; `pixel` places a point of the body.
template <class Pixel>
std::string rings_path(const std::vector<Polygon>& rings, const Pixel& pixel) {
  std::string path;
  for (const Polygon& ring : rings) {
    std::vector<Point> pixels;
    pixels.reserve(ring.size());
    for (const Point& p : ring) pixels.push_back(pixel(p));
    path += outline_path(pixels);
  }
  return path;
}

/// A body of these parts, each the data of a path. What of a part's line lies inside another part is not seen.
std::string body_shape(const std::vector<std::string>& parts, std::size_t body, double line_width);
/// The same for those parts of `shapes` that are painted at once.
template <class Pixel>
std::string sheet_shape(const WorldShapes& shapes, const PaintedSheet& sheet, const Pixel& pixel) {
  const std::vector<CurvedPart>& curves = shapes.curves(sheet.body);
  std::vector<std::string> parts;
  for (const std::size_t part : sheet.parts)
    parts.push_back(curves.empty() ? rings_path(shapes.parts(sheet.body)[part], pixel)
                                   : curve_path(curves[part], pixel));
  return body_shape(parts, sheet.body, world_outline_width(shapes));
}

/// All marks of `options`, where the bodies are at `poses`.
std::string world_marks(const Scene& scene, const WorldShapes& shapes, const std::vector<BodyPose>& poses,
                        const SvgCanvas& canvas, const DrawOptions& options);

/// The names of a few bodies, or how many there are.
std::string world_title(const Scene& scene);

/// Is there room for a number in the body, at this many pixels a unit?
bool has_room(const InnerPoint& inner, double scale, std::size_t body);
/// The number that a body has in the legend, centred at the origin.
std::string number_mark(std::size_t body);

// The joints of a mechanism as pictures show them: a ring where links turn, a pair of rails where they slide.

/// Where a joint is drawn. Its mark moves with a body.
struct JointPlace {
  std::string name;
  std::size_t body = 0;
  Point at;              ///< in the coordinates of that body
  bool slides = false;   ///< along `direction`, which turns with the body
  Point direction = {};  ///< of length 1
};

/// One place for each name. Links turn about a point that their joint's first body carries. A slide is drawn on its
/// second body, deep inside it: what slides is always as parallel to the direction as in the drawn pose.
std::vector<JointPlace> joint_places(const Scene& scene, const WorldShapes& shapes);

/// The mark, centred at the origin, where the body is at `pose`.
std::string joint_mark(const JointPlace& joint, const BodyPose& pose);

}  // namespace taut::internal::io
