#include "scene/meeting_boxes.hpp"

#include <algorithm>

#include "geometry/box_tree.hpp"
#include "numeric/budget.hpp"

namespace taut::internal {

bool is_long(const Instance& instance, int a, const AxisBox& box_a, int b, const AxisBox& box_b) {
  const auto size = [&](int k) { return instance.bodies()[static_cast<std::size_t>(k)].rings->diagonal(); };
  return is_long(box_a, box_b, size(a) + size(b));
}

MeetingBoxes::MeetingBoxes(const Instance& instance, const std::vector<int>& bodies, double from, double to)
    : instance_(instance), bodies_(bodies) {
  boxes_.reserve(bodies.size());
  for (const int b : bodies) {
    checkpoint();
    boxes_.push_back(swept_box(instance.bodies()[static_cast<std::size_t>(b)], from, to));
  }
}

void MeetingBoxes::each(const std::function<void(int, int, bool)>& visit) const {
  each(instance_.tests_groups() ? std::vector<int>{} : groups(), visit);
}

void MeetingBoxes::each_moving(const std::function<void(int, int, bool)>& visit) const { each(groups(), visit); }

std::vector<int> MeetingBoxes::groups() const {
  std::vector<int> groups;
  groups.reserve(bodies_.size());
  for (const int b : bodies_) groups.push_back(instance_.bodies()[static_cast<std::size_t>(b)].group);
  return groups;
}

void MeetingBoxes::each(const std::vector<int>& groups, const std::function<void(int, int, bool)>& visit) const {
  BoxTree(boxes_, groups).each_two([&](int i, int j) {
    const auto [first, last] = std::minmax(i, j);
    const int a = bodies_[static_cast<std::size_t>(first)], b = bodies_[static_cast<std::size_t>(last)];
    if (!instance_.asked(a, b)) return;
    visit(a, b,
          is_long(instance_, a, boxes_[static_cast<std::size_t>(first)], b, boxes_[static_cast<std::size_t>(last)]));
  });
}

}  // namespace taut::internal
