// The box of all joint values, divided into cells by halving.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "path/joint_space.hpp"
#include "path/reach.hpp"

namespace taut::internal::path {

using CellId = std::uint32_t;
inline constexpr CellId no_cell = UINT32_MAX;

/// Sides are counted in units of 2^-48 of the joint's range.
inline constexpr std::int64_t whole_side = std::int64_t{1} << 48;

/// Numbers of such units.
using CellSides = std::array<std::int64_t, max_joints>;

/// What a search from the start or the goal knows of a cell.
struct ReachMark {
  bool is_seed = false;
  bool is_reached = false;
  CellId from = no_cell;  ///< a reached neighbour, by which it was found
};

struct TreeCell {
  CellSides lo{}, side{};
  CellState state = CellState::undecided;
  std::uint8_t axis = 0;      ///< along which it was halved
  CellId children = no_cell;  ///< the first one; the second one follows
  CellId parent = no_cell;
  std::uint32_t depth = 0;
  JointValues sample{};  ///< in it; of an undecided cell, where it is likely to be free
  bool sample_free = false;
  bool is_least = false;            ///< it is not divided any more
  std::array<ReachMark, 2> marks;   ///< from the start, and from the goal
  std::unique_ptr<OpenPairs> open;  ///< of a leaf that is undecided, or the pair that collides
  /// Leaves that do not collide and have a face in common with this one, also across the ends of joints with a period.
  /// Of a leaf that does not collide.
  std::vector<CellId> neighbours;

  bool is_leaf() const { return children == no_cell; }
};

/// What two cells have in common, as the first one sees it: a box of cells that is flat across `axis`. Where the second
/// one sees it, its place along `axis` is less by `shift`: a period, or nothing.
struct CellFace {
  CellSides lo{}, side{};
  std::size_t axis = 0;
  std::int64_t shift = 0;
};

/// A point that two cells have in common. The second cell may be seen across the ends of joints with a period: it is
/// then where these shifts put it.
struct CommonPoint {
  JointValues at{};
  JointValues shift{};
};

class CellTree {
 public:
  /// `reach`: no ways matter that lead through cells which it does not hold; they are marked as if they collided.
  CellTree(const PathProblem& problem, const JointSpace& space, double tolerance, const Reach* reach = nullptr);

  const TreeCell& operator[](CellId id) const { return cells_[id]; }
  TreeCell& operator[](CellId id) { return cells_[id]; }
  std::size_t size() const { return cells_.size(); }
  CellId root() const { return 0; }

  /// Certainly contains the cell.
  JointCell box(CellId id) const;
  const JointValues& sample(CellId id) const { return cells_[id].sample; }
  bool sample_free(CellId id) const { return cells_[id].state == CellState::free || cells_[id].sample_free; }
  /// Halves a leaf across the joint that moves most, and evaluates both halves. False if it is as small as the
  /// tolerance, or nothing moves across it: it is_least then.
  bool divide(CellId id);
  void set_tolerance(double tolerance) { tolerance_ = tolerance; }

  /// All faces that two cells have in common, those without a shift first. A cell that is a period wide has one in
  /// common with itself.
  std::vector<CellFace> faces(CellId a, CellId b) const;
  std::optional<CommonPoint> common_point(CellId a, CellId b) const;
  /// The value of a joint that belongs to so many units of its range.
  double value(std::size_t joint, std::int64_t units) const;

 private:
  void add_root();
  void evaluate(CellId id);
  std::optional<std::size_t> widest(CellId id) const;
  /// Do two boxes have a face in common, or the inside?
  bool share_face(const CellSides& lo_a, const CellSides& side_a, const CellSides& lo_b, const CellSides& side_b) const;
  bool are_neighbours(CellId a, CellId b) const;
  void add_half(CellId whole, CellId half, std::size_t axis, const OpenPairs* open);
  void join(CellId a, CellId b);

  const PathProblem& problem_;
  const JointSpace& space_;
  double tolerance_;
  const Reach* reach_;
  std::size_t dimension_;
  std::vector<TreeCell> cells_;
};

}  // namespace taut::internal::path
