#include "path/tight_features.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/budget.hpp"
#include "scene/ring_set.hpp"

namespace taut::internal::path {
namespace {

using spacetime::BoxNode;

/// A vertex near an edge, and which way that pushes the second body.
struct NearFeatures {
  double distance = INFINITY;
  Vector push;
  bool vertex_of_p = false;
  std::uint32_t pair = 0, vertex = 0, edge = 0;
};

double length(Vector v) { return std::sqrt(dot(v, v)); }

/// Both bodies of a pair where the joints have these values.
class PairAtPlace {
 public:
  PairAtPlace(const JointSpace& space, std::uint32_t pair, const JointValues& values)
      : pair_(space.pairs()[pair]), number_(pair), pose_(space.pairs().between(pair_, {values, {}})) {}

  /// Replaces `nearest` by what is nearer among the runs, and counts. Branch and bound by the discs around runs.
  template <class Counts>
  void find_nearest(const Runs& runs, const Counts& counts, NearFeatures& nearest) const {
    Runs todo(runs.rbegin(), runs.rend());
    while (!todo.empty()) {
      checkpoint();
      const auto [i, k] = todo.back();
      todo.pop_back();
      const BoxNode &p = pair_.search.tree_p.node(i), &q = pair_.search.tree_q.node(k);
      const double apart = length(pose_.place(q.box.centre).value - p.box.centre) - p.box.radius - q.box.radius;
      if (apart >= nearest.distance) continue;
      if (p.count == 1 && q.count == 1) {
        for (const NearFeatures& f : compared(p.first, q.first)) {
          if (f.distance < nearest.distance && counts(f)) nearest = f;
        }
      } else if (divides_first(p, q)) {
        todo.emplace_back(p.right, k);
        todo.emplace_back(p.left, k);
      } else {
        todo.emplace_back(i, q.right);
        todo.emplace_back(i, q.left);
      }
    }
  }

 private:
  /// Each end of one edge with the other edge.
  std::array<NearFeatures, 4> compared(std::uint32_t p, std::uint32_t q) const {
    return {near(true, p, q), near(true, next(true, p), q), near(false, q, p), near(false, next(false, q), p)};
  }
  NearFeatures near(bool vertex_of_p, std::uint32_t vertex, std::uint32_t edge) const {
    const Vector at = place(vertex_of_p, vertex), a = place(!vertex_of_p, edge),
                 b = place(!vertex_of_p, next(!vertex_of_p, edge));
    const Vector e = b - a;
    const double share = std::clamp(dot(at - a, e) / dot(e, e), 0.0, 1.0);
    const Vector foot = a + Vector{share * e.x, share * e.y};
    // The edge's material is on its left. A gap at an end of it has a direction of its own.
    const bool at_end = (share == 0 || share == 1) && length(at - foot) > 0;
    const Vector push = at_end ? at - foot : -turned(e);
    return {length(at - foot), vertex_of_p ? -push : push, vertex_of_p, number_, vertex, edge};
  }

  /// Vertices of P come before those of Q.
  VertexId id(bool of_p, std::uint32_t vertex) const {
    return VertexId(of_p ? vertex : vertex + pair_.search.geometry.np);
  }
  std::uint32_t next(bool of_p, std::uint32_t vertex) const {
    return pair_.search.geometry.next(id(of_p, vertex)).value - (of_p ? 0 : pair_.search.geometry.np);
  }
  /// As P sees it.
  Vector place(bool of_p, std::uint32_t vertex) const {
    const DisplacedPoint& d = pair_.search.geometry.point(id(of_p, vertex));
    return of_p ? Vector{d.x, d.y} : pose_.place({d.x, d.y}).value;
  }

  const LinkedPair& pair_;
  std::uint32_t number_;
  PoseModel pose_;
};

TightFeatures named(const JointSpace& space, const NearFeatures& f) {
  const auto& rings = space.pairs()[f.pair].search.bodies.rings;
  const RingSet &own = *rings[f.vertex_of_p ? 0 : 1], &other = *rings[f.vertex_of_p ? 1 : 0];
  return {own.vertex(f.vertex), other.edge(f.edge), f.distance / space.pairs().scale()};
}

}  // namespace

std::vector<TightFeatures> tight_features(const JointSpace& space, const JointValues& values, const OpenPairs& open) {
  NearFeatures first, second;
  for (const auto& [pair, features] : open)
    PairAtPlace(space, pair, values)
        .find_nearest(
            features.runs, [](const NearFeatures&) { return true; }, first);
  for (const auto& [pair, features] : open) {
    if (pair != first.pair) continue;
    const auto opposes = [&](const NearFeatures& f) {
      return dot(f.push, first.push) < -0.5 * length(f.push) * length(first.push);
    };
    PairAtPlace(space, pair, values).find_nearest(features.runs, opposes, second);
  }
  std::vector<TightFeatures> found;
  for (const NearFeatures& f : {first, second}) {
    if (f.distance < INFINITY) found.push_back(named(space, f));
  }
  return found;
}

}  // namespace taut::internal::path
