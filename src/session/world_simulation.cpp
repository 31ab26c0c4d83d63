#include "session/world_simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "certificate/root.hpp"
#include "motion/pieces.hpp"
#include "numeric/budget.hpp"
#include "scene/meeting_boxes.hpp"
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

}  // namespace

WorldSimulation::WorldSimulation(const Scene& scene, Touch touch, std::uint64_t max_events, KineticObserver* observer)
    : touch_(touch),
      observer_(observer),
      start_(scene.start),
      instance_(validated(scene)),
      budget_(max_events),
      near_(instance_),
      now_(scene.start),
      reached_(scene.start),
      processed_(scene.start) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    names_.push_back(scene.bodies[i].name);
    extent_ = std::max(extent_, diagonal(input_bounds(static_cast<BodyId>(i))));
  }
  // Refuses features that are too fine now, rather than when the body comes near another one.
  for (const InstanceBody& body : instance_.bodies()) body.rings->displaced(offset_for(touch));
  answer_.outcome = Outcome::free;
  note_tested();
  for (const Key& pair : near_.pairs()) add_pair(pair, std::nullopt);
  if (instance_.tests_groups()) ask_starts_of_groups();
  conclude(now_);
}

/// Nothing happens to bodies that move alike after the start.
void WorldSimulation::ask_starts_of_groups() {
  std::vector<int> all(instance_.bodies().size());
  std::iota(all.begin(), all.end(), 0);
  MeetingBoxes(instance_, all, instance_.start(), instance_.start()).each([&](int a, int b, bool) {
    if (near_.has(a, b)) return;
    add_pair({a, b}, std::nullopt, never);
    if (ended_.count({a, b}) == 0) end_pair({a, b});
  });
}

KineticSolver* WorldSimulation::single_pair() const {
  return instance_.is_single_pair() && !pairs_.empty() ? pairs_.begin()->second.solver.get() : nullptr;
}

const RingEngines* WorldSimulation::engines(int a, int b) const {
  const auto known = pairs_.find(key(a, b));
  return known == pairs_.end() || !known->second.solver ? nullptr : known->second.solver->engines();
}

/// The time of what is first: a box that ends, or a pair that may have an event.
double WorldSimulation::first_due() const { return first_is_box() ? near_.until() : queue_.first_due(); }

/// The time of what comes after the first pair.
double WorldSimulation::next_due() const { return std::min(near_.until(), queue_.second_due()); }

/// Nothing is due before that. Tilings of pairs that are apart until a box ends again are not worth keeping.
void WorldSimulation::renew_boxes() {
  const double from = near_.until();
  const NearBodies::Changes changes = near_.renew();
  for (const Key& pair : changes.gone) end_pair(pair);
  for (const int body : changes.renewed) {
    for (const int other : near_.of(body)) {
      const auto known = pairs_.find(key(body, other));
      if (known == pairs_.end() || ended_.count(known->first) > 0) continue;
      if (known->second.has_changed || near_.apart_until(body, other, from) < near_.until(body, other)) continue;
      queue_.erase(known->second);
      leave_to_discs(known->second, from, 0);
      enqueue(known->second);
    }
  }
  for (const Key& pair : changes.come) add_pair(pair, from);
}

/// Requires that something is due by the limit. Returns the limit, which a result lowers: nothing after it comes first.
double WorldSimulation::process_first(double limit) {
  const double due = first_due();
  try {
    checkpoint();
    return process_due(limit);
  } catch (const Interrupted&) {
    // So far all is proved, whatever is half done now.
    now_ = std::max(now_, std::min(std::nextafter(due, -never), end()));
    throw;
  }
}

double WorldSimulation::process_due(double limit) {
  if (first_is_box()) {
    renew_boxes();
    return limit;
  }
  const double soon = std::min(limit, next_due());
  Near& near = queue_.first();
  queue_.erase(near);
  if (near.has_changed) {
    follow_change(near);
  } else if (!near.solver) {
    const double due = near.due;
    if (!leave_to_discs(near, due, 0)) begin_tilings(near, due);
  } else if (near.next) {
    take_step(near, limit);
  } else if (may_meet_soon(near) || !leave_to_discs(near, near.due, 0)) {
    look(near, soon, limit);
  }
  enqueue(near);
  return std::min(limit, result_end(near));
}

