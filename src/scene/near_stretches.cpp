#include "scene/near_stretches.hpp"

#include <algorithm>
#include <numeric>
#include <unordered_set>

#include "scene/meeting_boxes.hpp"

namespace taut::internal {
namespace {

/// Each stretch has a beginning of its own, which costs as much as some time on the way.
constexpr int halvings_of_coarse_windows = 6;

}  // namespace

NearStretches::NearStretches(const Instance& instance) : instance_(instance) {
  std::vector<int> bodies(instance.bodies().size());
  std::iota(bodies.begin(), bodies.end(), 0);
  for (int k = 0; k < coarse_windows; ++k)
    cover(bodies, coarse_boundary(instance, k), coarse_boundary(instance, k + 1), 0);
}

void NearStretches::cover(const std::vector<int>& bodies, double from, double to, int depth) {
  const double middle = from + (to - from) / 2;
  const bool divisible = from < middle && middle < to && depth < halvings_of_coarse_windows;
  std::unordered_set<int> again;
  MeetingBoxes(instance_, bodies, from, to).each([&](int a, int b, bool longer) {
    std::vector<TimeInterval>& own = stretches_[{a, b}];
    // The window around this one was short enough for them.
    if (!own.empty() && own.back().hi >= to) return;
    if (divisible && longer) {
      again.insert({a, b});
    } else if (!own.empty() && own.back().hi == from) {
      own.back().hi = to;
    } else {
      own.push_back({from, to});
    }
  });
  if (again.empty()) return;
  std::vector<int> rest(again.begin(), again.end());
  std::sort(rest.begin(), rest.end());
  cover(rest, from, middle, depth + 1);
  cover(rest, middle, to, depth + 1);
}

}  // namespace taut::internal
