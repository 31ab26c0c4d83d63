// A picture of any number of bodies that moves, by SMIL: no script, so that it also runs where a page shows it as an
// image.
//
// A body is one path, moved by its middle and turned about it: between frames the middle runs straight, so that what
// turns about a point of its own does not wobble.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "draw/svg_canvas.hpp"
#include "draw/svg_legend.hpp"
#include "draw/svg_track.hpp"
#include "draw/world_marks.hpp"
#include "draw/world_shapes.hpp"
#include "taut/io.hpp"

namespace taut {
using namespace internal;

namespace {

/// Instants between two frames at which angles are sampled, so that a fast turn is not taken for a slow one.
constexpr int samples_between = 8;

class WorldAnimation {
 public:
  WorldAnimation(const Scene& scene, double end, const AnimateOptions& options)
      : scene_(scene),
        end_(end),
        options_(options),
        shapes_(scene),
        frames_(frames()),
        lines_(lines()),
        legend_(scene, options.draw.width),
        canvas_(all_points(), options.draw.width, io::title_height, io::SvgLoop::bar_height + legend_height()),
        loop_(options.seconds + options.pause) {}

  std::string draw() const {
    const std::string title = options_.draw.title.empty() ? io::world_title(scene_) : options_.draw.title;
    std::string out = io::world_head(canvas_, title, true);
    out += "<g class=\"moving\">\n" + layers(true) + "</g>\n<g class=\"still\">\n" + layers(false) + "</g>\n";
    if (options_.draw.legend) out += legend_.draw(canvas_.height() - legend_.height());
    return out + "</svg>\n";
  }

 private:
  /// Where the bodies are, and by which angles they have turned since the start.
  struct Frame {
    std::vector<BodyPose> poses;
    std::vector<double> degrees;
  };

  double legend_height() const { return options_.draw.legend ? legend_.height() : 0; }

  std::vector<Frame> frames() const {
    const int count = std::max(options_.frames, 2), samples = (count - 1) * samples_between;
    Frame now{poses_at(scene_, scene_.start), std::vector<double>(shapes_.size(), 0.0)};
    std::vector<Frame> out{now};
    for (int k = 1; k <= samples; ++k) {
      const double t = k == samples ? end_ : scene_.start + (end_ - scene_.start) * k / samples;
      const std::vector<BodyPose> next = poses_at(scene_, t);
      for (std::size_t b = 0; b < next.size(); ++b) {
        const Point &x = now.poses[b].axis, &y = next[b].axis;
        now.degrees[b] += std::atan2(x.x * y.y - x.y * y.x, x.x * y.x + x.y * y.y) * 180 / std::numbers::pi;
      }
      now.poses = next;
      if (k % samples_between == 0) out.push_back(now);
    }
    return out;
  }

  std::vector<Point> all_points() const {
    std::vector<Point> points;
    for (std::size_t b = 0; b < shapes_.size(); ++b) {
      for (const std::vector<Polygon>& part : shapes_.parts(b)) {
        for (const Point& p : part[0]) {
          for (const Frame& frame : frames_) points.push_back(io::placed(frame.poses[b], p));
        }
      }
    }
    return points;
  }

  /// Moving, or the last frame alone.
  std::string layers(bool moving) const {
    std::string out = draw_tilings(moving);
    for (const io::PaintedSheet& sheet : shapes_.sheets()) out += draw_sheet(sheet, moving);
    for (const std::size_t body : shapes_.painting_order()) out += draw_number(body, moving);
    for (const io::JointPlace& joint : io::joint_places(scene_, shapes_)) out += draw_joint(joint, moving);
    const std::string marks = io::world_marks(scene_, shapes_, frames_.back().poses, canvas_, options_.draw);
    if (!marks.empty()) out += "<g>" + shown_at_the_end(moving) + marks + "</g>\n";
    return out + draw_bar(moving);
  }

  io::SvgLoop loop() const { return {options_.seconds, loop_, frames_.size()}; }
  double moment(std::size_t frame) const { return loop().moment(frame); }
  std::string shown_at_the_end(bool moving) const { return moving ? loop().shown_at_the_end() : ""; }

  /// Below the bodies. The vertices of a line run straight from frame to frame; where the tilings have changed, the
  /// lines jump.
  std::string draw_tilings(bool moving) const {
    std::string out;
    for (const bool pq : {false, true}) {
      const std::string last = path_of(frames_.size() - 1, frames_.size() - 1, pq);
      const io::SvgTrack track = moving ? track_of_tilings(pq) : io::SvgTrack();
      if (last.empty() && !track.varies()) continue;
      out += io::tiling_element(last, pq, track.varies() ? fmt::format("<animate {}/>", track.text("d", loop_)) : "");
    }
    return out;
  }

  io::SvgTrack track_of_tilings(bool pq) const {
    io::SvgTrack track;
    if (lines_.empty()) return track;
    const auto shown = [&](std::size_t of, std::size_t at) {
      const std::string path = path_of(of, at, pq);
      return path.empty() ? std::string("M0,0") : path;
    };
    track.add(0, shown(0, 0));
    for (std::size_t k = 1; k < frames_.size(); ++k) {
      track.add(moment(k), shown(k - 1, k));
      if (!same_lines(lines_[k - 1], lines_[k])) track.add(moment(k), shown(k, k));
    }
    track.add(1, shown(frames_.size() - 1, frames_.size() - 1));
    return track;
  }

