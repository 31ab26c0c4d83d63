#include "draw/svg_legend.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "draw/svg_canvas.hpp"
#include "io/text_file.hpp"

namespace taut::internal::io {

namespace {

constexpr double left = 24;
constexpr double row_height = 18;

std::string line(const char* colour, double width) {
  return fmt::format("<path d=\"M0-4H16\" stroke=\"{}\" stroke-width=\"{}\"/>", colour, width);
}

std::string arc(const char* colour) {
  return fmt::format("<path d=\"M1 0A8 8 0 0 1 15 0\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.4\"/>", colour);
}

}  // namespace

PathStyle path_style(DrawnPath::Kind kind) {
  switch (kind) {
    case DrawnPath::Kind::geodesic_0:
      return {geodesic_colour[0], 3.4, false, "geodesic"};
    case DrawnPath::Kind::geodesic_1:
      return {geodesic_colour[1], 1.8, false, "geodesic"};
    case DrawnPath::Kind::separator:
      return {separator_colour, 2.4, false, "separator"};
    case DrawnPath::Kind::gone:
      return {gone_colour, 2.4, true, "edge that goes"};
    case DrawnPath::Kind::guide:
      return {gone_colour, 0.8, true, "guide"};
    default:
      return {come_colour, 2.8, false, "edge that comes"};
  }
}

SvgLegend::SvgLegend(const Scene& scene, const Tiling& tiling, const TilingDrawOptions& options)
    : width_(std::max(options.width, 200)), x_(left) {
  for (std::size_t b = 0; b < 2 && b < scene.bodies.size(); ++b) {
    add(fmt::format("<rect y=\"-10\" width=\"16\" height=\"11\" fill=\"{}\"/>", body_fill[b]),
        excerpt(scene.bodies[b].name, 30));
  }
  if (!tiling.edges.empty() && options.edges) {
    add(line(tiling_colour, 0.8), "tiling");
    add(line(pq_colour, 2.2), "edge between the bodies");
  }
  if (options.certificates && !tiling.faces.empty()) {
    add(arc(convex_colour), "convex corner");
    add(arc(reflex_colour), "reflex corner");
  }
  std::vector<DrawnPath::Kind> seen;
  for (const DrawnPath& path : options.paths) {
    if (std::find(seen.begin(), seen.end(), path.kind) != seen.end()) continue;
    seen.push_back(path.kind);
    const PathStyle style = path_style(path.kind);
    const bool geodesic = path.kind == DrawnPath::Kind::geodesic_0 || path.kind == DrawnPath::Kind::geodesic_1;
    const std::size_t body = path.kind == DrawnPath::Kind::geodesic_1 ? 1 : 0;
    const std::string of = geodesic && body < scene.bodies.size() ? " of " + excerpt(scene.bodies[body].name, 30) : "";
    add(line(style.colour, style.width), style.label + of);
  }
  if (options.contact) add(line(contact_colour, 2.5), "contact");
}

void SvgLegend::add(std::string mark, const std::string& label) {
  // No font metrics here: a generous average width does.
  const double width = 42 + 6.6 * static_cast<double>(label.size());
  if (x_ > left && x_ + width > width_) {
    x_ = left;
    ++row_;
  }
  entries_.push_back({std::move(mark), label, x_, row_});
  x_ += width;
}

double SvgLegend::height() const { return 8 + row_height * (row_ + 1); }

std::string SvgLegend::draw(double picture_height) const {
  std::string out = "<g font-size=\"12\" fill=\"#333\">\n";
  for (const Entry& entry : entries_) {
    const double y = picture_height - 12 - row_height * (row_ - entry.row);
    out += fmt::format("<g transform=\"translate({:.0f} {:.0f})\">{}<text x=\"22\">{}</text></g>\n", entry.x, y,
                       entry.mark, escape_xml(entry.label));
  }
  return out + "</g>\n";
}

}  // namespace taut::internal::io
