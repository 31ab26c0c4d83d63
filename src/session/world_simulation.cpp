#include "session/world_simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "motion/pieces.hpp"
#include "scene/overlap_witness.hpp"
#include "scene/validate_scene.hpp"
#include "solver/earliest.hpp"
#include "taut/error.hpp"

namespace taut::internal {
namespace {

const Scene& validated(const Scene& scene) {
  validate_polygons(scene);
  return scene;
}

/// In the input's units.
AxisBox bounds_of(const Instance& instance, BodyId body) {
  return instance.bodies()[static_cast<std::size_t>(body)].rings->input_bounds();
}

}  // namespace

WorldSimulation::WorldSimulation(const Scene& scene, Touch touch, std::uint64_t max_events, KineticObserver* observer)
    : touch_(touch),
      observer_(observer),
      start_(scene.start),
      instance_(validated(scene)),
      near_(instance_),
      budget_(max_events),
      now_(scene.start),
      processed_(scene.start) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    names_.push_back(scene.bodies[i].name);
    extent_ = std::max(extent_, diagonal(bounds_of(instance_, static_cast<BodyId>(i))));
  }
  // Refuses features that are too fine now, rather than when the body comes near another one.
  for (const InstanceBody& body : instance_.bodies()) body.rings->displaced(offset_for(touch));
  answer_.outcome = Outcome::free;
  note_tested();
  near_.begin(now_);
  ask_starts();
}

void WorldSimulation::forget_distant_pairs() {
  std::erase_if(pairs_, [&](const auto& entry) { return !near_.has(entry.first.first, entry.first.second); });
}

KineticSolver& WorldSimulation::pair(const Key& key) {
  auto known = pairs_.find(key);
  if (known == pairs_.end()) {
    // Made first: a limit may end that.
    auto fresh =
        std::make_unique<KineticSolver>(instance_, key.first, key.second, offset_for(touch_), budget_, observer_);
    known = pairs_.emplace(key, std::move(fresh)).first;
  }
  return *known->second;
}

KineticSolver* WorldSimulation::single_pair() const {
  return instance_.is_single_pair() && !pairs_.empty() ? pairs_.begin()->second.get() : nullptr;
}

const RingEngines* WorldSimulation::engines(int a, int b) const {
  const auto known = pairs_.find(key(a, b));
  return known == pairs_.end() ? nullptr : known->second->engines();
}

/// Do any two bodies overlap, or touch?
void WorldSimulation::ask_starts() {
  if (instance_.is_single_pair()) {
    near_.each([this](int a, int b) { pair({a, b}).ask_start(); });
    return conclude();
  }
  std::vector<int> all(instance_.bodies().size());
  std::iota(all.begin(), all.end(), 0);
  MeetingBoxes(instance_, all, instance_.start(), instance_.start()).each([&](int a, int b, bool) {
    pair({a, b}).ask_start();
  });
  conclude();
}

bool WorldSimulation::may_meet_at_start(int a, int b) const {
  const auto box = [&](int k) {
    return swept_box(instance_.bodies()[static_cast<std::size_t>(k)], instance_.start(), instance_.start());
  };
  return instance_.is_single_pair() || box(a).meets(box(b));
}

/// The same of pairs that are asked about for the first time: of bodies that have moved alike, or, at the start of the
/// scene, of all that have changed. Whoever meets now is near.
void WorldSimulation::ask_starts_of(const std::vector<int>& changed, const std::vector<int>& groups_before) {
  const auto group_before = [&](int k) {
    const auto found = std::lower_bound(changed.begin(), changed.end(), k);
    if (found == changed.end() || *found != k) return instance_.bodies()[static_cast<std::size_t>(k)].group;
    return groups_before[static_cast<std::size_t>(found - changed.begin())];
  };
  bool met = false;
  for (const int body : changed) {
    near_.each_of(body, [&](int other) {
      const bool parted = !instance_.tests_groups() && group_before(body) == group_before(other);
      if (!parted && now_ > instance_.start()) return;
      if (pairs_.count(key(body, other)) > 0 || !may_meet_at_start(body, other)) return;
      KineticSolver& asked = pair(key(body, other));
      asked.ask_start();
      met = met || !asked.open();
    });
  }
  if (met) conclude();
}

void WorldSimulation::advance(double t) {
  while (!over() && processed_ < t) advance_in_window(t);
}

/// To t, or to the end of the current window, and then into the next one. After a change of motion, the window may end
/// at the present.
void WorldSimulation::advance_in_window(double t) {
  const double to = std::min(t, near_.until());
  advance_pairs(to);
  if (over()) return;
  processed_ = std::max(processed_, to);
  now_ = std::max(now_, to);
  if (to < near_.until() || near_.last()) return;
  near_.next();
  forget_distant_pairs();
}

void WorldSimulation::advance_pairs(double to) {
  double stop = to;
  near_.each([&](int a, int b) {
    KineticSolver& near = pair({a, b});
    near.work(near.engines() ? near.at() : near_.from(), stop, std::numeric_limits<std::uint64_t>::max());
    if (near.result().contact) stop = std::min(stop, near.result().contact->time.hi);
  });
  certificates_max_ = std::max(certificates_max_, certificates());
  conclude();
}

/// Encloses the next event of a near pair up to t, in next_; false if no near pair has one.
bool WorldSimulation::first_to_fail(double t) {
  bool found = false;
  next_ = {t, t};
  near_.each([&](int a, int b) {
    KineticSolver& near = pair({a, b});
    if (!near.engines()) near.work(near_.from(), now_, std::numeric_limits<std::uint64_t>::max());
    if (!near.engines()) return;
    const auto next = near.engines()->next_event(next_.hi);
    if (!next || (found && next->first >= next_.lo)) return;
    next_ = {next->first, next->second};
    found = true;
  });
  return found;
}

