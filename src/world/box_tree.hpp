// A tree over boxes that do not change: which of them meet another one.
#pragma once

#include <cstdint>
#include <vector>

#include "world/swept_box.hpp"

namespace taut {

/// Boxes in one array in the order of the tree, the halves of a run being its children: nothing is allocated for a
/// question but by its caller, and the tree is as large as the boxes.
class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(const std::vector<SweptBox>& boxes);

  /// Does any of them meet the box?
  bool any(const SweptBox& box) const;
  /// Adds the indices of those that do, in order.
  void find(const SweptBox& box, std::vector<int>& found) const;

 private:
  /// Small runs are looked at box by box.
  static constexpr std::uint32_t leaf = 4;
  /// Calls visit(index) for boxes that meet until it returns true; true if it did.
  template <class Visit>
  bool search(const SweptBox& box, const Visit& visit) const;
  void divide(std::uint32_t first, std::uint32_t count, std::uint32_t node);

  std::vector<SweptBox> around_;  ///< by node: the children of k are 2 k + 1 and 2 k + 2
  std::vector<SweptBox> boxes_;
  std::vector<int> index_;
};

}  // namespace taut
