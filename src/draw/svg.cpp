// A picture of the tiling. Elements of one style share one path each: ten thousand vertices make about twenty elements.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "draw/svg_canvas.hpp"
#include "draw/svg_legend.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "taut/io.hpp"
#include "taut/shape.hpp"

namespace taut {
using namespace internal;

namespace {

using io::pixel_text;

/// Deeper trees spread over the same colours.
constexpr int palette_size = 8;
/// One sequential palette a tree, strong near the root and pale at the leaves; they differ in hue and survive
/// colour-blindness (blue against orange).
const char* const palettes[2][palette_size] = {
    {"#6aa5d8", "#7fb2de", "#93bfe4", "#a7cbe9", "#bad6ee", "#cbe0f2", "#dae9f6", "#e8f1fa"},
    {"#f0a35e", "#f3b075", "#f5bc8b", "#f7c8a1", "#f9d3b5", "#fbdec8", "#fce8d9", "#fdf1e8"}};

class TilingPicture {
 public:
  TilingPicture(const Scene& scene, const Tiling& tiling, const TilingDrawOptions& options)
      : scene_(scene),
        tiling_(tiling),
        options_(options),
        legend_(scene, tiling, options),
        canvas_(all_points(tiling, options), options.width, io::title_height, options.legend ? legend_.height() : 0) {
    pixels_.reserve(tiling.vertices.size());
    for (const TilingVertex& v : tiling.vertices) pixels_.push_back(canvas_.pixel(v.position));
  }

  std::string draw() {
    out_ = io::svg_tag(canvas_.width(), canvas_.height(), "font-family=\"sans-serif\" font-size=\"13\"") +
           "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
    draw_title();
    if (options_.faces) draw_faces();
    draw_bodies();
    if (options_.edges) draw_edges();
    if (options_.certificates) draw_corners();
    for (const DrawnPath& path : options_.paths) draw_path(path);
    if (options_.contact) draw_contact(*options_.contact);
    for (const DrawnLabel& label : options_.labels) draw_label(label);
    if (!options_.legend) return out_ + "</svg>\n";
    return out_ + legend_.draw(canvas_.height()) + "</svg>\n";
  }

 private:
  static std::vector<Point> all_points(const Tiling& tiling, const TilingDrawOptions& options) {
    if (!options.window.empty()) return options.window;
    std::vector<Point> points;
    for (const TilingVertex& v : tiling.vertices) points.push_back(v.position);
    if (options.contact) points.push_back(options.contact->point);
    return points;
  }

  int body_of(int vertex) const { return tiling_.vertices[static_cast<std::size_t>(vertex)].vertex.body == 0 ? 0 : 1; }
  const Point& pixel_of(int vertex) const { return pixels_[static_cast<std::size_t>(vertex)]; }

  std::string names() const {
    std::string s;
    for (const Body& body : scene_.bodies) s += (s.empty() ? "" : " and ") + body.name;
    return s;
  }

  void draw_title() {
    const std::string title = io::escape_xml(
        options_.title.empty() ? fmt::format("{}, t = {}", io::excerpt(names(), 80),
                                             io::instant_text(tiling_.time, scene_.start, scene_.end, 10))
                               : options_.title);
    out_ +=
        fmt::format("<title>{0}</title>\n<text x=\"24\" y=\"22\" font-size=\"15\" fill=\"#222\">{0}</text>\n", title);
  }

  std::string face_path(const TilingFace& face) const {
    std::vector<Point> outline;
    for (int v : face.boundary) outline.push_back(pixel_of(v));
    return io::outline_path(outline);
  }

  void draw_faces() {
    std::map<std::string, std::string> by_colour;
    int deepest = palette_size - 1;
    for (const TilingFace& face : tiling_.faces) deepest = std::max(deepest, face.depth);
    for (const TilingFace& face : tiling_.faces) {
      if (face.boundary.empty()) continue;
      if (face.kind == FaceKind::root) by_colour["#ececec"] += face_path(face);
      if (face.kind != FaceKind::node) continue;  // the infinite face is the paper
      const int shade = std::clamp(face.depth * (palette_size - 1) / deepest, 0, palette_size - 1);
      by_colour[palettes[face.body == 0 ? 0 : 1][shade]] += face_path(face);
    }
    for (const auto& [colour, path] : by_colour) {
      out_ += fmt::format("<path d=\"{}\" fill=\"{}\"/>\n", path, colour);
    }
  }

