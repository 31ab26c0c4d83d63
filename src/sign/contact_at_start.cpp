#include "sign/contact_at_start.hpp"

#include "base/errors.hpp"
#include "pair/crossing_edges.hpp"
#include "pair/placement.hpp"

namespace taut {

StartOverlap overlap_of_outlines(const PairGeometry& geometry, const Leg& leg, double t,
                                 const std::optional<VertexId>& inside) {
  if (const auto crossing = crossing_edges(Placement(geometry, leg, t))) return {true, crossing->p, crossing->q, {}};
  if (!inside) throw StructureError("bodies that touch without a crossing of their outlines");
  return {false, {}, {}, *inside};
}

}  // namespace taut
