#include "scene/changing_boxes.hpp"

#include <algorithm>
#include <utility>

namespace taut::internal {

ChangingBoxes::ChangingBoxes(std::vector<int> bodies, std::vector<AxisBox> boxes)
    : bodies_(std::move(bodies)), boxes_(std::move(boxes)) {}

std::size_t ChangingBoxes::place(int body) const {
  return static_cast<std::size_t>(std::lower_bound(bodies_.begin(), bodies_.end(), body) - bodies_.begin());
}

bool ChangingBoxes::has(int body) const {
  const std::size_t k = place(body);
  return k < bodies_.size() && bodies_[k] == body;
}

void ChangingBoxes::set(int body, const AxisBox& box) { since_[body] = box; }

void ChangingBoxes::remove(int body) {
  if (has(body)) {
    since_[body] = std::nullopt;
  } else {
    since_.erase(body);
  }
}

const AxisBox& ChangingBoxes::box(int body) const {
  const auto changed = since_.find(body);
  return changed == since_.end() ? boxes_[place(body)] : *changed->second;
}

std::vector<int> ChangingBoxes::find(const AxisBox& box) {
  // Looking through what has changed, and making a tree once in so many changes, then cost about the same.
  if (!tree_ || since_.size() * since_.size() > 64 * (bodies_.size() + 64)) make_tree();
  std::vector<int> found;
  tree_->find(box, found);
  for (int& k : found) k = bodies_[static_cast<std::size_t>(k)];
  if (since_.empty()) return found;
  std::erase_if(found, [&](int body) { return since_.count(body) > 0; });
  for (const auto& [body, changed] : since_) {
    if (changed && changed->meets(box)) found.push_back(body);
  }
  std::sort(found.begin(), found.end());
  return found;
}

void ChangingBoxes::make_tree() {
  std::vector<std::pair<int, AxisBox>> now;
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    if (since_.count(bodies_[k]) == 0) now.emplace_back(bodies_[k], boxes_[k]);
  }
  for (const auto& [body, changed] : since_) {
    if (changed) now.emplace_back(body, *changed);
  }
  std::sort(now.begin(), now.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  bodies_.clear();
  boxes_.clear();
  for (const auto& [body, box] : now) {
    bodies_.push_back(body);
    boxes_.push_back(box);
  }
  since_.clear();
  tree_.emplace(boxes_);
}

}  // namespace taut::internal
