#include "scene/joined_parts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "geometry/displacement.hpp"
#include "geometry/predicates.hpp"
#include "geometry/region_union.hpp"
#include "geometry/vector.hpp"
#include "scene/ring_set.hpp"
#include "taut/error.hpp"

namespace taut::internal {
namespace {

/// How often random numbers are drawn anew where rings are not in general position.
constexpr int most_draws = 16;

Vector between(const Point& a, const Point& b) { return {b.x - a.x, b.y - a.y}; }
Point moved(const Point& p, const Vector& v) { return {p.x + v.x, p.y + v.y}; }
double length_of(const Vector& v) { return std::sqrt(dot(v, v)); }

/// How far p is from the segment from a to b.
double distance_to(const Point& p, const Point& a, const Point& b) {
  const Vector along = between(a, b), way = between(a, p);
  const double square = dot(along, along);
  const double share = square > 0 ? std::clamp(dot(way, along) / square, 0.0, 1.0) : 0;
  return length_of({way.x - share * along.x, way.y - share * along.y});
}

/// A ring of the body, with the material to its left.
struct GivenRing {
  Polygon points;
  BodyId body = 0;
  int part = 0, ring = 0;
  bool reversed = false;

  GivenRing(const Polygon& given, BodyId id, int of_part, int number)
      : points(given), body(id), part(of_part), ring(number) {
    reversed = (polygon_orientation(given) > 0) != (number == 0);
    if (reversed) std::reverse(points.begin(), points.end());
  }
  VertexRef vertex(std::uint32_t k) const {
    const auto n = static_cast<std::uint32_t>(points.size());
    return {body, static_cast<int>(reversed ? n - 1 - k : k), part, ring};
  }
  EdgeRef edge(std::uint32_t k) const {
    const auto n = static_cast<std::uint32_t>(points.size());
    return {body, static_cast<int>(reversed ? (2 * n - 2 - k) % n : k), part, ring};
  }
};

/// A ring whose edges have moved outwards by between `by` and twice as much, and of each vertex the given one.
class GrownRing {
 public:
  GrownRing(const Polygon& ring, double by, std::uint64_t seed) : by_(by), seed_(seed) {
    // A vertex moves by no more than so many times `by`, and edges next to one that others than it cut off are longer.
    constexpr double longest_way = 6, least_room = 24;
    const Displacement grown = displace(ring, Offset::outward, by, seed);
    const auto n = static_cast<std::uint32_t>(ring.size());
    for (std::uint32_t k = 0; k < n; ++k) {
      const Corner corner{ring[(k + n - 1) % n], ring[k], ring[(k + 1) % n]};
      const DisplacedPoint& to = grown.points[k];
      const double way = length_of({to.dx, to.dy});
      if (way > 0 && way <= longest_way * by && (corner.convex() || corner.room() > least_room * by)) {
        add(moved(corner.at, {to.dx, to.dy}), k);
      } else {
        go_round(corner, k);
      }
    }
  }

  Polygon points;
  std::vector<std::uint32_t> given;

 private:
  struct Corner {
    Point before, at, after;

    bool convex() const { return orientation(before, at, after) > 0; }
    double room() const { return std::min(length_of(between(before, at)), length_of(between(at, after))); }
  };

  void add(const Point& p, std::uint32_t k) {
    points.push_back(p);
    given.push_back(k);
  }
  double random(std::uint32_t k, std::uint64_t which, double lo, double hi) const {
    return random_between(seed_ + 8 * k + which + 0x51ed27, lo * by_, hi * by_);
  }
  /// A sharp corner is cut off. Into one without room the ring goes by a loop that winds around nothing that the edges
  /// next to it do not.
  void go_round(const Corner& corner, std::uint32_t k) {
    const Vector in = between(corner.before, corner.at), on = between(corner.at, corner.after);
    const Vector along_in = scaled(in, 1 / length_of(in)), along_on = scaled(on, 1 / length_of(on));
    const double out_in = random(k, 0, 1.2, 1.8), out_on = random(k, 1, 1.2, 1.8);
    const bool convex = corner.convex();
    const double beyond_in = convex ? random(k, 2, 1.2, 1.8) : 0, beyond_on = convex ? random(k, 3, 1.2, 1.8) : 0;
    add(moved(corner.at, scaled(along_in, beyond_in) - scaled(turned(along_in), out_in)), k);
    if (!convex) add(moved(corner.at, {random(k, 4, -0.1, 0.1), random(k, 5, -0.1, 0.1)}), k);
    add(moved(corner.at, -scaled(along_on, beyond_on) - scaled(turned(along_on), out_on)), k);
  }
  static Vector scaled(const Vector& v, double by) { return {v.x * by, v.y * by}; }