/// Infinite without a result.
double WorldSimulation::result_end(const Near& near) {
  if (!near.solver || near.solver->open()) return never;
  const PairResult& result = near.solver->result();
  return result.contact ? result.contact->time.hi : result.free_until;
}

/// Looks for the next event of a pair up to that time, when another pair is due. An event that is isolated, but may
/// come before or after, is looked for as far as the limit: otherwise two such pairs could wait for each other.
void WorldSimulation::look(Near& near, double soon, double limit) {
  KineticSolver& solver = *near.solver;
  near.next = solver.next_event(soon);
  if (!solver.open()) return;
  const double proved = solver.engines()->proved_until();
  near.due = std::max(std::nextafter(soon, never), proved);
  if (near.next) near.due = std::max(now_, near.next->lo);
  if (near.next || soon >= limit || proved >= soon) return;
  near.next = solver.next_event(limit);
  if (solver.open() && !near.next) near.due = std::nextafter(limit, never);
}

/// Processes the event of the pair that is known, unless it comes after the limit.
void WorldSimulation::take_step(Near& near, double limit) {
  KineticSolver& solver = *near.solver;
  const double to = std::min(limit, std::max(near.next->hi, near.due));
  const std::uint64_t before = events();
  near.next.reset();
  solver.step(to);
  // Another ring of the pair may be in contact before.
  while (solver.open() && solver.engines()->contact()) solver.step(to);
  if (!solver.open()) return;
  near.due = events() > before ? std::max(near.due, solver.engines()->proved_until()) : std::nextafter(to, never);
}

void WorldSimulation::advance(double t) {
  if (over() || processed_ >= t) return;
  double limit = t;
  for (const Key& pair : ended_) limit = std::min(limit, result_end(pairs_.at(pair)));
  while (first_due() <= limit) limit = process_first(limit);
  if (conclude(limit)) return;
  processed_ = std::max(processed_, t);
  now_ = std::max(now_, t);
  if (KineticSolver* const only = single_pair()) only->stand_at(t);
}

/// The time of the first pair that has come to an end.
std::optional<double> WorldSimulation::first_end() const {
  std::optional<double> first;
  for (const Key& pair : ended_) {
    const double time = time_of(answer_of(pairs_.at(pair).solver->result()));
    first = std::min(first.value_or(time), time);
  }
  return first;
}

std::optional<TimeInterval> WorldSimulation::next_event(double t) {
  while (!over() && first_due() <= t) {
    const double due = first_due();
    if (!first_is_box()) {
      const Near& first = queue_.first();
      // Enclosures of events that nearly coincide overlap, and that of the first one is past.
      if (first.next) return TimeInterval{std::max(first.next->lo, now_), std::max(first.next->hi, now_)};
    }
    if (const std::optional<double> ended = first_end(); ended && *ended <= due) {
      // A contact that was found before, but comes now. Others may come with it.
      advance(std::min(t, std::max(*ended, due)));
      break;
    }
    process_first(t);
    note_time();
  }
  if (!over()) conclude(t);
  return std::nullopt;
}

/// Where boxes have ended, or the only pair has had an event, or its motion has gone on to its next piece. Not past
/// what may be a contact: events that nearly coincide may be yet to come.
void WorldSimulation::note_time() {
  // What is due may come right then.
  double proved = std::min(std::nextafter(first_due(), -never), end());
  for (const Key& pair : ended_) proved = std::min(proved, pairs_.at(pair).solver->result().free_until);
  double reached = near_.latest();
  const KineticSolver* const only = single_pair();
  if (only && only->open() && only->engines()) reached = std::max(reached, only->engines()->time());
  reached_ = std::max(reached_, reached);
  now_ = std::max(now_, std::min(reached, proved));
}

void WorldSimulation::settle() {
  const double reached = std::max(now_, reached_);
  if (reached > processed_) advance(reached);
}

