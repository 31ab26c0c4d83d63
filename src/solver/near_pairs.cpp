#include "solver/near_pairs.hpp"

#include <algorithm>
#include <numeric>

#include "numeric/budget.hpp"

namespace taut::internal {
namespace {

std::vector<int> in_order(const std::unordered_set<int>& bodies) {
  std::vector<int> list(bodies.begin(), bodies.end());
  std::sort(list.begin(), list.end());
  return list;
}

}  // namespace

void NearPairs::begin_single_pair() {
  Window whole{instance_.end(), instance_.end(), false, {}, {}, {}};
  if (!instance_.excluded(0, 1)) add(whole, 0, 1);
  stack_.clear();
  stack_.push_back(std::move(whole));
}

void NearPairs::begin(double from) {
  std::vector<int> all(instance_.bodies().size());
  std::iota(all.begin(), all.end(), 0);
  from_ = from;
  if (instance_.is_single_pair()) return begin_single_pair();
  stack_.clear();
  descend(from, instance_.end(), std::move(all));
}

void NearPairs::next() {
  from_ = until();
  while (stack_.size() > 1 && stack_.back().to <= from_) stack_.pop_back();
  const Window& around = stack_.back();
  descend(around.middle, around.to, in_order(around.rest));
}

/// Adds the window, and its first halves as long as they separate more pairs. A window that has such halves stays on
/// the stack until its second half ends.
void NearPairs::descend(double from, double to, std::vector<int> bodies) {
  while (!bodies.empty()) {
    const double middle = from + (to - from) / 2;
    const bool divisible =
        from < middle && middle < to && stack_.size() < static_cast<std::size_t>(most_window_halvings);
    Window window{middle, to, divisible, {}, {}, {}};
    MeetingBoxes boxes(instance_, bodies, from, to);
    boxes.each([&](int a, int b, bool longer) {
      if (has(a, b)) return;
      if (divisible && longer) {
        window.rest.insert({a, b});
      } else {
        add(window, a, b);
      }
    });
    window.boxes = ChangingBoxes(std::move(bodies), boxes.take_boxes());
    bodies = in_order(window.rest);
    stack_.push_back(std::move(window));
    to = middle;
  }
}

/// From the longest window down, the boxes of the changed bodies are tested against all others. A body that one of them
/// may meet in the halves of a window is included in these halves from now on. A body that is no longer needed is
/// dropped where the next window begins.
void NearPairs::change(const std::vector<int>& changed, double from) {
  from_ = from;
  if (instance_.is_single_pair()) return begin_single_pair();
  for (Window& window : stack_) {
    for (const int body : changed) forget(window, body);
  }
  std::vector<int> entering = changed;
  for (Window& window : stack_) {
    for (const int body : entering)
      window.boxes.set(body, swept_box(instance_.bodies()[static_cast<std::size_t>(body)], from, window.to));
    std::vector<int> deeper;
    for (const int body : entering) {
      if (std::binary_search(changed.begin(), changed.end(), body)) examine(body, window, deeper);
    }
    entering = std::move(deeper);
  }
  std::sort(entering.begin(), entering.end());
  const double middle = stack_.back().middle, to = stack_.back().to;
  descend(from, from < middle ? middle : to, std::move(entering));
}

/// Finds the bodies that this one meets in the window. `deeper` receives the additional bodies that its halves have to
/// test.
void NearPairs::examine(int body, Window& window, std::vector<int>& deeper) {
  const AxisBox box = window.boxes.box(body);
  for (const int other : window.boxes.find(box)) {
    checkpoint();
    if (other == body || !instance_.asked(body, other) || has(body, other)) continue;
    if (!window.divisible || !is_long(instance_, body, box, other, window.boxes.box(other))) {
      add(window, body, other);
      continue;
    }
    for (const int k : {body, other}) {
      if (window.rest.insert(k).second) deeper.push_back(k);
    }
  }
}

void NearPairs::add(Window& window, int a, int b) { window.pairs.insert({{a, b}, {b, a}}); }

void NearPairs::forget(Window& window, int body) {
  window.boxes.remove(body);
  window.rest.erase(body);
  auto pair = window.pairs.lower_bound({body, INT_MIN});
  while (pair != window.pairs.end() && pair->first == body) {
    window.pairs.erase({pair->second, body});
    pair = window.pairs.erase(pair);
  }
}

bool NearPairs::has(int a, int b) const {
  const std::pair<int, int> pair(a, b);
  return std::any_of(stack_.begin(), stack_.end(), [&](const Window& window) { return window.pairs.count(pair) > 0; });
}

}  // namespace taut::internal
