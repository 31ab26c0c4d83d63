// One pair of bodies over a cell of joint values: apart, colliding, or neither; and which features keep it from either.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "joints/linked_pairs.hpp"

namespace taut::internal::path {

/// Runs of edges of P and of Q, by nodes of their trees.
using Runs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// What an open cell knows of a pair, and hands on to its parts.
struct OpenFeatures {
  /// Those that were not shown to be apart.
  Runs runs = {{0, 0}};
  /// A point of one body, in its coordinates, that stays inside the other one in a cell around, or in this one.
  struct Inner {
    bool of_p = false;
    Vector at;
  };
  std::optional<Inner> inner = {};
};

/// What must hold wherever the pair does not collide, of the cell's values middle + h half with h from -1 to 1:
/// constant + sum rate[k] h[k] >= 0. Two edges cross where it does not: three of their four ends are on the right sides
/// for all values in the cell, and the fourth one has to be on the other side.
struct Condition {
  double constant = 0;  ///< no less than the exact one by what is not linear
  std::array<double, max_joints> rate{};
  std::uint32_t pair = 0;
  std::uint32_t p = 0, q = 0;  ///< edges, by their first vertices
  bool vertex_of_p = false;    ///< the fourth end is of P's edge
  bool second_vertex = false;  ///< and is where it ends
};

/// Why a pair collides for all values of a cell.
struct Collision {
  enum class Kind : std::uint8_t { crossing, inside, near };
  Kind kind = Kind::crossing;
  std::uint32_t p = 0, q = 0;  ///< crossing: edges of P and Q, by their first vertices. near: a vertex and an edge
  bool of_p = false;           ///< whose vertex, or inner point, it is
  Vector at;                   ///< that inner point
};

/// The pose of Q seen from P over a cell, in plain numbers: only the joints that matter.
class PairView {
 public:
  PairView(const PoseModel& pose, double reach);

  struct Place {
    Vector value;
    std::array<Vector, max_joints> rate;
    double error;
  };
  Place place(Vector v) const {
    Place p{shift_.value + rotation_.value * v, {}, shift_.error + rotation_.error * l1_norm(v)};
    for (std::size_t k = 0; k < count_; ++k) p.rate[k] = shift_.rate[k] + rotation_.rate[k] * v;
    return p;
  }
  /// A vector that turns along.
  Place turn(Vector v) const {
    Place p{rotation_.value * v, {}, rotation_.error * l1_norm(v)};
    for (std::size_t k = 0; k < count_; ++k) p.rate[k] = rotation_.rate[k] * v;
    return p;
  }
  /// By how much n . z may vary around its value, to first order.
  double spread(Vector n, const Place& z) const {
    double sum = 0;
    for (std::size_t k = 0; k < count_; ++k) sum += std::fabs(dot(n, z.rate[k]));
    return sum;
  }
  /// How far the place may be from its value.
  double swing(const Place& z) const {
    double sum = z.error;
    for (std::size_t k = 0; k < count_; ++k) sum += std::sqrt(dot(z.rate[k], z.rate[k]));
    return sum * (1 + 0x1p-40);
  }
  /// More than what rounds in a few operations.
  double slack() const { return slack_; }
  Vector rotation() const { return rotation_.value; }
  std::size_t count() const { return count_; }
  /// The joint that a rate is about.
  std::size_t joint(std::size_t k) const { return joint_[k]; }

 private:
  JointModel shift_, rotation_;
  std::size_t count_ = 0;
  std::array<std::size_t, max_joints> joint_{};
  double slack_ = 0;
};

/// A cell is free if directions separate all runs of edges for all values in it by more than the clearance, and no
/// outline is inside the other body. It collides if for all values two edges cross, or a vertex is inside the other
/// body, or, with a clearance, a vertex is nearer to an edge. All in doubles with certified errors.
class PairCells {
 public:
  PairCells(const LinkedPair& pair, double clearance);

  /// Q's pose is seen from P. `open` is what is open in a larger cell around; it becomes what is open in this one if
  /// the answer is `undecided`. `why` is set if it is `colliding`. Conditions of open edges are added.
  CellState evaluate(const PoseModel& of_q, OpenFeatures& open, Collision* why = nullptr,
                     std::vector<Condition>* conditions = nullptr) const;
  /// The same for a cell that stays undecided and seems to collide: tries points inside of either body, near its
  /// vertices, which show this of bodies whose outlines lie on each other.
  bool find_deep(const PoseModel& of_q, OpenFeatures& open) const;
  /// How far each joint moves what is open, in the plane: to first order, with what the model leaves out. What loops of
  /// a mechanism add to that counts for the joints that drive them: without these, it is `rest` that is left out, and
  /// `held[k]` is the model if joint k keeps its value.
  std::array<double, max_joints> effect(const PoseModel& of_q, const PoseModel& rest,
                                        const std::array<PoseModel, max_joints>& held, const OpenFeatures& open) const;

 private:
  struct Seen;
  /// Do two edges cross, or come too near, for all joint values? Else those runs are left that stay open.
  bool runs_collide(const Seen& seen, Runs& runs, Collision& why, std::vector<Condition>* conditions) const;
  bool apart(const PairView& seen, const spacetime::Box& p, const spacetime::Box& q) const;
  bool edges_apart(const PairView& seen, std::uint32_t p, std::uint32_t q) const;
  bool cross(const Seen& seen, std::uint32_t p, std::uint32_t q, std::vector<Condition>* conditions) const;
  bool near(const Seen& seen, std::uint32_t p, std::uint32_t q, Collision& why) const;
  bool near_vertex(const PairView& seen, Vector a, Vector b, Vector vertex) const;
  bool stays_inside(const Seen& seen, const OpenFeatures::Inner& inner) const;
  bool find_inside(const Seen& seen, OpenFeatures& open) const;
  CellState containment(const Seen& seen, OpenFeatures& open) const;
  bool goes_around(bool p, Vector at) const;
  template <class Spread>
  bool is_near_edge(bool p, Vector at, double distance, const Spread& spread) const;
  template <class Spread>
  bool is_deep(bool in_p, Vector at, double distance, const Spread& spread) const;

  const std::vector<Vector>& points(bool p) const { return p ? points_p_ : points_q_; }
  const std::vector<std::uint32_t>& next(bool p) const { return p ? next_p_ : next_q_; }

  const spacetime::Hierarchy &tree_p_, &tree_q_;
  double clearance_, reach_p_, reach_q_;
  std::vector<Vector> points_p_, points_q_;
  std::vector<std::uint32_t> next_p_, next_q_;
  std::vector<std::uint32_t> outlines_p_, outlines_q_;  ///< a vertex of each outline
};

}  // namespace taut::internal::path
