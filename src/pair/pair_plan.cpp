#include "pair/pair_plan.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/budget.hpp"
#include "motion/pieces.hpp"
#include "taut/error.hpp"

namespace taut::internal {
namespace {

/// In units of checkpoint().
constexpr std::uint64_t work_of_plan = 55;

BodyMap map_body(const ShapeFacts& facts, BodyId body) { return {body, facts.size, facts.first, facts.reversed}; }

ShapeRole shape_role(const PairPlan& plan, Role role, bool inwards) {
  return ShapeRole::of(role, inwards, plan.exponent);
}

std::array<SharedPolygon, 2> displaced_bodies(const PairPlan& plan, bool inwards) {
  if (plan.rings[0]) return {plan.rings[0]->displaced(inwards), plan.rings[1]->displaced(inwards)};
  const auto displaced = [&](Role role) {
    const ShapeInRole* shape = shape_in_role(plan, role, inwards);
    if (shape) return shape->displaced;
    return displaced_for(*plan.polygons[index_of(role)], shape_role(plan, role, inwards));
  };
  return {displaced(Role::p), displaced(Role::q)};
}

std::string edge_text(const BodyMap& map, int edge) {
  return std::to_string(edge) + "-" + std::to_string((static_cast<std::uint32_t>(edge) + 1) % map.size);
}

/// Explains to the user why a body cannot be displaced.
[[noreturn]] void refuse(const std::string& name, const BodyMap& map, const DisplacementFault& fault) {
  const char* const hint = "features that small can only be rounding noise: remove them";
  if (fault.kind == DisplacementFault::Kind::sharp_corner) {
    const int v = map.vertex(fault.first);
    throw InputError(name,
                     "the corner at vertex " + std::to_string(v) +
                         " is sharper than the displacement that taut computes with allows, about 2^-42 radians",
                     hint, {{{map.body, v}}, {}});
  }
  const int e = map.edge(fault.first), f = map.edge(fault.second);
  throw InputError(name,
                   "edges " + edge_text(map, e) + " and " + edge_text(map, f) +
                       " come closer than the displacement that taut computes with, 2^-199 of the largest coordinate",
                   hint, {{}, {{map.body, e}, {map.body, f}}});
}

double diameter_squared_of(const Body& body) {
  return body.prepared ? body.prepared->diameter_squared() : diameter_squared(body.polygon);
}

}  // namespace

ShapeFacts facts_of(const Body& body) { return body.prepared ? body.prepared->facts() : facts_of(body.polygon); }

PairPlan plan_pair(const Scene& scene, const std::array<ShapeFacts, 2>& facts) {
  count_work(work_of_plan);
  PairPlan plan;
  int exponent = 0;
  std::frexp(std::max(facts[0].largest, facts[1].largest), &exponent);
  plan.exponent = -exponent;
  plan.extent = std::max(diagonal(facts[0].bounds), diagonal(facts[1].bounds));
  // The polygon with the larger diameter plays P (section 2.1 of the paper).
  const int p = diameter_squared_of(scene.bodies[1]) > diameter_squared_of(scene.bodies[0]) ? 1 : 0;
  for (const Role role : {Role::p, Role::q}) {
    const int index = role == Role::p ? p : 1 - p;
    const Body& body = scene.bodies[static_cast<std::size_t>(index)];
    const ShapeFacts& known = facts[static_cast<std::size_t>(index)];
    const std::size_t k = index_of(role);
    plan.maps[k] = map_body(known, index);
    plan.names[k] = body.name;
    plan.bounds[k] = known.bounds;
    plan.prepared[k] = body.prepared;
    plan.polygons[k] = body.prepared
                           ? body.prepared->in_role(shape_role(plan, role, true)).polygon
                           : std::make_shared<const std::vector<Point>>(normalised(body.polygon, known, plan.exponent));
    plan.pieces[k] = PieceList::between(body.motion, scene.start, scene.end, plan.exponent);
  }
  return plan;
}

const ShapeInRole* shape_in_role(const PairPlan& plan, Role role, bool inwards) {
  const auto& shape = plan.prepared[index_of(role)];
  return shape ? &shape->in_role(shape_role(plan, role, inwards)) : nullptr;
}

PairGeometry displaced_pair(const PairPlan& plan, bool inwards) {
  const std::array<SharedPolygon, 2> bodies = displaced_bodies(plan, inwards);
  for (std::size_t k = 0; k < 2; ++k) {
    if (bodies[k]->fault) refuse(plan.names[k], plan.maps[k], *bodies[k]->fault);
  }
  return {bodies[0], bodies[1]};
}

std::optional<PairGeometry> displaced_pair_if_possible(const PairPlan& plan, bool inwards) {
  const std::array<SharedPolygon, 2> bodies = displaced_bodies(plan, inwards);
  if (bodies[0]->fault || bodies[1]->fault) return std::nullopt;
  return PairGeometry(bodies[0], bodies[1]);
}

}  // namespace taut::internal
