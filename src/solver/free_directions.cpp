#include "solver/free_directions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "numeric/budget.hpp"
#include "numeric/errors.hpp"
#include "numeric/stages.hpp"
#include "numeric/trig.hpp"

namespace taut::internal {
namespace {

constexpr double whole_turn = 2 * std::numbers::pi;
/// A bound, in radians, of the error of the C library's atan2 and of the rounding of sums of angles.
constexpr double angle_rounding = 0x1p-48;
/// The margin at the ends of an arc that is left to exact signs, in radians.
constexpr double angle_slack = 0x1p-20;

std::uint32_t next_in_ring(const DisplacedPolygon& polygon, std::uint32_t k) {
  if (!polygon.next.empty()) return polygon.next[k];
  return k + 1 == polygon.points.size() ? 0 : k + 1;
}

/// The angle of v in [0, 2 pi).
double angle_of(Vector v) {
  const double a = std::atan2(v.y, v.x);
  return a < 0 ? a + whole_turn : a;
}

}  // namespace

Vector FreeDirections::difference(const VertexDirection& d) const {
  if (d.kind != VertexDirection::Kind::vertices) {
    const auto place = place_on_side<double>(d);
    return {place[0].mid, place[1].mid};
  }
  return theirs(d.other).vertices.at(d.to) - own(d.other).vertices.at(d.from);
}

double FreeDirections::difference_error(const VertexDirection& d) const {
  if (d.kind != VertexDirection::Kind::vertices) {
    const auto place = place_on_side<double>(d);
    return std::max(place[0].rad, place[1].rad);
  }
  return theirs(d.other).vertices.error() + own(d.other).vertices.error();
}

template <class Real>
std::array<Ball<Real>, 2> FreeDirections::vertex_difference(const VertexDirection& d) const {
  const auto to = theirs(d.other).vertices.enclosed<Real>(d.to);
  const auto from = own(d.other).vertices.enclosed<Real>(d.from);
  return {to[0] - from[0], to[1] - from[1]};
}

/// The vertices at the other end of a side.
VertexDirection FreeDirections::second_end(const VertexDirection& side) const {
  VertexDirection end{side.from, side.other, side.to};
  if (side.kind == VertexDirection::Kind::to_edge)
    end.to = next_in_ring(theirs(side.other).vertices.polygon(), side.to);
  if (side.kind == VertexDirection::Kind::from_edge)
    end.from = next_in_ring(own(side.other).vertices.polygon(), side.from);
  return end;
}

/// The place d + t w on a side of a parallelogram with |d + t w| = travel: a root of |w|^2 t^2 + 2 (d.w) t + |d|^2 -
/// travel^2.
template <class Real>
std::array<Ball<Real>, 2> FreeDirections::place_on_side(const VertexDirection& side) const {
  using B = Ball<Real>;
  const auto d = vertex_difference<Real>(side), end = vertex_difference<Real>(second_end(side));
  const B wx = end[0] - d[0], wy = end[1] - d[1], radius = B::exact(travel_);
  const B a = wx * wx + wy * wy, b = d[0] * wx + d[1] * wy, c = d[0] * d[0] + d[1] * d[1] - radius * radius;
  const B root = sqrt(b * b - a * c);
  const B t = (side.second ? root - b : -b - root) / a;
  return {d[0] + t * wx, d[1] + t * wy};
}

template <class Real>
std::array<Ball<Real>, 2> FreeDirections::exact_difference(const VertexDirection& d) const {
  return d.kind == VertexDirection::Kind::vertices ? vertex_difference<Real>(d) : place_on_side<Real>(d);
}

/// The sign of a quantity that has one at some precision, given as a function of a number's type.
template <class Quantity>
int FreeDirections::decided(const Quantity& quantity, const char* what) const {
  if (const int sign = quantity(double{}).sign()) return sign;
  if (const int sign = decided_sign(quantity)) return sign;
  throw Undecidable{what};
}

/// Are the two vertices nearer to each other than the travel?
bool FreeDirections::within_travel(const VertexDirection& d) const {
  const auto beyond = [&](auto real) {
    using B = Ball<decltype(real)>;
    const auto v = vertex_difference<decltype(real)>(d);
    return v[0] * v[0] + v[1] * v[1] - B::exact(travel_) * B::exact(travel_);
  };
  return decided(beyond, "whether two vertices are nearer than the travel") < 0;
}

/// For a side with both ends outside of the disc: does it enter the disc?
bool FreeDirections::dips_into_disc(const VertexDirection& side) const {
  const VertexDirection end = second_end(side);
  // From either end, the direction along the side leads towards the origin at first.
  const auto towards = [&](const VertexDirection& from, const VertexDirection& to) {
    return decided(
               [&](auto real) {
                 using Real = decltype(real);
                 const auto p = vertex_difference<Real>(from), q = vertex_difference<Real>(to);
                 return p[0] * (p[0] - q[0]) + p[1] * (p[1] - q[1]);
               },
               "whether an edge comes nearer") > 0;
  };
  VertexDirection begin = side;
  begin.kind = VertexDirection::Kind::vertices;
  if (!towards(begin, end) || !towards(end, begin)) return false;
  const auto inside = [&](auto real) {
    using B = Ball<decltype(real)>;
    const auto p = vertex_difference<decltype(real)>(begin), q = vertex_difference<decltype(real)>(end);
    const B x = q[0] - p[0], y = q[1] - p[1], area = p[0] * q[1] - p[1] * q[0], travel = B::exact(travel_);
    return travel * travel * (x * x + y * y) - area * area;
  };
  return decided(inside, "whether an edge is nearer than the travel") > 0;
}

/// Adds the places where a side of a parallelogram of differences crosses the circle whose radius is the travel.
void FreeDirections::add_places(VertexDirection side, FewDirections& found) const {
  VertexDirection begin = side;
  begin.kind = VertexDirection::Kind::vertices;
  const bool first = within_travel(begin), last = within_travel(second_end(side));
  if (first && last) return;
  if (!first && !last && !dips_into_disc(side)) return;
  if (!first) found.push_back(side);
  side.second = true;
  if (!last) found.push_back(side);
}

/// +1 if b is counterclockwise from a, by less than 180 degrees.
int FreeDirections::cross(const VertexDirection& a, const VertexDirection& b) const {
  const Vector u = difference(a), v = difference(b);
  const double value = u.x * v.y - u.y * v.x, e = difference_error(a), f = difference_error(b);
  const double error =
      l1_norm(u) * f + l1_norm(v) * e + 2 * e * f + 0x1p-50 * l1_norm(u) * l1_norm(v) + underflow_slack;
  if (std::fabs(value) > error) return value > 0 ? 1 : -1;
  const int sign = decided_sign([&](auto real) {
    using Real = decltype(real);
    const auto p = exact_difference<Real>(a), q = exact_difference<Real>(b);
    return p[0] * q[1] - p[1] * q[0];
  });
  if (sign != 0) return sign;
  throw Undecidable{"the order of two directions"};
}

/// +1 for directions between 0 and 180 degrees, else -1.
int FreeDirections::upper(const VertexDirection& d) const {
  const double y = difference(d).y;
  if (std::fabs(y) > difference_error(d)) return y > 0 ? 1 : -1;
  if (const int sign = decided_sign([&](auto real) { return exact_difference<decltype(real)>(d)[1]; })) return sign;
  throw Undecidable{"whether a direction is above the x axis"};
}

/// The order of directions, counterclockwise from the x axis.
bool FreeDirections::before(const VertexDirection& a, const VertexDirection& b) const {
  if (a == b) return false;
  const int half_a = upper(a), half_b = upper(b);
  return half_a != half_b ? half_a > half_b : cross(a, b) > 0;
}

/// The cone over the differences of the points of two edges is that over the differences of their ends. These are on
/// one side of the origin, since the edges do not meet. Nothing if the travel is too short for them to meet.
std::optional<VertexArc> FreeDirections::arc_of(std::uint32_t edge, int other, std::uint32_t other_edge) const {
  using Kind = VertexDirection::Kind;
  const std::uint32_t edge_end = next_in_ring(own(other).vertices.polygon(), edge);
  const std::uint32_t other_end = next_in_ring(theirs(other).vertices.polygon(), other_edge);
  FewDirections ends;
  for (const VertexDirection& d :
       {VertexDirection{edge, other, other_edge}, VertexDirection{edge, other, other_end},
        VertexDirection{edge_end, other, other_edge}, VertexDirection{edge_end, other, other_end}}) {
    if (!has_end() || within_travel(d)) ends.push_back(d);
  }
  if (has_end()) {
    for (const VertexDirection& side : {VertexDirection{edge, other, other_edge, Kind::to_edge},
                                        VertexDirection{edge_end, other, other_edge, Kind::to_edge},
                                        VertexDirection{edge, other, other_edge, Kind::from_edge},
                                        VertexDirection{edge, other, other_end, Kind::from_edge}})
      add_places(side, ends);
  }
  if (ends.empty()) return std::nullopt;
  VertexArc arc{ends[0], ends[0]};
  for (std::size_t i = 1; i < ends.size(); ++i) {
    if (cross(ends[i], arc.from) > 0) {
      arc.from = ends[i];
    } else if (cross(arc.to, ends[i]) > 0) {
      arc.to = ends[i];
    }
  }
  return arc;
}

/// Do doubles determine the direction?
bool FreeDirections::clear(const VertexDirection& d) const {
  return l1_norm(difference(d)) > 0x1p20 * difference_error(d);
}

void FreeDirections::block(std::uint32_t edge, int other, std::uint32_t other_edge) {
  const std::optional<VertexArc> blocked = arc_of(edge, other, other_edge);
  if (!blocked) return;
  const VertexArc& arc = *blocked;
  if (clear(arc.from) && clear(arc.to)) {
    const double from = angle_of(difference(arc.from));
    double to = angle_of(difference(arc.to));
    if (to < from) to += whole_turn;
    if (to - from < std::numbers::pi && covered(from - angle_slack, to + angle_slack)) return;
  }
  arcs_.push_back(arc);
  cover(arc);
}

/// Marks all sectors that lie within the arc, ends included. It uses doubles, so only those that are well inside are
/// marked.
void FreeDirections::cover(const VertexArc& arc) {
  if (!clear(arc.from) || !clear(arc.to)) return;
  const double from = angle_of(difference(arc.from));
  double to = angle_of(difference(arc.to));
  if (to < from) to += whole_turn;
  // Arcs are shorter than 180 degrees.
  if (to - from > std::numbers::pi) return;
  const double width = whole_turn / sectors;
  for (double k = std::ceil((from + angle_slack) / width); (k + 1) * width <= to - angle_slack; ++k)
    covered_.set(static_cast<std::size_t>(k) % sectors);
}

bool FreeDirections::covered(double from, double to) const {
  const double width = whole_turn / sectors;
  if (to - from >= whole_turn) return covered_.all();
  for (double k = std::floor(from / width); k * width <= to; ++k) {
    const auto index = static_cast<long long>(k) % static_cast<long long>(sectors);
    if (!covered_.test(static_cast<std::size_t>(index < 0 ? index + static_cast<long long>(sectors) : index)))
      return false;
  }
  return true;
}

/// Are all directions from one box to the other blocked already, or out of reach? Decided by the discs around them.
bool FreeDirections::covered(const spacetime::BoxNode& box, int other, const spacetime::BoxNode& node) const {
  const StandingBody &here = own(other), &there = theirs(other);
  const Vector way = there.vertices.place(node.box.centre) - here.vertices.place(box.box.centre);
  const double reach =
      (box.box.radius + node.box.radius + here.vertices.error() + there.vertices.error()) * (1 + 0x1p-20);
  const double distance = std::sqrt(dot(way, way));
  // The other box is out of reach.
  if (distance - reach > travel_ * (1 + 0x1p-20)) return true;
  if (!(distance > reach)) return covered_.all();
  const double half = std::asin(std::min(1.0, reach / distance)) + angle_slack, middle = angle_of(way);
  return covered(middle - half, middle + half);
}

void FreeDirections::add(const StandingBody& moving, const StandingBody& other) {
  pairs_.push_back({&moving, &other});
  const int index = static_cast<int>(pairs_.size()) - 1;
  sample(index);
  descend(index);
}

/// Tests some pairs from all over both bodies, so that most blocked directions are known early.
void FreeDirections::sample(int other) {
  const auto n = static_cast<std::uint32_t>(own(other).vertices.polygon().points.size());
  const auto m = static_cast<std::uint32_t>(theirs(other).vertices.polygon().points.size());
  const std::uint32_t count = 2 * std::max(n, m);
  for (std::uint32_t k = 0; k < count; ++k) {
    checkpoint();
    block(static_cast<std::uint32_t>(std::uint64_t{k} * 7919 % n), other,
          static_cast<std::uint32_t>((std::uint64_t{k} * 104729 + k / n) % m));
  }
}

void FreeDirections::descend(int other) {
  const spacetime::Hierarchy &here = own(other).tree, &there = theirs(other).tree;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> stack{{0, 0}};
  while (!stack.empty()) {
    checkpoint();
    const auto [i, j] = stack.back();
    stack.pop_back();
    const spacetime::BoxNode &a = here.node(i), &b = there.node(j);
    if (covered(a, other, b)) continue;
    if (a.count == 1 && b.count == 1) {
      block(a.first, other, b.first);
    } else if (divides_first(a, b)) {
      stack.insert(stack.end(), {{a.left, j}, {a.right, j}});
    } else {
      stack.insert(stack.end(), {{i, b.left}, {i, b.right}});
    }
  }
}

std::vector<VertexArc> FreeDirections::free() {
  struct End {
    VertexDirection at;
    int change;  ///< +1 where an arc begins, -1 where one ends
  };
  std::vector<End> ends;
  int count = 0;  // the number of arcs around the current direction, initially along the x axis
  for (const VertexArc& arc : arcs_) {
    ends.push_back({arc.from, 1});
    ends.push_back({arc.to, -1});
    if (before(arc.to, arc.from)) ++count;
  }
  std::stable_sort(ends.begin(), ends.end(), [this](const End& a, const End& b) { return before(a.at, b.at); });
  std::vector<VertexArc> found;
  std::optional<VertexDirection> begun;
  const bool free_at_first = count == 0;
  // Arcs are open. At a direction with several ends, arcs that contain the direction keep it blocked.
  for (std::size_t i = 0; i < ends.size();) {
    checkpoint();
    int ending = 0, beginning = 0;
    std::size_t k = i;
    for (; k < ends.size() && ends[k].at == ends[i].at; ++k) (ends[k].change < 0 ? ending : beginning) += 1;
    const int around = count - ending;
    if (around == 0) {
      const VertexDirection here = ends[i].at;
      if (ending > 0 && beginning > 0) {
        found.push_back({here, here});
      } else if (ending > 0) {
        begun = here;
      } else {
        found.push_back({begun.value_or(here), here});
        begun.reset();
      }
    }
    count = around + beginning;
    i = k;
  }
  // A free arc around the x axis begins last and ends first.
  if (free_at_first && begun && !found.empty()) found.front().from = *begun;
  return found;
}

bool FreeDirections::is_point(const VertexArc& arc) const {
  if (arc.from == arc.to) return true;
  const auto [from_lo, from_hi] = degrees(arc.from);
  const auto [to_lo, to_hi] = degrees(arc.to);
  bool together = false;
  // Either may lie a little before 360 degrees.
  for (const double turn : {-360.0, 0.0, 360.0}) {
    if (from_lo + turn <= to_hi && to_lo <= from_hi + turn) together = true;
  }
  return together && cross(arc.from, arc.to) > 0;
}

std::pair<double, double> FreeDirections::degrees(const VertexDirection& d) const {
  // Use more bits, in case the difference is small relative to the error of its ends.
  const auto [x, y] = exact_difference<Real320>(d);
  const double length =
      std::fabs(RealTraits<Real320>::to_double(x.mid)) + std::fabs(RealTraits<Real320>::to_double(y.mid));
  const int exponent = length > 0 ? -std::ilogb(length) : 0;
  const auto scaled = [&](const Real320& c) { return RealTraits<Real320>::to_double(ldexp(c, exponent)); };
  const double angle = angle_of({scaled(x.mid), scaled(y.mid)});
  const double error = angle_rounding + std::ldexp(x.rad + y.rad, exponent);
  const double to_degrees = 180 / std::numbers::pi;
  return {(angle - error) * to_degrees, (angle + error) * to_degrees};
}

}  // namespace taut::internal
