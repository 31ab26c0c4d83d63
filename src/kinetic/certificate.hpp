// Corner certificates.
#pragma once

#include "certificate/root.hpp"
#include "geometry/ids.hpp"

namespace taut::internal {

/// A certificate for one corner u -> v -> w of a face. It holds as long as the corner keeps its orientation: +1 convex,
/// -1 reflex. It fails at the root.
struct Certificate : Root {
  HalfedgeId corner;  ///< the half-edge u -> v of the face
  VertexId u, v, w;
};

}  // namespace taut::internal