  void draw_bodies() {
    std::vector<Point> outlines[2];
    for (std::size_t b = 0; b < 2 && b < scene_.bodies.size(); ++b)
      outlines[b].resize(polygon_of(scene_.bodies[b]).size());
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      const TilingVertex& v = tiling_.vertices[i];
      std::vector<Point>& outline = outlines[v.vertex.body == 0 ? 0 : 1];
      if (static_cast<std::size_t>(v.vertex.index) < outline.size())
        outline[static_cast<std::size_t>(v.vertex.index)] = pixels_[i];
    }
    for (std::size_t b = 0; b < 2; ++b) {
      if (outlines[b].empty()) continue;
      out_ += fmt::format(
          "<path d=\"{}\" fill=\"{}\" fill-opacity=\"0.9\" stroke=\"{}\" stroke-width=\"{}\" "
          "stroke-linejoin=\"round\"/>\n",
          io::outline_path(outlines[b]), io::body_fill[b], io::body_line[b], outline_width());
    }
  }

  /// Lines get thinner as the picture gets crowded.
  double crowding() const { return std::clamp(60.0 / std::sqrt(static_cast<double>(pixels_.size()) + 1), 0.4, 1.0); }
  double outline_width() const { return std::round(14 * crowding()) / 10; }

  void draw_edges() {
    std::string thin, bold;
    for (const TilingEdge& edge : tiling_.edges) {
      if (edge.polygon) continue;
      std::string& path = edge.pq ? bold : thin;
      path += "M" + pixel_text(pixel_of(edge.from)) + "L" + pixel_text(pixel_of(edge.to));
    }
    const auto lines = [this](const std::string& path, const char* colour, double width) {
      if (path.empty()) return;
      out_ +=
          fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:.2g}\" stroke-linecap=\"round\"/>\n",
                      path, colour, width);
    };
    lines(thin, io::tiling_colour, 0.7 * crowding());
    lines(bold, io::pq_colour, 2.2 * crowding());
  }

  /// A corner is active if one of its edges joins the two bodies: only such corners can fail.
  void draw_corners() {
    std::string convex, reflex;
    for (const TilingFace& face : tiling_.faces) {
      const std::size_t n = face.boundary.size();
      for (std::size_t i = 0; i < n; ++i) {
        const int u = face.boundary[i], v = face.boundary[(i + 1) % n], w = face.boundary[(i + 2) % n];
        if (body_of(u) == body_of(v) && body_of(v) == body_of(w)) continue;
        add_corner(pixel_of(u), pixel_of(v), pixel_of(w), &convex, &reflex);
      }
    }
    const auto arcs = [this](const std::string& path, const char* colour) {
      if (path.empty()) return;
      out_ += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.3\"/>\n", path, colour);
    };
    arcs(convex, io::convex_colour);
    arcs(reflex, io::reflex_colour);
  }

  /// An arc around v from the edge to w to the edge to u: the face is on the left of u, v, w (as seen with y up).
  static void add_corner(const Point& u, const Point& v, const Point& w, std::string* convex, std::string* reflex) {
    const double ux = u.x - v.x, uy = u.y - v.y, wx = w.x - v.x, wy = w.y - v.y;
    const double to_u = std::hypot(ux, uy), to_w = std::hypot(wx, wy);
    const double radius = std::min(9.0, 0.35 * std::min(to_u, to_w));
    if (!(radius > 0.8)) return;
    // In pixels y points down, so a left turn in the world has a negative cross product here.
    const bool is_convex = ux * wy - uy * wx > 0;
    const Point from{v.x + wx / to_w * radius, v.y + wy / to_w * radius};
    const Point to{v.x + ux / to_u * radius, v.y + uy / to_u * radius};
    *(is_convex ? convex : reflex) +=
        fmt::format("M{}A{:.1f} {:.1f} 0 {} 0 {}", pixel_text(from), radius, radius, is_convex ? 0 : 1, pixel_text(to));
  }

  void draw_path(const DrawnPath& path) {
    std::string d;
    for (const Point& p : path.points) d += (d.empty() ? "M" : "L") + pixel_text(canvas_.pixel(p));
    if (path.closed) d += "Z";
    const io::PathStyle style = io::path_style(path.kind);
    // A light seam sets the line off from what lies below it.
    for (const auto& [colour, width, opacity] :
         {std::tuple{"#ffffff", style.width * 1.8, 0.75}, std::tuple{style.colour, style.width, 1.0}}) {
      out_ += fmt::format(
          "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:.2g}\" stroke-opacity=\"{}\" "
          "stroke-linejoin=\"round\" stroke-linecap=\"round\"{}/>\n",
          d, colour, width, opacity, style.dashed ? " stroke-dasharray=\"6 5\"" : "");
    }
    for (const Point& p : path.stars) draw_star(canvas_.pixel(p), style.colour);
  }

  void draw_star(const Point& at, const char* colour) {
    std::vector<Point> outline;
    for (int k = 0; k < 10; ++k) {
      const double radius = k % 2 == 0 ? 7.5 : 3.2, angle = 0.6283185307179586 * k;
      outline.push_back({at.x + radius * std::sin(angle), at.y - radius * std::cos(angle)});
    }
    out_ += fmt::format("<path d=\"{}\" fill=\"{}\" stroke=\"#fff\" stroke-width=\"1\"/>\n", io::outline_path(outline),
                        colour);
  }

  void draw_label(const DrawnLabel& label) {
    const Point p = canvas_.pixel(label.at);
    out_ += fmt::format(
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\" fill=\"#111\" stroke=\"#fff\" stroke-width=\"3\" "
        "stroke-linejoin=\"round\" paint-order=\"stroke\">{}</text>\n",
        p.x, p.y + 4.5, io::escape_xml(label.text));
  }

  void draw_contact(const Contact& contact) {
    const Point p = canvas_.pixel(contact.point);
    const Point tip{p.x + 30 * contact.normal.x, p.y - 30 * contact.normal.y};
    out_ += fmt::format(
        "<g fill=\"none\" stroke-linecap=\"round\"><path d=\"M{0}L{1}\" stroke=\"#fff\" stroke-width=\"5\"/>"
        "<path d=\"M{0}L{1}\" stroke=\"{2}\" stroke-width=\"2.5\"/>",
        pixel_text(p), pixel_text(tip), io::contact_colour);
    for (const auto& [colour, width] : {std::pair{"#fff", 6.0}, std::pair{io::contact_colour, 2.5}}) {
      out_ += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"8\" stroke=\"{}\" stroke-width=\"{}\"/>", p.x, p.y,
                          colour, width);
    }
    out_ += "</g>\n";
  }

  const Scene& scene_;
  const Tiling& tiling_;
  const TilingDrawOptions& options_;
  io::SvgLegend legend_;
  io::SvgCanvas canvas_;
  std::vector<Point> pixels_;
  std::string out_;
};

}  // namespace

DrawnPath drawn_cycle(const Tiling& tiling, const GeodesicCycle& cycle) {
  DrawnPath path;
  path.kind = cycle.body == 0 ? DrawnPath::Kind::geodesic_0 : DrawnPath::Kind::geodesic_1;
  path.closed = true;
  const auto at = [&tiling](int v) { return tiling.vertices[static_cast<std::size_t>(v)].position; };
  for (const int v : cycle.vertices) path.points.push_back(at(v));
  for (const int i : cycle.pinned) path.stars.push_back(at(cycle.vertices[static_cast<std::size_t>(i)]));
  return path;
}

std::string draw_svg(const Scene& scene, const Tiling& tiling, const TilingDrawOptions& options) {
  return TilingPicture(scene, tiling, options).draw();
}

}  // namespace taut
