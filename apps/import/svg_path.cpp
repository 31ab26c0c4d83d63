#include "import/svg_path.hpp"

#include <cmath>
#include <initializer_list>

#include "io/shape_reader.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

/// The points of a subpath, where the element is placed.
class Tracer {
 public:
  Tracer(const Affine& where, Flattener& flattener) : where_(where), flattener_(flattener) {}

  Chain trace(const io::Subpath& path, const std::string& place) {
    at_ = path.outline.start;
    chain_ = {{where_(at_)}, path.closed, place};
    for (const CurveSegment& segment : path.outline.segments) {
      std::visit(*this, segment);
      at_ = end_of(segment);
    }
    return std::move(chain_);
  }

  void operator()(const LineTo& line) { chain_.points.push_back(where_(line.to)); }
  void operator()(const QuadraticTo& q) { bezier({at_, q.control, q.to}); }
  void operator()(const CubicTo& c) { bezier({at_, c.first, c.second, c.to}); }
  /// As section B.2.4 of SVG 2 has it.
  void operator()(const ArcTo& arc) {
    double rx = arc.rx, ry = arc.ry;
    const Affine turn = rotation(arc.rotation_deg);
    const Point to = arc.to;
    // In the frame of the axes, half the way from the end to the start.
    const Point half{(at_.x - to.x) / 2, (at_.y - to.y) / 2};
    const double x = turn.a * half.x + turn.b * half.y, y = turn.c * half.x + turn.d * half.y;
    const double reach = std::hypot(x / rx, y / ry);
    if (reach > 1) {
      rx *= reach;
      ry *= reach;
    }
    const double left = std::max(0.0, 1 / (std::min(reach, 1.0) * std::min(reach, 1.0)) - 1);
    const double factor = (arc.large == arc.sweep ? -1 : 1) * (reach < 1 ? std::sqrt(left) : 0);
    const double cx = factor * rx * y / ry, cy = -factor * ry * x / rx;
    const Point shift = turn.turn({cx, cy});
    const Point centre{shift.x + (at_.x + to.x) / 2, shift.y + (at_.y + to.y) / 2};
    const double from = std::atan2((y - cy) / ry, (x - cx) / rx);
    double angle = std::atan2((-y - cy) / ry, (-x - cx) / rx) - from;
    constexpr double full_angle = 2 * 3.14159265358979323846;
    if (arc.sweep && angle < 0) angle += full_angle;
    if (!arc.sweep && angle > 0) angle -= full_angle;
    flattener_.arc(chain_.points, where_(centre), where_.turn(turn.turn({rx, 0})), where_.turn(turn.turn({0, ry})),
                   from, angle, where_(to));
  }

 private:
  void bezier(std::initializer_list<Point> points) {
    std::vector<ControlPoint> control;
    for (const Point& p : points) {
      const Point placed = where_(p);
      control.push_back({placed.x, placed.y, 1});
    }
    flattener_.bezier(chain_.points, control);
  }

  const Affine& where_;
  Flattener& flattener_;
  Chain chain_;
  Point at_;
};

}  // namespace

std::vector<Chain> read_path(const XmlElement& element, const Affine& where, Flattener& flattener) {
  const std::string* data = element.find("d");
  if (!data) return {};
  std::vector<Chain> chains;
  for (const io::Subpath& path : io::read_path_data(*data, element.place)) {
    chains.push_back(Tracer(where, flattener).trace(path, element.place));
  }
  return chains;
}

}  // namespace taut::drawing
