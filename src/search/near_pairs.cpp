#include "search/near_pairs.hpp"

#include <algorithm>
#include <numeric>
#include <unordered_set>

namespace taut {

void NearPairs::begin(double from) {
  std::vector<int> all(plan_.bodies().size());
  std::iota(all.begin(), all.end(), 0);
  stack_.clear();
  from_ = from;
  descend(from, plan_.end(), std::move(all));
}

void NearPairs::next() {
  from_ = until();
  while (stack_.size() > 1 && stack_.back().to <= from_) stack_.pop_back();
  const Window& around = stack_.back();
  descend(around.middle, around.to, around.rest);
}

/// Adds the window, and its first halves as far as they tell more. Where they do, it stays until its second half ends.
void NearPairs::descend(double from, double to, std::vector<int> bodies) {
  while (!bodies.empty()) {
    const double middle = from + (to - from) / 2;
    const bool divisible = from < middle && middle < to && stack_.size() < static_cast<std::size_t>(most_halvings);
    Window window{middle, to, {}, {}};
    std::unordered_set<int> again;
    MeetingBoxes(plan_, bodies, from, to).each([&](int a, int b, bool longer) {
      if (has(a, b)) return;
      if (divisible && longer) {
        again.insert({a, b});
      } else {
        window.pairs.emplace_back(a, b);
      }
    });
    std::sort(window.pairs.begin(), window.pairs.end());
    window.rest.assign(again.begin(), again.end());
    std::sort(window.rest.begin(), window.rest.end());
    bodies = window.rest;
    stack_.push_back(std::move(window));
    to = middle;
  }
}

bool NearPairs::has(int a, int b) const {
  const std::pair<int, int> pair(std::min(a, b), std::max(a, b));
  return std::any_of(stack_.begin(), stack_.end(), [&](const Window& window) {
    return std::binary_search(window.pairs.begin(), window.pairs.end(), pair);
  });
}

}  // namespace taut
