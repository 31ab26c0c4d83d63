#include "draw/world_tilings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "draw/svg_canvas.hpp"

namespace taut::internal::io {

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
