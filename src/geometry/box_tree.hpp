// A tree over boxes that do not change: which of them meet another one, and which meet each other?
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "geometry/axis_box.hpp"

namespace taut::internal {

/// Boxes in one array in the order of the tree, the halves of a run being its children: nothing is allocated for a
/// question but by its caller, and the tree is as large as the boxes.
class BoxTree {
 public:
  BoxTree() = default;
  /// `groups` has a number, 0 or more, for each box, or nothing: see each_two().
  explicit BoxTree(std::span<const AxisBox> boxes, std::span<const int> groups = {});

  /// Does any of them meet the box?
  bool any(const AxisBox& box) const;
  /// Adds the indices of those that do, in order.
  void find(const AxisBox& box, std::vector<int>& found) const;
  /// Calls visit(i, j) for every two that meet, once, those of one group left out: these cost nothing, however many of
  /// them meet.
  void each_two(const std::function<void(int, int)>& visit) const;
  /// Calls visit(i, j) for each box i of this tree and j of the other one that are no farther apart than `reach`, up to
  /// rounding.
  void each_near(const BoxTree& other, double reach, const std::function<void(int, int)>& visit) const;

 private:
  /// Small runs are tested box by box.
  static constexpr std::uint32_t leaf = 4;
  static constexpr int several = -1;  ///< of boxes: they are in no group
  struct Entry {
    AxisBox box;
    int index;
    int group;
  };
  struct Node {
    AxisBox around;
    int group;  ///< of all that are in it
  };
  /// Entries first to first + count, below a node. The two halves of a run are the children of its node.
  struct Run {
    std::uint32_t first, count, node;
    Run half(std::uint32_t which) const {
      const std::uint32_t before = count / 2;
      return which == 0 ? Run{first, before, 2 * node + 1} : Run{first + before, count - before, 2 * node + 2};
    }
  };
  Run root() const { return {0, static_cast<std::uint32_t>(entries_.size()), 0}; }
  /// Calls visit(index) for boxes that meet until it returns true; true if it did.
  template <class Visit>
  bool search(const AxisBox& box, const Visit& visit) const;
  void divide(const Run& run);
  void each_within(const Run& run, const std::function<void(int, int)>& visit) const;
  void each_of(const Entry& entry, std::uint32_t first, std::uint32_t last,
               const std::function<void(int, int)>& visit) const;
  void each_between(const Run& a, const Run& b, const std::function<void(int, int)>& visit) const;
  void each_near(const Run& run, const BoxTree& other, const Run& of_other, double reach,
                 const std::function<void(int, int)>& visit) const;

  std::vector<Node> nodes_;
  std::vector<Entry> entries_;
};

}  // namespace taut::internal
