// The tilings of the pairs of a world that are near at an instant, to be drawn.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "certificate/root.hpp"
#include "motion/pieces.hpp"
#include "scene/meeting_boxes.hpp"
#include "scene/validate_scene.hpp"
#include "session/world_simulation.hpp"
#include "solver/kinetic_solver.hpp"
#include "taut/error.hpp"
#include "taut/simulation.hpp"

namespace taut::internal {
namespace {

/// Of the scene's time: so soon do the boxes of near bodies meet, and so long before do bodies that touch stand apart.
constexpr double share_that_is_near = 0x1p-4, share_before_touching = 0x1p-20;

/// The rest of a scene, or a little of it.
Scene from_there(const Scene& scene, double t) {
  Scene rest = scene;
  rest.start = t;
  rest.end = std::min(scene.end, t + share_that_is_near * (scene.end - scene.start));
  return rest;
}

std::vector<std::pair<int, int>> near_pairs(const Instance& instance) {
  std::vector<int> bodies(instance.bodies().size());
  std::iota(bodies.begin(), bodies.end(), 0);
  std::vector<std::pair<int, int>> pairs;
  if (instance.is_single_pair()) {
    if (!instance.excluded(0, 1)) pairs.emplace_back(0, 1);
    return pairs;
  }
  MeetingBoxes(instance, bodies, instance.start(), instance.end()).each([&](int a, int b, bool) {
    pairs.emplace_back(a, b);
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// None where they overlap, or it was not decided.
std::vector<NearTiling> tilings_at_start(const Instance& instance, const std::pair<int, int>& pair, Offset offset) {
  EventBudget budget(UINT64_MAX);
  KineticSolver near(instance, pair.first, pair.second, offset, budget);
  near.ask_start();
  return near.tilings();
}

}  // namespace

}  // namespace taut::internal

namespace taut {
using namespace internal;

std::vector<NearTiling> tilings_of_near_pairs(const Scene& scene, double t, Touch touch) {
  if (!(t >= scene.start && t <= scene.end))
    throw InputError("t", "the instant is outside of the scene's time", "choose one within");
  const Offset offset = offset_for(touch);
  const Instance instance(from_there(scene, t));
  std::vector<NearTiling> all;
  for (const std::pair<int, int>& pair : near_pairs(instance)) {
    std::vector<NearTiling> own = tilings_at_start(instance, pair, offset);
    const double before = t - share_before_touching * (scene.end - scene.start);
    if (own.empty() && before >= scene.start) own = tilings_at_start(Instance(from_there(scene, before)), pair, offset);
    std::move(own.begin(), own.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace taut

namespace taut::internal {

// The pairs of a simulated world: when they have tilings, and what a change of motion does to these.

/// A pair that is near from that time on, at which the two are apart; without one, from the start of the motions on,
/// and whether the two overlap there is asked.
void WorldSimulation::add_pair(const Key& key, std::optional<double> from, double jump) {
  Near& near = pairs_[key];
  near.key = key;
  if (!leave_to_discs(near, from.value_or(now_), jump)) begin_tilings(near, from);
  enqueue(near);
}

/// If discs keep the two bodies apart for a while, that is enough. Nothing must be due before.
bool WorldSimulation::leave_to_discs(Near& near, double from, double jump) {
  const double apart = near_.apart_until(near.key.first, near.key.second, from, jump);
  if (!(apart > from)) return false;
  near.due = apart;
  near.next.reset();
  near.solver.reset();
  near.has_changed = false;
  return true;
}

/// Before the first one of their boxes ends? If discs show that they do not, tilings are not worth their memory, nor
/// the work of keeping them. Requires that nothing is due before.
bool WorldSimulation::may_meet_soon(const Near& near) const {
  const auto [a, b] = near.key;
  return instance_.is_single_pair() || near_.apart_until(a, b, near.due) < near_.until(a, b);
}

/// At that time, or at the start of the motions.
void WorldSimulation::begin_tilings(Near& near, std::optional<double> from) {
  const auto [a, b] = near.key;
  // Made first: a limit may end that.
  auto solver = std::make_unique<KineticSolver>(instance_, a, b, offset_for(touch_), budget_, observer_);
  if (from) {
    solver->start_at(*from);
  } else {
    solver->ask_start();
  }
  near.solver = std::move(solver);
  near.due = from.value_or(instance_.start_of(a, b));
  near.next.reset();
}

/// Into the queue, or to the pairs that have come to an end.
void WorldSimulation::enqueue(Near& near) {
  count_certificates(near);
  if (near.solver && !instance_.is_single_pair()) near.solver->put_aside();
  if (!near.solver || near.solver->open()) {
    queue_.insert(near);
  } else {
    ended_.insert(near.key);
  }
}

void WorldSimulation::end_pair(const Key& key) {
  const auto pair = pairs_.find(key);
  if (pair == pairs_.end()) return;
  certificates_ -= pair->second.certificates;
  queue_.erase(pair->second);
  ended_.erase(key);
  pairs_.erase(pair);
}

void WorldSimulation::count_certificates(Near& near) {
  const RingEngines* const engines = near.solver ? near.solver->engines() : nullptr;
  const std::uint64_t count = engines ? engines->certificates() : 0;
  certificates_ = certificates_ - near.certificates + count;
  near.certificates = count;
  certificates_max_ = std::max(certificates_max_, certificates_);
}

/// How far two bodies may jump at the present, in internal units, so that discs still tell that they do not meet on the
/// way. Several changes at one time count from what the body did before.
double WorldSimulation::jump_of(BodyId body) const {
  const PieceList& own = instance_.bodies()[static_cast<std::size_t>(body)].own;
  if (now_ == start_ || (!own.empty() && own.until(0) == now_)) return never;
  return std::ldexp(2 * joint_tolerance * extent_, instance_.exponent());
}

/// A tiling stays if it corresponds to the present, or before. At the start of the scene no bridge is possible. Pairs
/// that are asked about for the first time, as bodies that have moved alike, may overlap. What else there is to do
/// waits until time goes on: both bodies may change. At the start of the scene, and of a single pair, it is shown at
/// once.
void WorldSimulation::replan_pair(const Key& key, double jump) {
  const auto known = pairs_.find(key);
  if (known == pairs_.end()) return add_pair(key, std::nullopt, never);
  Near& near = known->second;
  queue_.erase(near);
  ended_.erase(key);
  if (leave_to_discs(near, now_, jump)) return enqueue(near);
  near.has_changed = true;
  near.next.reset();
  near.due = now_;
  if (instance_.is_single_pair() || now_ == start_) {
    follow_change(near);
    return enqueue(near);
  }
  queue_.insert(near);
}

void WorldSimulation::follow_change(Near& near) {
  near.has_changed = false;
  if (near.solver && now_ > start_ && near.solver->replan(now_)) return;
  begin_tilings(near, std::nullopt);
}

}  // namespace taut::internal
