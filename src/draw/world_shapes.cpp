#include "draw/world_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "draw/svg_canvas.hpp"
#include "geometry/band.hpp"
#include "io/text_file.hpp"
#include "numeric/overloaded.hpp"
#include "scene/joined_parts.hpp"
#include "scene/ring_set.hpp"

namespace taut::internal::io {
namespace {

constexpr BodyStyle styles[body_styles] = {
    {"#2a6f9e", "#032e4b", "#fff"}, {"#e59345", "#683e15", "#000"}, {"#0f7d74", "#00423c", "#fff"},
    {"#f0d762", "#675b1e", "#000"}, {"#683b6a", "#341c35", "#fff"}, {"#7abee4", "#2e5366", "#000"},
    {"#966042", "#472b1b", "#fff"}, {"#f5accc", "#6d4758", "#000"}, {"#1e4070", "#0f203a", "#fff"},
    {"#6ca45a", "#2c4923", "#000"}, {"#838a8f", "#3a3d40", "#000"}, {"#daeaa8", "#5b6342", "#000"}};

/// Lines on which an inner point is searched, in each direction, in tenths of the width; the middle first.
constexpr int scan_lines[] = {5, 4, 6, 3, 7, 2, 8, 1, 9};
/// What lies nearer to the middle is given up for so much more room only.
constexpr double worth_it = 1.1;
/// Bodies with more vertices are not searched: a number is not worth the time.
constexpr std::size_t largest_searched = 20000;

double distance(const Point& p, const Point& a, const Point& b) {
  const double ex = b.x - a.x, ey = b.y - a.y, square = ex * ex + ey * ey;
  const double share = square > 0 ? std::clamp(((p.x - a.x) * ex + (p.y - a.y) * ey) / square, 0.0, 1.0) : 0;
  return std::hypot(a.x + share * ex - p.x, a.y + share * ey - p.y);
}

template <class Visit>
void each_edge(const std::vector<Polygon>& rings, const Visit& visit) {
  for (const Polygon& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[(i + 1) % ring.size()]);
  }
}

/// The middles of the stretches of a line that lie inside: across x = c (or y = c), where it meets the rings.
std::vector<Point> middles(const std::vector<Polygon>& rings, double c, bool upright) {
  std::vector<double> at;
  each_edge(rings, [&](Point a, Point b) {
    if (upright) a = {a.y, a.x}, b = {b.y, b.x};
    if ((a.y > c) != (b.y > c)) at.push_back(a.x + (c - a.y) / (b.y - a.y) * (b.x - a.x));
  });
  std::sort(at.begin(), at.end());
  std::vector<Point> out;
  for (std::size_t i = 0; i + 1 < at.size(); i += 2) {
    const double middle = (at[i] + at[i + 1]) / 2;
    out.push_back(upright ? Point{c, middle} : Point{middle, c});
  }
  return out;
}

/// Of one part: the best of the middles of some lines across it.
InnerPoint inner_point(const std::vector<Polygon>& part) {
  const AxisBox box = box_around(part[0]);
  InnerPoint best;
  for (const int tenths : scan_lines) {
    for (const bool upright : {false, true}) {
      const double lo = upright ? box.lo_x : box.lo_y, hi = upright ? box.hi_x : box.hi_y;
      for (const Point& p : middles(part, lo + (hi - lo) * tenths / 10, upright)) {
        double room = std::numeric_limits<double>::infinity();
        each_edge(part, [&](const Point& a, const Point& b) { room = std::min(room, distance(p, a, b)); });
        if (room > worth_it * best.room) best = {p, room, 0};
      }
    }
  }
  return best;
}

/// Of each part: its outline, then its holes.
std::vector<std::vector<Polygon>> rings_of(const Body& body) {
  std::vector<std::vector<Polygon>> all;
  for (const CurvedPart& part : body.curves) all.push_back(sketched(part));
  if (!body.curves.empty()) return all;
  for (const Part& part : parts_of(body)) {
    all.push_back({part.outline});
    all.back().insert(all.back().end(), part.holes.begin(), part.holes.end());
  }
  return all;
}

}  // namespace

