// The part of a log that states how the loops of a mechanism move: docs/separation-logs.md, "Mechanisms".
#pragma once

#include "proof/bytes.hpp"
#include "taut/scene.hpp"

namespace taut::internal::proof {

/// Has the scene a mechanism with loops? Its logs state cells.
bool has_loops(const Scene& scene);

void write_cells(ByteWriter& out, const Scene& scene);

/// The scene, moved as the cells of the log say, each of which is proved. Throws ProofError where one cannot be.
Scene with_stated_cells(const Scene& scene, ByteReader& in);

}  // namespace taut::internal::proof
