// The contact that a log states, as the verifiers report it.
#pragma once

#include "certificate/feature_map.hpp"
#include "proof/separation.hpp"

namespace taut::internal::proof {

struct ProvedContact {
  Contact contact;
  double free_until;  ///< nothing happens before that time
};

/// A vertex meets an edge at an instant of that segment, enclosed in doubles as Lifetimes::tightened() does. The scene
/// begins at `start`. `free_until`: up to when all else is shown to be apart, infinite if it is up to that instant.
ProvedContact proved_contact(const FeatureMap& features, const Incidence& hit, const MotionSegment& segment,
                             const Instant& tight, double start, double free_until);

}  // namespace taut::internal::proof
