#include "proof/proved_contact.hpp"

#include <algorithm>

namespace taut::internal::proof {

ProvedContact proved_contact(const FeatureMap& features, const Incidence& hit, const MotionSegment& segment,
                             const Instant& tight, double start, double free_until) {
  ProvedContact proved{features.contact({hit.vertex, hit.edge, tight.lo, std::min(tight.hi, segment.end)}, segment),
                       free_until};
  TimeInterval& time = proved.contact.time;
  time.lo = std::max(time.lo, start);
  // A jump has its instant. Elsewhere other pairs may meet before, as far as is known, once nothing is said of them.
  if (!segment.bridge) time.lo = std::min(time.lo, free_until);
  proved.free_until = std::min(time.lo, free_until);
  return proved;
}

}  // namespace taut::internal::proof
