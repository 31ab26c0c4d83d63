// Checks a log of separations: of any scene.
#pragma once

#include "proof/header.hpp"

namespace taut::internal::proof {

/// What the rest of the log proves. Throws ProofError, or Undecidable. The scene must be valid.
Verified verify_separations(const Scene& scene, ByteReader& in, const Header& header);

}  // namespace taut::internal::proof
