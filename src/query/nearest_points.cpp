#include "query/nearest_points.hpp"

#include <utility>

#include "certificate/feature_map.hpp"
#include "spacetime/clearance.hpp"

namespace taut::internal {

NearestPoints nearest_points_of(const PairInstance& search, std::size_t segment, double parameter, VertexId edge_p,
                                VertexId edge_q) {
  const FeatureMap witness(search.bodies, search.geometry, Offset::outward);
  const MotionSegment& on = search.segments()[segment];
  const auto at = [&](VertexId v) { return witness.in_frame(v, on, parameter); };
  const auto found = spacetime::Closest::of(at(edge_p), at(search.geometry.next(edge_p)), at(edge_q),
                                            at(search.geometry.next(edge_q)));
  NearestPoints result;
  result.points = {witness.world(found.on_p, on, parameter), witness.world(found.on_q, on, parameter)};
  result.edges = {witness.edge(edge_p), witness.edge(edge_q)};
  if (result.edges[0].body > result.edges[1].body) {
    std::swap(result.points[0], result.points[1]);
    std::swap(result.edges[0], result.edges[1]);
  }
  result.pair = {result.edges[0].body, result.edges[1].body};
  return result;
}

std::string why_wide(double lo, double hi, double relative) {
  // Both parts of the tolerance add up: what is asked for is missed where the absolute one is the larger one.
  if (!(hi - lo > 2 * relative * hi)) return {};
  return "the bracket is wider than was asked for: distances are found to 1e-12 of the largest coordinate; shapes that "
         "are drawn near their own origin, and moved by their motions, have smaller ones";
}

}  // namespace taut::internal
