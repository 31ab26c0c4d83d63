// Which bodies of a world may meet during a window of time, and would a shorter one show more?
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "scene/swept_box.hpp"

namespace taut::internal {

/// Over half of the window that the boxes are for, would those of the two bodies be much shorter?
bool is_long(const Instance& instance, int a, const AxisBox& box_a, int b, const AxisBox& box_b);

/// Some bodies of a world, and their boxes over a window.
class MeetingBoxes {
 public:
  MeetingBoxes(const Instance& instance, const std::vector<int>& bodies, double from, double to);

  /// Calls visit(a, b, longer) for all pairs of bodies a < b whose boxes meet and that are asked about. `longer`:
  /// is_long().
  void each(const std::function<void(int, int, bool)>& visit) const;
  /// The same without pairs of one group, to which nothing happens after the start.
  void each_moving(const std::function<void(int, int, bool)>& visit) const;
  /// Of each body, for those who go on with them.
  std::vector<AxisBox> take_boxes() { return std::move(boxes_); }

 private:
  void each(const std::vector<int>& groups, const std::function<void(int, int, bool)>& visit) const;
  std::vector<int> groups() const;

  const Instance& instance_;
  const std::vector<int>& bodies_;
  std::vector<AxisBox> boxes_;
};

}  // namespace taut::internal
