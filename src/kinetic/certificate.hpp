// Corner certificates.
#pragma once

#include "geometry/ids.hpp"
#include "sign/root.hpp"

namespace taut::internal {

/// One corner u -> v -> w of a face, as long as it keeps its orientation: +1 convex, -1 reflex. It fails at the root.
struct Certificate : Root {
  HalfedgeId corner;  ///< the half-edge u -> v of the face
  VertexId u, v, w;
};

}  // namespace taut::internal