  double by_;
  std::uint64_t seed_;
};

/// A vertex of the union, and what it is called.
struct NamedVertex {
  Point at;
  VertexRef vertex;
  EdgeRef edge;
};
using NamedRing = std::vector<NamedVertex>;

/// Takes away vertices next to edges that are shorter than the tolerance, as long as each one that is gone stays within
/// it.
class Smoother {
 public:
  Smoother(NamedRing ring, double tolerance) : ring_(std::move(ring)), tolerance_(tolerance) {
    for (std::size_t i = 0; i < ring_.size(); ++i) kept_.push_back(i);
  }

  /// With fewer than three vertices where all of the ring is within the tolerance of a segment.
  NamedRing run() {
    for (bool again = true; again && kept_.size() > 2;) {
      again = false;
      for (std::size_t i = 0; i < kept_.size() && kept_.size() > 2;) {
        if (may_go(i)) {
          kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(i));
          again = true;
        } else {
          ++i;
        }
      }
    }
    NamedRing rest;
    for (const std::size_t i : kept_) rest.push_back(ring_[i]);
    return rest;
  }

 private:
  bool may_go(std::size_t i) const {
    const std::size_t n = kept_.size(), before = kept_[(i + n - 1) % n], after = kept_[(i + 1) % n];
    const Point &a = ring_[before].at, &b = ring_[after].at, &v = ring_[kept_[i]].at;
    if (length_of(between(a, v)) > tolerance_ && length_of(between(v, b)) > tolerance_) return false;
    for (std::size_t k = (before + 1) % ring_.size(); k != after; k = (k + 1) % ring_.size()) {
      if (distance_to(ring_[k].at, a, b) > tolerance_) return false;
    }
    return true;
  }

  NamedRing ring_;
  double tolerance_;
  std::vector<std::size_t> kept_;
};

Polygon points_of(const NamedRing& ring) {
  Polygon points;
  for (const NamedVertex& v : ring) points.push_back(v.at);
  return points;
}

JoinedRing joined_ring(NamedRing ring, bool hole) {
  JoinedRing joined;
  if (hole) {
    // Edges leave from their other ends then.
    std::reverse(ring.begin(), ring.end());
    std::vector<EdgeRef> edges;
    for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back(ring[(i + 1) % ring.size()].edge);
    for (std::size_t i = 0; i < ring.size(); ++i) ring[i].edge = edges[i];
  }
  for (const NamedVertex& v : ring) {
    joined.points.push_back(v.at);
    joined.vertices.push_back(v.vertex);
    joined.edges.push_back(v.edge);
  }
  return joined;
}

class PartJoiner {
 public:
  PartJoiner(const Body& body, BodyId id, double tolerance) : body_(body), tolerance_(tolerance) {
    const std::vector<Part> parts = parts_of(body);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      rings_.emplace_back(parts[i].outline, id, static_cast<int>(i), 0);
      for (std::size_t k = 0; k < parts[i].holes.size(); ++k)
        rings_.emplace_back(parts[i].holes[k], id, static_cast<int>(i), static_cast<int>(k) + 1);
    }
  }

  std::optional<std::vector<JoinedPart>> run() {
    for (int draw = 0; draw < most_draws; ++draw) {
      grow(static_cast<std::uint64_t>(draw) << 40);
      std::vector<Polygon> grown;
      for (const GrownRing& ring : grown_) grown.push_back(ring.points);
      const std::optional<RingUnion> joined = union_of(grown);
      if (!joined) continue;
      if (!joined->changed) return std::nullopt;
      return parts_of_union(*joined);
    }
    throw InputError(body_.name, "its parts touch in too many places at once for them to be joined",
                     "join them in the drawing, or leave out the fit");
  }

