// A picture that moves, by SMIL: no script, so that it also runs where a page shows it as an image.
//
// A body is one path, moved by its first vertex and turned about it. The edges between the bodies are one path whose
// vertices run straight from frame to frame; where the tiling has changed, it jumps.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/svg_canvas.hpp"
#include "io/svg_style.hpp"
#include "io/svg_track.hpp"
#include "io/text_file.hpp"
#include "taut/io.hpp"
#include "taut/shape.hpp"

namespace taut {
using namespace internal;

namespace {

using io::pixel_text;
using Track = io::SvgTrack;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

class Animation {
 public:
  Animation(const Scene& scene, const std::vector<Tiling>& frames, const AnimateOptions& options)
      : scene_(scene),
        frames_(frames),
        options_(options),
        canvas_(all_points(frames), options.width, io::title_height, io::SvgLoop::bar_height),
        loop_(options.seconds + options.pause) {}

  std::string draw() const {
    std::string out = io::svg_tag(canvas_.width(), canvas_.height(),
                                  std::string("font-family=\"sans-serif\" font-size=\"13\" ") + io::pauses_on_click) +
                      io::moving_style + "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
    const std::string title =
        io::escape_xml(options_.title.empty() ? io::excerpt(scene_.bodies[0].name + " and " + scene_.bodies[1].name, 80)
                                              : options_.title);
    out +=
        fmt::format("<title>{0}</title>\n<text x=\"24\" y=\"22\" font-size=\"15\" fill=\"#222\">{0}</text>\n", title);
    out += "<g class=\"moving\">\n" + layers(true) + "</g>\n<g class=\"still\">\n" + layers(false) + "</g>\n";
    return out + "</svg>\n";
  }

 private:
  static std::vector<Point> all_points(const std::vector<Tiling>& frames) {
    std::vector<Point> points;
    for (const Tiling& frame : frames) {
      for (const TilingVertex& v : frame.vertices) points.push_back(v.position);
    }
    return points;
  }

  /// Moving, or the last frame alone.
  std::string layers(bool moving) const {
    std::string out;
    for (const int body : {0, 1}) out += draw_body(body, moving);
    if (options_.edges) out += draw_edges(moving);
    if (options_.contact) out += draw_contact(*options_.contact, moving);
    return out + draw_bar(moving);
  }

  io::SvgLoop loop() const { return {options_.seconds, loop_, frames_.size()}; }
  double moment(std::size_t frame) const { return loop().moment(frame); }
  std::string shown_at_the_end(bool moving) const { return moving ? loop().shown_at_the_end() : ""; }

  std::vector<Point> outline(const Tiling& frame, int body) const {
    std::vector<Point> pixels(polygon_of(scene_.bodies[index(body)]).size());
    for (const TilingVertex& v : frame.vertices) {
      if (v.vertex.body == body) pixels[index(v.vertex.index)] = canvas_.pixel(v.position);
    }
    return pixels;
  }

  /// The vertex farthest from the first one: it shows turns best.
  static std::size_t farthest(const std::vector<Point>& outline) {
    const auto distance = [&outline](const Point& p) { return std::hypot(p.x - outline[0].x, p.y - outline[0].y); };
    return static_cast<std::size_t>(
        std::max_element(outline.begin(), outline.end(),
                         [&distance](const Point& a, const Point& b) { return distance(a) < distance(b); }) -
        outline.begin());
  }

  std::string draw_body(int body, bool moving) const {
    const std::vector<Point> first = outline(moving ? frames_.front() : frames_.back(), body);
    std::vector<Point> local;
    for (const Point& p : first) local.push_back({p.x - first[0].x, p.y - first[0].y});
    const std::string path = fmt::format(
        "<path d=\"{}\" fill=\"{}\" fill-opacity=\"0.9\" stroke=\"{}\" stroke-width=\"{:.2g}\" "
        "stroke-linejoin=\"round\"/>",
        io::outline_path(local), io::body_fill[body], io::body_line[body], 1.4 * crowding());
    const std::string place = fmt::format("<g transform=\"translate({})\">", pixel_text(first[0]));
    if (!moving) return place + path + "</g>\n";
    const std::size_t far = farthest(first);
    Track way, turn;
    double before = std::atan2(local[far].y, local[far].x), angle = 0;
    for (std::size_t k = 0; k < frames_.size(); ++k) {
      const std::vector<Point> now = outline(frames_[k], body);
      const double heading = std::atan2(now[far].y - now[0].y, now[far].x - now[0].x);
      angle += std::remainder(heading - before, 2 * std::numbers::pi);
      before = heading;
      way.add(moment(k), pixel_text(now[0]));
      turn.add(moment(k), fmt::format("{:.2f}", angle * 180 / std::numbers::pi));
      if (k + 1 < frames_.size()) continue;
      way.add(1, pixel_text(now[0]));
      turn.add(1, fmt::format("{:.2f}", angle * 180 / std::numbers::pi));
    }
    return place + way.transform("translate", loop_) + "<g>" + turn.transform("rotate", loop_) + path + "</g></g>\n";
  }

