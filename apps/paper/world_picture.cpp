#include "world_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace taut::paper {

std::string draw_world(const std::vector<Polygon>& bodies, const std::vector<DrawnEdge>& edges) {
  constexpr double width = 470, margin = 6;
  double left = INFINITY, right = -INFINITY, low = INFINITY, high = -INFINITY;
  for (const Polygon& body : bodies) {
    for (const Point& p : body) {
      left = std::min(left, p.x), right = std::max(right, p.x);
      low = std::min(low, p.y), high = std::max(high, p.y);
    }
  }
  const double scale = (width - 2 * margin) / (right - left);
  const auto place = [&](const Point& p) {
    return fmt::format("{:.1f} {:.1f}", margin + scale * (p.x - left), margin + scale * (high - p.y));
  };
  std::string out = fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{:.0f}\" height=\"{:.0f}\">\n",
                                width, scale * (high - low) + 2 * margin);
  for (const Polygon& body : bodies) {
    std::string path;
    for (const Point& p : body) path += (path.empty() ? "M" : "L") + place(p);
    out += fmt::format("<path d=\"{}z\" fill=\"#d5d9de\" stroke=\"#5b6673\" stroke-width=\"0.8\"/>\n", path);
  }
  for (const bool mixed : {false, true}) {
    std::string path;
    for (const DrawnEdge& e : edges)
      if (e.mixed == mixed) path += "M" + place(e.from) + "L" + place(e.to);
    out += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"/>\n", path,
                       mixed ? "#d55e00" : "#0072b2", mixed ? 1.1 : 0.6);
  }
  return out + "</svg>\n";
}

}  // namespace taut::paper
