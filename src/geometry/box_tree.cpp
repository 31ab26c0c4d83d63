#include "geometry/box_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "numeric/budget.hpp"

namespace taut::internal {

BoxTree::BoxTree(std::span<const AxisBox> boxes, std::span<const int> groups) {
  if (boxes.empty()) return;
  entries_.reserve(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    entries_.push_back({boxes[i], static_cast<int>(i), groups.empty() ? several : groups[i]});
  }
  divide(root());
}

/// At the median of the boxes' middles, along the longer side.
void BoxTree::divide(const Run& run) {
  const std::span<Entry> entries = std::span(entries_).subspan(run.first, run.count);
  Node node{entries.front().box, entries.front().group};
  for (const Entry& e : entries) {
    node.around.include(e.box);
    if (e.group != node.group) node.group = several;
  }
  if (nodes_.size() <= run.node) nodes_.resize(run.node + 1);
  nodes_[run.node] = node;
  if (run.count <= leaf) return;
  const bool along_x = node.around.width() >= node.around.height();
  const auto key = [&](const Entry& e) {
    const double sum = along_x ? e.box.lo_x + e.box.hi_x : e.box.lo_y + e.box.hi_y;
    return std::pair(std::isnan(sum) ? 0 : sum, e.index);  // a box may be infinite both ways
  };
  std::nth_element(entries.begin(), entries.begin() + run.count / 2, entries.end(),
                   [&](const Entry& a, const Entry& b) { return key(a) < key(b); });
  divide(run.half(0));
  divide(run.half(1));
}

template <class Visit>
bool BoxTree::search(const AxisBox& box, const Visit& visit) const {
  if (entries_.empty()) return false;
  // Depths differ by one at most, so 64 are enough for any number of boxes.
  std::array<Run, 64> stack;
  std::size_t size = 0;
  stack[size++] = root();
  while (size > 0) {
    const Run run = stack[--size];
    if (!nodes_[run.node].around.meets(box)) continue;
    if (run.count > leaf) {
      stack[size++] = run.half(1);
      stack[size++] = run.half(0);
      continue;
    }
    for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
      if (entries_[i].box.meets(box) && visit(entries_[i].index)) return true;
    }
  }
  return false;
}

bool BoxTree::any(const AxisBox& box) const {
  return search(box, [](int) { return true; });
}

void BoxTree::find(const AxisBox& box, std::vector<int>& found) const {
  const auto begin = static_cast<std::ptrdiff_t>(found.size());
  search(box, [&](int index) {
    found.push_back(index);
    return false;
  });
  std::sort(found.begin() + begin, found.end());
}

void BoxTree::each_two(const std::function<void(int, int)>& visit) const {
  if (!entries_.empty()) each_within(root(), visit);
}

void BoxTree::each_within(const Run& run, const std::function<void(int, int)>& visit) const {
  if (nodes_[run.node].group != several) return;
  if (run.count > leaf) {
    each_within(run.half(0), visit);
    each_within(run.half(1), visit);
    each_between(run.half(0), run.half(1), visit);
    return;
  }
  for (std::uint32_t i = run.first; i < run.first + run.count; ++i) each_of(entries_[i], run.first, i, visit);
}

void BoxTree::each_between(const Run& a, const Run& b, const std::function<void(int, int)>& visit) const {
  checkpoint();
  const Node &left = nodes_[a.node], &right = nodes_[b.node];
  if (left.group != several && left.group == right.group) return;
  if (!left.around.meets(right.around)) return;
  const Run &larger = a.count < b.count ? b : a, &other = a.count < b.count ? a : b;
  if (larger.count > leaf) {
    each_between(larger.half(0), other, visit);
    each_between(larger.half(1), other, visit);
    return;
  }
  for (std::uint32_t i = a.first; i < a.first + a.count; ++i) each_of(entries_[i], b.first, b.first + b.count, visit);
}

void BoxTree::each_near(const BoxTree& other, double reach, const std::function<void(int, int)>& visit) const {
  if (!entries_.empty() && !other.entries_.empty()) each_near(root(), other, other.root(), reach, visit);
}

void BoxTree::each_near(const Run& run, const BoxTree& other, const Run& of_other, double reach,
                        const std::function<void(int, int)>& visit) const {
  if (nodes_[run.node].around.distance_to(other.nodes_[of_other.node].around) > reach) return;
  if (run.count > leaf && run.count >= of_other.count) {
    for (const std::uint32_t k : {0u, 1u}) each_near(run.half(k), other, of_other, reach, visit);
  } else if (of_other.count > leaf) {
    for (const std::uint32_t k : {0u, 1u}) each_near(run, other, of_other.half(k), reach, visit);
  } else {
    for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
      for (std::uint32_t j = of_other.first; j < of_other.first + of_other.count; ++j) {
        if (entries_[i].box.distance_to(other.entries_[j].box) <= reach)
          visit(entries_[i].index, other.entries_[j].index);
      }
    }
  }
}

/// With those from first to before last.
void BoxTree::each_of(const Entry& entry, std::uint32_t first, std::uint32_t last,
                      const std::function<void(int, int)>& visit) const {
  for (std::uint32_t i = first; i < last; ++i) {
    checkpoint();
    const Entry& other = entries_[i];
    if (entry.group != several && entry.group == other.group) continue;
    if (entry.box.meets(other.box)) visit(entry.index, other.index);
  }
}

}  // namespace taut::internal