  double crowding() const {
    return std::clamp(60.0 / std::sqrt(static_cast<double>(frames_[0].vertices.size()) + 1), 0.4, 1.0);
  }

  static bool same_edges(const Tiling& a, const Tiling& b) {
    const auto joins = [](const TilingEdge& e, const TilingEdge& f) {
      return e.from == f.from && e.to == f.to && e.pq == f.pq;
    };
    return std::equal(a.edges.begin(), a.edges.end(), b.edges.begin(), b.edges.end(), joins);
  }

  /// The edges between the bodies that `edges` has, where its vertices are in `at`.
  std::string edge_path(const Tiling& edges, const Tiling& at) const {
    std::string path;
    const auto pixel = [&](int v) { return pixel_text(canvas_.pixel(at.vertices[index(v)].position)); };
    for (const TilingEdge& edge : edges.edges) {
      if (edge.pq && !edge.polygon) path += "M" + pixel(edge.from) + "L" + pixel(edge.to);
    }
    return path.empty() ? "M0,0" : path;
  }

  std::string draw_edges(bool moving) const {
    const Tiling& last = frames_.back();
    std::string animate;
    if (moving) {
      Track track;
      track.add(0, edge_path(frames_[0], frames_[0]));
      for (std::size_t k = 1; k < frames_.size(); ++k) {
        track.add(moment(k), edge_path(frames_[k - 1], frames_[k]));
        if (!same_edges(frames_[k - 1], frames_[k])) track.add(moment(k), edge_path(frames_[k], frames_[k]));
      }
      track.add(1, edge_path(last, last));
      if (track.varies()) animate = fmt::format("<animate {}/>", track.text("d", loop_));
    }
    return fmt::format(
        "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:.2g}\" stroke-linecap=\"round\">{}</path>\n",
        edge_path(last, last), io::pq_colour, 1.6 * crowding(), animate);
  }

  std::string draw_contact(const Contact& contact, bool moving) const {
    const Point p = canvas_.pixel(contact.point);
    std::string rings;
    for (const auto& [colour, width] : {std::pair{"#fff", 6.0}, std::pair{io::contact_colour, 2.5}}) {
      rings += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"9\" stroke=\"{}\" stroke-width=\"{}\"/>", p.x, p.y,
                           colour, width);
    }
    return fmt::format("<g fill=\"none\">{}{}</g>\n", shown_at_the_end(moving), rings);
  }

  /// Where in time the picture stands: a bar over the scene's interval, and in words how it ends.
  std::string draw_bar(bool moving) const {
    const double y = canvas_.height() - 20, whole = canvas_.width() - 2 * io::SvgCanvas::margin;
    const double length = scene_.end - scene_.start;
    const double reached = length > 0 ? whole * (frames_.back().time - scene_.start) / length : whole;
    const char* colour = options_.contact ? io::contact_colour : io::bar_colour(options_.free);
    return loop().bar(moving, io::SvgCanvas::margin, whole, y, reached, colour, io::escape_xml(options_.ending));
  }

  const Scene& scene_;
  const std::vector<Tiling>& frames_;
  const AnimateOptions& options_;
  io::SvgCanvas canvas_;
  double loop_;
};

}  // namespace

std::string animate_svg(const Scene& scene, const std::vector<Tiling>& frames, const AnimateOptions& options) {
  return Animation(scene, frames, options).draw();
}

}  // namespace taut
