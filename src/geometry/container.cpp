#include "geometry/container.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/displaced_orientation.hpp"
#include "numeric/exact_sum.hpp"

namespace taut {
namespace {

using Ring = std::vector<DisplacedPoint>;

/// The width of the mouth beside a displacement.
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

/// The mouth's other side: a little way along the edge that comes back to it.
DisplacedPoint beside_mouth(const View& view) {
  const DisplacedPoint &v = view.at(0), &before = view.at(view.hole.size() - 1);
  const double ux = before.x - v.x, uy = before.y - v.y, scale = std::max(std::fabs(ux), std::fabs(uy));
  const double size = std::sqrt((ux / scale) * (ux / scale) + (uy / scale) * (uy / scale));
  const double way = mouth_share * displacement_unit / (view.sine * view.sine);
  return {v.x, v.y, v.dx + way * (ux / scale / size), v.dy + way * (uy / scale / size)};
}

/// The vertex beside the mouth is on its side of the edge that leaves it, and on the way along the other one, so that
/// the two walls of the slit, and the edges, do not meet.
bool is_open(const View& view, const DisplacedPoint& beside) {
  const DisplacedPoint &v = view.at(0), &after = view.at(1), &before = view.at(view.hole.size() - 1);
  if (!(view.sine > 0)) return false;
  if (orientation(after, v, beside) <= 0 && sine_at(after, v, before) < 1) return false;
  // By a step along x and y that is no farther than the edge's end.
  const auto between = [](double from, double to, double step) { return std::fabs(step) <= std::fabs(to - from) / 4; };
  return between(v.x, before.x, beside.dx - v.dx) || between(v.y, before.y, beside.dy - v.dy);
}

/// The box around the hole, cut open on its right: counterclockwise from the wall above the mouth to the one below.
/// Its proportions are irregular, so that its edges are in line with nothing.
std::vector<Point> box_around(const View& view) {
  Bounds b{{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
  for (const DisplacedPoint& v : view.hole) {
    b.lo = {std::min(b.lo.x, v.x), std::min(b.lo.y, v.y)};
    b.hi = {std::max(b.hi.x, v.x), std::max(b.hi.y, v.y)};
  }
  const double s = std::max(b.hi.x - b.lo.x, b.hi.y - b.lo.y), y = view.at(0).y;
  return {{b.hi.x + 0.2371 * s, y + 0.1137 * s},      {b.hi.x + 0.2293 * s, b.hi.y + 0.2531 * s},
          {b.lo.x - 0.2417 * s, b.hi.y + 0.2239 * s}, {b.lo.x - 0.2173 * s, b.lo.y - 0.2357 * s},
          {b.hi.x + 0.2539 * s, b.lo.y - 0.2467 * s}, {b.hi.x + 0.2213 * s, y - 0.1171 * s}};
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
  // The bluntest of the outermost vertices on four sides.
  std::optional<View> best;
  int turns = 0;
  Ring seen(hole.begin(), hole.end());
  for (int k = 0; k < 4; ++k) {
    View view(seen);
    if (is_open(view, beside_mouth(view)) && (!best || view.sine > best->sine)) {
      best = view;
      turns = k;
    }
    for (DisplacedPoint& v : seen) v = turned(v);
  }
  if (!best) return std::nullopt;
  Container result;
  result.hole_size = static_cast<std::uint32_t>(hole.size());
  result.mouth = static_cast<std::uint32_t>(best->mouth);
  Ring ring;
  ring.reserve(hole.size() + 7);
  for (std::size_t k = 0; k < hole.size(); ++k) ring.push_back(best->at(k));
  ring.push_back(beside_mouth(*best));
  for (const Point& p : box_around(*best)) ring.push_back({p.x, p.y, 0, 0});
  for (DisplacedPoint& v : ring) {
    for (int k = 0; k < turns; ++k) v = turned_back(v);
  }
  const auto start = std::min_element(ring.begin(), ring.end(), is_lower_left) - ring.begin();
  std::rotate(ring.begin(), ring.begin() + start, ring.end());
  const auto n = static_cast<std::uint32_t>(ring.size());
  result.first = (n - static_cast<std::uint32_t>(start)) % n;
  result.polygon = std::make_shared<const DisplacedPolygon>(std::move(ring));
  return result;
}

}  // namespace taut
