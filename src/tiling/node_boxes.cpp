#include "tiling/node_boxes.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/budget.hpp"

namespace taut::internal {
namespace {

/// Coordinates are at most 1 in magnitude; the few operations behind a box err by less.
constexpr double box_margin = 0x1p-46;

class NearSearch {
 public:
  NearSearch(const BoxedTree& tree, const BoxedTree& other, double margin, std::size_t most)
      : tree_(tree), other_(other), margin_(margin), most_(most) {
    near_.has.resize(tree.boxes.size(), false);
  }

  NodeSet run() {
    candidates_.push_back(1);
    visit(1, 0);
    return std::move(near_);
  }

 private:
  /// The candidates from `begin` on may be near the parent's region. Leaves the stack as it was.
  void visit(std::uint32_t node, std::size_t begin) {
    if (node >= tree_.tree.leaves() || near_.size > most_) return;
    const std::size_t end = candidates_.size();
    for (std::size_t i = begin; i < end; ++i) refine(node, candidates_[i]);
    if (candidates_.size() > end) {
      near_.has[node] = true;
      ++near_.size;
      visit(2 * node, end);
      visit(2 * node + 1, end);
    }
    candidates_.resize(end);
  }

  /// Pushes the descendants of `other` that are no larger than the node and may be near it.
  void refine(std::uint32_t node, std::uint32_t other) {
    const NodeBox &box = tree_.boxes[node], &far = other_.boxes[other];
    checkpoint();
    if (!near(box, tree_.pose, far, other_.pose, margin_)) return;
    if (other < other_.tree.leaves() && far.along + far.across > box.along + box.across) {
      refine(node, 2 * other);
      refine(node, 2 * other + 1);
    } else {
      candidates_.push_back(other);
    }
  }

  const BoxedTree &tree_, &other_;
  double margin_;
  std::size_t most_;
  NodeSet near_;
  std::vector<std::uint32_t> candidates_;  ///< a stack of ranges
};

}  // namespace

BoxBuilder::BoxBuilder(const Point& a, const Point& b) {
  const double x = b.x - a.x, y = b.y - a.y, length = std::sqrt(x * x + y * y);
  ux_ = length > 0 ? x / length : 1;
  uy_ = length > 0 ? y / length : 0;
  low_along_ = high_along_ = ux_ * a.x + uy_ * a.y;
  low_across_ = high_across_ = ux_ * a.y - uy_ * a.x;
  include(b.x, b.y);
}

void BoxBuilder::include(double x, double y) {
  const double s = ux_ * x + uy_ * y, r = ux_ * y - uy_ * x;
  low_along_ = std::min(low_along_, s);
  high_along_ = std::max(high_along_, s);
  low_across_ = std::min(low_across_, r);
  high_across_ = std::max(high_across_, r);
}

NodeBox BoxBuilder::box() const {
  const double s = (low_along_ + high_along_) / 2, r = (low_across_ + high_across_) / 2;
  return {ux_ * s - uy_ * r,
          uy_ * s + ux_ * r,
          ux_,
          uy_,
          (high_along_ - low_along_) / 2 + box_margin,
          (high_across_ - low_across_) / 2 + box_margin};
}

bool near(const NodeBox& a, const RoundedPose& pose_a, const NodeBox& b, const RoundedPose& pose_b, double margin) {
  // Everything along a's sides.
  const double aux = pose_a.c * a.ux - pose_a.s * a.uy, auy = pose_a.s * a.ux + pose_a.c * a.uy;
  const double bux = pose_b.c * b.ux - pose_b.s * b.uy, buy = pose_b.s * b.ux + pose_b.c * b.uy;
  const double dx = (pose_b.x + (pose_b.c * b.x - pose_b.s * b.y)) - (pose_a.x + (pose_a.c * a.x - pose_a.s * a.y));
  const double dy = (pose_b.y + (pose_b.s * b.x + pose_b.c * b.y)) - (pose_a.y + (pose_a.s * a.x + pose_a.c * a.y));
  const double cosine = std::fabs(aux * bux + auy * buy), sine = std::fabs(aux * buy - auy * bux);
  if (std::fabs(dx * aux + dy * auy) > a.along + cosine * b.along + sine * b.across + margin) return false;
  if (std::fabs(aux * dy - auy * dx) > a.across + sine * b.along + cosine * b.across + margin) return false;
  if (std::fabs(dx * bux + dy * buy) > b.along + cosine * a.along + sine * a.across + margin) return false;
  return std::fabs(bux * dy - buy * dx) <= b.across + sine * a.along + cosine * a.across + margin;
}

NodeSet near_nodes(const BoxedTree& tree, const BoxedTree& other, double margin, std::size_t most) {
  return NearSearch(tree, other, margin, most).run();
}

}  // namespace taut::internal
