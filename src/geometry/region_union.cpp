#include "geometry/region_union.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/polygon/polygon.hpp>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "geometry/part_rings.hpp"
#include "numeric/budget.hpp"
#include "taut/error.hpp"

/// Where edges cross is computed in long double otherwise, which is not the same on all platforms.
namespace boost::polygon {
template <>
struct high_precision_type<int> {
  using type = boost::multiprecision::cpp_bin_float_quad;
};
template <>
inline int convert_high_precision_type<int>(const boost::multiprecision::cpp_bin_float_quad& x) {
  return static_cast<int>(x);
}
}  // namespace boost::polygon

namespace taut::internal {
namespace {

namespace grid = boost::polygon;
using GridPoint = grid::point_data<int>;
using GridRing = std::vector<GridPoint>;
using GridSet = grid::polygon_set_data<int>;

/// So many polygons are united at once: what the union takes grows with the square of it.
constexpr int most_together = 4;
/// Points are so many bits of the grid away from its origin, at most; the origin itself is rounded to fewer.
constexpr int largest_bits = 28, rounded_bits = 20;

/// Cuts a ring where it comes to a vertex again, into rings that do not.
void cut_at_pinches(const GridRing& ring, std::vector<GridRing>& simple) {
  GridRing open;
  std::map<std::pair<int, int>, std::size_t> places;
  for (const GridPoint& p : ring) {
    const std::pair at(p.x(), p.y());
    const auto before = places.find(at);
    if (before != places.end()) {
      simple.emplace_back(open.begin() + static_cast<std::ptrdiff_t>(before->second), open.end());
      for (std::size_t k = before->second + 1; k < open.size(); ++k) places.erase({open[k].x(), open[k].y()});
      open.resize(before->second);
    }
    places[at] = open.size();
    open.push_back(p);
  }
  simple.push_back(std::move(open));
}

/// Twice the area, positive if counterclockwise. What overflows on the way does not matter: the sum fits.
std::int64_t doubled_area(const GridRing& ring) {
  const auto from = [&](const GridPoint& p) {
    const auto far = [](int a, int b) { return static_cast<std::uint64_t>(std::int64_t{a} - b); };
    return std::pair(far(p.x(), ring[0].x()), far(p.y(), ring[0].y()));
  };
  std::uint64_t sum = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const auto [px, py] = from(ring[k]);
    const auto [qx, qy] = from(ring[(k + 1) % ring.size()]);
    sum += px * qy - qx * py;
  }
  return static_cast<std::int64_t>(sum);
}

enum class Place : std::uint8_t { inside, outside, on };

Place place_of(const GridPoint& p, const GridRing& ring) {
  bool inside = false;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const GridPoint &a = ring[k], &b = ring[(k + 1) % ring.size()];
    const std::int64_t dx = std::int64_t{b.x()} - a.x(), dy = std::int64_t{b.y()} - a.y();
    const std::int64_t side = dx * (std::int64_t{p.y()} - a.y()) - dy * (std::int64_t{p.x()} - a.x());
    if (side == 0 && std::min(a.x(), b.x()) <= p.x() && p.x() <= std::max(a.x(), b.x()) &&
        std::min(a.y(), b.y()) <= p.y() && p.y() <= std::max(a.y(), b.y()))
      return Place::on;
    if ((a.y() <= p.y()) != (b.y() <= p.y()) && (side > 0) == (dy > 0)) inside = !inside;
  }
  return inside ? Place::inside : Place::outside;
}

/// Is a ring that does not cross the outline inside of it?
bool is_within(const GridRing& ring, const GridRing& outline) {
  for (const GridPoint& p : ring) {
    const Place place = place_of(p, outline);
    if (place != Place::on) return place == Place::inside;
  }
  return true;
}

/// Outlines, the smallest first, each with the holes that no smaller one has.
std::vector<std::vector<GridRing>> nested(std::vector<GridRing> rings) {
  std::vector<std::pair<std::int64_t, GridRing>> outlines, holes;
  for (GridRing& ring : rings) {
    const std::int64_t area = doubled_area(ring);
    if (area != 0) (area > 0 ? outlines : holes).emplace_back(area, std::move(ring));
  }
  std::stable_sort(outlines.begin(), outlines.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::vector<GridRing>> all;
  for (auto& [area, outline] : outlines) all.push_back({std::move(outline)});
  for (auto& of_hole : holes) {
    GridRing& hole = of_hole.second;
    const auto around =
        std::find_if(all.begin(), all.end(), [&](const auto& part) { return is_within(hole, part.front()); });
    if (around != all.end()) around->push_back(std::move(hole));
  }
  return all;
}

/// Of a polygon as the union has it, whose rings may come to vertices twice.
std::vector<GridRing> simple_rings(const grid::polygon_with_holes_data<int>& polygon) {
  std::vector<GridRing> simple;
  const auto add = [&](GridRing ring, bool hole) {
    if ((doubled_area(ring) > 0) == hole) std::reverse(ring.begin(), ring.end());
    cut_at_pinches(ring, simple);
  };
  add(GridRing(polygon.begin(), polygon.end()), false);
  for (auto hole = polygon.begin_holes(); hole != polygon.end_holes(); ++hole)
    add(GridRing(hole->begin(), hole->end()), true);
  return simple;
}

}  // namespace

