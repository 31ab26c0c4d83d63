// The bodies of a world as a picture needs them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "draw/svg_canvas.hpp"
#include "taut/feature.hpp"
#include "taut/outline.hpp"
#include "taut/pose.hpp"
#include "taut/scene.hpp"
#include "taut/simulation.hpp"

namespace taut::internal::io {

struct BodyStyle {
  const char *fill, *line;
  const char* ink;  ///< for what is written on the fill
};
/// Colours that follow each other differ in lightness as well as in hue, so that neighbours in the legend
/// differ in grey, too. There are twelve; then they repeat, and the numbers distinguish the bodies.
BodyStyle body_style(std::size_t body);
inline constexpr std::size_t body_styles = 12;

/// A point deep inside a body, in its own coordinates, and how far it is from the boundary.
struct InnerPoint {
  Point at;
  double room = 0;
  std::size_t part = 0;  ///< that it is in
};

/// The parts of a body between the same heights: they are painted at once.
struct PaintedSheet {
  std::size_t body = 0;
  std::vector<std::size_t> parts;  ///< in order
  Layers z;
};

/// All bodies, in their own coordinates.
class WorldShapes {
 public:
  explicit WorldShapes(const Scene& scene);

  std::size_t size() const { return bodies_.size(); }
  /// Of each part of a body: its outline, then its holes.
  const std::vector<std::vector<Polygon>>& parts(std::size_t body) const { return bodies_[body].parts; }
  /// The parts of a body that is bounded by curves; then parts() has polygons near them.
  const std::vector<CurvedPart>& curves(std::size_t body) const { return bodies_[body].curves; }
  const InnerPoint& inner(std::size_t body) const { return bodies_[body].inner; }
  /// Of its bounds.
  const Point& middle(std::size_t body) const { return bodies_[body].middle; }
  /// The diagonal of its bounds.
  double extent(std::size_t body) const { return bodies_[body].extent; }
  /// Is the body's inner point below another body, where they stand so? A number there would be read as that one's.
  bool is_covered(std::size_t body, const std::vector<BodyPose>& poses) const;
  std::size_t vertices() const { return vertices_; }
  /// Lower layers first; of one layer, larger bodies first, so that none hides a smaller one that it overlaps.
  const std::vector<PaintedSheet>& sheets() const { return sheets_; }
  /// Bodies in the order of their lowest sheets.
  const std::vector<std::size_t>& painting_order() const { return order_; }

 private:
  struct Shape {
    std::vector<std::vector<Polygon>> parts;
    std::vector<CurvedPart> curves;
    InnerPoint inner;
    Point middle;
    double extent = 0;
  };
  void add_sheets(const Body& body, std::size_t index);

  std::vector<Shape> bodies_;
  std::vector<PaintedSheet> sheets_;
  std::vector<std::size_t> order_;
  std::size_t vertices_ = 0;
};

/// The body's point in the world.
Point placed(const BodyPose& pose, const Point& p);

/// "A x B", cut to what fits.
std::string pair_text(const Scene& scene, BodyId a, BodyId b);

/// Takes a point of a body to where it is drawn: turned, moved, enlarged and mirrored, but never sheared.
using PlaceOnPage = std::function<Point(const Point&)>;

/// The rings of a part as the data of one SVG path, for the rule evenodd: arcs stay arcs, and Bezier curves what they
/// are.
std::string curve_path(const CurvedPart& part, const PlaceOnPage& place);

/// The rings as polygons for measuring, each near enough to its curve for a picture.
std::vector<Polygon> sketched(const CurvedPart& part);

// The tilings of near pairs as lines in the world.

/// A vertex in the world.
Point place_of(const WorldShapes& shapes, const std::vector<BodyPose>& poses, const VertexRef& v);

/// Each line once. Tilings of rings that are farther from each other than the smaller one is large are left out, except
/// the only one of two bodies: they show little, and a body of many parts has many.
std::vector<NearEdge> tiling_lines(const WorldShapes& shapes, const std::vector<BodyPose>& poses,
                                   const std::vector<NearTiling>& tilings);

/// Those lines that join two bodies, or the others, as the data of a path, where the bodies are at `poses`.
std::string tiling_path(const WorldShapes& shapes, const std::vector<BodyPose>& poses,
                        const std::vector<NearEdge>& lines, bool pq, const SvgCanvas& canvas);

/// The element of such a path. `inside`: what it holds.
std::string tiling_element(const std::string& path, bool pq, const std::string& inside = "");

}  // namespace taut::internal::io
