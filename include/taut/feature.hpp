// How bodies, vertices and edges of a scene are named.
#pragma once

#include <optional>

namespace taut {

/// Of a body bounded by curves, an index is that of a segment of the ring's Outline, and the parameter says where on
/// it: between 0 and 1, as of Bezier curves; of an arc, the share of its angle.
using CurveParameter = std::optional<double>;

/// A body of a scene: its position in Scene::bodies.
using BodyId = int;

/// A vertex of a body, by its index in the input.
struct VertexRef {
  BodyId body = 0;
  int index = 0;  ///< vertex `index` of the ring
  int part = 0;   ///< of the body; a simple body is one part
  int ring = 0;   ///< of the part: 0 is its outline, k its k-th hole
  CurveParameter parameter = {};
  friend bool operator==(const VertexRef&, const VertexRef&) = default;
};

/// An edge of a body, by the index of its first vertex in the input. It has a type of its own, so that an edge is never
/// taken for a vertex.
struct EdgeRef {
  BodyId body = 0;
  int index = 0;  ///< the edge from vertex `index` of the ring to the next one
  int part = 0;   ///< of the body; a simple body is one part
  int ring = 0;   ///< of the part: 0 is its outline, k its k-th hole
  CurveParameter parameter = {};
  friend bool operator==(const EdgeRef&, const EdgeRef&) = default;
};

}  // namespace taut