namespace {

/// By the parity of the edges that a ray to the right crosses.
bool is_within(const std::vector<Polygon>& rings, const Point& p) {
  bool odd = false;
  each_edge(rings, [&](const Point& a, const Point& b) {
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y))) odd = !odd;
  });
  return odd;
}

}  // namespace

bool WorldShapes::is_covered(std::size_t body, const std::vector<BodyPose>& poses) const {
  const auto has_number = [&](const PaintedSheet& sheet) {
    return sheet.body == body &&
           std::find(sheet.parts.begin(), sheet.parts.end(), bodies_[body].inner.part) != sheet.parts.end();
  };
  const Point at = placed(poses[body], bodies_[body].inner.at);
  auto sheet = std::find_if(sheets_.begin(), sheets_.end(), has_number);
  for (; sheet != sheets_.end(); ++sheet) {
    const Shape& other = bodies_[sheet->body];
    const BodyPose& pose = poses[sheet->body];
    const Point middle = placed(pose, other.middle);
    if (sheet->body == body || !(std::hypot(at.x - middle.x, at.y - middle.y) < other.extent)) continue;
    const double dx = at.x - pose.origin.x, dy = at.y - pose.origin.y;
    const Point seen{pose.axis.x * dx + pose.axis.y * dy, pose.axis.x * dy - pose.axis.y * dx};
    for (const std::size_t part : sheet->parts) {
      if (is_within(other.parts[part], seen)) return true;
    }
  }
  return false;
}

BodyStyle body_style(std::size_t body) { return styles[body % body_styles]; }

WorldShapes::WorldShapes(const Scene& scene) {
  for (const Body& body : scene.bodies) {
    Shape shape;
    AxisBox box;
    shape.curves = body.curves;
    for (std::vector<Polygon>& rings : rings_of(body)) {
      std::size_t count = 0;
      for (const Polygon& ring : rings) count += ring.size();
      vertices_ += count;
      InnerPoint inner = count <= largest_searched ? inner_point(rings) : InnerPoint{};
      inner.part = shape.parts.size();
      if (inner.room > shape.inner.room) shape.inner = inner;
      box.include(box_around(rings[0]));
      shape.parts.push_back(std::move(rings));
    }
    shape.middle = {box.lo_x / 2 + box.hi_x / 2, box.lo_y / 2 + box.hi_y / 2};
    shape.extent = std::hypot(box.width(), box.height());
    add_sheets(body, bodies_.size());
    bodies_.push_back(std::move(shape));
  }
  // Higher layers over lower ones, and small bodies over large ones.
  std::stable_sort(sheets_.begin(), sheets_.end(), [this](const PaintedSheet& a, const PaintedSheet& b) {
    return std::tuple(a.z.lo, a.z.hi, -bodies_[a.body].extent) < std::tuple(b.z.lo, b.z.hi, -bodies_[b.body].extent);
  });
  std::vector<bool> known(bodies_.size(), false);
  for (const PaintedSheet& sheet : sheets_) {
    if (!known[sheet.body]) order_.push_back(sheet.body);
    known[sheet.body] = true;
  }
}

void WorldShapes::add_sheets(const Body& body, std::size_t index) {
  const std::size_t first = sheets_.size();
  const std::vector<Layers> layers = layers_of_parts(body);
  for (std::size_t part = 0; part < layers.size(); ++part) {
    std::size_t k = first;
    while (k < sheets_.size() && !(sheets_[k].z == layers[part])) ++k;
    if (k == sheets_.size()) sheets_.push_back({index, {}, layers[part]});
    sheets_[k].parts.push_back(part);
  }
}

Point placed(const BodyPose& pose, const Point& p) {
  return {pose.origin.x + pose.axis.x * p.x - pose.axis.y * p.y, pose.origin.y + pose.axis.y * p.x + pose.axis.x * p.y};
}

std::string pair_text(const Scene& scene, BodyId a, BodyId b) {
  const auto name = [&](BodyId id) { return excerpt(scene.bodies[static_cast<std::size_t>(id)].name, 30); };
  return name(std::min(a, b)) + " x " + name(std::max(a, b));
}

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

