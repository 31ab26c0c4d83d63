#include "query/nearest_points.hpp"

#include <utility>

#include "certificate/feature_map.hpp"
#include "spacetime/closest.hpp"

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

}  // namespace taut::internal
