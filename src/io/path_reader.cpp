// Outlines from the data of an SVG path.
#include "geometry/part_rings.hpp"
#include "io/shape_reader.hpp"
#include "io/text.hpp"
#include "numeric/overloaded.hpp"
#include "taut/error.hpp"
#include "taut/outline.hpp"

namespace taut {
using namespace internal;
namespace {

void add_point(std::string& s, const Point& p) { s += " " + io::number_text(p.x) + " " + io::number_text(p.y); }

void add_ring(std::string& s, const Outline& ring) {
  s += s.empty() ? "M" : " M";
  add_point(s, ring.start);
  for (const CurveSegment& segment : ring.segments) {
    std::visit(Overloaded{[&](const LineTo&) { s += " L"; },
                          [&](const ArcTo& arc) {
                            s += " A " + io::number_text(arc.rx) + " " + io::number_text(arc.ry) + " " +
                                 io::number_text(arc.rotation_deg) + (arc.large ? " 1" : " 0") +
                                 (arc.sweep ? " 1" : " 0");
                          },
                          [&](const QuadraticTo& q) {
                            s += " Q";
                            add_point(s, q.control);
                          },
                          [&](const CubicTo& c) {
                            s += " C";
                            add_point(s, c.first);
                            add_point(s, c.second);
                          }},
               segment);
    add_point(s, end_of(segment));
  }
  s += " Z";
}

}  // namespace

std::vector<CurvedPart> parse_path(std::string_view path, FillRule rule, const std::string& name) {
  std::vector<Outline> outlines;
  for (io::Subpath& s : io::read_path_data(path, name)) outlines.push_back(std::move(s.outline));
  if (outlines.empty()) {
    throw InputError(name, "the path has no segments", "write what it encloses, as in \"M0 0 H10 A5 5 0 0 1 10 10 Z\"");
  }
  return curve::nested(std::move(outlines), rule, name);
}

std::string write_path(const std::vector<CurvedPart>& parts) {
  std::string s;
  for (const CurvedPart& part : parts) {
    add_ring(s, part.outline);
    for (const Outline& hole : part.holes) add_ring(s, hole);
  }
  return s;
}

}  // namespace taut