  /// The lines of one frame, with the bodies where they are in another one.
  std::string path_of(std::size_t of, std::size_t at, bool pq) const {
    if (lines_.empty()) return "";
    return io::tiling_path(shapes_, frames_[at].poses, lines_[of], pq, canvas_);
  }

  static bool same_lines(const std::vector<NearEdge>& a, const std::vector<NearEdge>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const NearEdge& e, const NearEdge& f) {
      return e.from == f.from && e.to == f.to && e.pq == f.pq;
    });
  }

  /// The tilings' lines in each frame.
  std::vector<std::vector<NearEdge>> lines() const {
    std::vector<std::vector<NearEdge>> all;
    for (std::size_t k = 0; options_.tilings && k < frames_.size(); ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(frames_.size() - 1);
      const double t = k + 1 == frames_.size() ? end_ : scene_.start + (end_ - scene_.start) * share;
      all.push_back(io::tiling_lines(shapes_, frames_[k].poses, options_.tilings(t)));
    }
    return all;
  }

  Point pixel(const Frame& frame, std::size_t body, const Point& p) const {
    return canvas_.pixel(io::placed(frame.poses[body], p));
  }

  /// A transform over all frames, held through the pause.
  template <class Value>
  std::string transform(const char* type, const Value& value) const {
    io::SvgTrack track;
    for (std::size_t k = 0; k < frames_.size(); ++k) track.add(moment(k), value(frames_[k]));
    track.add(1, value(frames_.back()));
    return track.transform(type, loop_);
  }

  /// What is drawn around a point of the body, moved along with that point.
  std::string carried(std::size_t body, const Point& p, const std::string& drawn, bool moving) const {
    const auto place = [&](const Frame& frame) { return io::pixel_text(pixel(frame, body, p)); };
    return fmt::format("<g transform=\"translate({})\">{}{}</g>\n", place(moving ? frames_.front() : frames_.back()),
                       moving ? transform("translate", place) : "", drawn);
  }

  std::string draw_sheet(const io::PaintedSheet& sheet, bool moving) const {
    const std::size_t body = sheet.body;
    const Frame& shown = moving ? frames_.front() : frames_.back();
    const Point middle = pixel(shown, body, shapes_.middle(body));
    const auto local = [&](const Point& p) {
      const Point q = pixel(shown, body, p);
      return Point{q.x - middle.x, q.y - middle.y};
    };
    const std::string path = io::sheet_shape(shapes_, sheet, local);
    return carried(body, shapes_.middle(body), turned(body, path, moving), moving);
  }

  /// What is drawn for the first frame, turned with the body.
  std::string turned(std::size_t body, const std::string& drawn, bool moving) const {
    if (!moving) return drawn;
    // In pixels y points down: what turns left there turns right here.
    const auto angle = [&](const Frame& frame) { return fmt::format("{:.2f}", -frame.degrees[body] + 0.0); };
    return "<g>" + transform("rotate", angle) + drawn + "</g>";
  }

  std::string draw_joint(const io::JointPlace& joint, bool moving) const {
    const std::size_t body = joint.body;
    const std::string mark = io::joint_mark(joint, (moving ? frames_.front() : frames_.back()).poses[body]);
    return carried(body, joint.at, joint.slides ? turned(body, mark, moving) : mark, moving);
  }

  std::string draw_number(std::size_t body, bool moving) const {
    const io::InnerPoint& inner = shapes_.inner(body);
    if (!options_.draw.legend || !io::has_room(inner, canvas_.scale(), body)) return "";
    return carried(body, inner.at, io::number_mark(body), moving);
  }

  /// Where in time the picture stands: a bar over the scene's interval, and in words how it ends.
  std::string draw_bar(bool moving) const {
    const double y = canvas_.height() - legend_height() - 20, whole = canvas_.width() - 2 * io::SvgCanvas::margin;
    const double length = scene_.end - scene_.start;
    const double reached = length > 0 ? whole * (end_ - scene_.start) / length : whole;
    const bool hit = !options_.draw.contacts.empty() || !options_.draw.overlaps.empty();
    const char* colour = hit ? io::contact_colour : io::bar_colour(options_.free);
    return loop().bar(moving, io::SvgCanvas::margin, whole, y, reached, colour, io::escape_xml(options_.ending));
  }

  const Scene& scene_;
  double end_;
  const AnimateOptions& options_;
  io::WorldShapes shapes_;
  std::vector<Frame> frames_;
  std::vector<std::vector<NearEdge>> lines_;
  io::WorldLegend legend_;
  io::SvgCanvas canvas_;
  double loop_;
};

}  // namespace

std::string animate_svg(const Scene& scene, double end, const AnimateOptions& options) {
  return WorldAnimation(scene, end, options).draw();
}

}  // namespace taut
