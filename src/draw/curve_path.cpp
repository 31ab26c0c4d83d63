#include "draw/curve_path.hpp"

#include <fmt/format.h>

#include <cmath>

#include "draw/svg_canvas.hpp"
#include "geometry/band.hpp"
#include "numeric/overloaded.hpp"

namespace taut::internal::io {
namespace {

/// What the placement does to lengths and angles, which arcs are given by.
class CurvePen {
 public:
  explicit CurvePen(const PlaceOnPage& place) : place_(place) {
    const Point origin = place({0, 0}), x = place({1, 0}), y = place({0, 1});
    const double ax = x.x - origin.x, ay = x.y - origin.y, bx = y.x - origin.x, by = y.y - origin.y;
    scale_ = std::hypot(ax, ay);
    mirrored_ = ax * by - ay * bx < 0;
    turn_ = std::atan2(ay, ax) * (180 / 3.14159265358979323846);
  }

  std::string ring(const Outline& outline) const {
    std::string s = "M" + at(outline.start);
    for (const CurveSegment& segment : outline.segments) {
      s += std::visit(Overloaded{[](const LineTo&) { return std::string("L"); },
                                 [&](const ArcTo& arc) { return arc_text(arc); },
                                 [&](const QuadraticTo& q) { return "Q" + at(q.control) + " "; },
                                 [&](const CubicTo& c) { return "C" + at(c.first) + " " + at(c.second) + " "; }},
                      segment) +
           at(end_of(segment));
    }
    return s + "Z";
  }

 private:
  std::string at(const Point& p) const { return pixel_text(place_(p)); }

  std::string arc_text(const ArcTo& arc) const {
    const double turned = turn_ + (mirrored_ ? -arc.rotation_deg : arc.rotation_deg);
    return fmt::format("A{:.4g},{:.4g} {:.6g} {} {} ", arc.rx * scale_, arc.ry * scale_, arc.rx == arc.ry ? 0 : turned,
                       arc.large ? 1 : 0, arc.sweep != mirrored_ ? 1 : 0);
  }

  const PlaceOnPage& place_;
  double scale_ = 1, turn_ = 0;
  bool mirrored_ = false;
};

}  // namespace

std::string curve_path(const CurvedPart& part, const PlaceOnPage& place) {
  const CurvePen pen(place);
  std::string path = pen.ring(part.outline);
  for (const Outline& hole : part.holes) path += pen.ring(hole);
  return path;
}

std::vector<Polygon> sketched(const CurvedPart& part) {
  std::vector<Polygon> rings;
  const auto add = [&](const Outline& outline) {
    curve::Band band(outline, "outline");
    const double fine = band.resolution().size / 512;
    for (int round = 0; round < 8; ++round) {
      std::vector<int> halvings;
      for (const curve::Cell& cell : band.cells()) halvings.push_back(cell.thickness > fine ? 1 : 0);
      band.refine(halvings);
    }
    rings.push_back(band.wall(true));
  };
  add(part.outline);
  for (const Outline& hole : part.holes) add(hole);
  return rings;
}

}  // namespace taut::internal::io
