#include "path/tight_features.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/budget.hpp"
#include "scene/ring_set.hpp"

namespace taut::internal::path {
namespace {

/// So many edges are compared with each other at the most.
constexpr std::size_t most_compared = 1'000'000;

/// A vertex near an edge, and which way that pushes the second body.
struct NearFeatures {
  double distance = INFINITY;
  Vector push;
  bool vertex_of_p = false;
  std::uint32_t pair = 0, vertex = 0, edge = 0;
};

double length(Vector v) { return std::sqrt(dot(v, v)); }

void add_edges(const spacetime::Hierarchy& tree, std::uint32_t node, std::vector<std::uint32_t>& edges) {
  const spacetime::BoxNode& at = tree.node(node);
  if (at.count == 1) return edges.push_back(at.first);
  add_edges(tree, at.left, edges);
  add_edges(tree, at.right, edges);
}

/// Both bodies of a pair where the joints have these values.
class PairAtPlace {
 public:
  PairAtPlace(const JointSpace& space, std::uint32_t pair, const JointValues& values)
      : pair_(space.pairs()[pair]), number_(pair) {
    const PoseModel pose = space.pairs().between(pair_, {values, {}});
    const PairGeometry& geometry = pair_.search.geometry;
    for (std::uint32_t k = 0; k < geometry.size(); ++k) {
      const DisplacedPoint& d = geometry.point(VertexId(k));
      const bool p = k < geometry.np;
      points_[p ? 0 : 1].push_back(p ? Vector{d.x, d.y} : pose.place({d.x, d.y}).value);
      next_[p ? 0 : 1].push_back(geometry.next(VertexId(k)).value - (p ? 0 : geometry.np));
    }
  }

  void add(const Runs& runs, std::vector<NearFeatures>& all) const {
    std::size_t compared = 0;
    for (const auto& [i, k] : runs) {
      std::vector<std::uint32_t> of_p, of_q;
      add_edges(pair_.search.tree_p, i, of_p);
      add_edges(pair_.search.tree_q, k, of_q);
      compared += of_p.size() * of_q.size();
      if (compared > most_compared && !all.empty()) return;
      for (const std::uint32_t p : of_p) {
        checkpoint();
        for (const std::uint32_t q : of_q) {
          for (const std::uint32_t v : {p, next_[0][p]}) all.push_back(near(true, v, q));
          for (const std::uint32_t v : {q, next_[1][q]}) all.push_back(near(false, v, p));
        }
      }
    }
  }

 private:
  NearFeatures near(bool vertex_of_p, std::uint32_t vertex, std::uint32_t edge) const {
    const std::size_t own = vertex_of_p ? 0 : 1, other = 1 - own;
    const Vector at = points_[own][vertex], a = points_[other][edge], b = points_[other][next_[other][edge]];
    const Vector e = b - a;
    const double share = std::clamp(dot(at - a, e) / dot(e, e), 0.0, 1.0);
    const Vector foot = a + Vector{share * e.x, share * e.y};
    // The edge's material is on its left. At an end of it, the gap has a direction of its own.
    const bool at_end = share == 0 || share == 1;
    const Vector push = at_end ? at - foot : -turned(e);
    return {length(at - foot), vertex_of_p ? -push : push, vertex_of_p, number_, vertex, edge};
  }

  const LinkedPair& pair_;
  std::uint32_t number_;
  std::array<std::vector<Vector>, 2> points_;
  std::array<std::vector<std::uint32_t>, 2> next_;
};

}  // namespace

std::vector<TightFeatures> tight_features(const JointSpace& space, const JointValues& values, const OpenPairs& open) {
  std::vector<NearFeatures> all;
  for (const auto& [pair, features] : open) PairAtPlace(space, pair, values).add(features.runs, all);
  std::vector<TightFeatures> found;
  const auto add_nearest = [&](const auto& counts) -> const NearFeatures* {
    const NearFeatures* nearest = nullptr;
    for (const NearFeatures& f : all) {
      if (counts(f) && (!nearest || f.distance < nearest->distance)) nearest = &f;
    }
    if (!nearest) return nullptr;
    const auto& rings = space.pairs()[nearest->pair].search.bodies.rings;
    const RingSet &own = *rings[nearest->vertex_of_p ? 0 : 1], &other = *rings[nearest->vertex_of_p ? 1 : 0];
    found.push_back(
        {own.vertex(nearest->vertex), other.edge(nearest->edge), nearest->distance / space.pairs().scale()});
    return nearest;
  };
  const NearFeatures* first = add_nearest([](const NearFeatures&) { return true; });
  if (first) {
    add_nearest([&](const NearFeatures& f) {
      return f.pair == first->pair && dot(f.push, first->push) < -0.5 * length(f.push) * length(first->push);
    });
  }
  return found;
}

}  // namespace taut::internal::path
