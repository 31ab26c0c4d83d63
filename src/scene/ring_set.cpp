#include "scene/ring_set.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/budget.hpp"
#include "numeric/errors.hpp"
#include "scene/placement.hpp"
#include "taut/error.hpp"
#include "taut/shape.hpp"

namespace taut::internal {
namespace {

/// Different for any two rings of a scene, so that no two are displaced alike.
std::uint64_t seed_of(int body, std::size_t ring) {
  return 0x9e3779b97f4a7c15u * (static_cast<std::uint64_t>(body) + 1) + 0xbf58476d1ce4e5b9u * (ring + 1);
}

void reverse_order(std::vector<DisplacedPoint>& ring) { std::reverse(ring.begin() + 1, ring.end()); }

}  // namespace

std::vector<Part> parts_of(const Body& body) {
  refuse_curves(body);
  if (!body.parts.empty()) return body.parts;
  return {{polygon_of(body), {}}};
}

std::string ring_name(const Body& body, std::size_t part, std::size_t ring) {
  return ring_name(body.name, body.parts.size() > 1, static_cast<int>(part), static_cast<int>(ring));
}

std::string ring_name(std::string body, bool several_parts, int part, int ring) {
  if (several_parts) body += ": part " + std::to_string(part);
  if (ring > 0) body += ": hole " + std::to_string(ring);
  return body;
}

RingSet::RingSet(const Body& body, int index, int exponent, const std::vector<std::size_t>& section)
    : index_(index), exponent_(exponent), name_(body.name) {
  refuse_curves(body);
  bounds_ = AxisBox();
  if (body.parts.empty() && body.prepared) {
    prepared_ = body.prepared;
    add(prepared_->scaled(exponent), prepared_->facts(), 0, 0);
  } else if (body.parts.empty()) {
    add_ring(body.polygon, 0, 0);
  }
  for (std::size_t i = 0; i < body.parts.size(); ++i) {
    if (!section.empty() && !std::binary_search(section.begin(), section.end(), i)) continue;
    const Part& part = body.parts[i];
    add_ring(part.outline, static_cast<int>(i), 0);
    for (std::size_t j = 0; j < part.holes.size(); ++j)
      add_ring(part.holes[j], static_cast<int>(i), static_cast<int>(j) + 1);
  }
  diagonal_ = internal::diagonal(bounds_);
}

void RingSet::add_ring(const Polygon& ring, int part, int number) {
  const ShapeFacts facts = facts_of(ring);
  add(std::make_shared<const std::vector<Point>>(normalised(ring, facts, exponent_)), facts, part, number);
}

void RingSet::add(const Points& points, const ShapeFacts& facts, int part, int number) {
  rings_.push_back(points);
  const bool hole = number > 0;
  maps_.push_back({part, number, static_cast<std::uint32_t>(size_), facts.size, facts.first, facts.reversed != hole});
  size_ += points->size();
  for (const Point& p : *points) bounds_.include(p);
}

AxisBox RingSet::input_bounds() const {
  const auto unscaled = [this](double x) { return std::ldexp(x, -exponent_); };
  return {unscaled(bounds_.lo_x), unscaled(bounds_.lo_y), unscaled(bounds_.hi_x), unscaled(bounds_.hi_y)};
}

double RingSet::diameter_squared() const {
  const std::lock_guard lock(mutex_);
  if (diameter_squared_) return *diameter_squared_;
  if (prepared_) return *(diameter_squared_ = std::ldexp(prepared_->diameter_squared(), 2 * exponent_));
  if (rings_.size() == 1) return *(diameter_squared_ = internal::diameter_squared(points(0)));
  std::vector<Point> all;
  for (std::size_t i = 0; i < rings_.size(); ++i) {
    if (maps_[i].ring == 0) all.insert(all.end(), rings_[i]->begin(), rings_[i]->end());
  }
  return *(diameter_squared_ = internal::diameter_squared(all));
}

const RingMap& RingSet::ring_of(std::uint32_t k) const {
  const auto after =
      std::upper_bound(maps_.begin(), maps_.end(), k, [](std::uint32_t v, const RingMap& m) { return v < m.offset; });
  return *std::prev(after);
}

VertexRef RingSet::vertex(std::uint32_t k) const {
  const RingMap& m = ring_of(k);
  return {index_, m.vertex(k - m.offset), m.part, m.ring};
}

EdgeRef RingSet::edge(std::uint32_t k) const {
  const RingMap& m = ring_of(k);
  return {index_, m.edge(k - m.offset), m.part, m.ring};
}

const SharedPolygon& RingSet::displaced(Offset offset) const {
  const std::lock_guard lock(mutex_);
  SharedPolygon& place = displaced_[index_of(offset)];
  if (place) return place;
  const UnmeteredScope making;
  return place = displace_rings(offset);
}

/// Less material is a larger hole.
SharedPolygon RingSet::displaced_ring(std::size_t ring, Offset offset) const {
  const RingMap& map = maps_[ring];
  const std::uint64_t seed = seed_of(index_, ring);
  SharedPolygon displaced;
  if (prepared_) {
    const auto& kept = in_role_[index_of(offset)] = prepared_->in_role({seed, offset, exponent_});
    displaced = kept->displaced;
  } else {
    displaced = displaced_polygon(points(ring), map.ring > 0 ? opposite(offset) : offset, seed);
  }
  if (displaced->fault) refuse(map, *displaced->fault);
  return displaced;
}

SharedPolygon RingSet::displace_rings(Offset offset) const {
  if (rings_.size() == 1) return displaced_ring(0, offset);
  std::vector<DisplacedPoint> points;
  points.reserve(size_);
  std::vector<RingSpan> spans;
  for (std::size_t i = 0; i < rings_.size(); ++i) {
    const RingMap& map = maps_[i];
    const bool hole = map.ring > 0;
    std::vector<DisplacedPoint> vertices = displaced_ring(i, offset)->points;
    if (hole) reverse_order(vertices);
    spans.push_back({map.offset, map.size, hole});
    points.insert(points.end(), vertices.begin(), vertices.end());
  }
  return std::make_shared<const DisplacedPolygon>(std::move(points), std::move(spans));
}

const SingleRing& RingSet::single_ring(std::size_t ring, Offset offset) const {
  const SharedPolygon& all = displaced(offset);
  const std::lock_guard lock(mutex_);
  const auto [place, fresh] = single_rings_[index_of(offset)].try_emplace(ring);
  SingleRing& result = place->second;
  if (!fresh && result.polygon) return result;
  const UnmeteredScope making;
  const RingMap& map = maps_[ring];
  result.offset = map.offset;
  const std::span<const DisplacedPoint> points(all->points.data() + map.offset, map.size);
  if (map.ring == 0) {
    result.polygon =
        maps_.size() == 1
            ? all
            : std::make_shared<const DisplacedPolygon>(std::vector<DisplacedPoint>(points.begin(), points.end()));
    return result;
  }
  result.container = container_around(points);
  if (!result.container) throw Undecidable{"what meets a hole all of whose outermost corners are needles"};
  result.polygon = result.container->polygon;
  return result;
}

void RingSet::refuse(const RingMap& ring, const DisplacementFault& fault) const {
  const std::string place = ring_name(name_, maps_.back().part > 0, ring.part, ring.ring);
  const char* const hint = "features that small can only be rounding noise: remove them";
  // The fault counts counterclockwise, also in a hole.
  const RingMap around{ring.part, ring.ring, ring.offset, ring.size, ring.first, ring.reversed != (ring.ring > 0)};
  if (fault.kind == DisplacementFault::Kind::sharp_corner) {
    const int v = around.vertex(fault.first);
    throw InputError(place,
                     "the corner at vertex " + std::to_string(v) +
                         " is sharper than the displacement that taut computes with allows, about 2^-42 radians",
                     hint, {{{index_, v, ring.part, ring.ring}}, {}});
  }
  const int e = around.edge(fault.first), f = around.edge(fault.second);
  throw InputError(place,
                   "edges " + std::to_string(e) + " and " + std::to_string(f) +
                       " come closer than the displacement that taut computes with, 2^-199 of the largest coordinate",
                   hint, {{}, {{index_, e, ring.part, ring.ring}, {index_, f, ring.part, ring.ring}}});
}

namespace {

/// The rings of P, or Q, where they are.
class PlacedRings {
 public:
  PlacedRings(const BodyPair& bodies, const Placement& placement, Role role)
      : place_(placement), rings_(bodies.rings[index_of(role)]->rings()), first_(placement.geometry().first(role)) {}

