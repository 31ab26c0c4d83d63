// The verifiers of the kinds of logs that verify() distinguishes, besides that of tilings.
#pragma once

#include "proof/header.hpp"
#include "taut/scene.hpp"

namespace taut::internal::proof {

/// What the rest of the log proves. Throws ProofError, or Undecidable. The scene must be valid.
Verified verify_separations(const Scene& scene, ByteReader& in, const Header& header);

/// A log is polygons around the bodies and a log about these, and then, for what they do, polygons within and a log
/// about those: docs/separation-logs.md. Throws ProofError, and InputError if the scene is not valid.
Verified verify_curves(const Scene& scene, std::istream& log);

}  // namespace taut::internal::proof
