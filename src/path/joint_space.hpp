// Points, cells and segments of joint values: free, colliding, or neither.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "path/pair_cells.hpp"
#include "taut/path.hpp"

namespace taut::internal::path {

/// What is open in a cell: pairs by their numbers, and their features.
using OpenPairs = std::vector<std::pair<std::uint32_t, OpenFeatures>>;

/// Why a cell collides: a collision of one pair, or conditions that exclude each other, and their weights.
struct CellReason {
  std::uint32_t pair = 0;
  std::optional<Collision> collision;
  std::vector<Condition> conditions;
  std::vector<double> weights;
};

/// All tested pairs of a problem, which must be valid and outlive this.
class JointSpace {
 public:
  /// `clearance` is in the scene's units.
  JointSpace(const PathProblem& problem, double clearance);

  const Linkage& linkage() const { return problem_.linkage; }
  const LinkedPairs& pairs() const { return pairs_; }
  std::size_t dimension() const { return problem_.linkage.joints.size(); }
  const std::vector<std::array<BodyId, 2>>& of_scene() const { return bodies_; }

  OpenPairs all_open() const;
  /// `open` is what a larger cell around left open; it becomes what this one does if it is undecided. If it collides,
  /// what remains is the pair that does, or the pairs that cannot all be free. `best`: of an undecided cell, values in
  /// it at which bodies are likely to be farthest apart.
  CellState evaluate(const JointCell& cell, OpenPairs& open, JointValues* best = nullptr) const;
  /// Of a cell that is undecided: tries harder to show that it collides. If so, that pair remains.
  bool collides_deeply(const JointCell& cell, OpenPairs& open) const;
  /// Of a cell that collides, with what remains of it; nothing if that cannot be found again.
  std::optional<CellReason> why(const JointCell& cell, OpenPairs open) const;
  bool is_free(const JointValues& at, const OpenPairs& among) const;
  bool is_free(const JointValues& at) const { return is_free(at, all_open()); }
  /// How far each joint moves what is open across the cell.
  std::array<double, max_joints> effect(const JointCell& cell, const OpenPairs& open) const;

  /// Are the bodies certainly apart at every instant at which all joints move evenly from `a` to `b`? Gives up where
  /// bodies come so near that doubles do not decide.
  bool is_free(const JointValues& a, const JointValues& b) const;

 private:
  double share_of_range(const JointCell& cell, std::size_t joint) const;
  bool is_free_between(const JointCell& segment, OpenPairs& open) const;
  std::array<double, max_joints> effect_on(std::uint32_t pair, const JointCell& cell,
                                           const OpenFeatures& features) const;

  const PathProblem& problem_;
  LinkedPairs pairs_;
  std::vector<PairCells> cells_;
  std::vector<std::array<BodyId, 2>> bodies_;
  std::array<bool, max_joints> drives_{};  ///< loops of a mechanism
};

}  // namespace taut::internal::path
