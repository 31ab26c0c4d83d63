// The part of a log that states how the loops of a mechanism move: docs/separation-logs.md, "Mechanisms".
#pragma once

#include <memory>

#include "proof/bytes.hpp"
#include "scene/mechanism.hpp"
#include "taut/path.hpp"
#include "taut/scene.hpp"

namespace taut::internal::proof {

/// Has the scene a mechanism with loops? Its logs state cells.
bool has_loops(const Scene& scene);

void write_cells(ByteWriter& out, const AssembledMechanism& mechanism);

/// The functions of the joints as the cells of a log say, each of which is proved. Throws ProofError where one cannot
/// be.
std::shared_ptr<const JointFunctions> read_stated_functions(const AssembledMechanism& mechanism, ByteReader& in);

/// The scene, moved as the cells of the log say, each of which is proved. Throws ProofError where one cannot be.
Scene with_stated_cells(const Scene& scene, ByteReader& in);
/// Likewise, over the range of each joint that drives loops, in order.
PathProblem with_stated_cells(const PathProblem& problem, ByteReader& in);
void write_cells(ByteWriter& out, const PathProblem& problem);

}  // namespace taut::internal::proof
