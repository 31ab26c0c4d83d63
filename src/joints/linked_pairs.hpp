// Which pairs of bodies joints move against each other, and how these see each other over a box of joint values.
#pragma once

#include <array>
#include <bitset>
#include <memory>
#include <optional>
#include <vector>

#include "joints/pose_model.hpp"
#include "solver/pair_solver.hpp"

namespace taut::internal {

/// How a body hangs on others: itself, its parent, and so on.
using Chain = std::vector<int>;

/// Some joints of a linkage, by their positions there.
using JointSet = std::bitset<max_joints>;

/// Is a mechanism not shown to move over a cell, and across which joints could smaller cells show that?
struct MayLock {
  bool anywhere = false;
  JointSet joints;
};

/// One pair that is tested: the bodies in their roles, and the chains from them up to what they have in common.
struct LinkedPair {
  LinkedPair(const Instance& world, int a, int b, const std::vector<Chain>& chains);

  PairInstance search;
  Chain of_p, of_q;  ///< the innermost first, without common parents
  std::array<BodyId, 2> bodies;
};

/// All pairs of a linkage, which must be valid and outlive this.
class LinkedPairs {
 public:
  explicit LinkedPairs(const Linkage& linkage);

  const std::vector<std::unique_ptr<LinkedPair>>& pairs() const { return pairs_; }
  const LinkedPair& operator[](std::size_t i) const { return *pairs_[i]; }
  /// Two bodies that no joint moves against each other and that overlap, if such pairs are tested.
  const std::optional<std::array<BodyId, 2>>& overlap() const { return overlap_; }
  /// Pairs that no joint moves against each other, and that the scene does not ignore.
  const std::vector<std::array<BodyId, 2>>& fixed() const { return fixed_; }
  const Coverage& coverage() const { return coverage_; }
  /// May a mechanism lock in the cell, or not get there? Where it may, poses of its links are not known.
  MayLock may_lock(const JointCell& box) const;
  /// Q's pose, seen from P.
  PoseModel between(const LinkedPair& pair, const JointCell& box) const;
  /// Do the pair's bodies depend on the joint?
  bool follows(const LinkedPair& pair, std::size_t joint) const;
  /// Does the body follow a joint, or does one of its parents?
  bool moves(int body) const { return moves(chains_[static_cast<std::size_t>(body)]); }
  /// The body's pose, seen from the world.
  PoseModel pose(int body, const JointCell& box) const { return pose(chains_[static_cast<std::size_t>(body)], box); }
  /// Coordinates inside are the input's times this, a power of two.
  double scale() const { return scale_; }
  const Instance& world() const { return world_; }

 private:
  void find_chains();
  void choose_pairs();
  void test_fixed(bool any_moves);
  const JointMotion* motion_of(int body) const;
  bool move_apart(Chain a, Chain b) const;
  bool moves(const Chain& chain) const;
  bool follows(const Chain& chain, std::size_t joint) const;
  PoseModel pose(const Chain& chain, const JointCell& box) const;

  const Linkage& linkage_;
  Scene rests_;
  Instance world_;
  double scale_ = 1;
  std::vector<Chain> chains_;
  std::vector<std::unique_ptr<LinkedPair>> pairs_;
  std::vector<std::array<BodyId, 2>> fixed_;
  std::optional<std::array<BodyId, 2>> overlap_;
  Coverage coverage_;
};

}  // namespace taut::internal
