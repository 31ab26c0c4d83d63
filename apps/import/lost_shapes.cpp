// Of BodyMaker: shapes that were not read, and may bound the material of those that were.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "geometry/segment_strips.hpp"
#include "import/bodies.hpp"
#include "import/body_text.hpp"
#include "import/open_lines.hpp"
#include "io/text_file.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

void add_edges(const Polygon& ring, std::vector<AxisBox>& boxes) {
  for (std::size_t i = 0; i < ring.size(); ++i) boxes.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
}

std::string consequence_of(const Skipped& skipped, const LostShape& shape, const std::string& layer) {
  if (!skipped.remedy.empty()) return shape.points.empty() ? "; it may change the shape of any body" : "";
  if (shape.points.empty()) return "; where it lies is not known, and it may be a hole or an outline of any body";
  return fmt::format("; it lies in material of layer {}, or across its boundary, and may be a hole or an outline",
                     layer_title(layer));
}

}  // namespace

/// A hole may lie wherever material is. What is filled in material, or along its boundary, changes nothing; what goes
/// beyond it does.
std::optional<std::size_t> BodyMaker::layer_at(const LostShape& shape, const SegmentStrips& edges) const {
  const auto any_edge = [&](const AxisBox& box) {
    bool any = false;
    edges.each_near(box, [&](std::size_t) { any = true; });
    return any;
  };
  std::vector<Point> points;  // of a filling: those that are not on a boundary
  const double near = file_.fineness.join + 2 * file_.fineness.tolerance;
  for (const Point& p : shape.points)
    if (!shape.filling || !any_edge(AxisBox(p, p, near))) points.push_back(p);
  if (shape.filling && points.empty()) return std::nullopt;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    for (const Named& named : parts_[k]) {
      if (points.empty()) return k;
      const AxisBox box = box_of(points);
      if (!box_of(named.part.outline).meets(box)) continue;
      const auto inside =
          std::count_if(points.begin(), points.end(), [&](const Point& p) { return roughly_inside(named.part, p); });
      const bool all = inside == static_cast<std::ptrdiff_t>(points.size());
      if (shape.filling ? inside > 0 && !all : inside > 0 || any_edge(box)) return k;
    }
  }
  return std::nullopt;
}

/// A line that ends open where the shape lies may be a part of the same outline.
std::optional<BodyMaker::OpenEnd> BodyMaker::open_end_at(const LostShape& shape) const {
  if (shape.points.empty() || shape.filling) return std::nullopt;
  const AxisBox tight = box_of(shape.points);
  const AxisBox box({tight.lo_x, tight.lo_y}, {tight.hi_x, tight.hi_y}, file_.fineness.join);
  for (const OpenReport& open : file_.open)
    for (const Point& end : {open.points.front(), open.points.back()})
      if (box.holds(AxisBox(end, end))) return OpenEnd{open.place, end};
  return std::nullopt;
}

/// An outline that was not read leaves a hole filled, or a part out: as open ones do.
void BodyMaker::require_nothing_lost(const Drawing& drawing) {
  const bool any = std::any_of(file_.skipped.begin(), file_.skipped.end(),
                               [](const Skipped& skipped) { return !skipped.shapes.empty(); });
  if (!any || settings_.open == OpenRings::skip || settings_.strict) return;
  std::vector<AxisBox> boxes;
  for (const std::vector<Named>& parts : parts_) {
    for (const Named& named : parts) {
      add_edges(named.part.outline, boxes);
      for (const Polygon& hole : named.part.holes) add_edges(hole, boxes);
    }
  }
  const SegmentStrips edges(std::move(boxes));
  for (const Skipped& skipped : file_.skipped) {
    for (const LostShape& shape : skipped.shapes) {
      if (shape.hidden) continue;
      const auto layer = layer_at(shape, edges);
      const auto end = layer || !skipped.remedy.empty() ? std::nullopt : open_end_at(shape);
      if (!layer && !end && skipped.remedy.empty()) continue;
      fail(shape.place,
           skipped.what + " " + skipped.reason +
               (end ? fmt::format("; the line at {} ends open there, at {}, and both may be one outline", end->place,
                                  point_text(end->at))
                    : consequence_of(skipped, shape, layer ? drawing.layers[*layer].name : "")),
           (!skipped.remedy.empty()   ? skipped.remedy
            : !skipped.advice.empty() ? skipped.advice
                                      : "draw it anew as lines, arcs, polylines or paths") +
               ", or leave it as it is with --open skip");
      break;
    }
  }
}

/// An open line from one end of hidden lines to another one is a part of an outline, the rest of which is hidden. In
/// material it changes nothing.
void BodyMaker::require_nothing_hidden() {
  if (settings_.open == OpenRings::skip || file_.open.empty()) return;
  std::vector<std::pair<Point, const Skipped*>> ends;
  std::vector<AxisBox> boxes;
  for (const Skipped& skipped : file_.skipped)
    for (const LostShape& shape : skipped.shapes)
      for (std::size_t k = 0; shape.hidden && k < shape.points.size(); ++k) {
        ends.emplace_back(shape.points[k], &skipped);
        boxes.emplace_back(shape.points[k], shape.points[k]);
      }
  const SegmentStrips strips(std::move(boxes));
  const auto hidden_at = [&](const Point& p) {
    const Skipped* found = nullptr;
    strips.each_near(AxisBox(p, p, file_.fineness.join), [&](std::size_t k) {
      if (!found || ends[k].second->place < found->place) found = ends[k].second;
    });
    return found;
  };
  const auto in_material = [&](const std::vector<Point>& line) {
    const Point &a = line[line.size() / 2 - 1], &b = line[line.size() / 2];
    const Point middle{a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2};
    for (const std::vector<Named>& parts : parts_)
      for (const Named& named : parts)
        if (roughly_inside(named.part, middle)) return true;
    return false;
  };
  for (const OpenReport& open : file_.open) {
    const Skipped* rest = hidden_at(open.points.front());
    if (!rest || !hidden_at(open.points.back()) || in_material(open.points)) continue;
    // This says more than that it is open.
    std::erase_if(import_.faults, [&open](const InputError& fault) { return fault.place() == open.place; });
    fail(open.place,
         fmt::format("an outline stays open between {} and {}, where lines go on that are not visible: {} at {} {}",
                     point_text(open.points.front()), point_text(open.points.back()), rest->what, rest->place,
                     rest->reason),
         "make these lines visible, or leave the outline out with --open skip");
    return;
  }
}

}  // namespace taut::drawing
