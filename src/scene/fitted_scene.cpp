#include "scene/fitted_scene.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>

#include "geometry/displacement.hpp"
#include "geometry/predicates.hpp"
#include "scene/joined_parts.hpp"
#include "scene/ring_set.hpp"
#include "scene/validate_scene.hpp"
#include "taut/error.hpp"
#include "taut/shape.hpp"

namespace taut::internal {
namespace {

/// The least fit, as a share of the largest coordinate: what rounding adds to a way of 1.05 to 1.95 times the fit must
/// stay well below 0.05 times that.
constexpr double least_share = 0x1p-40;

/// As short as distinguishes it from other doubles, or nearly.
std::string number_of(double x) {
  for (int digits = 6;; ++digits) {
    std::ostringstream s;
    s.precision(digits);
    s << x;
    if (digits == 17 || std::stod(s.str()) == x) return s.str();
  }
}

double largest_in(const Scene& scene) {
  double largest = 0;
  for (const Body& body : scene.bodies) {
    for (const Part& part : parts_of(body)) {
      for (const Point& p : part.outline) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
    }
  }
  return largest;
}

/// What messages call the edges and vertices of a ring.
struct RingNames {
  std::string ring;
  std::size_t count = 0;
  bool reversed = false;               ///< counterclockwise it runs against the order given
  const JoinedRing* joined = nullptr;  ///< of a ring of joined parts, which is counterclockwise

  std::string vertex(std::size_t k) const {
    if (joined) return text(joined->vertices[k]);
    return std::to_string(reversed ? count - 1 - k : k);
  }
  std::string edge(std::size_t k) const {
    if (joined) return text(joined->edges[k]);
    return std::to_string(reversed ? (2 * count - 2 - k) % count : k);
  }

 private:
  template <class Ref>
  static std::string text(const Ref& ref) {
    return std::to_string(ref.index) + (ref.ring > 0 ? " of hole " + std::to_string(ref.ring) : "") + " of part " +
           std::to_string(ref.part);
  }
};

}  // namespace

class Fitter {
 public:
  Fitter(double fit, double way, int exponent) : fit_(fit), way_(std::ldexp(way, -exponent)), exponent_(exponent) {}

  Part part(const Body& body, const Part& given, std::size_t index) {
    Part shrunk{in_given_order(given.outline, Offset::inward, ring_name(body, index, 0)), {}};
    for (std::size_t i = 0; i < given.holes.size(); ++i)
      shrunk.holes.push_back(in_given_order(given.holes[i], Offset::outward, ring_name(body, index, i + 1)));
    return shrunk;
  }
  Part part(const Body& body, const JoinedPart& joined) {
    const auto of = [&](const JoinedRing& r, Offset offset) {
      return ring(r.points, offset, {body.name, r.points.size(), false, &r});
    };
    Part shrunk{of(joined.outline, Offset::inward), {}};
    for (const JoinedRing& hole : joined.holes) shrunk.holes.push_back(of(hole, Offset::outward));
    return shrunk;
  }

 private:
  Polygon in_given_order(const Polygon& given, Offset offset, const std::string& name) {
    const bool reversed = polygon_orientation(given) < 0;
    Polygon turned = given;
    if (reversed) std::reverse(turned.begin(), turned.end());
    Polygon shrunk = ring(turned, offset, {name, given.size(), reversed});
    if (reversed) std::reverse(shrunk.begin(), shrunk.end());
    return shrunk;
  }

  /// Counterclockwise, displaced.
  Polygon ring(const Polygon& given, Offset offset, const RingNames& names) {
    std::vector<Point> points;
    for (const Point& p : given) points.push_back({std::ldexp(p.x, -exponent_), std::ldexp(p.y, -exponent_)});
    Displacement moved = displace(points, offset, way_, ++seed_);
    if (moved.too_sharp) refuse(names, {DisplacementFault::Kind::sharp_corner, *moved.too_sharp, 0});
    Polygon shrunk;
    for (DisplacedPoint& p : moved.points) {
      // To doubles: what it is displaced by is then what it has been displaced by.
      const Point to{p.x + p.dx, p.y + p.dy};
      p.dx = to.x - p.x;
      p.dy = to.y - p.y;
      shrunk.push_back({std::ldexp(to.x, exponent_), std::ldexp(to.y, exponent_)});
    }
    const double farthest = moved.farthest * (1 + 0x1p-20);
    if (!has_room(points, farthest)) {
      const auto fault = find_displacement_fault(moved.points, offset, farthest);
      if (fault) refuse(names, *fault);
    }
    return shrunk;
  }

  [[noreturn]] void refuse(const RingNames& names, const DisplacementFault& fault) const {
    const bool corner = fault.kind == DisplacementFault::Kind::sharp_corner;
    const std::string where =
        corner ? "the corner at vertex " + names.vertex(fault.first) + " is too sharp"
               : "edges " + names.edge(fault.first) + " and " + names.edge(fault.second) + " come too close";
    throw InputError(names.ring, where + " for a fit of " + number_of(fit_),
                     "bodies are shrunk by up to twice the fit on each side: choose a smaller one, or a coarser shape");
  }

