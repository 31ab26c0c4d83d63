#include "solver/pair_solver.hpp"

#include <algorithm>
#include <utility>

#include "numeric/budget.hpp"
#include "numeric/errors.hpp"

namespace taut::internal {

SpacetimeSolver::SpacetimeSolver(PairInstance search, Offset offset, double start, double end)
    : search_(std::move(search)), offset_(offset), start_(start), end_(end) {
  result_.a = search_.a;
  result_.b = search_.b;
  result_.free_until = end;
}

void SpacetimeSolver::ask_start() {
  try {
    resolve_start();
  } catch (const Undecidable& limit) {
    result_.free_until = start_;
    result_.outcome = Outcome::undecided;
    result_.reason = not_decided(limit);
  }
}

void SpacetimeSolver::resolve_start() {
  const MotionSegment& segment = search_.segments()[0];
  const auto overlap = spacetime::overlapping(search_.geometry, search_.trees(), segment, start_, &stages_);
  if (!overlap) return;
  const auto overlap_of = [&](const PairGeometry& shapes) {
    return spacetime::overlapping(shapes, segment, start_).has_value();
  };
  const FeatureMap witness(search_.bodies, search_.geometry, offset_);
  take_start(contact_at_start(
                 witness, segment, start_, [&] { return *overlap; }, overlap_of),
             start_, result_);
}

void take_start(const std::optional<StartContact>& touching, double start, PairResult& result) {
  result.free_until = start;
  result.outcome = touching ? Outcome::contact : Outcome::overlap_at_start;
  if (!touching) return;
  result.touching = touching->how;
  result.contact = touching->contact;
}

PairResult contact_of(const PairResult& known, const FeatureMap& witness, const MotionSegment& segment,
                      std::size_t segment_index, const FoundContact& found, double start) {
  PairResult result = known;
  result.outcome = Outcome::contact;
  result.found = found;
  result.segment = segment_index;
  result.contact = witness.contact(found, segment);
  result.contact->time.lo = std::max(result.contact->time.lo, start);
  result.free_until = result.contact->time.lo;
  return result;
}

spacetime::ContactSearch SpacetimeSolver::search(double from, double to) const {
  return {search_.geometry, search_.trees(), search_.segments(), spacetime::TimeWindow{from, to, from == start_}};
}

bool SpacetimeSolver::work(double from, double to, std::uint64_t effort) {
  if (decided_before(from)) return true;
  if (!left_ || window_ != from) left_.emplace(search(from, to));
  window_ = from;
  const std::optional<spacetime::SpacetimeResult> result = left_->advance(Slice(effort));
  if (!result) return false;
  left_.reset();
  note(*result);
  return true;
}

void SpacetimeSolver::note(const spacetime::SpacetimeResult& found) {
  stages_ += found.stages;
  if (found.outcome == spacetime::SpacetimeResult::free) return;
  const MotionSegment& segment = search_.segments()[found.segment];
  PairResult result = result_;
  if (found.outcome == spacetime::SpacetimeResult::contact) {
    result = contact_of(result_, FeatureMap(search_.bodies, search_.geometry, offset_), segment, found.segment,
                        found.found, start_);
  } else {
    result.outcome = Outcome::undecided;
    result.reason = found.reason;
    result.free_until = std::clamp(segment.time(found.lo), start_, end_);
  }
  if (open() || result.free_until < result_.free_until) result_ = result;
}

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
