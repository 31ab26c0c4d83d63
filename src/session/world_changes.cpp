// Bodies of a simulated world that come and go, and whom they are attached to.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "certificate/root.hpp"
#include "motion/pieces.hpp"
#include "scene/validate_scene.hpp"
#include "session/world_simulation.hpp"
#include "taut/error.hpp"

namespace taut::internal {

/// Of the body that would come to where another one is.
InputError WorldSimulation::overlap_error(const Key& key, int culprit) const {
  const auto name = [&](int k) { return names_[static_cast<std::size_t>(instance_.scene_pair(k, k)[0])]; };
  const auto [one, other] = key.first == culprit ? std::pair(key.second, key.first) : key;
  return InputError(name(other), fmt::format("it would overlap \"{}\" at the present, t = {}", name(one), now_),
                    "move it, or ignore the pair first");
}

/// The pairs of bodies that are there from now on: at most those that are near, and those that move alike where these
/// are asked about at the start. Returns a pair that overlaps, if there is one.
std::optional<WorldSimulation::Key> WorldSimulation::begin_pairs(const std::vector<int>& bodies,
                                                                 const NearBodies::Changes& changes) {
  std::optional<Key> overlap;
  const auto begin = [&](const Key& pair, double jump) {
    add_pair(pair, std::nullopt, jump);
    const KineticSolver* const solver = pairs_.at(pair).solver.get();
    if (solver && solver->result().outcome == Outcome::overlap_at_start) overlap = pair;
  };
  for (const Key& pair : changes.gone) end_pair(pair);
  for (const int body : bodies) {
    for (const int other : near_.of(body)) {
      if (other < body && std::binary_search(bodies.begin(), bodies.end(), other)) continue;
      end_pair(key(body, other));
      begin(key(body, other), 0);
    }
    if (!instance_.tests_groups()) continue;
    for (const int other : near_.alike_at(body, now_)) {
      if (pairs_.count(key(body, other)) > 0) continue;
      begin(key(body, other), never);
      if (ended_.count(key(body, other)) == 0) end_pair(key(body, other));
    }
  }
  for (const Key& pair : changes.come) {
    if (pairs_.count(pair) == 0) begin(pair, never);
  }
  return overlap;
}

/// Of parents.
int WorldSimulation::depth_of(int body) const {
  int depth = 0;
  for (int k = body; k >= 0; k = instance_.bodies()[static_cast<std::size_t>(k)].parent) ++depth;
  return depth - 1;
}

bool WorldSimulation::add_body(const Body& body) {
  const int index = static_cast<int>(names_.size());
  double extent = extent_;
  const double largest = std::ldexp(instance_.largest(), -instance_.exponent());
  validate_added(body, index, now_, end(), largest, extent);
  if (index < 3 || !instance_.can_add(body)) return false;
  if (!numbers_) numbers_.emplace(names_);
  const std::optional<BodyId> parent = numbers_->find(body.relative_to);
  if (!parent && !body.relative_to.empty()) {
    if (body.relative_to == body.name) refuse_cycle(body.name);
    refuse_parent(body, names_);
  }
  if (parent) validate_depth(body.name, depth_of(*parent) + 1);
  InstanceBody added = instance_.to_add(body, parent.value_or(-1), now_);
  // Refuses features that are too fine.
  added.rings->displaced(offset_for(touch_));
  numbers_->add(body.name, index);
  names_.push_back(body.name);
  const double from = right_before();
  instance_.add(std::move(added), from);
  if (const std::optional<Key> overlap = begin_pairs({index}, near_.add(from))) {
    const InputError error = overlap_error(*overlap, index);
    forget_last();
    throw error;
  }
  extent_ = extent;
  note_tested();
  if (!over()) conclude(now_);
  return true;
}

/// The last body, after the present has been refused to it.
void WorldSimulation::forget_last() {
  const int last = static_cast<int>(names_.size()) - 1;
  std::vector<Key> pairs;
  for (const int other : near_.of(last)) pairs.push_back(key(other, last));
  std::copy_if(ended_.begin(), ended_.end(), std::back_inserter(pairs),
               [last](const Key& pair) { return pair.second == last; });
  for (const Key& pair : pairs) end_pair(pair);
  near_.remove_last();
  instance_.remove_last();
  numbers_->remove(names_.back());
  names_.pop_back();
}

bool WorldSimulation::remove_body(BodyId body, const std::string& name) {
  if (instance_.is_single_pair()) return false;
  std::string& own = names_[static_cast<std::size_t>(body)];
  if (numbers_) {
    numbers_->add(name, body);
    numbers_->remove(own);
  }
  own = name;
  for (const int k : instance_.sections(body)) {
    for (const Key& pair : near_.remove(k).gone) end_pair(pair);
  }
  instance_.retire(body);
  return true;
}

bool WorldSimulation::ignore(BodyId a, BodyId b) {
  if (instance_.is_single_pair()) return false;
  for (const int k : instance_.sections(a)) {
    for (const int other : instance_.sections(b)) {
      near_.part(k, other);
      end_pair(key(k, other));
    }
  }
  instance_.ignore(a, b);
  return true;
}

/// The body's pairs, and its followers', begin at the present.
std::optional<WorldSimulation::Key> WorldSimulation::attach(int body, int parent, const PieceList& own) {
  const double from = right_before();
  instance_.attach(body, parent, own, now_, from);
  const std::vector<int> moved = instance_.followers(body);
  return begin_pairs(moved, near_.change(moved, from));
}

bool WorldSimulation::set_parent(BodyId body, std::optional<BodyId> parent, const Motion& motion) {
  if (instance_.is_single_pair()) return false;
  const std::string& name = names_[static_cast<std::size_t>(body)];
  const std::vector<int> followers = instance_.followers(body);
  if (parent && std::binary_search(followers.begin(), followers.end(), *parent)) refuse_cycle(name);
  const int deeper = (parent ? depth_of(*parent) + 1 : 0) - depth_of(body);
  for (const int k : followers) {
    if (k < static_cast<int>(names_.size())) validate_depth(names_[static_cast<std::size_t>(k)], depth_of(k) + deeper);
  }
  validate_motion(motion, name, input_bounds(body), now_, end(), extent_);
  const InstanceBody before = instance_.bodies()[static_cast<std::size_t>(body)];
  if (const std::optional<Key> overlap = attach(body, parent.value_or(-1), instance_.pieces_of(motion, now_))) {
    const bool first = std::binary_search(followers.begin(), followers.end(), overlap->first);
    const InputError error = overlap_error(*overlap, first ? overlap->first : overlap->second);
    attach(body, before.parent, before.own);
    throw error;
  }
  note_tested();
  if (!over()) conclude(now_);
  return true;
}

}  // namespace taut::internal
