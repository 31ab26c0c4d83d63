#include "scene/body_pair.hpp"

#include <algorithm>
#include <cmath>

#include "motion/across_joint.hpp"
#include "numeric/budget.hpp"
#include "taut/error.hpp"

namespace taut::internal {
namespace {

/// In units of checkpoint().
constexpr std::uint64_t work_of_plan = 55;

}  // namespace

double largest_coordinate(const Body& body) {
  if (body.parts.empty() && body.prepared) return body.prepared->facts().largest;
  double largest = 0;
  const auto include = [&](const Polygon& outline) {
    for (const Point& p : outline) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
  };
  include(body.polygon);
  for (const Part& part : body.parts) include(part.outline);
  return largest;
}

BodyPair pair_of(const SharedRings& first, const MotionChain& first_motions, const SharedRings& second,
                 const MotionChain& second_motions) {
  const bool swap = second->diameter_squared() > first->diameter_squared();
  const MotionChain &p = swap ? second_motions : first_motions, &q = swap ? first_motions : second_motions;
  BodyPair bodies;
  bodies.exponent = first->exponent();
  bodies.rings = {swap ? second : first, swap ? first : second};
  if (auto seen = across_joint(p, q)) {
    bodies.motions = {without_first(seen->p, 0), without_first(seen->q, 0)};
    bodies.common = std::move(seen->frame);
    return bodies;
  }
  const std::size_t common = count_common(p, q);
  bodies.motions = {without_first(p, common), without_first(q, common)};
  bodies.common.assign(p.begin(), p.begin() + static_cast<std::ptrdiff_t>(common));
  return bodies;
}

BodyPair pair_of(const Scene& scene) {
  count_work(work_of_plan);
  int exponent = 0;
  std::frexp(std::max(largest_coordinate(scene.bodies[0]), largest_coordinate(scene.bodies[1])), &exponent);
  std::array<SharedRings, 2> rings;
  std::array<MotionChain, 2> motions;
  for (std::size_t k = 0; k < 2; ++k) {
    rings[k] = std::make_shared<const RingSet>(scene.bodies[k], static_cast<int>(k), -exponent);
    const PieceList own = PieceList::between(scene.bodies[k].motion, scene.start, scene.end, -exponent);
    if (!own.rests()) motions[k].push_back(own);
  }
  return pair_of(rings[0], motions[0], rings[1], motions[1]);
}

MotionSegments segments_of(const BodyPair& pair, double start, double end) {
  return MotionSegments(pair.motions[0], pair.motions[1], start, end);
}

PairGeometry displaced_pair(const BodyPair& bodies, Offset offset) {
  return {bodies.rings[0]->displaced(offset), bodies.rings[1]->displaced(offset)};
}

std::optional<PairGeometry> displaced_pair_if_possible(const BodyPair& bodies, Offset offset) {
  try {
    return displaced_pair(bodies, offset);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace taut::internal