std::optional<TimeInterval> WorldSimulation::next_event(double t) {
  while (!over()) {
    const double until = std::min(t, near_.until());
    if (first_to_fail(until)) {
      note_time();
      // Enclosures of events that nearly coincide overlap, and that of the first one is past.
      return TimeInterval{std::max(next_.lo, now_), std::max(next_.hi, now_)};
    }
    conclude();
    if (over() || near_.last() || near_.until() >= t) break;
    advance_in_window(until);
  }
  return std::nullopt;
}

/// The solver of the single pair, if it has just one tiling: then its events can be processed one by one.
KineticSolver* WorldSimulation::only_tiling() const {
  KineticSolver* const only = single_pair();
  return only && only->engines() && only->engines()->size() == 1 ? only : nullptr;
}

bool WorldSimulation::step(double t) {
  const std::uint64_t before = events();
  if (!next_event(t)) {
    advance(t);
  } else if (KineticSolver* const only = only_tiling()) {
    only->step(only->at(), t);
    certificates_max_ = std::max(certificates_max_, certificates());
    conclude();
    note_time();
  } else {
    advance(next_.hi);
  }
  return events() > before && !over();
}

/// Without events, engines may have followed a motion beyond the present.
void WorldSimulation::note_time() {
  if (over()) return;
  double least = near_.until();
  for (const auto& [key, near] : pairs_) {
    if (near->engines()) least = std::min(least, near->engines()->time());
  }
  now_ = std::max(now_, least);
}

void WorldSimulation::conclude() {
  std::vector<PairEvent> events;
  for (const auto& [key, near] : pairs_) {
    if (!near->open()) events.push_back({answer_of(near->result(), instance_), near->instant()});
  }
  if (events.empty()) return;
  events = earliest_of_each_pair(std::move(events));
  // What has been processed is free, though enclosures may begin a little before its end.
  for (PairEvent& event : events) {
    event.pair.free_until = std::max(event.pair.free_until, processed_);
    if (!event.pair.contact) continue;
    TimeInterval& time = event.pair.contact->time;
    time = {std::max(time.lo, processed_), std::max(time.hi, processed_)};
  }
  take_earliest(events, answer_);
  now_ = std::max(now_, answer_.free_until);
  if (answer_.outcome != Outcome::overlap_at_start) return;
  answer_.overlap_point = common_point(instance_, *answer_.pair);
}

Coverage WorldSimulation::coverage() const {
  if (single_pair()) {
    Coverage tested;
    tested.pairs = tested.tested = 1;
    return tested;
  }
  return instance_.coverage(instance_.coverage(0).apart);
}

std::uint64_t WorldSimulation::certificates() const {
  std::uint64_t sum = 0;
  for (const auto& [key, near] : pairs_) {
    if (near->engines()) sum += near->engines()->certificates();
  }
  return sum;
}

void WorldSimulation::check_body(BodyId body) const {
  const auto count = static_cast<BodyId>(names_.size());
  if (body < 0 || body >= count)
    throw InputError("", "there is no body " + std::to_string(body), "bodies are 0 to " + std::to_string(count - 1));
}

void WorldSimulation::check_motion(BodyId body, const Motion& motion) const {
  const std::string& name = names_[static_cast<std::size_t>(body)];
  const AxisBox bounds = bounds_of(instance_, body);
  validate_motion(motion, name, bounds, now_, end(), extent_);
  const PieceList& own = instance_.bodies()[static_cast<std::size_t>(body)].own;
  const MotionPiece before = own.empty() ? MotionPiece{} : scaled(own.at(now_), -instance_.exponent());
  const MotionPiece after = pieces_between(motion, now_, end()).front();
  const double gap = joint_gap(before, after, bounds, now_);
  if (!(gap <= joint_room(before, after, bounds, now_, extent_)))
    throw InputError(name, fmt::format("the new motion jumps by {:.6g} at the present, t = {}", gap, now_),
                     "coefficients are in powers of t, or of t - origin where the piece has an origin");
}

void WorldSimulation::set_motion(BodyId body, const Motion& motion) {
  check_body(body);
  // Events that nearly coincide with the last one, and the rest of a bridge, belong to the old motion.
  if (now_ > processed_) advance(now_);
  if (over()) return;
  check_motion(body, motion);
  const double from = now_ > start_ ? std::nextafter(now_, start_) : now_;
  const std::vector<int> changed = instance_.followers(body);
  std::vector<int> groups;
  for (const int k : changed) groups.push_back(instance_.bodies()[static_cast<std::size_t>(k)].group);
  instance_.replan(body, motion, now_, from);
  near_.change(changed, from);
  forget_distant_pairs();
  for (const int k : changed) replan_pairs_of(k);
  note_tested();
  ask_starts_of(changed, groups);
}

/// A tiling stays if it corresponds to the present. At the start of the scene no bridge is possible.
void WorldSimulation::replan_pairs_of(int body) {
  near_.each_of(body, [&](int other) {
    const auto known = pairs_.find(key(body, other));
    if (known == pairs_.end()) return;
    const RingEngines* engines = known->second->engines();
    if (engines && engines->are_at(now_) && now_ > instance_.start()) {
      known->second->replan(now_);
    } else {
      pairs_.erase(known);
    }
  });
}

}  // namespace taut::internal
