#include "solver/pair_instance.hpp"

#include <algorithm>
#include <utility>

namespace taut::internal {

using spacetime::Hierarchy;

const Hierarchy& tree_of(const RingSet& rings, Offset offset) {
  const SharedPolygon& displaced = rings.displaced(offset);
  return rings.kept<Hierarchy>(offset, [&] { return std::make_shared<const Hierarchy>(*displaced); });
}

PairInstance::PairInstance(BodyPair pair, SharedSegments all_segments, Offset offset)
    : a(std::min(pair.body(Role::p), pair.body(Role::q))),
      b(std::max(pair.body(Role::p), pair.body(Role::q))),
      bodies(std::move(pair)),
      geometry(displaced_pair(bodies, offset)),
      shared_segments(std::move(all_segments)),
      tree_p(tree_of(*bodies.rings[0], offset)),
      tree_q(tree_of(*bodies.rings[1], offset)) {}

PairInstance::PairInstance(const Instance& world, int first, int second, Offset offset)
    : a(std::min(first, second)),
      b(std::max(first, second)),
      bodies(world.pair(first, second)),
      geometry(displaced_pair(bodies, offset)),
      shared_segments(std::make_shared<const MotionSegments>(world.segments(bodies))),
      tree_p(tree_of(*bodies.rings[0], offset)),
      tree_q(tree_of(*bodies.rings[1], offset)) {}

}  // namespace taut::internal