/// The solver of the single pair, if it has just one tiling: then its events can be processed one by one.
KineticSolver* WorldSimulation::only_tiling() const {
  KineticSolver* const only = single_pair();
  return only && only->engines() && only->engines()->size() == 1 ? only : nullptr;
}

bool WorldSimulation::step(double t) {
  const std::uint64_t before = events();
  const std::optional<TimeInterval> next = next_event(t);
  if (!next) {
    advance(t);
  } else if (only_tiling()) {
    process_first(t);
    if (!conclude(t)) note_time();
  } else {
    advance(std::min(t, next->hi));
  }
  return events() > before && !over();
}

/// What has come to an end by the limit. Returns whether something has.
bool WorldSimulation::conclude(double limit) {
  std::vector<PairEvent> events;
  for (const Key& pair : ended_) {
    const KineticSolver& solver = *pairs_.at(pair).solver;
    PairEvent event{answer_of(solver.result(), instance_), solver.instant()};
    if (time_of(event.pair) <= limit) events.push_back(std::move(event));
  }
  if (events.empty()) return false;
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
  if (answer_.outcome == Outcome::overlap_at_start) answer_.overlap_point = common_point(instance_, *answer_.pair);
  return true;
}

void WorldSimulation::resume() {
  if (answer_.outcome != Outcome::contact) return;
  answer_ = {};
  answer_.outcome = Outcome::free;
  processed_ = std::max(processed_, now_);
  conclude(now_);
}

Coverage WorldSimulation::coverage() const {
  if (single_pair()) {
    Coverage tested;
    tested.pairs = tested.tested = 1;
    return tested;
  }
  return instance_.coverage(instance_.coverage(0).apart);
}

void WorldSimulation::check_body(BodyId body) const {
  const auto count = static_cast<BodyId>(names_.size());
  if (body < 0 || body >= count)
    throw InputError("", "there is no body " + std::to_string(body), "bodies are 0 to " + std::to_string(count - 1));
}

void WorldSimulation::check_motion(BodyId body, const Motion& motion) const {
  const std::string& name = names_[static_cast<std::size_t>(body)];
  const AxisBox bounds = input_bounds(body);
  validate_motion(motion, name, bounds, now_, end(), extent_);
  const PieceList& own = instance_.bodies()[static_cast<std::size_t>(body)].own;
  const MotionPiece before = own.empty() ? MotionPiece{} : scaled(own.at(now_), -instance_.exponent());
  const MotionPiece after = pieces_between(motion, now_, end()).front();
  const double gap = joint_gap(before, after, bounds, now_);
  if (!(gap <= joint_room(before, after, bounds, now_, extent_)))
    throw InputError(name, fmt::format("the new motion jumps by {:.6g} at the present, t = {}", gap, now_),
                     "coefficients are in powers of t, or of t - origin where the piece has an origin");
}

void WorldSimulation::carry_on(const WorldSimulation& before) {
  has_tested_ = has_tested_ || before.has_tested_;
  if (before.answer_.outcome == Outcome::contact) answer_ = before.answer_;
}

void WorldSimulation::set_motion(BodyId body, const Motion& motion) {
  check_body(body);
  settle();
  if (over() && answer_.outcome != Outcome::contact) return;
  check_motion(body, motion);
  const double from = right_before();
  const std::vector<int> changed = instance_.followers(body);
  const double jump = jump_of(body);
  instance_.replan(body, motion, now_, from);
  const NearBodies::Changes changes = near_.change(changed, from);
  for (const Key& pair : changes.gone) end_pair(pair);
  for (const int k : changed) {
    for (const int other : near_.of(k)) {
      const bool twice = other < k && std::binary_search(changed.begin(), changed.end(), other);
      if (!twice) replan_pair(key(k, other), k == body ? jump : never);
    }
  }
  for (const Key& pair : changes.come) {
    if (pairs_.count(pair) == 0) add_pair(pair, std::nullopt, never);
  }
  note_tested();
  if (!over()) conclude(now_);
}

}  // namespace taut::internal
