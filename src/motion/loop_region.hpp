// A mechanism's joint values as functions of several driven joints, where these move one loop together.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "motion/loop_box.hpp"
#include "taut/envelope.hpp"

namespace taut::internal {

/// Around the drawn pose, in which all values are 0: boxes of the driven joints' values, in each of which the equations
/// have one regular solution near a linear function. Boxes that have a point in common agree there, and all hang
/// together with the one that holds the drawn pose. So the union has one continuous solution, which every way within it
/// follows. Near a lock, and beyond, there are no boxes.
class LoopRegion {
 public:
  struct Range {
    int joint;  ///< its position in Linkage::joints
    int drive;  ///< in the equations
    double lo, hi;
  };
  /// Drives that are not among the ranges rest at 0. Boxes near locks are no smaller than 2^-10 of a range.
  LoopRegion(LoopEquations equations, std::vector<Range> ranges);

  const std::vector<Range>& ranges() const { return ranges_; }
  /// Does a joint of the tree depend on the value of a joint of the linkage?
  bool depends(std::size_t joint, int on) const;

  /// A joint's value over a box of the values of all joints of a linkage: at the middle, all values, and all
  /// derivatives by the joints whose values vary. The sum of slope[k] times (value of joint k - its middle) is within
  /// `middle`.
  struct Value {
    Ball<double> middle, range;
    std::array<Ball<double>, max_joints> slope{};
  };
  using Values = std::array<double, max_joints>;
  /// Of a joint of the tree. Nothing if the box reaches beyond the region, or is too large.
  std::optional<Value> value(std::size_t joint, const Values& middle, const Values& half) const;
  /// How much of a box is in the region?
  enum class Share : unsigned char { none, some, all };
  Share share_of(const Values& middle, const Values& half) const;
  /// Is the straight way from the drawn pose to these values in the region? It is how a mechanism gets to where its
  /// drives begin.
  bool has_straight_way(const Values& to) const;
  /// Can no way without a lock, which may leave the region and come back, lead to another pose than the region's? Not
  /// if the region is all of the box, if only one value varies, or if the loops can be solved one after the other, for
  /// two links each: such a loop has at most two poses, and the sign of its Jacobian tells which. False: not known.
  bool has_one_pose() const;

 private:
  enum class State : unsigned char { unknown, divided, regular, irregular };
  struct Node {
    Values lo{}, hi{};  ///< by the number of the range
    int depth = 0, children = 0;
    State state = State::unknown;
    BoxSolution solution;
  };
  /// A box that holds a place at which the solution is known from another box; of the first one, from the drawing.
  struct Attempt {
    int node, from;
    Values place;
  };
  class Builder;

  bool touches(const Node& node, const Values& lo, const Values& hi) const;
  /// Calls visit(number) for each box, not divided, that has a point in common with this one.
  template <class Visit>
  void for_each_leaf(const Values& lo, const Values& hi, const Visit& visit) const;
  /// A box of the values of all joints of a linkage, as one of the ranges. It is a little smaller, by more than what is
  /// rounded when cells are halved.
  struct Inside {
    Values at{}, lo{}, hi{};
  };
  Inside inside(const Values& middle, const Values& half) const;
  DriveBox drives(const Values& middle, const Values& half) const;
  DriveBox drives(const Node& node) const;
  std::vector<double> place(const Values& at) const;
  /// The parts that a box consists of.
  struct Parts {
    bool any_regular = false, all_regular = true;
    const Node* at_middle = nullptr;
  };
  Parts parts_of(const Inside& box) const;
  std::optional<BoxSolution> solved(const Values& middle, const Values& half) const;
  const std::optional<BoxSolution>& known(const Values& middle, const Values& half) const;

  LoopEquations equations_;
  std::vector<double> weights_;
  std::vector<Range> ranges_;
  std::vector<Node> nodes_;
  std::uint64_t id_;
};

}  // namespace taut::internal
