#include "taut/separator.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "motion/pieces.hpp"
#include "motion/pose.hpp"
#include "numeric/errors.hpp"
#include "scene/body_pair.hpp"
#include "scene/placement.hpp"
#include "scene/validate_scene.hpp"
#include "taut/error.hpp"
#include "taut/shape.hpp"
#include "taut/simulation.hpp"
#include "taut/validate.hpp"
#include "tiling/link_paths.hpp"
#include "tiling/root_faces.hpp"
#include "tiling/separator_curve.hpp"
#include "tiling/sleeve.hpp"

namespace taut {
using namespace internal;
namespace {

/// The curve is drawn around polygons that are larger by so much (of the scaled coordinates): wide berths first, which
/// look better.
constexpr double tried_margins[] = {0x1p-7, 0x1p-9, 0x1p-12, 0x1p-16, 0x1p-22, 0x1p-30, 0x1p-38, 0x1p-44};

VertexRef input_vertex(const Arena& arena, VertexId v) {
  const int side = arena.owner(v);
  return arena.bodies.rings[static_cast<std::size_t>(side)]->vertex(side == 0 ? v.value : v.value - arena.geometry.np);
}

int mixed_edges(const Arena& arena, const std::vector<VertexId>& cycle) {
  int count = 0;
  for (std::size_t i = 0; i < cycle.size(); ++i)
    count += arena.owner(cycle[i]) != arena.owner(cycle[(i + 1) % cycle.size()]);
  return count;
}

/// The path that the two hulls share: RCH(P)'s vertices from where it meets RCH(Q) to where it leaves it.
std::vector<VertexId> contact_path(const Arena& arena) {
  const std::vector<VertexId>&p = arena.hulls[0], &q = arena.hulls[1];
  std::map<std::uint32_t, std::uint32_t> before_in_q;  // the vertex before, around Q
  for (std::size_t j = 0; j < q.size(); ++j) before_in_q[q[(j + 1) % q.size()].value] = q[j].value;
  const auto on_q = [&](VertexId v) { return before_in_q.count(v.value) > 0; };
  const auto shared = [&](std::size_t i) {
    const VertexId u = p[i % p.size()], v = p[(i + 1) % p.size()];
    return on_q(u) && on_q(v) && before_in_q[u.value] == v.value;
  };
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!on_q(p[i]) || shared(i + p.size() - 1)) continue;
    std::vector<VertexId> path{p[i]};
    for (std::size_t k = i; shared(k) && path.size() <= p.size(); ++k) path.push_back(p[(k + 1) % p.size()]);
    return path;
  }
  return {};
}

MovingSeparator moving_separator(const Arena& arena) {
  MovingSeparator moving;
  for (std::size_t side = 0; side < 2; ++side) {
    const auto body = static_cast<std::size_t>(arena.bodies.rings[side]->body());
    for (const VertexId v : arena.hulls[side]) moving.hulls[body].push_back(input_vertex(arena, v));
    moving.bichromatic_edges[body] = mixed_edges(arena, arena.hulls[side]);
  }
  const std::vector<VertexId> path = contact_path(arena);
  for (std::size_t i = 0; i < path.size(); ++i) {
    moving.contact.push_back(input_vertex(arena, path[i]));
    if (i > 0) moving.bichromatic_contact_edges += arena.owner(path[i - 1]) != arena.owner(path[i]);
  }
  return moving;
}

/// The scaled polygon that plays this role.
const Polygon& polygon_of(const BodyPair& bodies, Role role) { return bodies.rings[index_of(role)]->points(0); }

std::vector<Point> both(const BodyPair& bodies) {
  std::vector<Point> all = polygon_of(bodies, Role::p);
  const Polygon& q = polygon_of(bodies, Role::q);
  all.insert(all.end(), q.begin(), q.end());
  return all;
}

Polygon grown(const Polygon& polygon, double margin) {
  Polygon out;
  for (const DisplacedPoint& v : displace(polygon, Offset::outward, margin, 1).points)
    out.push_back({v.x + v.dx, v.y + v.dy});
  return out;
}

/// A curve around polygons that are a little larger, if they are still apart, in this plan's coordinates.
std::optional<Curve> curve_at_distance(const BodyPair& bodies, double margin) {
  const std::optional<Arena> wide =
      make_arena(grown(polygon_of(bodies, Role::p), margin), grown(polygon_of(bodies, Role::q), margin));
  if (!wide) return std::nullopt;
  Curve curve = curve_of(link_bound(*wide).path, both(wide->bodies));
  for (Point& v : curve.vertices)
    v = {std::ldexp(v.x, -wide->bodies.exponent), std::ldexp(v.y, -wide->bodies.exponent)};
  return curve;
}

