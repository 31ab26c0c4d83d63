#include "simulation/world_simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "check/earliest.hpp"
#include "motion/pieces.hpp"
#include "pair/overlap_witness.hpp"
#include "pair/validate_scene.hpp"
#include "taut/error.hpp"

namespace taut::internal {
namespace {

const Scene& validated(const Scene& scene) {
  validate_polygons(scene);
  return scene;
}

/// In the input's units.
Bounds bounds_of(const Instance& instance, BodyId body) {
  const Bounds& b = instance.bodies()[static_cast<std::size_t>(body)].rings->bounds();
  const auto back = [&](double x) { return std::ldexp(x, -instance.exponent()); };
  return {{back(b.lo.x), back(b.lo.y)}, {back(b.hi.x), back(b.hi.y)}};
}

}  // namespace

WorldSimulation::WorldSimulation(const Scene& scene, Touch touch, std::uint64_t max_events)
    : touch_(touch),
      start_(scene.start),
      instance_(validated(scene)),
      near_(instance_),
      budget_(max_events),
      now_(scene.start) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    names_.push_back(scene.bodies[i].name);
    extent_ = std::max(extent_, diagonal(bounds_of(instance_, static_cast<BodyId>(i))));
    // Refuses features that are too fine now, rather than when the body comes near another one.
    instance_.bodies()[i].rings->displaced(offset_for(touch));
  }
  answer_.outcome = Outcome::free;
  note_tested();
  near_.begin(now_);
  open_window();
  ask_starts();
}

/// Pairs that are no longer near are forgotten.
void WorldSimulation::open_window() {
  std::erase_if(pairs_, [&](const auto& entry) { return !near_.has(entry.first.first, entry.first.second); });
}

KineticSolver& WorldSimulation::pair(const Key& key) {
  auto known = pairs_.find(key);
  if (known == pairs_.end()) {
    // Made first: a limit may end that.
    auto fresh = std::make_unique<KineticSolver>(instance_, key.first, key.second, offset_for(touch_), budget_);
    known = pairs_.emplace(key, std::move(fresh)).first;
  }
  return *known->second;
}

/// Do any two bodies overlap, or touch?
void WorldSimulation::ask_starts() {
  std::vector<int> all;
  for (const InstanceBody& body : instance_.bodies()) all.push_back(body.rings->body());
  MeetingBoxes(instance_, all, instance_.start(), instance_.start()).each([&](int a, int b, bool) {
    pair({a, b}).ask_start();
  });
  conclude();
}

/// The same of pairs that are asked about for the first time: of bodies that have moved alike, or, at the start of the
/// scene, of all that have changed. Whoever meets now is near.
void WorldSimulation::ask_starts_of(const std::vector<int>& changed, const std::vector<int>& groups_before) {
  const auto group_before = [&](int k) {
    const auto found = std::lower_bound(changed.begin(), changed.end(), k);
    if (found == changed.end() || *found != k) return instance_.bodies()[static_cast<std::size_t>(k)].group;
    return groups_before[static_cast<std::size_t>(found - changed.begin())];
  };
  const auto box = [&](int k) {
    return swept_box(instance_.bodies()[static_cast<std::size_t>(k)], instance_.start(), instance_.start());
  };
  bool met = false;
  for (const int body : changed) {
    near_.each_of(body, [&](int other) {
      const bool parted = !instance_.tests_groups() && group_before(body) == group_before(other);
      if (!parted && now_ > instance_.start()) return;
      if (pairs_.count(key(body, other)) > 0 || !box(body).meets(box(other))) return;
      KineticSolver& asked = pair(key(body, other));
      asked.ask_start();
      met = met || !asked.open();
    });
  }
  if (met) conclude();
}

void WorldSimulation::advance(double t) {
  while (!over() && now_ < t) {
    const double to = std::min(t, near_.until());
    advance_pairs(to);
    if (over()) return;
    now_ = to;
    if (now_ < near_.until() || near_.last()) continue;
    near_.next();
    open_window();
  }
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

std::optional<TimeInterval> WorldSimulation::next_event() {
  while (!over()) {
    std::optional<std::pair<double, double>> first;
    near_.each([&](int a, int b) {
      KineticSolver& near = pair({a, b});
      if (!near.engines()) near.work(near_.from(), now_, std::numeric_limits<std::uint64_t>::max());
      if (!near.engines()) return;
      const auto next = near.engines()->next_event(first ? std::min(near_.until(), first->second) : near_.until());
      if (next && (!first || next->first < first->first)) first = next;
    });
    if (first) return TimeInterval{first->first, first->second};
    conclude();
    if (near_.last() || over()) return std::nullopt;
    advance(near_.until());
  }
  return std::nullopt;
}

void WorldSimulation::conclude() {
  std::vector<PairEvent> events;
  for (const auto& [key, near] : pairs_) {
    if (!near->open()) events.push_back({answer_of(near->result()), near->instant()});
  }
  if (events.empty()) return;
  // Nothing happens before the present: enclosures may begin a little before it.
  for (PairEvent& event : events) {
    event.pair.free_until = std::max(event.pair.free_until, now_);
    if (!event.pair.contact) continue;
    TimeInterval& time = event.pair.contact->time;
    time = {std::max(time.lo, now_), std::max(time.hi, now_)};
  }
  take_earliest(events, answer_);
  now_ = std::max(now_, answer_.free_until);
  if (answer_.outcome != Outcome::overlap_at_start) return;
  answer_.overlap_point = common_point(instance_.pair((*answer_.pair)[0], (*answer_.pair)[1]), instance_.start());
}

Coverage WorldSimulation::coverage() const { return instance_.coverage(instance_.coverage(0).apart); }

std::uint64_t WorldSimulation::certificates() const {
  std::uint64_t sum = 0;
  for (const auto& [key, near] : pairs_) {
    if (near->engines()) sum += near->engines()->certificates();
  }
  return sum;
}

void WorldSimulation::check_motion(BodyId body, const Motion& motion) const {
  const auto count = static_cast<BodyId>(names_.size());
  if (body < 0 || body >= count)
    throw InputError("", "there is no body " + std::to_string(body), "bodies are 0 to " + std::to_string(count - 1));
  const std::string& name = names_[static_cast<std::size_t>(body)];
  const Bounds bounds = bounds_of(instance_, body);
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
  check_motion(body, motion);
  if (over()) return;
  const double from = now_ > start_ ? std::nextafter(now_, start_) : now_;
  const std::vector<int> changed = instance_.followers(body);
  std::vector<int> groups;
  for (const int k : changed) {
    groups.push_back(instance_.bodies()[static_cast<std::size_t>(k)].group);
    near_.each_of(k, [&](int other) { pairs_.erase(key(k, other)); });
  }
  instance_.replan(body, motion, now_, from);
  note_tested();
  near_.change(changed, from);
  ask_starts_of(changed, groups);
}

}  // namespace taut::internal
