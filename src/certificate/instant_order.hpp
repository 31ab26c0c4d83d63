// The order of several contacts, of any pairs of bodies.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "certificate/contact_bracket.hpp"

namespace taut::internal {

/// A contact found by an engine for bodies displaced as the geometry is.
struct ContactInstant {
  std::shared_ptr<const MotionSegment> segment;
  const PairGeometry* geometry;
  FoundContact contact;
};

/// The order in world time: -1 if a is certainly before b, 1 if it is after, 0 if even the highest precision does not
/// decide. The segments may be those of different pairs. On one bridge, its parameter decides; on different bridges at
/// one joint, nothing does.
int order_of(const ContactInstant& a, const ContactInstant& b);

/// One of many contacts of bodies as given. Doubles enclose it; if its certificate function is known, its root gives a
/// more precise enclosure.
struct ContactCandidate {
  TimeInterval time;
  std::optional<ContactInstant> instant;
};

/// The contacts that are not certain to come after another one. Where doubles leave several, each is enclosed at high
/// precision, with room for its shift due to the displacement. The remaining ones differ by less.
std::vector<std::size_t> possibly_first(const std::vector<ContactCandidate>& contacts);

}  // namespace taut::internal