/// The last resort: a relative convex hull itself.
Curve hull_curve(const Arena& arena, std::size_t side) {
  Curve curve;
  curve.closed = true;
  for (const VertexId v : arena.hulls[side]) curve.vertices.push_back(arena.at(v));
  return curve;
}

MinimumLinkSeparator minimum_link_separator(const Arena& arena) {
  const BodyPair& bodies = arena.bodies;
  MinimumLinkSeparator result;
  const LinkBound bound = link_bound(arena);
  result.lower = bound.lower;
  std::optional<Curve> best;
  const auto offer = [&](Curve curve) {
    if (best && best->edges() <= curve.edges()) return;
    if (separates(curve, polygon_of(bodies, Role::p), polygon_of(bodies, Role::q))) best = std::move(curve);
  };
  for (const double margin : tried_margins) {
    if (std::optional<Curve> curve = curve_at_distance(bodies, margin)) offer(std::move(*curve));
    if (best && static_cast<int>(best->edges()) <= result.lower) break;
  }
  // Where there is no room at all, rounding may yet leave the curve right.
  if (!best || static_cast<int>(best->edges()) > result.lower) offer(curve_of(bound.path, both(bodies)));
  for (std::size_t side = 0; side < 2 && !best; ++side) offer(hull_curve(arena, side));
  if (!best) throw StructureError("no separator passes the check");
  result.upper = static_cast<int>(best->edges());
  result.closed = best->closed;
  for (const Point& v : best->vertices)
    result.vertices.push_back({std::ldexp(v.x, -bodies.exponent), std::ldexp(v.y, -bodies.exponent)});
  return result;
}

Separator separator_at_rest(const Body& first, const Body& second) {
  Scene scene;
  scene.bodies = {first, second};
  validate(scene);
  Separator result;
  try {
    const std::optional<Arena> arena = make_arena(first.polygon, second.polygon);
    if (!arena) {
      result.overlap = true;
      return result;
    }
    result.moving = moving_separator(*arena);
    result.minimum_link = minimum_link_separator(*arena);
    return result;
  } catch (const Undecidable& limit) {
    throw UndecidedError(not_decided(limit));
  }
}

}  // namespace

Separator separator(const Polygon& p, const Polygon& q) {
  return separator_at_rest({"the first polygon", p, {}}, {"the second polygon", q, {}});
}

std::array<Polygon, 2> placed(const Scene& scene, double t) {
  std::array<Polygon, 2> out;
  for (std::size_t k = 0; k < 2; ++k) {
    const Body& body = scene.bodies[k];
    if (body.motion.pieces.empty()) {
      out[k] = polygon_of(body);
      continue;
    }
    const std::vector<MotionPiece> pieces = pieces_between(body.motion, scene.start, scene.end);
    const Pose<double> at = sharp_pose(piece_at(pieces, t), t);
    const double c = at.xx.v.mid, s = at.xy.v.mid;
    for (const Point& v : polygon_of(body))
      out[k].push_back({at.ox.v.mid + (c * v.x - s * v.y), at.oy.v.mid + (s * v.x + c * v.y)});
  }
  return out;
}

namespace {

/// Divides the coordinates by a power of two, so that the largest is below 1, and returns its exponent. Where a motion
/// puts a vertex, a coordinate may be far smaller or larger than those of valid polygons. The small ones become 0:
/// poses are rounded by far more than that.
int scale_to_one(std::array<Polygon, 2>& polygons) {
  double largest = 0;
  for (const Polygon& polygon : polygons) {
    for (const Point& v : polygon) largest = std::max({largest, std::fabs(v.x), std::fabs(v.y)});
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  const auto scaled = [&](double x) {
    const double y = std::ldexp(x, -exponent);
    return std::fabs(y) < 0x1p-390 ? 0 : y;
  };
  for (Polygon& polygon : polygons) {
    for (Point& v : polygon) v = {scaled(v.x), scaled(v.y)};
  }
  return exponent;
}

}  // namespace

Separator separator(const Scene& scene, double t) {
  validate_polygons(scene);
  require_ring_pair(scene, "a separator");
  if (!(t >= scene.start && t <= scene.end)) {
    throw InputError("", "the instant " + std::to_string(t) + " is outside the scene's time", "choose one within");
  }
  std::array<Polygon, 2> polygons = placed(scene, t);
  const int exponent = scale_to_one(polygons);
  Separator found = separator_at_rest({scene.bodies[0].name, polygons[0], {}}, {scene.bodies[1].name, polygons[1], {}});
  for (Point& v : found.minimum_link.vertices) v = {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent)};
  return found;
}

}  // namespace taut
