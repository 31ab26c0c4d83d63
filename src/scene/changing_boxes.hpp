// Boxes of bodies, of which now and then one changes: which of them meet another one.
#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "geometry/box_tree.hpp"

namespace taut::internal {

/// A tree over the boxes as they once were, and a list of those that came, changed or went since. Once these are many,
/// the tree is made anew: so a change costs little, however many boxes there are. No tree is made before a question.
class ChangingBoxes {
 public:
  ChangingBoxes() = default;
  /// Bodies in order, and the box of each.
  ChangingBoxes(std::vector<int> bodies, std::vector<AxisBox> boxes);

  void set(int body, const AxisBox& box);
  void remove(int body);
  /// Of a body that is there.
  const AxisBox& box(int body) const;
  /// The bodies whose boxes meet it, in order.
  std::vector<int> find(const AxisBox& box);

 private:
  std::size_t place(int body) const;
  bool has(int body) const;
  void make_tree();

  std::vector<int> bodies_;
  std::vector<AxisBox> boxes_;
  std::optional<BoxTree> tree_;                            ///< over these
  std::unordered_map<int, std::optional<AxisBox>> since_;  ///< what holds instead; none for a body that went
};

}  // namespace taut::internal
