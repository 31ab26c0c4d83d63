// Which of several contacts comes first, of whatever pairs of bodies?
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "sign/contact_bracket.hpp"

namespace taut::internal {

/// A contact that an engine found, of bodies displaced as the geometry is.
struct ContactInstant {
  std::shared_ptr<const MotionSegment> segment;
  const PairGeometry* geometry;
  FoundContact contact;
};

/// In the world's time: -1 if a is certainly before b, 1 if it is after, 0 if even the highest precision does not tell.
/// Segments may be those of different pairs; on one bridge its parameter decides, on different ones at one joint
/// nothing does.
int order_of(const ContactInstant& a, const ContactInstant& b);

/// One of many contacts of bodies as they were given: enclosed by doubles, and more precisely by what it is the root
/// of, if that is known.
struct ContactCandidate {
  TimeInterval time;
  std::optional<ContactInstant> instant;
};

/// Of which of them is it not certain that another one comes before? Where doubles leave several, each is enclosed at
/// high precision, with room for what the displacement moves it by: what is left then differs by less.
std::vector<std::size_t> possibly_first(const std::vector<ContactCandidate>& contacts);

}  // namespace taut::internal
