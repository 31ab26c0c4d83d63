#include "geometry/container.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/displacement.hpp"
#include "numeric/exact_sum.hpp"

namespace taut::internal {
namespace {

using Ring = std::vector<DisplacedPoint>;

/// The width of the mouth relative to a displacement.
constexpr double mouth_share = 0x1p-40;

/// A quarter turn clockwise, exactly: what was on top is on the right.
DisplacedPoint turned(const DisplacedPoint& v) { return {v.y, -v.x, v.dy, -v.dx}; }
DisplacedPoint turned_back(const DisplacedPoint& v) { return {-v.y, v.x, -v.dy, v.dx}; }

bool is_left_of(const DisplacedPoint& a, const DisplacedPoint& b) {
  ExactSum<4> sum;
  for (const double x : {a.dx, -b.dx, a.x, -b.x}) sum.add(x);
  return sum.sign() < 0;
}

/// The sine of the angle between the edges at v, roughly.
double sine_at(const DisplacedPoint& before, const DisplacedPoint& v, const DisplacedPoint& after) {
  const double ux = before.x - v.x, uy = before.y - v.y, wx = after.x - v.x, wy = after.y - v.y;
  const double scale_u = std::max(std::fabs(ux), std::fabs(uy)), scale_w = std::max(std::fabs(wx), std::fabs(wy));
  const double ax = ux / scale_u, ay = uy / scale_u, bx = wx / scale_w, by = wy / scale_w;
  // Between edges nearly in line there is as much room as between square ones.
  if (ax * bx + ay * by < 0) return 1;
  return std::fabs(ax * by - ay * bx) / std::sqrt((ax * ax + ay * ay) * (bx * bx + by * by));
}

/// The hole seen from one side, as if that were the right.
struct View {
  Ring hole;  ///< clockwise
  std::size_t mouth = 0;
  double sine = 0;

