#include "world.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "draw/world_marks.hpp"
#include "draw/world_shapes.hpp"
#include "io/json_writer.hpp"
#include "numeric/budget.hpp"
#include "query/bracket.hpp"
#include "taut/io.hpp"
#include "taut/pose.hpp"

namespace taut::web {
using namespace internal;

namespace {

/// Bands are drawn no wider than this share of their body: what is coarse because it is far away would look it.
constexpr double widest_band = 1.0 / 2048;
/// A frame waits for its tilings.
constexpr double seconds_for_tilings = 0.25;

double extent_of(const curve::BandedPart& part) {
  Point lo{INFINITY, INFINITY}, hi{-INFINITY, -INFINITY};
  const curve::Band& outline = part.bands()[0];
  for (std::size_t k = 0; k < outline.cells().size(); ++k) {
    for (const Point& p : outline.corners(k)) {
      lo = {std::min(lo.x, p.x), std::min(lo.y, p.y)};
      hi = {std::max(hi.x, p.x), std::max(hi.y, p.y)};
    }
  }
  return std::hypot(hi.x - lo.x, hi.y - lo.y);
}

/// Marks the cells that are drawn too wide; how many?
std::size_t mark_wide(const CurvedWorld& curved, CurvedWorld::Halvings& marks) {
  std::size_t count = 0;
  for (std::size_t b = 0; b < curved.scene().bodies.size(); ++b) {
    const auto& parts = curved.parts(static_cast<BodyId>(b));
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const double wide = extent_of(parts[p]) * widest_band;
      for (std::size_t ring = 0; ring < parts[p].bands().size(); ++ring) {
        const auto& cells = parts[p].bands()[ring].cells();
        for (std::size_t k = 0; k < cells.size(); ++k) {
          if (cells[k].is_final || !(cells[k].thickness > wide)) continue;
          marks[b][p][ring][k] = 1;
          ++count;
        }
      }
    }
  }
  return count;
}

/// Finer cells lie within coarser ones: what was decided with these holds for those.
void make_drawable(CurvedWorld& curved) {
  for (CurvedWorld::Halvings marks = curved.no_halvings(); mark_wide(curved, marks) > 0; marks = curved.no_halvings()) {
    if (!curved.refine(marks)) return;
  }
}

std::string wall_text(const Polygon& wall) {
  std::vector<double> numbers;
  for (const Point& p : wall) numbers.insert(numbers.end(), {p.x, p.y});
  return io::array_text(numbers);
}

std::string band_text(const curve::Band& band) {
  double width = 0;
  for (const curve::Cell& cell : band.cells()) width = std::max(width, cell.thickness);
  return "[" + io::number_text(width) + "," + wall_text(band.wall(true)) + "," + wall_text(band.wall(false)) + "]";
}

std::string bands_text(const CurvedWorld& curved) {
  std::string text;
  for (std::size_t b = 0; b < curved.scene().bodies.size(); ++b) {
    std::string parts;
    for (const curve::BandedPart& part : curved.parts(static_cast<BodyId>(b))) {
      std::string rings;
      for (const curve::Band& band : part.bands()) rings += (rings.empty() ? "" : ",") + band_text(band);
      parts += (parts.empty() ? "[" : ",[") + rings + "]";
    }
    text += (b ? ",[" : "[") + parts + "]";
  }
  return "[" + text + "]";
}

}  // namespace

World::World(const Scene& scene, Touch touch, double max_seconds) : scene_(scene), touch_(touch) {
  CheckOptions options;
  options.touch = touch;
  options.limits.max_seconds = max_seconds;
  options.tell_touching = false;
  if (!has_curves(scene)) {
    answer_ = check(scene, options);
    return;
  }
  CurvedContact found = first_contact_of_curves(scene, options);
  answer_ = std::move(found.answer);
  curves_ = std::move(found.world);
  make_drawable(*curves_);
}

double World::end() const {
  if (answer_.contact) return answer_.contact->time.lo;
  return answer_.outcome == Outcome::overlap_at_start ? scene_.start : answer_.free_until;
}

std::string World::picture(double t, bool proof) const {
  const double shown = std::min(t, end());
  DrawOptions options = shown == end() ? marked(answer_) : DrawOptions{};
  if (proof && !curves_) options.tilings = tilings_of_near_pairs(scene_, shown, touch_);
  return draw_svg(scene_, shown, options);
}

std::vector<double> World::tilings(double t) const {
  std::vector<double> numbers;
  if (curves_) return numbers;
  const double shown = std::clamp(t, scene_.start, end());
  try {
    const Budget scope(Limits{seconds_for_tilings});
    if (!shapes_) shapes_.emplace(scene_);
    const std::vector<BodyPose> poses = poses_at(scene_, shown);
    for (const NearEdge& line : io::tiling_lines(*shapes_, poses, tilings_of_near_pairs(scene_, shown, touch_))) {
      const Point from = io::place_of(*shapes_, poses, line.from), to = io::place_of(*shapes_, poses, line.to);
      numbers.insert(numbers.end(), {from.x, from.y, to.x, to.y, line.pq ? 1.0 : 0.0});
    }
  } catch (const Interrupted&) {
    numbers.clear();
  }
  return numbers;
}

std::string shapes_text(const Scene& scene, const CurvedWorld* curves) {
  const io::WorldShapes shapes(scene);
  std::string order, inner, styles;
  for (const std::size_t body : shapes.painting_order()) order += (order.empty() ? "" : ",") + std::to_string(body);
  for (std::size_t b = 0; b < shapes.size(); ++b) {
    const io::InnerPoint& p = shapes.inner(b);
    inner += (b ? "," : "") + io::array_text({p.at.x, p.at.y, p.room, static_cast<double>(p.part)});
  }
  for (std::size_t k = 0; k < io::body_styles; ++k) {
    const io::BodyStyle style = io::body_style(k);
    styles += std::string(k ? "," : "") + "[\"" + style.fill + "\",\"" + style.line + "\",\"" + style.ink + "\"]";
  }
  std::string joints;
  for (const io::JointPlace& joint : io::joint_places(scene, shapes)) {
    joints += (joints.empty() ? "[" : ",[") + std::to_string(joint.body) + "," + io::point_text(joint.at) +
              (joint.slides ? "," + io::point_text(joint.direction) : "") + "]";
  }
  return "{\"order\":[" + order + "],\"inner\":[" + inner + "],\"styles\":[" + styles + "],\"joints\":[" + joints +
         "]" + (curves ? ",\"bands\":" + bands_text(*curves) : "") + "}";
}

std::vector<double> poses_of(const Scene& scene, double t) {
  std::vector<double> numbers;
  for (const BodyPose& p : poses_at(scene, t))
    numbers.insert(numbers.end(), {p.origin.x, p.origin.y, p.axis.x, p.axis.y});
  return numbers;
}

}  // namespace taut::web
