// Which of two contacts comes first, of whatever pairs of bodies?
#pragma once

#include "sign/contact_bracket.hpp"

namespace taut {

/// A contact that an engine found, of bodies displaced as the geometry is.
struct ContactInstant {
  const Leg& leg;
  const PairGeometry& geometry;
  FoundContact contact;
};

/// In the world's time: -1 if a is certainly before b, 1 if it is after, 0 if even the highest precision does not tell.
/// `room` is what the instants may be off by, together. Legs may be those of different pairs; on the same bridge its
/// parameter decides, on different ones at one joint nothing does.
int order_of(const ContactInstant& a, const ContactInstant& b, double room = 0);

/// The order of two contacts of the bodies as they were given: 0 as well where their difference is below what the
/// displacement adds.
int order_of_given(const ContactInstant& a, const ContactInstant& b);

}  // namespace taut
