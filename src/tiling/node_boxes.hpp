// Rectangles around the regions between chains and their geodesics, and where another body may come near them.
#pragma once

#include <span>
#include <vector>

#include "geometry/displacement.hpp"
#include "scene/placement.hpp"
#include "tiling/chain_tree.hpp"

namespace taut::internal {

/// A rectangle along the unit vector (ux, uy), rounded outwards.
struct NodeBox {
  double x = 0, y = 0;           ///< its middle
  double ux = 1, uy = 0;         ///< unit vector up to rounding
  double along = 0, across = 0;  ///< half its size
};

/// The rectangle along the line from a to b that holds the points and `box`'s range so far.
class BoxBuilder {
 public:
  BoxBuilder(const Point& a, const Point& b);
  void include(double x, double y);
  NodeBox box() const;

 private:
  double ux_, uy_;
  double low_along_, high_along_, low_across_, high_across_;
};

/// Do two rectangles, each moved as given, come closer than `margin`? "No" is certain if margin is at least four times
/// the error of the placement's positions.
bool near(const NodeBox& a, const RoundedPose& pose_a, const NodeBox& b, const RoundedPose& pose_b, double margin);

/// A tree and a box for each of its nodes, by heap number.
struct BoxedTree {
  const ChainTree& tree;
  std::span<const NodeBox> boxes;
  RoundedPose pose;
};

/// Some nodes, by heap number.
struct NodeSet {
  std::vector<bool> has;
  std::size_t size = 0;
};

/// The nodes of `tree` to whose regions an edge of `other` may come near; the others' regions hold nothing of it.
/// Leaves are skipped. If a node is near, its ancestors are. Gives up, with an incomplete set, after `most`.
NodeSet near_nodes(const BoxedTree& tree, const BoxedTree& other, double margin, std::size_t most);

}  // namespace taut::internal
