// A pair of a world, with the data that the spacetime engine needs.
#pragma once

#include <memory>
#include <vector>

#include "scene/instance.hpp"
#include "spacetime/first_contact.hpp"

namespace taut::internal {

using SharedSegments = std::shared_ptr<const MotionSegments>;

/// Built once, and kept with the body.
const spacetime::Hierarchy& tree_of(const RingSet& rings, Offset offset);

struct PairInstance {
  /// Throws InputError if a body has features that are finer than the displacement.
  PairInstance(BodyPair pair, SharedSegments all_segments, Offset offset);
  PairInstance(const Instance& world, int first, int second, Offset offset);

  spacetime::TreePair trees() const { return {tree_p, tree_q}; }
  const MotionSegments& segments() const { return *shared_segments; }

  int a, b;  ///< a < b: the bodies' numbers, of the world if there is one
  BodyPair bodies;
  PairGeometry geometry;
  SharedSegments shared_segments;
  const spacetime::Hierarchy &tree_p, &tree_q;
};

}  // namespace taut::internal
