// Of BodyMaker: filled shapes that repeat what lines of another layer enclose.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "geometry/segment_strips.hpp"
#include "import/bodies.hpp"
#include "import/body_text.hpp"
#include "import/open_lines.hpp"
#include "io/text_file.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

using Segments = std::vector<std::pair<Point, Point>>;

void add_sides(const Polygon& ring, Segments& sides) {
  for (std::size_t i = 0; i < ring.size(); ++i) sides.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
}

Segments sides_of(const Part& part) {
  Segments sides;
  add_sides(part.outline, sides);
  for (const Polygon& hole : part.holes) add_sides(hole, sides);
  return sides;
}

SegmentStrips strips_of(const Segments& sides) {
  std::vector<AxisBox> boxes;
  for (const auto& [a, b] : sides) boxes.emplace_back(a, b);
  return SegmentStrips(std::move(boxes));
}

/// Do lines run along the boundary? Its vertices and the middles of its sides decide.
bool runs_along(const Segments& boundary, const Segments& lines, const SegmentStrips& strips, double near) {
  const auto on_line = [&](const Point& p) {
    bool any = false;
    strips.each_near(AxisBox(p, p, near), [&](std::size_t k) {
      any = any || distance_to_segment(p, lines[k].first, lines[k].second) <= near;
    });
    return any;
  };
  return std::all_of(boundary.begin(), boundary.end(), [&](const auto& side) {
    const auto& [a, b] = side;
    return on_line(a) && on_line({a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2});
  });
}

double length_of(const Segments& sides) {
  double sum = 0;
  for (const auto& [a, b] : sides) sum += std::hypot(a.x - b.x, a.y - b.y);
  return sum;
}

/// A part that lines enclose.
struct Contour {
  std::size_t layer;
  Point inner;
  double area, filled;  ///< with its holes, and without
};

/// The contours of other layers in a filling.
struct Covered {
  const Contour* last = nullptr;
  double area = 0, filled = 0;
};

Covered covered_by(const Part& filling, std::size_t layer, const std::vector<Contour>& contours) {
  Covered covered;
  for (const Contour& contour : contours) {
    if (contour.layer == layer || !roughly_inside(filling, contour.inner)) continue;
    covered.last = &contour;
    covered.area += contour.area;
    covered.filled += contour.filled;
  }
  return covered;
}

/// Fillings of one layer that follow contours of another one.
struct Repeated {
  std::size_t same = 0, covering = 0;
  std::string first;
};

std::string text_of(const Repeated& repeated, const std::string& layer, const std::string& other) {
  const std::size_t n = repeated.same + repeated.covering;
  return fmt::format(
      "layer {}: {} of layer {}, the first one at {}: the same part, and no body of its own{} (--by layer keeps layers "
      "apart)",
      layer_title(layer),
      n == 1 ? "1 filled shape follows contours" : fmt::format("{} filled shapes follow contours", n),
      layer_title(other), repeated.first, repeated.covering > 0 ? "; holes that are covered are holes" : "");
}

}  // namespace

/// A filling that follows contours of another layer shows what is material, as hatches do: a body of its own would be
/// that part again. Where it covers holes of the contours, these count.
void BodyMaker::drop_repeated_fillings(const Drawing& drawing) {
  if (settings_.by == Grouping::layer || settings_.by == Grouping::color) return;
  std::vector<Contour> contours;
  Segments lines;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    for (const Named& named : parts_[k]) {
      if (!named.lines) continue;
      contours.push_back({k, inner_point(named.part), area_of(named.part), area_of({named.part.outline, {}})});
      for (const auto& side : sides_of(named.part)) lines.push_back(side);
    }
  }
  const SegmentStrips strips = strips_of(lines);
  const double near = file_.fineness.join + 2 * file_.fineness.tolerance;
  std::map<std::pair<std::size_t, std::size_t>, Repeated> repeated;  // layers of fillings and of their contours
  const auto repeats = [&](const Named& named, std::size_t layer) {
    if (named.lines || contours.empty()) return false;
    const Segments boundary = sides_of(named.part);
    if (!runs_along(boundary, lines, strips, near)) return false;
    const Covered covered = covered_by(named.part, layer, contours);
    const double own = area_of(named.part), slack = near * length_of(boundary);
    if (!covered.last || own < covered.area - slack || own > covered.filled + slack) return false;
    Repeated& here = repeated[{layer, covered.last->layer}];
    if (here.same + here.covering == 0) here.first = named.place;
    ++(own <= covered.area + slack ? here.same : here.covering);
    return true;
  };
  for (std::size_t k = 0; k < parts_.size(); ++k)
    std::erase_if(parts_[k], [&](const Named& named) { return repeats(named, k); });
  for (const auto& [layers, fillings] : repeated)
    file_.notes.push_back(text_of(fillings, drawing.layers[layers.first].name, drawing.layers[layers.second].name));
}

/// Layers may lie on each other, but two bodies of one shape at one place are rarely meant.
void BodyMaker::note_equal_fillings() {
  struct Shape {
    const Named* named;
    std::size_t layer;
    AxisBox box;
  };
  const double near = file_.fineness.join + 2 * file_.fineness.tolerance;
  std::vector<Shape> shapes;
  std::vector<AxisBox> corners;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    for (const Named& named : parts_[k]) {
      if (named.lines) continue;
      shapes.push_back({&named, k, box_of(named.part.outline)});
      const Point low{shapes.back().box.lo_x, shapes.back().box.lo_y};
      corners.emplace_back(low, low, near);
    }
  }
  const auto are_equal = [&](const Shape& a, const Shape& b) {
    if (a.layer == b.layer || std::fabs(a.box.hi_x - b.box.hi_x) > near || std::fabs(a.box.hi_y - b.box.hi_y) > near)
      return false;
    const Segments sides = sides_of(a.named->part), others = sides_of(b.named->part);
    return runs_along(sides, others, strips_of(others), near) && runs_along(others, sides, strips_of(sides), near);
  };
  std::set<const Named*> copies;
  std::pair<std::string, std::string> first;
  SegmentStrips(std::move(corners)).each_pair([&](std::size_t i, std::size_t j) {
    const Shape &a = shapes[std::min(i, j)], &b = shapes[std::max(i, j)];
    if (copies.count(b.named) || !are_equal(a, b)) return;
    if (copies.empty() || b.named->place < first.first) first = {b.named->place, a.named->place};
    copies.insert(b.named);
  });
  if (!copies.empty())
    file_.notes.push_back(fmt::format(
        "{}, the first one at {}, as at {}: delete one, unless two bodies are meant",
        copies.size() == 1 ? "1 filled shape is that of another layer or group again"
                           : fmt::format("{} filled shapes are those of other layers or groups again", copies.size()),
        first.first, first.second));
}

}  // namespace taut::drawing
