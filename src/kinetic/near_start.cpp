#include "kinetic/near_start.hpp"

#include <algorithm>

#include "base/budget.hpp"
#include "base/errors.hpp"

namespace taut::internal {
namespace {

/// Between two rotations of a body, straight displacements pass through copies of it that are smaller by a few percent
/// at most.
constexpr double least_cosine = 0.95;

/// On a bridge, the frame is computed from four poses at each evaluation. An event costs this much more than is
/// counted.
constexpr std::uint64_t work_of_bridged_event = 100;
/// For two squares, both approaches take microseconds.
constexpr std::uint64_t least_limit = 256;

bool is_small_turn(const MotionSegment& from, double since, const MotionSegment& to, double until) {
  for (const bool of_p : {true, false}) {
    const Pose<double> a = from.pose_of_body(of_p, since), b = to.pose_of_body(of_p, until);
    if (!(a.xx.v.mid * b.xx.v.mid + a.xy.v.mid * b.xy.v.mid > least_cosine)) return false;
  }
  return true;
}

}  // namespace

std::unique_ptr<Engine> NearStart::engine(const PairGeometry& geometry, const MotionSegments& segments) {
  if (!last_ || last_->geometry.p() != geometry.p() || last_->geometry.q() != geometry.q()) return nullptr;
  const MotionSegment& from = *last_->segment;
  const MotionSegment& to = segments.front();
  if (from.composed || to.composed || !is_small_turn(from, last_->time, to, to.start)) return nullptr;
  if (skip_ > 0) {
    --skip_;
    return nullptr;
  }
  std::unique_ptr<Engine> engine = moved(geometry, to);
  if (!engine) {
    skip_ = (1 << std::min(failures_++, 6)) - 1;
    return nullptr;
  }
  failures_ = 0;
  engine->begin_question(segments);
  return engine;
}

/// Moves the engine of the last placement to the new one, which is the start of the segment.
std::unique_ptr<Engine> NearStart::moved(const PairGeometry& geometry, const MotionSegment& to) const {
  const MotionSegment& from = *last_->segment;
  const bool far = from.far() || to.far();
  MotionSegments way(MotionSegment::bridging_between(from.p, from.q, last_->time, to.p, to.q, to.start, far));
  const std::uint64_t limit = least_limit + work_of_building_ / 2, begun = work_spent();
  const Budget turn(limit);
  try {
    auto engine =
        std::make_unique<Engine>(geometry, std::move(way), nullptr,
                                 KnownTilings{nullptr, nullptr, &last_->map, last_->segment.get(), last_->time});
    while (engine->step(to.start)) {
      if (work_spent() - begun + work_of_bridged_event * engine->events() > limit) return nullptr;
    }
    return engine->state() == EngineState::finished ? std::move(engine) : nullptr;
  } catch (const Undecidable&) {
    return nullptr;
  } catch (const Interrupted&) {
    if (!turn.exhausted()) throw;
    return nullptr;
  }
}

void NearStart::note(const Engine& engine, const PairPlan& plan, std::optional<std::uint64_t> work_of_building) {
  if (!plan.prepared[0] || !plan.prepared[1] || engine.state() == EngineState::overlap) return;
  if (work_of_building) work_of_building_ = *work_of_building;
  last_.reset();
  last_.emplace(Last{engine.geometry(), plan.prepared, engine.map(), engine.held_segment(), engine.segment().start});
}

}  // namespace taut::internal