  /// Of each part, its outline.
  std::vector<std::size_t> outlines() const {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < rings_.size(); ++i) {
      if (rings_[i].ring == 0) all.push_back(i);
    }
    return all;
  }
  VertexId vertex_of(std::size_t ring) const { return VertexId(first_ + rings_[ring].offset); }

  /// The ring of the part with this outline that a vertex of the other body is just inside of; `outline` itself if it
  /// is in no hole. Nothing if it is outside.
  std::optional<std::size_t> around(VertexId v, std::size_t outline) const {
    if (!encloses(outline, v)) return std::nullopt;
    for (std::size_t i = outline + 1; i < rings_.size() && rings_[i].ring > 0; ++i) {
      if (encloses(i, v)) return i;
    }
    return outline;
  }

 private:
  /// A ray along the sweep's "up" crosses a ring an odd number of times from inside.
  bool encloses(std::size_t ring, VertexId v) const {
    checkpoint();
    const RingMap& map = rings_[ring];
    bool inside = false;
    VertexId a(first_ + map.offset + map.size - 1);
    bool a_before = place_.before(a, v);
    for (std::uint32_t k = 0; k < map.size; ++k) {
      const VertexId b(first_ + map.offset + k);
      const bool b_before = place_.before(b, v);
      if (a_before != b_before && place_.orientation(a_before ? a : b, a_before ? b : a, v) < 0) inside = !inside;
      a = b;
      a_before = b_before;
    }
    return inside;
  }

  const Placement& place_;
  const std::vector<RingMap>& rings_;
  std::uint32_t first_;
};

}  // namespace

RingMeetings ring_meetings(const BodyPair& bodies, const Placement& placement) {
  const PlacedRings p(bodies, placement, Role::p), q(bodies, placement, Role::q);
  const std::vector<std::size_t> parts_p = p.outlines(), parts_q = q.outlines();
  RingMeetings result;
  for (const std::size_t i : parts_p) {
    for (const std::size_t j : parts_q) {
      const VertexId of_p = p.vertex_of(i), of_q = q.vertex_of(j);
      RingMeeting meeting{i, j};
      if (const auto ring = p.around(of_q, i)) {
        if (*ring == i) return {{}, of_q};
        meeting.p = *ring;
      } else if (const auto other = q.around(of_p, j)) {
        if (*other == j) return {{}, of_p};
        meeting.q = *other;
      }
      result.pairs.push_back(meeting);
    }
  }
  return result;
}

}  // namespace taut::internal
