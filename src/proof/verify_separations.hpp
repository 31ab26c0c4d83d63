// The verifiers of the kinds of logs that verify() distinguishes, besides that of tilings.
#pragma once

#include "certificate/feature_map.hpp"
#include "proof/format.hpp"
#include "proof/separation.hpp"
#include "taut/scene.hpp"

namespace taut::internal::proof {

/// What the rest of the log proves. Throws ProofError, or Undecidable. The scene must be valid.
Verified verify_separations(const Scene& scene, ByteReader& in, const Header& header);

/// A log is polygons around the bodies and a log about these, and then, for what they do, polygons within and a log
/// about those: docs/separation-logs.md. Throws ProofError, and InputError if the scene is not valid.
Verified verify_curves(const Scene& scene, std::istream& log);

// The contact that a log states, as the verifiers report it.

struct ProvedContact {
  Contact contact;
  double free_until;  ///< nothing happens before that time
};

/// A vertex meets an edge at an instant of that segment, enclosed in doubles as Lifetimes::tightened() does. The scene
/// begins at `start`. `free_until`: up to when all else is shown to be apart, infinite if it is up to that instant.
ProvedContact proved_contact(const FeatureMap& features, const Incidence& hit, const MotionSegment& segment,
                             const Instant& tight, double start, double free_until);

}  // namespace taut::internal::proof
