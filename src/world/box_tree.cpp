#include "world/box_tree.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace taut {
namespace {

SweptBox around_all(const std::vector<SweptBox>& boxes, std::uint32_t first, std::uint32_t count) {
  SweptBox all = boxes[first];
  for (std::uint32_t i = first; i < first + count; ++i) {
    all.lo_x = std::min(all.lo_x, boxes[i].lo_x);
    all.lo_y = std::min(all.lo_y, boxes[i].lo_y);
    all.hi_x = std::max(all.hi_x, boxes[i].hi_x);
    all.hi_y = std::max(all.hi_y, boxes[i].hi_y);
  }
  return all;
}

}  // namespace

BoxTree::BoxTree(const std::vector<SweptBox>& boxes) : boxes_(boxes), index_(boxes.size()) {
  std::iota(index_.begin(), index_.end(), 0);
  if (!boxes.empty()) divide(0, static_cast<std::uint32_t>(boxes.size()), 0);
}

/// At the median of the boxes' middles, along the longer side.
void BoxTree::divide(std::uint32_t first, std::uint32_t count, std::uint32_t node) {
  if (around_.size() <= node) around_.resize(node + 1);
  const SweptBox all = around_all(boxes_, first, count);
  around_[node] = all;
  if (count <= leaf) return;
  const bool along_x = all.hi_x - all.lo_x >= all.hi_y - all.lo_y;
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), first);
  const auto key = [&](std::uint32_t i) {
    return along_x ? boxes_[i].lo_x + boxes_[i].hi_x : boxes_[i].lo_y + boxes_[i].hi_y;
  };
  std::nth_element(order.begin(), order.begin() + count / 2, order.end(), [&](std::uint32_t i, std::uint32_t k) {
    return std::pair(key(i), index_[i]) < std::pair(key(k), index_[k]);
  });
  std::vector<SweptBox> boxes;
  std::vector<int> index;
  for (const std::uint32_t i : order) {
    boxes.push_back(boxes_[i]);
    index.push_back(index_[i]);
  }
  std::copy(boxes.begin(), boxes.end(), boxes_.begin() + first);
  std::copy(index.begin(), index.end(), index_.begin() + first);
  divide(first, count / 2, 2 * node + 1);
  divide(first + count / 2, count - count / 2, 2 * node + 2);
}

template <class Visit>
bool BoxTree::search(const SweptBox& box, const Visit& visit) const {
  struct Run {
    std::uint32_t first, count, node;
  };
  if (boxes_.empty()) return false;
  // Depths differ by one at most, so 64 are enough for any number of boxes.
  std::array<Run, 64> stack;
  std::size_t size = 0;
  stack[size++] = {0, static_cast<std::uint32_t>(boxes_.size()), 0};
  while (size > 0) {
    const Run run = stack[--size];
    if (!around_[run.node].meets(box)) continue;
    if (run.count > leaf) {
      stack[size++] = {run.first + run.count / 2, run.count - run.count / 2, 2 * run.node + 2};
      stack[size++] = {run.first, run.count / 2, 2 * run.node + 1};
      continue;
    }
    for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
      if (boxes_[i].meets(box) && visit(index_[i])) return true;
    }
  }
  return false;
}

bool BoxTree::any(const SweptBox& box) const {
  return search(box, [](int) { return true; });
}

void BoxTree::find(const SweptBox& box, std::vector<int>& found) const {
  const auto begin = static_cast<std::ptrdiff_t>(found.size());
  search(box, [&](int index) {
    found.push_back(index);
    return false;
  });
  std::sort(found.begin() + begin, found.end());
}

}  // namespace taut