 private:
  void grow(std::uint64_t seed) {
    grown_.clear();
    for (std::size_t i = 0; i < rings_.size(); ++i)
      grown_.emplace_back(rings_[i].points, tolerance_ / 16, seed + (static_cast<std::uint64_t>(i) << 24));
  }

  NamedVertex named(const UnionVertex& v) const {
    const GivenRing& given = rings_[v.ring];
    const std::vector<std::uint32_t>& of = grown_[v.ring].given;
    const std::uint32_t k = of[v.edge], next = (k + 1) % static_cast<std::uint32_t>(given.points.size());
    const bool first = length_of(between(v.at, given.points[k])) <= length_of(between(v.at, given.points[next]));
    return {v.at, given.vertex(first ? k : next), given.edge(k)};
  }

  std::vector<JoinedPart> parts_of_union(const RingUnion& joined) const {
    std::vector<NamedRing> holes;
    std::vector<JoinedPart> parts;
    for (const std::vector<UnionVertex>& ring : joined.rings) {
      NamedRing all;
      for (const UnionVertex& v : ring) all.push_back(named(v));
      const bool hole = polygon_orientation(points_of(all)) < 0;
      NamedRing smooth = Smoother(std::move(all), tolerance_).run();
      if (smooth.size() > 2 && hole) {
        holes.push_back(std::move(smooth));
      } else if (smooth.size() > 2) {
        parts.push_back({joined_ring(std::move(smooth), false), {}});
      } else if (!hole) {
        throw InputError(body_.name, "part " + std::to_string(smooth[0].vertex.part) + " is too thin to be shrunk",
                         "choose a smaller fit");
      }
    }
    for (NamedRing& hole : holes) part_around(hole[0].at, parts).holes.push_back(joined_ring(std::move(hole), true));
    return parts;
  }

  /// The smallest one that the hole lies in.
  JoinedPart& part_around(const Point& p, std::vector<JoinedPart>& parts) const {
    JoinedPart* best = nullptr;
    for (JoinedPart& part : parts) {
      const bool inside = side_of_ring(part.outline.points, p) > 0;
      if (inside && (!best || side_of_ring(best->outline.points, part.outline.points[0]) > 0)) best = &part;
    }
    if (best) return *best;
    throw InputError(body_.name, "a hole between its parts comes too near to their outside to be shrunk",
                     "choose a smaller fit");
  }

  const Body& body_;
  double tolerance_;
  std::vector<GivenRing> rings_;
  std::vector<GrownRing> grown_;
};

}  // namespace

std::optional<std::vector<JoinedPart>> joined_parts(const Body& body, BodyId id, double tolerance) {
  if (body.parts.size() < 2) return std::nullopt;
  return PartJoiner(body, id, tolerance).run();
}

std::vector<Layers> layers_of_parts(const Body& body) {
  std::vector<Layers> all;
  for_each_layers(body, [&](const Layers& z) { all.push_back(z); });
  return all;
}

std::vector<CrossSection> cross_sections_of(const Body& body) {
  const std::vector<Layers> parts = layers_of_parts(body);
  if (std::all_of(parts.begin(), parts.end(), [&](const Layers& z) { return z == parts[0]; })) {
    CrossSection all{parts[0], {}};
    for (std::size_t k = 0; k < parts.size(); ++k) all.parts.push_back(k);
    return {all};
  }
  std::vector<double> ends;
  for (const Layers& z : parts) ends.insert(ends.end(), {z.lo, z.hi});
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  std::vector<CrossSection> sections;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    CrossSection section{{ends[i], ends[i + 1]}, {}};
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (parts[k].meet(section.z)) section.parts.push_back(k);
    }
    if (section.parts.empty()) continue;
    const bool goes_on = !sections.empty() && sections.back().z.hi == section.z.lo;
    if (goes_on && sections.back().parts == section.parts) {
      sections.back().z.hi = section.z.hi;
    } else {
      sections.push_back(std::move(section));
    }
  }
  return sections;
}

bool share_layers(const Body& a, const Body& b) {
  bool share = false;
  for_each_layers(a,
                  [&](const Layers& x) { for_each_layers(b, [&](const Layers& y) { share = share || x.meet(y); }); });
  return share;
}

}  // namespace taut::internal
