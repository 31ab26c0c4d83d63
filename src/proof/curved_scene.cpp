#include "proof/curved_scene.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/predicates.hpp"
#include "scene/validate_scene.hpp"
#include "taut/error.hpp"
#include "taut/proof.hpp"

namespace taut::internal::proof {
namespace {

bool is_usable(double x) {
  return x == 0 || (std::fabs(x) >= min_coordinate && std::fabs(x) <= max_coordinate);  // no NaN
}

std::string name_of_ring(const Body& body, std::size_t part, std::size_t ring) {
  std::string name = body.name;
  if (body.curves.size() > 1) name += ": part " + std::to_string(part);
  if (ring > 0) name += ": hole " + std::to_string(ring);
  return name;
}

/// A rectangle around the points that bound the pieces.
Polygon rectangle_around(const std::vector<CurvePiece>& pieces) {
  Point lo{INFINITY, INFINITY}, hi{-INFINITY, -INFINITY};
  for (const CurvePiece& piece : pieces) {
    for (int i = 0; i < piece.size; ++i) {
      const Point p = piece.point(i).rounded();
      lo = {std::min(lo.x, p.x), std::min(lo.y, p.y)};
      hi = {std::max(hi.x, p.x), std::max(hi.y, p.y)};
    }
  }
  return {lo, {hi.x, lo.y}, hi, {lo.x, hi.y}};
}

double distance_squared(const Point& a, const Point& b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

/// How far along the chord the point is, from 0 to 1.
double share_along(const NamedChord& chord, const Point& p) {
  const double length = distance_squared(chord.begin, chord.end);
  if (!(length > 0)) return 0;
  const double along =
      (p.x - chord.begin.x) * (chord.end.x - chord.begin.x) + (p.y - chord.begin.y) * (chord.end.y - chord.begin.y);
  return std::clamp(along / length, 0.0, 1.0);
}

Point point_at(const Point& a, const Point& b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

}  // namespace

bool any_curves(const Scene& scene) {
  return std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const Body& body) { return !body.curves.empty(); });
}

Scene with_polygons(const Scene& scene, const PolygonsOfBodies& polygons) {
  Scene flat = scene;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    Body& body = flat.bodies[i];
    if (body.curves.empty()) continue;
    body.curves.clear();
    body.parts = polygons[i];
    for (std::size_t k = 0; k < body.parts.size(); ++k) body.parts[k].z = scene.bodies[i].curves[k].z;
    if (body.parts.size() > 1 || !body.parts[0].holes.empty() || body.parts[0].z) continue;
    body.polygon = std::move(body.parts[0].outline);
    body.parts.clear();
  }
  return flat;
}

CurvedBodies::CurvedBodies(const Scene& scene) {
  for (const Body& body : scene.bodies) {
    bodies_.emplace_back();
    if (body.curves.empty()) continue;
    if (!body.polygon.empty() || !body.parts.empty() || body.prepared)
      throw InputError(body.name, "the body has polygons besides its curves",
                       "write all of its parts as curves: outline_of() makes one of a polygon");
    for (std::size_t k = 0; k < body.curves.size(); ++k) {
      Rings& rings = bodies_.back().emplace_back();
      const auto add = [&](const Outline& outline) {
        const std::string name = name_of_ring(body, k, rings.size());
        rings.push_back({name, pieces_of(outline, name), {}, {}});
        if (rings.back().pieces.empty()) throw InputError(name, "the outline has no segments", "draw a closed curve");
      };
      add(body.curves[k].outline);
      for (const Outline& hole : body.curves[k].holes) add(hole);
    }
  }
  validate(scene);
}

/// Names, motions, parents and time, of rectangles around the bodies.
void CurvedBodies::validate(const Scene& scene) const {
  PolygonsOfBodies boxes(scene.bodies.size());
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    for (const Rings& rings : bodies_[i]) boxes[i].push_back({rectangle_around(rings[0].pieces), {}});
  }
  validate_polygons(with_polygons(scene, boxes));
}

void CurvedBodies::require(const PolygonsOfBodies& polygons, Bodies side) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (polygons[i].size() != bodies_[i].size()) throw ProofError("a body with other parts than in the scene");
    for (std::size_t k = 0; k < bodies_[i].size(); ++k) require_part(bodies_[i][k], polygons[i][k], side);
  }
}

void CurvedBodies::require_part(Rings& rings, const Part& part, Bodies side) const {
  if (part.holes.size() + 1 != rings.size()) throw ProofError(rings[0].name + ": other rings than in the scene");
  for (std::size_t r = 0; r < rings.size(); ++r) {
    Ring& ring = rings[r];
    ring.polygon = r == 0 ? part.outline : part.holes[r - 1];
    for (const Point& p : ring.polygon) {
      if (!is_usable(p.x) || !is_usable(p.y)) throw ProofError(ring.name + ": a vertex that makes no sense");
    }
    // A body without its holes is larger where these are smaller.
    const bool within = (r == 0) == (side == Bodies::around);
    ring.chords = require_side(ring.pieces, ring.polygon, within ? RingSide::within : RingSide::around, ring.name);
  }
}

template <class Feature>
void CurvedBodies::name(Feature& feature, double share) const {
  const auto& body = bodies_[static_cast<std::size_t>(feature.body)];
  if (body.empty()) return;
  const Ring& ring = body[static_cast<std::size_t>(feature.part)][static_cast<std::size_t>(feature.ring)];
  const auto index = static_cast<std::size_t>(feature.index);
  const Point p = point_at(ring.polygon[index], ring.polygon[(index + 1) % ring.polygon.size()], share);
  // A corner is the beginning of its segment rather than the end of the one before.
  std::pair<double, bool> nearest{INFINITY, true};
  for (const NamedChord& chord : ring.chords) {
    const double along = share_along(chord, p);
    const std::pair distance{distance_squared(p, point_at(chord.begin, chord.end, along)), along == 1};
    if (!(distance < nearest)) continue;
    nearest = distance;
    feature.index = chord.segment;
    feature.parameter = chord.from + along * (chord.to - chord.from);
  }
}

void CurvedBodies::name(VertexRef& vertex) const { name(vertex, 0); }
void CurvedBodies::name(EdgeRef& edge) const { name(edge, 0.5); }

}  // namespace taut::internal::proof
