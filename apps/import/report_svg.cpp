// A picture of what was read, and of what a person has to check.
#include <fmt/format.h>

#include <algorithm>

#include "draw/svg_canvas.hpp"
#include "import/import.hpp"
#include "taut/outline.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

constexpr int picture_width = 1000;
constexpr double legend_height = 26;
const char* const body_color = "#c9d3dc";
const char* const open_color = "#d62828";
const char* const gap_color = "#e07b00";
const char* const repair_color = "#2a6fdb";

/// The parts of a body as polygons: of curves, their ends do.
std::vector<Part> parts_of(const Body& body) {
  if (!body.curves.empty()) return flatten(body.curves, CurveSide::outer, 1e300, body.name);
  return body.polygon.empty() ? body.parts : std::vector<Part>{{body.polygon, {}}};
}

class ReportPicture {
 public:
  explicit ReportPicture(const Import& import) : import_(import), canvas_(points(), picture_width, legend_height, 0) {}

  std::string draw() const {
    std::string s = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
        "{1:.0f}\" font-family=\"sans-serif\" font-size=\"13\">\n<rect width=\"100%\" height=\"100%\" "
        "fill=\"#fff\"/>\n",
        canvas_.width(), canvas_.height());
    for (std::size_t b = 0; b < import_.scene.bodies.size(); ++b) s += body(import_.scene.bodies[b]);
    for (std::size_t k = 0; k < import_.files.size(); ++k) s += marks(k, import_.files[k]);
    return s + legend() + "</svg>\n";
  }

 private:
  std::vector<Point> points() const {
    std::vector<Point> all;
    for (const BodyReport& body : import_.bodies) all.insert(all.end(), {body.low, body.high});
    for (const FileReport& file : import_.files)
      for (const OpenReport& open : file.open) all.insert(all.end(), open.points.begin(), open.points.end());
    if (all.empty()) all = {{0, 0}, {1, 1}};
    return all;
  }

  std::string line_path(const std::vector<Point>& line) const {
    std::string d;
    for (const Point& p : line) d += (d.empty() ? "M" : "L") + io::pixel_text(canvas_.pixel(p));
    return d;
  }

  std::string ring_path(const Polygon& ring) const {
    std::vector<Point> pixels;
    for (const Point& p : ring) pixels.push_back(canvas_.pixel(p));
    return io::outline_path(pixels);
  }

  /// Each part is a path of its own: where parts overlap is no hole.
  std::string body(const Body& body) const {
    std::string s =
        fmt::format("<g fill=\"{}\" fill-rule=\"evenodd\" stroke=\"#46566a\" stroke-width=\"0.8\"><title>{}</title>",
                    body_color, io::escape_xml(body.name));
    for (const Part& part : parts_of(body)) {
      std::string d = ring_path(part.outline);
      for (const Polygon& hole : part.holes) d += ring_path(hole);
      s += "<path d=\"" + d + "\"/>";
    }
    return s + "</g>\n";
  }

  /// `id`: by which a page finds it.
  std::string mark(const std::string& id, const Point& at, const char* color, const std::string& title) const {
    const Point p = canvas_.pixel(at);
    return fmt::format(
        "<circle id=\"{}\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"5\" fill=\"none\" stroke=\"{}\" "
        "stroke-width=\"1.5\"><title>{}</title></circle>\n",
        id, p.x, p.y, color, io::escape_xml(title));
  }

  std::string marks(std::size_t number, const FileReport& file) const {
    std::string s;
    const auto id = [number](const char* kind, std::size_t k) { return fmt::format("{}-{}-{}", kind, number, k); };
    for (std::size_t k = 0; k < file.open.size(); ++k) {
      const OpenReport& open = file.open[k];
      s += fmt::format(
          "<path id=\"{}\" d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"><title>open: {}</title></path>\n",
          id("open", k), line_path(open.points), open_color, io::escape_xml(open.place));
      for (const Point& end : {open.points.front(), open.points.back()}) {
        const Point p = canvas_.pixel(end);
        s += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"3\" fill=\"{}\"/>\n", p.x, p.y, open_color);
      }
    }
    for (const auto* rings : {&file.suspicious, &file.closed})
      for (const RingReport& ring : *rings)
        for (const auto& [from, to] : ring.gaps)
          s += fmt::format("<path d=\"{}\" stroke=\"{}\" stroke-width=\"2\" stroke-dasharray=\"5 4\"/>\n",
                           line_path({from, to}), open_color);
    for (std::size_t k = 0; k < file.gaps.size(); ++k)
      s += mark(id("gap", k), file.gaps[k].from, gap_color,
                fmt::format("a gap of {:.3g}, closed: {}", file.gaps[k].width, file.gaps[k].place));
    for (std::size_t k = 0; k < file.repairs.size(); ++k)
      s += mark(id("repair", k), file.repairs[k].at, repair_color,
                fmt::format("a {} of {:.3g}: {}", file.repairs[k].what, file.repairs[k].size, file.repairs[k].place));
    for (std::size_t k = 0; k < file.crossings.size(); ++k)
      s += mark(id("crossing", k), file.crossings[k].at, open_color,
                "a contour meets itself: " + file.crossings[k].place);
    return s;
  }

  std::string legend() const {
    std::size_t open = 0, gaps = 0, repairs = 0;
    for (const FileReport& file : import_.files) {
      open += file.open.size();
      gaps += file.gaps.size();
      repairs += file.repairs.size();
    }
    return fmt::format(
        "<text x=\"24\" y=\"20\">{} {} <tspan fill=\"{}\" dx=\"12\">open lines: {}</tspan> <tspan "
        "fill=\"{}\" dx=\"12\">gaps closed: {}</tspan> <tspan fill=\"{}\" dx=\"12\">cut off: {}</tspan>"
        "</text>\n",
        import_.bodies.size(), import_.bodies.size() == 1 ? "body" : "bodies", open_color, open, gap_color, gaps,
        repair_color, repairs);
  }

  const Import& import_;
  io::SvgCanvas canvas_;
};

}  // namespace

std::string report_svg(const Import& import) { return ReportPicture(import).draw(); }

}  // namespace taut::drawing