  explicit View(Ring ring) : hole(std::move(ring)) {
    for (std::size_t i = 1; i < hole.size(); ++i) {
      if (is_left_of(hole[mouth], hole[i])) mouth = i;
    }
    sine = sine_at(at(hole.size() - 1), at(0), at(1));
  }
  /// The k-th vertex after the mouth.
  const DisplacedPoint& at(std::size_t k) const { return hole[(mouth + k) % hole.size()]; }
};

/// The two sides of the mouth: the vertex at which the walls below and above it end. One is the hole's vertex itself,
/// the other a little way along the edge above, or below.
struct Mouth {
  DisplacedPoint below, above;
};

/// A little way from the mouth's vertex towards a neighbour of it.
DisplacedPoint beside_mouth(const View& view, const DisplacedPoint& neighbour) {
  const DisplacedPoint& v = view.at(0);
  const double ux = neighbour.x - v.x, uy = neighbour.y - v.y, scale = std::max(std::fabs(ux), std::fabs(uy));
  const double x = ux / scale, y = uy / scale, size = std::sqrt(x * x + y * y);
  const double way = mouth_share * displacement_unit / (view.sine * view.sine);
  return {v.x, v.y, v.dx + way * (x / size), v.dy + way * (y / size)};
}

/// Do the walls from the mouth to the ends of the box not meet each other, or the edges that come to the mouth? The
/// hole's vertex must be on its side of the wall that ends next to it. And what is next to it is on the hole's side of
/// the other edge, or beyond its end, where the two edges are nearly in line.
bool is_open(const View& view, const Mouth& mouth, bool above_is_sideways, const DisplacedPoint& low_end,
             const DisplacedPoint& high_end) {
  const DisplacedPoint &v = view.at(0), &after = view.at(1), &before = view.at(view.hole.size() - 1);
  const DisplacedPoint& sideways = above_is_sideways ? mouth.above : mouth.below;
  if (above_is_sideways ? orientation(sideways, high_end, v) >= 0 : orientation(sideways, low_end, v) <= 0)
    return false;
  const int side = above_is_sideways ? orientation(after, v, sideways) : orientation(sideways, v, before);
  if (side <= 0 && sine_at(after, v, before) < 1) return false;
  // Far from the edge's other end.
  const auto far = [&](const DisplacedPoint& end) {
    const double way = std::max(std::fabs(sideways.dx - v.dx), std::fabs(sideways.dy - v.dy));
    return 4 * way <= std::max(std::fabs(end.x - v.x), std::fabs(end.y - v.y));
  };
  return far(before) && far(after);
}

/// The box around the hole, cut open on its right: counterclockwise from the wall above the mouth to the one below.
/// Its proportions are irregular, so that its edges are in line with nothing.
std::vector<Point> cut_box(const View& view) {
  AxisBox b;
  for (const DisplacedPoint& v : view.hole) b.include(v.x, v.y);
  const double s = b.longest(), y = view.at(0).y;
  return {{b.hi_x + 0.2371 * s, y + 0.1137 * s},      {b.hi_x + 0.2293 * s, b.hi_y + 0.2531 * s},
          {b.lo_x - 0.2417 * s, b.hi_y + 0.2239 * s}, {b.lo_x - 0.2173 * s, b.lo_y - 0.2357 * s},
          {b.hi_x + 0.2539 * s, b.lo_y - 0.2467 * s}, {b.hi_x + 0.2213 * s, y - 0.1171 * s}};
}

DisplacedPoint given(const Point& p) { return {p.x, p.y, 0, 0}; }

/// The hole cut open, from the mouth's side below to the one above, and on around the box; nothing if doubles leave no
/// room for a mouth.
std::optional<Ring> cut_open(const View& view) {
  if (!(view.sine > 0)) return std::nullopt;
  const std::vector<Point> box = cut_box(view);
  const DisplacedPoint &v = view.at(0), low_end = given(box.back()), high_end = given(box.front());
  const DisplacedPoint up = beside_mouth(view, view.at(view.hole.size() - 1)), down = beside_mouth(view, view.at(1));
  Mouth mouth{v, up};
  if (!is_open(view, mouth, true, low_end, high_end)) {
    mouth = {down, v};
    if (!is_open(view, mouth, false, low_end, high_end)) return std::nullopt;
  }
  Ring ring{mouth.below};
  ring.reserve(view.hole.size() + 7);
  for (std::size_t k = 1; k < view.hole.size(); ++k) ring.push_back(view.at(k));
  ring.push_back(mouth.above);
  for (const Point& p : box) ring.push_back(given(p));
  return ring;
}

bool is_lower_left(const DisplacedPoint& a, const DisplacedPoint& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

}  // namespace

std::optional<std::uint32_t> Container::vertex(std::uint32_t k) const {
  const auto n = static_cast<std::uint32_t>(polygon->points.size()), i = (k + n - first) % n;
  if (i > hole_size) return std::nullopt;
  return (mouth + i) % hole_size;
}

std::optional<std::uint32_t> Container::edge(std::uint32_t k) const {
  const auto n = static_cast<std::uint32_t>(polygon->points.size()), i = (k + n - first) % n;
  if (i >= hole_size) return std::nullopt;
  return (mouth + i) % hole_size;
}

std::optional<Container> container_around(std::span<const DisplacedPoint> hole) {
  // At the bluntest of the outermost vertices on four sides.
  std::optional<Ring> ring;
  double sine = 0;
  int turns = 0;
  Container result;
  result.hole_size = static_cast<std::uint32_t>(hole.size());
  Ring seen(hole.begin(), hole.end());
  for (int k = 0; k < 4; ++k) {
    const View view(seen);
    std::optional<Ring> open = view.sine > sine ? cut_open(view) : std::nullopt;
    if (open) {
      ring = std::move(open);
      sine = view.sine;
      turns = k;
      result.mouth = static_cast<std::uint32_t>(view.mouth);
    }
    for (DisplacedPoint& v : seen) v = turned(v);
  }
  if (!ring) return std::nullopt;
  for (DisplacedPoint& v : *ring) {
    for (int k = 0; k < turns; ++k) v = turned_back(v);
  }
  const auto start = std::min_element(ring->begin(), ring->end(), is_lower_left) - ring->begin();
  std::rotate(ring->begin(), ring->begin() + start, ring->end());
  const auto n = static_cast<std::uint32_t>(ring->size());
  result.first = (n - static_cast<std::uint32_t>(start)) % n;
  result.polygon = std::make_shared<const DisplacedPolygon>(std::move(*ring));
  return result;
}

}  // namespace taut::internal
