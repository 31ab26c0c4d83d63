#include "io/world_tilings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "io/svg_style.hpp"

namespace taut::internal::io {
namespace {

Point place_of(const WorldShapes& shapes, const std::vector<BodyPose>& poses, const VertexRef& v) {
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  return placed(poses[at(v.body)], shapes.parts(at(v.body))[at(v.part)][at(v.ring)][at(v.index)]);
}

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

auto key_of(const TilingLine& l) { return std::tuple(l.pq, l.from.x, l.from.y, l.to.x, l.to.y); }

}  // namespace

std::vector<TilingLine> tiling_lines(const WorldShapes& shapes, const std::vector<BodyPose>& poses,
                                     const std::vector<NearTiling>& tilings) {
  std::vector<TilingLine> lines;
  for (const NearTiling& tiling : tilings) {
    if (!is_worth_drawing(shapes, poses, tiling)) continue;
    for (const NearEdge& e : tiling.edges) {
      Point a = place_of(shapes, poses, e.from), b = place_of(shapes, poses, e.to);
      if (std::tie(b.x, b.y) < std::tie(a.x, a.y)) std::swap(a, b);
      lines.push_back({a, b, e.pq});
    }
  }
  std::sort(lines.begin(), lines.end(), [](const TilingLine& a, const TilingLine& b) { return key_of(a) < key_of(b); });
  lines.erase(std::unique(lines.begin(), lines.end(),
                          [](const TilingLine& a, const TilingLine& b) { return key_of(a) == key_of(b); }),
              lines.end());
  return lines;
}

std::string tiling_paths(const std::vector<TilingLine>& lines, const SvgCanvas& canvas) {
  std::string out;
  for (const bool pq : {false, true}) {
    std::string path;
    for (const TilingLine& l : lines) {
      if (l.pq == pq) path += "M" + pixel_text(canvas.pixel(l.from)) + "L" + pixel_text(canvas.pixel(l.to));
    }
    if (path.empty()) continue;
    out += fmt::format("<path class=\"tiling\" d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"/>\n", path,
                       pq ? pq_colour : tiling_colour, pq ? 0.9 : 0.7);
  }
  return out;
}

}  // namespace taut::internal::io