/// Like the digits of a binary counter: each level holds the union of twice as many polygons as the one before, or
/// nothing.
struct RegionUnion::Levels {
  double unit;
  Point origin;  ///< a multiple of the unit, so that adding it to points of the grid rounds nothing
  std::unique_ptr<GridSet> fresh = std::make_unique<GridSet>();
  int waiting = 0;
  std::vector<std::unique_ptr<GridSet>> united = {};

  GridPoint rounded(const Point& p) const {
    return {static_cast<int>(std::lrint((p.x - origin.x) / unit)),
            static_cast<int>(std::lrint((p.y - origin.y) / unit))};
  }
  GridRing rounded(const Polygon& polygon) const {
    GridRing ring;
    for (const Point& p : polygon) {
      const GridPoint at = rounded(p);
      if (ring.empty() || ring.back() != at) ring.push_back(at);
    }
    while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
    return ring;
  }
  Polygon in_units(const GridRing& ring) const {
    Polygon polygon;
    for (const GridPoint& p : ring) polygon.push_back({origin.x + p.x() * unit, origin.y + p.y() * unit});
    return polygon;
  }
  void add(const Polygon& polygon, bool hole) {
    const GridRing ring = rounded(polygon);
    if (ring.size() < 3) return;
    grid::polygon_data<int> data(ring.begin(), ring.end());
    fresh->insert(data, hole);
  }
  void count() {
    checkpoint();
    if (++waiting >= most_together) unite();
  }
  void unite() {
    waiting = 0;
    std::unique_ptr<GridSet> sum = std::exchange(fresh, std::make_unique<GridSet>());
    sum->clean();
    for (std::size_t level = 0;; ++level) {
      if (level == united.size()) united.emplace_back();
      if (!united[level]) {
        united[level] = std::move(sum);
        return;
      }
      add_to(*sum, *std::exchange(united[level], nullptr));
    }
  }
  static void add_to(GridSet& sum, const GridSet& other) {
    count_work(sum.size() + other.size());
    checkpoint();
    sum.insert(other);
    sum.clean();
  }
};

RegionUnion::RegionUnion(double grid, const Point& near) {
  const double step = std::ldexp(grid, rounded_bits);
  levels_ = std::make_unique<Levels>(Levels{grid, {std::rint(near.x / step) * step, std::rint(near.y / step) * step}});
}
RegionUnion::~RegionUnion() = default;

bool RegionUnion::has_room_for(const Point& p) const {
  const Point& o = levels_->origin;
  return std::max(std::fabs(p.x - o.x), std::fabs(p.y - o.y)) < std::ldexp(0.99 * levels_->unit, largest_bits);
}

void RegionUnion::add(const Polygon& polygon) {
  levels_->add(polygon, false);
  levels_->count();
}

void RegionUnion::add(const Part& part) {
  levels_->add(part.outline, false);
  for (const Polygon& hole : part.holes) levels_->add(hole, true);
  levels_->unite();
}

std::vector<Part> RegionUnion::parts() {
  levels_->unite();
  // Each polygon is united once at first, once with each level that is full, and then with the levels above.
  if (levels_->united.size() + 1 >= most_unions)
    throw InputError("region", "more than a million polygons would have to be united", "ask for a larger tolerance");
  GridSet all;
  for (const auto& level : levels_->united) {
    if (level) Levels::add_to(all, *level);
  }
  std::vector<grid::polygon_with_holes_data<int>> found;
  all.get(found);
  std::vector<Part> parts;
  for (const auto& polygon : found) {
    checkpoint();
    for (const std::vector<GridRing>& rings : nested(simple_rings(polygon))) {
      Part part{levels_->in_units(rings.front()), {}};
      for (std::size_t k = 1; k < rings.size(); ++k) part.holes.push_back(levels_->in_units(rings[k]));
      for (Part& cut : cut_where_rings_touch(std::move(part))) parts.push_back(std::move(cut));
    }
  }
  return parts;
}

}  // namespace taut::internal
