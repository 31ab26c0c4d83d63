// From what an engine finds back to the user's terms: input indices, input units, world coordinates.
#pragma once

#include "pair/pair_plan.hpp"
#include "taut/check.hpp"

namespace taut {

/// Internal vertices and edges of one pair in the terms of the scene. The plan and the geometry must outlive it.
class Witness {
 public:
  Witness(const PairPlan& plan, const PairGeometry& geometry) : plan_(plan), geometry_(geometry) {}

  VertexRef vertex(VertexId v) const;
  /// The edge from v to the next vertex, counterclockwise.
  EdgeRef edge(VertexId v) const;
  /// World position at a parameter of a leg, in the input's units (rounded).
  Point world(VertexId v, const Leg& leg, double parameter) const;
  /// The contact of a vertex with the edge that starts at `edge`, at [lo, hi] of the leg's parameter.
  Contact contact(VertexId vertex, VertexId edge, const Leg& leg, double lo, double hi) const;
  /// The contact at time t of two shapes that touch there, given two edges of the outward shapes that cross: the end of
  /// one of them that is nearest to the other is the vertex.
  Contact contact_of_crossing(VertexId e, VertexId f, const Leg& leg, double t) const;

 private:
  Point outward_normal(VertexId edge, const Leg& leg, double parameter) const;

  const PairPlan& plan_;
  const PairGeometry& geometry_;
};

}  // namespace taut
