#include "world/meeting_boxes.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/interruption.hpp"

namespace taut {

bool is_long(const WorldPlan& plan, int a, const SweptBox& box_a, int b, const SweptBox& box_b) {
  const auto size = [&](int k) { return plan.bodies()[static_cast<std::size_t>(k)].rings->diagonal(); };
  return is_long(box_a, box_b, size(a) + size(b));
}

MeetingBoxes::MeetingBoxes(const WorldPlan& plan, const std::vector<int>& bodies, double from, double to)
    : plan_(plan), bodies_(bodies) {
  boxes_.reserve(bodies.size());
  for (const int b : bodies) {
    interruption_point();
    boxes_.push_back(swept_box(plan.bodies()[static_cast<std::size_t>(b)], from, to));
  }
}

void MeetingBoxes::each(const std::function<void(int, int, bool)>& visit) const {
  std::vector<std::size_t> order(bodies_.size()), active;
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return std::pair(boxes_[i].lo_x, i) < std::pair(boxes_[j].lo_x, j); });
  for (const std::size_t i : order) {
    std::erase_if(active, [&](std::size_t j) { return boxes_[j].hi_x < boxes_[i].lo_x; });
    for (const std::size_t j : active) {
      interruption_point();
      if (!boxes_[i].meets(boxes_[j]) || !plan_.asked(bodies_[i], bodies_[j])) continue;
      visit(std::min(bodies_[i], bodies_[j]), std::max(bodies_[i], bodies_[j]),
            is_long(plan_, bodies_[i], boxes_[i], bodies_[j], boxes_[j]));
    }
    active.push_back(i);
  }
}

}  // namespace taut