Point place_of(const WorldShapes& shapes, const std::vector<BodyPose>& poses, const VertexRef& v) {
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  return placed(poses[at(v.body)], shapes.parts(at(v.body))[at(v.part)][at(v.ring)][at(v.index)]);
}

namespace {

double across(const Polygon& ring) {
  Point lo = ring[0], hi = ring[0];
  for (const Point& p : ring) {
    lo = {std::min(lo.x, p.x), std::min(lo.y, p.y)};
    hi = {std::max(hi.x, p.x), std::max(hi.y, p.y)};
  }
  return std::hypot(hi.x - lo.x, hi.y - lo.y);
}

/// Of the ring that a vertex is on.
double size_of(const WorldShapes& shapes, const VertexRef& v) {
  const auto& part = shapes.parts(static_cast<std::size_t>(v.body))[static_cast<std::size_t>(v.part)];
  return across(part[static_cast<std::size_t>(v.ring)]);
}

bool is_worth_drawing(const WorldShapes& shapes, const std::vector<BodyPose>& poses, const NearTiling& tiling) {
  if (tiling.contained) return true;
  return std::any_of(tiling.edges.begin(), tiling.edges.end(), [&](const NearEdge& e) {
    if (!e.pq) return false;
    const Point a = place_of(shapes, poses, e.from), b = place_of(shapes, poses, e.to);
    return std::hypot(b.x - a.x, b.y - a.y) <= std::min(size_of(shapes, e.from), size_of(shapes, e.to));
  });
}

}  // namespace

std::vector<NearEdge> tiling_lines(const WorldShapes& shapes, const std::vector<BodyPose>& poses,
                                   const std::vector<NearTiling>& tilings) {
  struct Line {
    Point from, to;
    NearEdge edge;
    auto key() const { return std::tuple(edge.pq, from.x, from.y, to.x, to.y); }
  };
  std::vector<Line> lines;
  const bool only = shapes.size() == 2 && tilings.size() == 1;
  for (const NearTiling& tiling : tilings) {
    if (!only && !is_worth_drawing(shapes, poses, tiling)) continue;
    for (const NearEdge& e : tiling.edges) {
      Line line{place_of(shapes, poses, e.from), place_of(shapes, poses, e.to), e};
      if (std::tie(line.to.x, line.to.y) < std::tie(line.from.x, line.from.y)) {
        std::swap(line.from, line.to);
        std::swap(line.edge.from, line.edge.to);
      }
      lines.push_back(line);
    }
  }
  std::sort(lines.begin(), lines.end(), [](const Line& a, const Line& b) { return a.key() < b.key(); });
  lines.erase(std::unique(lines.begin(), lines.end(), [](const Line& a, const Line& b) { return a.key() == b.key(); }),
              lines.end());
  // In an order that does not change while the bodies move.
  const auto place = [](const VertexRef& v) { return std::tuple(v.body, v.part, v.ring, v.index); };
  std::vector<NearEdge> edges;
  for (const Line& line : lines) edges.push_back(line.edge);
  for (NearEdge& e : edges)
    if (place(e.to) < place(e.from)) std::swap(e.from, e.to);
  std::sort(edges.begin(), edges.end(), [&](const NearEdge& a, const NearEdge& b) {
    return std::tuple(place(a.from), place(a.to)) < std::tuple(place(b.from), place(b.to));
  });
  return edges;
}

std::string tiling_path(const WorldShapes& shapes, const std::vector<BodyPose>& poses,
                        const std::vector<NearEdge>& lines, bool pq, const SvgCanvas& canvas) {
  std::string path;
  const auto pixel = [&](const VertexRef& v) { return pixel_text(canvas.pixel(place_of(shapes, poses, v))); };
  for (const NearEdge& e : lines)
    if (e.pq == pq) path += "M" + pixel(e.from) + "L" + pixel(e.to);
  return path;
}

std::string tiling_element(const std::string& path, bool pq, const std::string& inside) {
  return fmt::format("<path class=\"tiling\" d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\">{}</path>\n",
                     path, pq ? pq_colour : tiling_colour, pq ? 0.9 : 0.7, inside);
}

}  // namespace taut::internal::io