  double fit_;  ///< as the user says it
  double way_;  ///< how far edges move, in internal units
  int exponent_;
  std::uint64_t seed_ = 0;
};

namespace {

/// Boundaries of joined parts are off by this share of the fit: shrinking them moves edges by 1.05 to 1.95 times it.
constexpr double share_of_joints = 0x1p-6;

/// With the numbers of the body's parts, of which `parts` were joined.
JoinedPart with_parts_of(const std::vector<std::size_t>& parts, JoinedPart joined) {
  const auto rename = [&](JoinedRing& ring) {
    for (VertexRef& v : ring.vertices) v.part = static_cast<int>(parts[static_cast<std::size_t>(v.part)]);
    for (EdgeRef& e : ring.edges) e.part = static_cast<int>(parts[static_cast<std::size_t>(e.part)]);
  };
  rename(joined.outline);
  for (JoinedRing& hole : joined.holes) rename(hole);
  return joined;
}

}  // namespace

FittedScene::FittedScene(const Scene& scene, double fit, double excess) : scene_(scene) {
  const double largest = largest_in(scene);
  if (!(fit > 0 && std::isfinite(fit))) throw InputError("fit", "it is not a positive number", "leave it out");
  if (fit < least_share * largest)
    throw InputError("fit", "it is less than 2^-40 of the largest coordinate, " + number_of(largest),
                     "doubles round by nearly as much: choose a larger one");
  int exponent = 0;
  std::frexp(largest, &exponent);
  Fitter fitter(fit, fit + excess, exponent);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    Body& small = scene_.bodies[i];
    small.prepared = nullptr;
    small.polygon.clear();
    small.parts = fitted_parts(fitter, scene.bodies[i], static_cast<BodyId>(i), fit);
    if (!scene.bodies[i].parts.empty()) continue;
    small.polygon = small.parts[0].outline;
    small.parts.clear();
  }
  try {
    validate_polygons(scene_);
  } catch (const InputError& error) {
    throw InputError(error.place(), "shrunk by a fit of " + number_of(fit) + ", " + error.problem(),
                     "the walls there are thinner than the fit allows: choose a smaller one");
  }
}

/// The union of the body's parts, layer by layer.
std::vector<Part> FittedScene::fitted_parts(Fitter& fitter, const Body& body, BodyId id, double fit) {
  std::vector<Origin>& origins = origins_.emplace_back();
  const std::vector<Part> parts = parts_of(body);
  std::vector<Part> fitted;
  const auto add = [&](Part part, const Layers& z, Origin origin) {
    fitted.push_back(std::move(part));
    fitted.back().z = z;
    origins.push_back(std::move(origin));
  };
  for (const CrossSection& section : cross_sections_of(body)) {
    Body some = body;
    some.parts.clear();
    for (const std::size_t k : section.parts) some.parts.push_back(parts[k]);
    if (const auto joined = joined_parts(some, id, share_of_joints * fit)) {
      for (const JoinedPart& part : *joined) {
        const JoinedPart named = with_parts_of(section.parts, part);
        add(fitter.part(body, named), section.z, {0, named});
      }
    } else {
      for (const std::size_t k : section.parts)
        add(fitter.part(body, parts[k], k), section.z, {static_cast<int>(k), std::nullopt});
    }
  }
  return fitted;
}

void FittedScene::name_given(Contact& contact) const {
  const auto origin_of = [&](const auto& feature) -> const Origin& {
    return origins_[static_cast<std::size_t>(feature.body)][static_cast<std::size_t>(feature.part)];
  };
  const auto ring_of = [](const auto& feature, const JoinedPart& part) -> const JoinedRing& {
    return feature.ring == 0 ? part.outline : part.holes[static_cast<std::size_t>(feature.ring - 1)];
  };
  const Origin &of_vertex = origin_of(contact.vertex), &of_edge = origin_of(contact.edge);
  contact.vertex.part = of_vertex.joined ? contact.vertex.part : of_vertex.given;
  contact.edge.part = of_edge.joined ? contact.edge.part : of_edge.given;
  if (of_vertex.joined)
    contact.vertex =
        ring_of(contact.vertex, *of_vertex.joined).vertices[static_cast<std::size_t>(contact.vertex.index)];
  if (of_edge.joined)
    contact.edge = ring_of(contact.edge, *of_edge.joined).edges[static_cast<std::size_t>(contact.edge.index)];
}

void FittedScene::name_given(Answer& answer) const {
  if (answer.contact) name_given(*answer.contact);
  if (answer.touching) name_given(*answer.touching);
  for (PairAnswer& pair : answer.also) {
    if (pair.contact) name_given(*pair.contact);
  }
  if (!answer.pairs) return;
  for (PairAnswer& pair : *answer.pairs) {
    if (pair.contact) name_given(*pair.contact);
  }
}

}  // namespace taut::internal
