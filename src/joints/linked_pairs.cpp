#include "joints/linked_pairs.hpp"

#include <algorithm>
#include <cmath>

#include "motion/loop_region.hpp"
#include "numeric/budget.hpp"
#include "scene/linkage.hpp"
#include "scene/untested.hpp"

namespace taut::internal {
namespace {

void drop_common(Chain& a, Chain& b) {
  while (!a.empty() && !b.empty() && a.back() == b.back()) {
    a.pop_back();
    b.pop_back();
  }
}

/// The cross-sections of two bodies that have a layer in common.
std::vector<std::array<int, 2>> sections_of_pair(const Instance& world, const std::array<BodyId, 2>& bodies) {
  std::vector<std::array<int, 2>> pairs;
  for (const int a : world.sections(bodies[0])) {
    for (const int b : world.sections(bodies[1])) {
      if (!world.excluded(a, b)) pairs.push_back({a, b});
    }
  }
  return pairs;
}

/// Two bodies that no joint moves against each other overlap.
bool overlap_at_rest(const Instance& world, const std::array<BodyId, 2>& bodies) {
  const std::vector<std::array<int, 2>> sections = sections_of_pair(world, bodies);
  return std::any_of(sections.begin(), sections.end(), [&](const std::array<int, 2>& s) {
    const PairInstance pair(world, s[0], s[1], Offset::inward);
    return spacetime::overlapping(pair.geometry, pair.trees(), pair.segments()[0], world.start()).has_value();
  });
}

}  // namespace

LinkedPair::LinkedPair(const Instance& world, int a, int b, const std::vector<Chain>& chains)
    : search(world, a, b, Offset::outward), bodies(world.scene_pair(a, b)) {
  of_p = chains[static_cast<std::size_t>(search.bodies.rings[0]->body())];
  of_q = chains[static_cast<std::size_t>(search.bodies.rings[1]->body())];
  drop_common(of_p, of_q);
}

LinkedPairs::LinkedPairs(const Linkage& linkage)
    : linkage_(linkage), rests_(resting_scene(linkage)), world_(rests_), scale_(std::ldexp(1.0, world_.exponent())) {
  find_chains();
  choose_pairs();
}

void LinkedPairs::find_chains() {
  const std::map<std::string, int> by_name = bodies_by_name(rests_);
  chains_.resize(rests_.bodies.size());
  for (std::size_t i = 0; i < chains_.size(); ++i) {
    for (int body = static_cast<int>(i);;) {
      chains_[i].push_back(body);
      const std::string& parent = rests_.bodies[static_cast<std::size_t>(body)].relative_to;
      if (parent.empty()) break;
      body = by_name.at(parent);
    }
  }
}

/// Bodies that no joint moves against each other are tested once, as the scene says, and where there are no others.
void LinkedPairs::choose_pairs() {
  const IgnoredPairs ignored(rests_);
  const int n = static_cast<int>(chains_.size());
  bool any_moves = false;
  for (int a = 0; a < n; ++a) {
    for (int b = a + 1; b < n; ++b) {
      checkpoint();
      ++coverage_.pairs;
      const bool apart = move_apart(chains_[static_cast<std::size_t>(a)], chains_[static_cast<std::size_t>(b)]);
      any_moves = any_moves || apart;
      if (ignored.has(a, b)) {
        ++coverage_.ignored;
      } else if (!apart) {
        fixed_.push_back({a, b});
      } else {
        const std::vector<std::array<int, 2>> sections = sections_of_pair(world_, {a, b});
        ++(sections.empty() ? coverage_.layers : coverage_.tested);
        for (const auto& [of_a, of_b] : sections)
          pairs_.push_back(std::make_unique<LinkedPair>(world_, of_a, of_b, chains_));
      }
    }
  }
  test_fixed(any_moves);
}

void LinkedPairs::test_fixed(bool any_moves) {
  const bool tests_fixed = !any_moves || rests_.at_rest == AtRest::test;
  coverage_.at_rest = tests_fixed ? 0 : fixed_.size();
  if (!tests_fixed) return;
  for (const auto& pair : fixed_) ++(sections_of_pair(world_, pair).empty() ? coverage_.layers : coverage_.tested);
  const auto found =
      std::find_if(fixed_.begin(), fixed_.end(), [&](const auto& pair) { return overlap_at_rest(world_, pair); });
  if (found != fixed_.end()) overlap_ = *found;
}

const JointMotion* LinkedPairs::motion_of(int body) const {
  const auto i = static_cast<std::size_t>(body);
  return i < linkage_.motions.size() && linkage_.motions[i] ? &*linkage_.motions[i] : nullptr;
}

/// Is there a joint below what two chains have in common?
bool LinkedPairs::move_apart(Chain a, Chain b) const {
  drop_common(a, b);
  return moves(a) || moves(b);
}

bool LinkedPairs::moves(const Chain& chain) const {
  return std::any_of(chain.begin(), chain.end(), [this](int body) { return motion_of(body) != nullptr; });
}

bool LinkedPairs::follows(const Chain& chain, std::size_t joint) const {
  return std::any_of(chain.begin(), chain.end(), [&](int body) {
    const JointMotion* motion = motion_of(body);
    return motion && internal::follows(*motion, joint);
  });
}

bool LinkedPairs::follows(const LinkedPair& pair, std::size_t joint) const {
  return follows(pair.of_p, joint) || follows(pair.of_q, joint);
}

MayLock LinkedPairs::may_lock(const JointCell& box) const {
  MayLock found;
  for (const DrivenLoops& loops : linkage_.loops) {
    if (!loops.region) continue;
    const LoopRegion::Share share = loops.region->share_of(box.middle, box.half);
    if (share == LoopRegion::Share::none) return {true, {}};
    if (share == LoopRegion::Share::all) continue;
    found.anywhere = true;
    for (const LoopRegion::Range& range : loops.region->ranges())
      found.joints.set(static_cast<std::size_t>(range.joint));
  }
  return found;
}

PoseModel LinkedPairs::pose(const Chain& chain, const JointCell& box) const {
  PoseModel whole;
  for (const int body : chain) {
    if (const JointMotion* motion = motion_of(body)) whole = pose_of(*motion, box, scale_).of(whole);
  }
  return whole;
}

PoseModel LinkedPairs::between(const LinkedPair& pair, const JointCell& box) const {
  const PoseModel q = pose(pair.of_q, box);
  return moves(pair.of_p) ? pose(pair.of_p, box).inverse().of(q) : q;
}

}  // namespace taut::internal
