#include "world/meeting_boxes.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/interruption.hpp"

namespace taut {

MeetingBoxes::MeetingBoxes(const WorldPlan& plan, const std::vector<int>& bodies, double from, double to)
    : plan_(plan), bodies_(bodies) {
  boxes_.reserve(bodies.size());
  for (const int b : bodies) {
    interruption_point();
    boxes_.push_back(swept_box(plan.bodies()[static_cast<std::size_t>(b)], from, to));
  }
}

bool MeetingBoxes::longer(std::size_t i, std::size_t j) const {
  const auto size = [&](std::size_t k) {
    return diagonal(plan_.bodies()[static_cast<std::size_t>(bodies_[k])].rings->bounds());
  };
  return is_long(boxes_[i], boxes_[j], size(i) + size(j));
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
      visit(std::min(bodies_[i], bodies_[j]), std::max(bodies_[i], bodies_[j]), longer(i, j));
    }
    active.push_back(i);
  }
}

}  // namespace taut
